"""A28: whether there is an account cannot be told, guessing is slow, and nobody is locked out by a stranger."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime

import pytest
from pwdlib import PasswordHash
from starlette.testclient import TestClient

from server.people import identity
from server.people.passwords import Passwords
from server.storage.people import Person
from server.web.limits import TRIES, TRIES_FROM_ANYWHERE, Rate
from tests.server.school import CHEAP, PASSWORD, School

EN = {"accept-language": "en", "accept": "text/html"}


class Counted:
    """A hash that counts how often it is made and checked."""

    def __init__(self) -> None:
        self._hash = PasswordHash((CHEAP,))
        self.made = self.work = 0

    def hash(self, password: str) -> str:
        self.made += 1
        return self._hash.hash(password)

    def verify(self, password: str, kept: str) -> bool:
        self.work += 1
        return self._hash.verify(password, kept)


def test_an_answer_and_its_work_are_the_same_for_all_who_may_not(school: School) -> None:
    passwords, counted = Passwords(CHEAP), Counted()
    passwords._hash = counted  # type: ignore[assignment]
    bare = Person("NNNN-NNNN-NNNN", "bare", "Bare", "student", datetime.now(UTC))
    shut = replace(bare, id="SSSS-SSSS-SSSS", login="shut", active=False)
    for person in (bare, replace(shut, password=school.portal.call(passwords.hashed, PASSWORD))):
        assert school.portal.call(school.bench.people.add, person)
    school.app.state.bench = replace(school.bench, passwords=passwords)
    seen = set()
    for login, password in (("nobody", PASSWORD), ("student", "wrong"), ("bare", PASSWORD), ("shut", PASSWORD)):
        before = counted.work
        reply = school.browser().post("/api/v1/sessions", json={"login": login, "password": password})
        told = reply.json()["error"] | {"request_id": ""}
        seen.add((reply.status_code, str(told), counted.work - before, "set-cookie" in reply.headers))
    passwords.close()
    assert len(seen) == 1 and next(iter(seen))[2] == 1


def test_the_first_who_signs_in_after_a_start_waits_alike_known_or_not(school: School) -> None:
    kept, work = PasswordHash((CHEAP,)).hash(PASSWORD), []
    for known in (kept, None):
        passwords, counted = Passwords(CHEAP), Counted()
        passwords._hash = counted  # type: ignore[assignment]
        for _ in range(2):
            assert not school.portal.call(passwords.fits, "wrong", known)
            work.append((counted.made, counted.work))
        passwords.close()
    assert work == [(1, 1), (1, 2)] * 2


def tries(browser: TestClient, login: str, number: int) -> list[int]:
    bodies = ({"login": login, "password": f"guess {i}"} for i in range(number))
    return [browser.post("/api/v1/sessions", json=body).status_code for body in bodies]


def test_guessing_one_password_is_stopped_with_a_countdown(school: School) -> None:
    browser, burst = school.browser(), int(TRIES.burst)
    assert tries(browser, "student", burst + 1) == [401] * burst + [429]
    page = browser.post("/signin", data={"login": "student", "password": "x"}, headers=EN)
    assert page.status_code == 429 and "data-countdown" in page.text and "Wait" in page.text
    assert int(page.headers["retry-after"]) >= 1


def test_a_right_password_in_a_flood_waits_as_well(school: School) -> None:
    browser = school.browser()
    tries(browser, "student", int(TRIES.burst))
    right = browser.post("/api/v1/sessions", json={"login": "student", "password": PASSWORD})
    assert right.status_code == 429


def test_a_stranger_does_not_lock_out_a_browser_that_knows_the_person(school: School) -> None:
    own = school.browser("student")
    own.post("/signout")
    assert tries(school.browser(), "student", int(TRIES.burst) + 1)[-1] == 429
    form = {"login": "student", "password": PASSWORD}
    assert own.post("/signin", data=form).headers["location"] == "/home"
    stranger = school.browser()
    stranger.cookies.set(identity.KNOWN, own.cookies[identity.KNOWN].partition(".")[0] + "." + "0" * 64)
    assert stranger.post("/signin", data=form).status_code == 429


def test_trying_one_password_on_many_is_stopped(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(identity, "ALL_TRIES", Rate(5, 1e-6))
    browser = school.browser()
    assert [tries(browser, f"s{number}", 1)[0] for number in range(6)] == [401] * 5 + [429]
    assert TRIES_FROM_ANYWHERE.refill <= 0.1  # 8,640 guesses a day, from however many addresses


def test_taking_a_place_by_a_course_code_is_guessing_too(school: School) -> None:
    form = {"code": "KX49-2MQT", "login": "student", "name": "S", "password": "another password"}
    browser = school.browser()
    replies = [browser.post("/api/v1/join", json=form) for _ in range(int(TRIES.burst) + 1)]
    assert [reply.status_code for reply in replies] == [409] * int(TRIES.burst) + [429]
