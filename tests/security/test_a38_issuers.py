"""A26, A38: only the registered issuer lets people in, by a token for us, now and in answer to our own question."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from server.people import oidc_fetch
from server.people.oidc_fetch import LARGEST, Unreachable, fetch
from server.settings import Provider
from tests.conftest import Laid
from tests.server.issuer import CLIENT, OTHER_KEY, PASSWORD, Issuer, running
from tests.server.school import School, opened


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[tuple[School, Issuer]]:
    with running() as issuer:
        provider = Provider(issuer.address, CLIENT, PASSWORD)
        with opened(laid_for_all(tmp_path_factory.mktemp("issuer"), secret=b"s", provider=provider)) as school:
            yield school, issuer


@pytest.fixture
def issuer(here: tuple[School, Issuer]) -> Issuer:
    found = here[1]
    clean = Issuer(found.address)
    found.claims, found.described, found.key, found.padding = {}, {}, clean.key, ""
    return found


@pytest.fixture
def school(here: tuple[School, Issuer]) -> School:
    return here[0]


def there_and_back(browser: TestClient, issuer: Issuer) -> tuple[int, str]:
    left = browser.get("/oidc?next=/account")
    assert left.status_code == 303, left.text
    back = browser.get(f"/oidc/callback?{issuer.consent(left.headers['location'])}")
    return back.status_code, back.headers["location"] if back.status_code == 303 else back.json()["error"]["code"]


def test_a_university_account_signs_in_and_is_known_again(school: School, issuer: Issuer) -> None:
    people = []
    for _ in range(2):
        browser = school.browser()
        assert 'href="/oidc?next=' in browser.get("/signin").text
        assert there_and_back(browser, issuer) == (303, "/account")
        people.append(browser.get("/api/v1/me").json())
    assert people[0] == people[1]
    assert people[0] | {"id": ""} == {"id": "", "login": None, "name": "Olga Uczelniana", "role": "student"}


def test_somebody_signed_in_joins_both_accounts(school: School, issuer: Issuer) -> None:
    issuer.claims = {"sub": "u2"}
    assert there_and_back(school.browser("student"), issuer)[0] == 303
    browser = school.browser()
    assert there_and_back(browser, issuer)[0] == 303
    assert browser.get("/api/v1/me").json()["login"] == "student"
    assert there_and_back(school.browser("other"), issuer) == (409, "taken_subject")


LIES: dict[str, dict[str, Any]] = {
    "another issuer": {"iss": "https://evil.example"}, "another audience": {"aud": "moodle"},
    "many audiences": {"aud": [CLIENT, "moodle"]}, "another party": {"azp": "moodle"},
    "another nonce": {"nonce": "x"}, "no nonce": {"nonce": None}, "expired": {"exp": int(time.time()) - 3600},
    "without end": {"exp": None},
    "no subject": {"sub": None}, "empty subject": {"sub": ""}, "subject of another kind": {"sub": ["u1"]},
    "issued later": {"iat": int(time.time()) + 3600},
}  # fmt: skip


@pytest.mark.parametrize("lie", LIES)
def test_a_word_that_does_not_fit_lets_nobody_in(school: School, issuer: Issuer, lie: str) -> None:
    issuer.claims, browser = LIES[lie], school.browser()
    assert there_and_back(browser, issuer) == (401, "wrong_provider")
    assert browser.get("/api/v1/me").status_code == 401


def test_a_word_signed_by_somebody_else_lets_nobody_in(school: School, issuer: Issuer) -> None:
    issuer.key = OTHER_KEY
    assert there_and_back(school.browser(), issuer) == (401, "wrong_provider")


def test_role_and_login_are_not_taken_from_the_issuer(school: School, issuer: Issuer) -> None:
    issuer.claims = {"sub": "u3", "role": "administrator", "email": "administrator", "preferred_username": "lecturer"}
    browser = school.browser()
    assert there_and_back(browser, issuer)[0] == 303
    assert browser.get("/api/v1/me").json()["role"] == "student"
    assert browser.get("/api/v1/courses").json() == []


def test_a_code_is_taken_only_by_the_browser_that_asked(school: School, issuer: Issuer) -> None:
    attacker, victim = school.browser(), school.browser()
    query = issuer.consent(attacker.get("/oidc").headers["location"])
    assert victim.get(f"/oidc/callback?{query}").status_code == 401
    victim.get("/oidc")
    assert victim.get(f"/oidc/callback?{query}").status_code == 401
    assert attacker.get(f"/oidc/callback?{query}").status_code == 303
    assert attacker.get(f"/oidc/callback?{query}").status_code == 401  # the journey is over


@pytest.mark.parametrize("place", ["token_endpoint", "jwks_uri", "authorization_endpoint"])
@pytest.mark.parametrize("url", ["http://169.254.169.254/latest", "http://127.0.0.1:1/x", "file:///etc/passwd"])
def test_the_issuer_does_not_send_us_elsewhere(school: School, issuer: Issuer, place: str, url: str) -> None:
    browser = school.browser()
    query = issuer.consent(browser.get("/oidc").headers["location"])
    issuer.described = {place: url}
    asked = browser.get("/oidc" if place == "authorization_endpoint" else f"/oidc/callback?{query}")
    assert (asked.status_code, asked.json()["error"]["code"]) == (503, "provider_down")
    assert asked.headers["retry-after"]


def test_another_server_is_not_asked_even_where_it_would_answer(issuer: Issuer) -> None:
    with running() as other, pytest.raises(Unreachable, match="is not asked for"):
        fetch(issuer.address, f"{other.address}/jwks_uri")


ELSEWHERE = {  # what large issuers tell in their descriptions
    "https://accounts.google.com": "https://oauth2.googleapis.com/token",
    "https://login.microsoftonline.com/4bb1/v2.0": "https://graph.microsoft.com:443/oidc/userinfo",
    "https://idp.uni.example:8443/realms/x": "https://idp.uni.example:8443/realms/x/token",
}


@pytest.mark.parametrize("issuer", ELSEWHERE)
def test_an_issuer_may_keep_its_endpoints_on_another_public_host(issuer: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(oidc_fetch, "_asked", lambda scheme, host, *rest: {"asked": f"{scheme}://{host}"})
    assert ELSEWHERE[issuer].startswith(fetch(issuer, ELSEWHERE[issuer])["asked"])


@pytest.mark.parametrize(
    "url", ["http://oauth2.googleapis.com/token", "https://oauth2.googleapis.com:6379/", "https://127.0.0.1/", "https://",
            "https://a:b@oauth2.googleapis.com/", "https://[::1]/", "ftp://x.example/", "https://x:y/", "//x.example/"],
)  # fmt: skip
def test_an_issuer_sends_us_to_no_other_scheme_port_or_own_machine(url: str) -> None:
    with pytest.raises(Unreachable, match="is not asked for"):
        fetch("https://accounts.google.com", url)


@pytest.mark.parametrize("address", ["10.0.0.5", "127.0.0.1", "169.254.169.254", "::1", "fd00::1", "0.0.0.0"])
def test_a_public_name_with_a_private_address_is_not_asked(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    answer = [(0, 0, 0, "", ("203.0.114.9", 443)), (0, 0, 0, "", (address, 443))]
    monkeypatch.setattr("socket.getaddrinfo", lambda *wanted, **more: answer)
    with pytest.raises(Unreachable, match="private address"):
        fetch("https://accounts.google.com", "https://oauth2.googleapis.com/token")


def test_an_answer_without_end_is_not_read(school: School, issuer: Issuer) -> None:
    issuer.padding = "x" * LARGEST
    assert school.browser().get("/oidc").status_code == 503


@pytest.mark.parametrize(
    "host", ["https://10.0.0.1", "https://192.168.1.1", "https://169.254.169.254", "https://[::1]:1", "https://0.0.0.0",
             "https://localhost", "http://example.org", "https://[::ffff:10.0.0.1]"],
)  # fmt: skip
def test_no_private_address_and_no_plain_http_is_asked(host: str) -> None:
    with pytest.raises(Unreachable):
        fetch(host, f"{host}/.well-known/openid-configuration")


def test_without_a_registered_issuer_there_is_no_such_way(tmp_path: Path, laid: Laid) -> None:
    with opened(laid(tmp_path, secret=b"s")) as school:
        browser = school.browser()
        assert "/oidc" not in browser.get("/signin").text
        assert [browser.get(path).status_code for path in ("/oidc", "/oidc/callback?code=x&state=y")] == [404, 404]
