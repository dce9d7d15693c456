"""A26: no token without our signature, for somebody else, out of time, revoked, or above its person."""

from __future__ import annotations

import base64
import json
import time
from typing import Any

import pytest
from joserfc import jwt
from joserfc.jwk import OctKey
from sqlalchemy import update
from starlette.testclient import TestClient

from server.database.engine import engine
from server.people import tokens
from server.tables import persons
from tests.server.school import School

SECRET = b"a secret of the tests"
CLAIMS = {"sub": "a", "role": "administrator", "aud": "grubler"}


def told(browser: TestClient, token: str, path: str = "/api/v1/exercises") -> tuple[int, str | None]:
    reply = browser.get(path, headers={"authorization": f"Bearer {token}"})
    return reply.status_code, reply.json()["error"]["code"] if reply.status_code >= 400 else None


def by_hand(header: dict[str, Any], claims: dict[str, Any], signature: bytes = b"") -> str:
    parts = [base64.urlsafe_b64encode(json.dumps(part).encode()).rstrip(b"=") for part in (header, claims)]
    return b".".join([*parts, base64.urlsafe_b64encode(signature).rstrip(b"=")]).decode()


FORGED = {
    "none": by_hand({"alg": "none"}, CLAIMS | {"exp": time.time() + 60}),
    "another key": jwt.encode({"alg": "HS256"}, CLAIMS | {"exp": time.time() + 60}, OctKey.import_key(b"k" * 32)),
    "key named": by_hand({"alg": "HS256", "kid": "/dev/null"}, CLAIMS | {"exp": time.time() + 60}, b"x" * 32),
    "key inside": by_hand({"alg": "HS256", "jwk": {"kty": "oct", "k": "AA"}}, CLAIMS | {"exp": 2e9}, b"x" * 32),
    "expired": tokens.issue("administrator", SECRET, hours=-1),
    "another server": tokens.issue("administrator", b"another secret"),
    "another audience": jwt.encode({"alg": "HS256"}, CLAIMS | {"aud": "moodle", "exp": 2e9}, tokens._key(SECRET)),
}


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_token_is_refused(school: School, name: str) -> None:
    assert told(school.browser(), FORGED[name]) == (401, "bad_token")


def made(school: School, who: str, role: str) -> dict[str, str]:
    reply = school.browser(who).post("/api/v1/tokens", json={"name": "ci", "role": role})
    assert reply.status_code == 201, reply.text
    found: dict[str, str] = reply.json()
    return found


def change(school: School, who: str, **values: Any) -> None:
    store = engine(school.bench.settings.store_url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        connection.execute(update(persons).where(persons.c.login == who).values(**values))
    store.dispose()


def test_a_revoked_token_is_refused_at_once(school: School) -> None:
    token = made(school, "lecturer", "lecturer")
    assert told(school.browser(), token["token"])[0] == 200
    assert school.browser("lecturer").delete(f"/api/v1/tokens/{token['id']}").status_code == 204
    assert told(school.browser(), token["token"]) == (401, "bad_token")


def test_a_token_falls_with_its_person(school: School) -> None:
    token = made(school, "lecturer", "lecturer")["token"]
    change(school, "lecturer", role="student")
    assert told(school.browser(), token, "/problems") == (403, "forbidden")
    change(school, "lecturer", active=False)
    assert told(school.browser(), token) == (401, "bad_token")


def test_the_subject_of_a_token_of_the_command_line_is_no_person(school: School) -> None:
    token = tokens.issue("student", SECRET, subject=school.people["student"])
    assert told(school.browser(), token, "/api/v1/me") == (403, "person_needed")


def test_a_token_of_the_store_needs_our_signature_as_well(school: School) -> None:
    number = made(school, "administrator", "administrator")["id"]
    forged = by_hand({"alg": "none"}, CLAIMS | {"sub": f"token:{number}", "exp": 2e9})
    assert told(school.browser(), forged) == (401, "bad_token")
