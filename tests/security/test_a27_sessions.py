"""A27: a session is nobody else's: no fixation, no posts from other sites, no frame, cookies that stay here."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from sqlalchemy import update
from starlette.testclient import TestClient

from server.database.engine import engine
from server.people import sessions
from server.tables import sessions as kept
from tests.conftest import Laid
from tests.server.school import PASSWORD, School, opened
from tests.server.stores import everything

FORM = {"login": "student", "password": PASSWORD}


def test_a_cookie_from_before_signing_in_is_not_taken(school: School) -> None:
    browser = school.browser()
    browser.cookies.set("grubler_session", "f" * 43)
    browser.post("/signin", data=FORM)
    held = {cookie.value for cookie in browser.cookies.jar if cookie.name == "grubler_session"}
    assert len(held - {"f" * 43}) == 1
    stranger = school.browser()
    stranger.cookies.set("grubler_session", "f" * 43)
    assert stranger.get("/api/v1/me").status_code == 401


def test_signing_in_again_ends_the_session_before(school: School) -> None:
    browser, copy = school.browser("student"), school.browser()
    copy.cookies.update(browser.cookies)
    assert copy.get("/api/v1/me").status_code == 200
    browser.post("/signin", data=FORM)
    assert copy.get("/api/v1/me").status_code == 401 and browser.get("/api/v1/me").status_code == 200


@pytest.mark.parametrize("column", ["expires", "last_used"])
def test_a_session_ends_by_itself(school: School, column: str) -> None:
    browser = school.browser("student")
    old = datetime.now(UTC) - sessions.IDLE - timedelta(minutes=1)
    store = engine(school.bench.settings.store_url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        connection.execute(update(kept).values({column: old}))
    store.dispose()
    assert browser.get("/api/v1/me").status_code == 401


def test_the_store_holds_no_cookie(school: School) -> None:
    browser = school.browser("student")
    (cookie,) = [cookie.value for cookie in browser.cookies.jar if cookie.name == "grubler_session"]
    assert cookie
    assert cookie not in everything(school.bench.settings.store_url)


@pytest.mark.parametrize("foreign", [{"origin": "https://evil.example"}, {"origin": "null"},
                                     {"sec-fetch-site": "cross-site"}])  # fmt: skip
@pytest.mark.parametrize("path", ["/signin", "/signout", "/account", "/account/tokens", "/courses", "/api/v1/tokens"])
def test_a_page_of_another_site_posts_nothing(school: School, path: str, foreign: dict[str, str]) -> None:
    reply = school.browser("lecturer").post(path, data=FORM, headers=foreign)
    assert (reply.status_code, reply.json()["error"]["code"]) == (403, "foreign_page")


def cookies(client: TestClient) -> list[str]:
    return client.post("/signin", data=FORM).headers.get_list("set-cookie")


def test_on_loopback_a_cookie_is_kept_from_scripts_and_other_sites(school: School) -> None:
    (session,) = [line for line in cookies(school.browser()) if line.startswith("grubler_session=")]
    assert "HttpOnly" in session and "SameSite=lax" in session and "Path=/" in session and "Secure" not in session


def test_behind_https_every_cookie_is_bound_to_the_host(tmp_path: Path, laid: Laid) -> None:
    with opened(laid(tmp_path, secret=b"s", public_url="https://lab.example")) as school:
        client = TestClient(school.app, base_url="https://lab.example", follow_redirects=False)
        lines = cookies(client)
        assert [line for line in lines if line.startswith("__Host-grubler_session=")]
        assert all("Secure" in line and "HttpOnly" in line and "Domain" not in line for line in lines)
        assert client.get("/api/v1/me").status_code == 200
        unbound = TestClient(school.app, base_url="https://lab.example")
        unbound.cookies.set("grubler_session", client.cookies["__Host-grubler_session"])
        assert unbound.get("/api/v1/me").status_code == 401


def test_no_page_with_a_password_stands_in_a_frame(school: School) -> None:
    for path in ("/signin", "/account", "/home"):
        headers = school.browser("student").get(path).headers
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-frame-options"] == "DENY" and headers["cache-control"] == "no-store"


def test_what_a_stranger_says_about_the_way_is_not_believed(school: School) -> None:
    said = {"x-forwarded-proto": "https", "x-forwarded-host": "evil.example", "forwarded": "proto=https"}
    reply = school.browser().post("/signin", data=FORM, headers=said)
    assert reply.headers["location"] == "/home" and "Secure" not in reply.headers["set-cookie"]
    page = school.browser("lecturer").get(f"/courses/{school.course}", headers=said | {"host": "evil.example"}).text
    assert "evil.example" not in page
    assert replace(school.bench.settings, public_url="https://lab.example/").address == "https://lab.example"
