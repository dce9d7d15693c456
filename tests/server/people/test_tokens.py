"""A bearer token is accepted only if this server has made it, for this audience, and not too long ago."""

from __future__ import annotations

import base64
import json
import time
from typing import Any

import pytest
from joserfc import jwt
from joserfc.jwk import OctKey

from server.people import tokens
from server.people.tokens import BadToken, issue, read
from server.policy import Role

SECRET = b"secret"


def forged(header: dict[str, Any], key: OctKey | None = None, **changes: Any) -> str:
    claims = {"sub": "a", "role": "lecturer", "aud": "grubler", "exp": int(time.time()) + 60}
    return jwt.encode(header, claims | changes, key or tokens._key(SECRET), algorithms=["HS256", "HS384", "none"])


def unsigned(algorithm: str) -> str:
    claims = {"sub": "a", "role": "administrator", "aud": "grubler", "exp": int(time.time()) + 60}
    parts = [base64.urlsafe_b64encode(json.dumps(part).encode()).rstrip(b"=") for part in ({"alg": algorithm}, claims)]
    return b".".join([*parts, b""]).decode()


def test_a_token_carries_its_role_and_subject() -> None:
    assert read(issue("lecturer", SECRET, subject="anna"), SECRET) == (Role.LECTURER, "anna")


def test_tokens_without_a_subject_belong_to_nobody_else() -> None:
    assert read(issue("student", SECRET), SECRET) != read(issue("student", SECRET), SECRET)


def test_a_role_that_does_not_exist_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"dean.*lecturer"):
        issue("dean", SECRET)


@pytest.mark.parametrize("algorithm", ["none", "None", "NONE", "HS256"])
def test_an_unsigned_token_is_refused(algorithm: str) -> None:
    with pytest.raises(BadToken):
        read(unsigned(algorithm), SECRET)


def test_another_algorithm_under_the_same_key_is_refused() -> None:
    with pytest.raises(BadToken):
        read(forged({"alg": "HS384"}), SECRET)


def test_another_key_is_refused_whatever_the_header_says() -> None:
    with pytest.raises(BadToken):
        read(forged({"alg": "HS256", "kid": "../../dev/null"}, OctKey.import_key(b"x" * 32)), SECRET)
    with pytest.raises(BadToken):
        read(issue("lecturer", b"another secret"), SECRET)


@pytest.mark.parametrize(
    "changes",
    [{"exp": 1}, {"aud": "other"}, {"role": "dean"}, {"role": ["lecturer"]}, {"sub": 7}, {"exp": None}, {"aud": None}],
)  # fmt: skip
def test_wrong_claims_are_refused(changes: dict[str, Any]) -> None:
    with pytest.raises(BadToken):
        read(forged({"alg": "HS256"}, **changes), SECRET)


@pytest.mark.parametrize("text", ["", "a", "a.b.c", "." * 2000, "é.é.é", "x" * 3000])
def test_what_is_no_token_is_refused(text: str) -> None:
    with pytest.raises(BadToken):
        read(text, SECRET)


def test_an_expired_token_is_refused() -> None:
    with pytest.raises(BadToken):
        read(issue("lecturer", SECRET, hours=-1), SECRET)
