"""How students of a roster come in: by personal links, or by the course code where the lecturer lets it."""

from __future__ import annotations

import csv
import io

import pytest
from starlette.testclient import TestClient

from server.storage.people import Person
from tests.server.school import CODE, NOW, PASSWORD, School

EN = {"accept-language": "en", "accept": "text/html"}
NEW = {"login": "2001", "name": "Somebody Else", "password": "a lever and a place"}


@pytest.fixture
def lecturer(school: School) -> TestClient:
    """The lecturer, whose roster names 2001 and 2002, who have never signed in."""
    found = school.browser("lecturer")
    body = {"csv": "2002,Jan,B\n2001,Olga Żak,A", "apply": True}
    assert found.post(f"/api/v1/courses/{school.course}/roster", json=body).json()["applied"]
    return found


def member(lecturer: TestClient, school: School, login: str = "2001") -> dict[str, object]:
    members = lecturer.get(f"/api/v1/courses/{school.course}/members").json()
    (found,) = [one for one in members if one["login"] == login]
    assert isinstance(found, dict)
    return found


def test_the_course_code_gives_no_place_of_the_roster_away(school: School, lecturer: TestClient) -> None:
    reply = school.browser().post(f"/join/{CODE}", data=NEW, headers=EN)
    assert reply.status_code == 409 and "use the personal link from your lecturer" in reply.text
    assert member(lecturer, school)["signed_up"] is False
    assert "by a personal link" in lecturer.get(f"/courses/{school.course}", headers=EN).text


def test_where_the_lecturer_lets_it_a_claim_is_seen_and_taken_back(school: School, lecturer: TestClient) -> None:
    page = f"/courses/{school.course}"
    assert lecturer.post(f"{page}/claims", data={"open": "yes"}).status_code == 303
    browser = school.browser()
    assert browser.post(f"/join/{CODE}", data=NEW).status_code == 303
    token = browser.post("/api/v1/tokens", json={"name": "ci"}).json()["token"]
    taken = member(lecturer, school)
    assert (taken["name"], taken["signed_up"]) == ("Olga Żak", True) and taken["claimed"]
    assert school.browser().post(f"/join/{CODE}", data=NEW).status_code == 409
    assert "By course code, " in lecturer.get(page, headers=EN).text
    assert lecturer.post(f"{page}/members/{taken['id']}/unclaim").status_code == 303
    assert browser.get("/api/v1/me").status_code == 401
    assert browser.get("/api/v1/me", headers={"authorization": f"Bearer {token}"}).status_code == 401
    assert (member(lecturer, school)["signed_up"], member(lecturer, school)["claimed"]) == (False, None)
    again = lecturer.post(f"/api/v1{page}/members/{taken['id']}/unclaim")
    assert (again.status_code, again.json()["error"]["code"]) == (404, "unclaimed")
    shut = lecturer.post(f"/api/v1{page}/claims", json={"open": False})
    assert shut.json()["claims"] is False
    assert school.browser().post(f"/join/{CODE}", data=NEW).status_code == 409


def test_a_code_gives_away_no_place_on_the_roster_of_another_course(school: School, lecturer: TestClient) -> None:
    stranger = school.browser("stranger")
    own = stranger.get("/api/v1/courses").json()[0]["id"]
    assert stranger.post(f"/api/v1/courses/{own}/claims", json={"open": True}).json()["claims"]
    assert school.browser().post("/join/ZZZZ-0000", data=NEW).status_code == 409


def test_personal_links_of_all_come_as_a_table(school: School, lecturer: TestClient) -> None:
    reply = lecturer.post(f"/courses/{school.course}/links", headers=EN)
    assert reply.headers["content-disposition"] == 'attachment; filename="links.csv"'
    assert reply.content.startswith(b"\xef\xbb\xbf") and reply.headers["cache-control"] == "no-store"
    head, *rows = csv.reader(io.StringIO(reply.content.decode("utf-8-sig")))
    assert head == ["Index number or e-mail", "Name", "Group", "Personal link"]
    assert [row[:3] for row in rows] == [["2001", "Olga Żak", "A"], ["2002", "Jan", "B"]]
    path = rows[0][3].removeprefix(school.bench.settings.address)
    assert school.browser().post(path, data={"password": PASSWORD}).headers["location"] == "/home"
    again = lecturer.post(f"/api/v1/courses/{school.course}/links").json()
    assert [one["login"] for one in again] == ["2002"]
    older = rows[1][3].removeprefix(school.bench.settings.address)
    assert school.browser().get(older).status_code == 404  # the newer link has ended it


def test_nobody_who_may_do_more_is_among_them(school: School, lecturer: TestClient) -> None:
    dean = Person("NNNN-NNNN-NNNN", "dean", "Dean", "lecturer", NOW)
    assert school.portal.call(school.bench.people.add, dean)
    for login in ("dean", "stranger", "student"):
        body = {"csv": f"{login},X,", "apply": True}
        lecturer.post(f"/api/v1/courses/{school.course}/roster", json=body)
    links = lecturer.post(f"/api/v1/courses/{school.course}/links").json()
    assert [one["login"] for one in links] == ["2001", "2002"]
