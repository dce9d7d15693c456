"""Administrators find people, change roles, close accounts, make links and end sessions."""

from __future__ import annotations

import pytest

from server.people import everybody
from server.storage.people import Person
from tests.server.school import NOW, PASSWORD, School

EN = {"accept-language": "en", "accept": "text/html"}


@pytest.mark.parametrize(
    ("sought", "names"),
    [("stud", ["Student"]), ("TUD", ["Student"]), ("żak", ["Olga Żak"]), ("olga ż", ["Olga Żak"]), ("%", []), ("_", []),
     ("100", ["Olga Żak"]), ("nobody", [])],
)  # fmt: skip
def test_people_are_found_by_login_or_name(school: School, sought: str, names: list[str]) -> None:
    school.portal.call(school.bench.people.add, Person("NNNN-NNNN-NNNN", "100234", "Olga Żak", "student", NOW))
    found = school.browser("administrator").get("/api/v1/people", params={"q": sought}).json()
    assert [one["name"] for one in found["people"]] == names
    page = school.browser("administrator").get("/people", params={"q": sought}, headers=EN).text
    assert all(name in page for name in names) and ("Nobody found" in page) == (not names)


def test_many_people_come_page_by_page(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(everybody, "AT_ONCE", 3)
    browser, seen, following = school.browser("administrator"), [], "/api/v1/people?q="
    while following:
        part = browser.get(following).json()
        seen += [one["login"] for one in part["people"]]
        following = part["next"]
    assert sorted(seen) == sorted(school.people) and len(seen) == len(set(seen))
    second = browser.get("/people?page=2", headers=EN).text
    assert "Previous page" in second and "Next page" in second and 'href="/people?q=&amp;page=3"' in second


def test_a_role_is_given_and_taken(school: School) -> None:
    boss, student = school.browser("administrator"), school.browser("student")
    page = f"/people/{school.people['student']}"
    assert boss.post(page, data={"role": "lecturer"}).status_code == 303
    assert student.get("/api/v1/me").json()["role"] == "lecturer"
    assert boss.patch(f"/api/v1{page}", json={"role": "student"}).json()["role"] == "student"
    assert student.post("/api/v1/courses", json={"title": "Mine"}).status_code == 403
    assert boss.post(page, data={"role": "dean"}).status_code == 422
    assert boss.patch(f"/api/v1{page}", json={"role": "dean"}).status_code == 422
    own = f"/people/{school.people['administrator']}"
    for body in ({"role": "student"}, {"active": False}):
        assert boss.patch(f"/api/v1{own}", json=body).json()["error"]["code"] == "own_role"
    assert 'name="role"' not in boss.get(own).text and 'name="active"' not in boss.get(own).text


def test_a_closed_account_is_shut_until_it_is_opened(school: School) -> None:
    boss, other = school.browser("administrator"), school.browser("other")
    token = other.post("/api/v1/tokens", json={"name": "ci"}).json()["token"]
    page, bearer = f"/people/{school.people['other']}", {"authorization": f"Bearer {token}"}
    assert boss.post(page, data={"active": "no"}).status_code == 303
    assert other.get("/api/v1/me").status_code == 401
    assert school.browser().get("/api/v1/me", headers=bearer).status_code == 401
    signing = {"login": "other", "password": PASSWORD}
    assert school.browser().post("/api/v1/sessions", json=signing).json()["error"]["code"] == "wrong_sign_in"
    assert boss.post(f"/api/v1{page}/link").json()["error"]["code"] == "closed_account"
    assert boss.patch(f"/api/v1{page}", json={"active": True}).json()["active"] is True
    assert school.browser().post("/api/v1/sessions", json=signing).status_code == 201


def test_sessions_tokens_and_links_end_together(school: School) -> None:
    boss, other = school.browser("administrator"), school.browser("other")
    token = other.post("/api/v1/tokens", json={"name": "ci"}).json()["token"]
    page = f"/people/{school.people['other']}"
    made = boss.post(f"{page}/link", headers=EN).text
    path = made.split('<code class="wrap-anywhere">')[1].split("<")[0].removeprefix(school.bench.settings.address)
    assert school.browser().get(path).status_code == 200
    shown = boss.get(f"/api/v1{page}").json()
    assert (shown["sessions"], shown["tokens"], [one["title"] for one in shown["courses"]]) == (1, 1, ["TMM"])
    assert boss.delete(f"/api/v1{page}/sessions").status_code == 204
    assert other.get("/api/v1/me").status_code == 401 and school.browser().get(path).status_code == 404
    assert school.browser().get("/api/v1/me", headers={"authorization": f"Bearer {token}"}).status_code == 401
    acts = school.portal.call(school.bench.audit.lines, None, None, 2)
    assert [line.entry.action for line in acts] == ["sessions_ended", "link_made"]
