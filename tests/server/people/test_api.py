"""People sign in, join, come back and go; pages and programs alike."""

from __future__ import annotations

import re

import pytest
from starlette.testclient import TestClient

from server.app import create_app
from server.people import accounts, identity
from server.people.passwords import Passwords
from server.settings import Settings
from server.web.language import LANGUAGES
from tests.server.school import CHEAP, CODE, PASSWORD, School

EN = {"accept-language": "en", "accept": "text/html"}
NEW = {"login": " 2001 ", "name": "Olga  Nowa", "password": "a lever and a place"}


def link_of(school: School, page: str) -> str:
    found = re.search(rf"{re.escape(school.bench.settings.address)}(/links/[\w-]+)", page)
    assert found is not None
    return found[1]


def test_the_first_link_makes_the_first_administrator_and_no_second(settings: Settings, school: School) -> None:
    link = school.portal.call(identity.make_link, school.bench.people, settings, "first", "server")
    path = link.removeprefix(settings.address)
    assert school.browser().post(path, data=NEW).status_code == 404  # the school has an administrator
    assert accounts.first_link(settings) is None


def test_a_fresh_server_lets_its_first_administrator_in_by_a_link(settings: Settings) -> None:
    first, second = accounts.first_link(settings), accounts.first_link(settings)
    assert first and second
    with TestClient(create_app(settings, passwords=Passwords(CHEAP)), follow_redirects=False) as client:
        assert client.get(first.removeprefix(settings.address)).status_code == 404
        path = second.removeprefix(settings.address)
        assert "administrator" in client.get(path, headers=EN).text
        weak = client.post(path, data=NEW | {"password": "2001"}, headers=EN)
        assert weak.status_code == 422 and 'role="alert"' in weak.text and 'value="Olga  Nowa"' in weak.text
        assert client.post(path, data=NEW).headers["location"] == "/home"
        assert client.get("/api/v1/me").json()["role"] == "administrator"
        assert client.get(path).status_code == 404


def test_a_course_link_signs_a_student_up_and_in(school: School) -> None:
    browser = school.browser()
    assert browser.get("/join?code=kx49-2mqt").headers["location"] == f"/join/{CODE}"
    assert "TMM" in browser.get(f"/join/{CODE}").text
    reply = browser.post(f"/join/{CODE}", data=NEW)
    assert (reply.status_code, reply.headers["location"]) == (303, "/home")
    assert browser.get("/api/v1/me").json() | {"id": ""} == {
        "id": "", "login": "2001", "name": "Olga Nowa", "role": "student",
    }  # fmt: skip
    assert [course["role"] for course in browser.get("/api/v1/courses").json()] == ["student"]
    assert "TMM" in browser.get("/home").text
    assert school.browser().get("/join/NONE-0000").status_code == 404


def test_somebody_signed_in_joins_with_one_button(school: School) -> None:
    browser = school.browser("outsider")
    assert 'name="password"' not in browser.get(f"/join/{CODE}").text
    assert browser.post(f"/join/{CODE}", data={"name": ""}).status_code == 303
    assert browser.get(f"/courses/{school.course}").status_code == 200


def test_a_login_that_is_taken_is_not_signed_up_again(school: School) -> None:
    browser = school.browser()
    reply = browser.post(f"/join/{CODE}", data=NEW | {"login": "Outsider"}, headers=EN)
    assert reply.status_code == 409 and "If you have an account, sign in" in reply.text
    assert browser.get("/api/v1/me").status_code == 401
    assert school.browser("outsider").get("/api/v1/courses").json() == []


def test_a_lecturer_replaces_a_forgotten_password_by_a_link(school: School) -> None:
    old, fresh = school.browser("student"), school.browser()
    page = school.browser("lecturer").post(f"/courses/{school.course}/members/{school.people['student']}/link").text
    path = link_of(school, page)
    assert "Student" in fresh.get(path).text
    assert fresh.post(path, data={"password": "another password"}).headers["location"] == "/home"
    assert fresh.get("/api/v1/me").json()["login"] == "student"
    assert old.get("/api/v1/me").status_code == 401
    again = {"login": "student", "password": PASSWORD}
    assert school.browser().post("/api/v1/sessions", json=again).status_code == 401


def test_pages_ask_to_sign_in_and_come_back(school: School) -> None:
    browser = school.browser()
    reply = browser.get("/account", headers=EN)
    assert (reply.status_code, reply.headers["location"]) == (303, "/signin?next=/account")
    assert 'value="/account"' in browser.get(reply.headers["location"]).text
    form = {"login": "STUDENT", "password": PASSWORD, "next": "/account"}
    assert browser.post("/signin", data=form).headers["location"] == "/account"
    for elsewhere in ("https://evil.example", "//evil.example", "/\\evil.example", "", "/\n/evil.example"):
        assert browser.post("/signin", data=form | {"next": elsewhere}).headers["location"] == "/home"
    reply = browser.post("/signout")
    assert (reply.status_code, reply.headers["clear-site-data"]) == (303, '"storage"')
    assert browser.get("/api/v1/me").status_code == 401


def test_sessions_are_listed_and_ended(school: School) -> None:
    one, other = school.browser("student"), school.browser("student")
    listed = one.get("/api/v1/sessions").json()
    assert sorted(session["current"] for session in listed) == [False, True]
    theirs = next(session["id"] for session in listed if not session["current"])
    assert school.browser("other").delete(f"/api/v1/sessions/{theirs}").status_code == 404
    assert one.delete(f"/api/v1/sessions/{theirs}").status_code == 204
    assert other.get("/api/v1/me").status_code == 401 and one.get("/api/v1/me").status_code == 200
    assert one.delete("/api/v1/sessions/current").status_code == 204
    assert one.get("/api/v1/me").status_code == 401


def test_a_new_password_ends_the_other_sessions(school: School) -> None:
    one, other = school.browser("student"), school.browser("student")
    wrong = one.post("/account/password", data={"old": "x", "password": "another password"})
    assert wrong.status_code == 401 and 'role="alert"' in wrong.text
    form = {"old": PASSWORD, "password": "another password"}
    assert one.post("/account/password", data=form).status_code == 303
    assert one.get("/api/v1/me").status_code == 200 and other.get("/api/v1/me").status_code == 401


def test_language_and_appearance_stay_with_the_person(school: School) -> None:
    school.browser("student").post("/account", data={"language": "ru", "theme": "dark"})
    browser = school.browser()
    browser.post("/signin", data={"login": "student", "password": PASSWORD})
    assert '<html lang="ru" data-theme="dark"' in browser.get("/home").text


def test_practice_before_signing_in_is_taken_over_on_request(school: School) -> None:
    browser = school.browser()
    variant = browser.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
    receipt = browser.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"l3": "1 mm"}}).json()
    browser.post("/signin", data={"login": "student", "password": PASSWORD})
    assert browser.get(f"/variants/{variant}").status_code == 404
    assert "/account/practice" in browser.get("/home").text
    assert browser.post("/account/practice").status_code == 303
    assert "/account/practice" not in browser.get("/home").text
    elsewhere = school.browser("student")
    assert elsewhere.get(f"/variants/{variant}").status_code == 200
    assert elsewhere.get(f"/api/v1/submissions/{receipt['receipt']['id']}").json()["answers"] == {"l3": "1 mm"}
    assert school.browser("lecturer").get(f"/variants/{variant}").status_code == 200
    assert school.browser("stranger").get(f"/variants/{variant}").status_code == 404


def test_a_token_does_what_it_was_made_for_until_it_is_revoked(school: School) -> None:
    lecturer, program = school.browser("lecturer"), school.browser()
    made = lecturer.post("/api/v1/tokens", json={"name": "ci", "role": "student", "days": 1}).json()
    program.headers["authorization"] = f"Bearer {made['token']}"
    assert program.get("/api/v1/me").json()["login"] == "lecturer"
    assert program.get(f"/api/v1/courses/{school.course}").json()["role"] == "student"
    assert program.get(f"/api/v1/courses/{school.course}/members").status_code == 403
    assert program.post("/api/v1/compare", content=b"{}").status_code == 403
    assert made["token"] not in lecturer.get("/account").text and "ci" in lecturer.get("/account").text
    assert lecturer.post(f"/account/tokens/{made['id']}").status_code == 303
    assert program.get("/api/v1/me").status_code == 401


def test_a_lecturer_runs_a_course(school: School) -> None:
    lecturer = school.browser("lecturer")
    made = lecturer.post("/courses", data={"title": "Statics", "language": "en", "time_zone": "Asia/Tomsk"})
    page = made.headers["location"]
    assert lecturer.post(f"{page}/groups", data={"name": "Tuesday"}).status_code == 303
    assert lecturer.post(f"{page}/groups", data={"name": "Tuesday"}).status_code == 409
    text = "Nr indeksu;Imię;Grupa\n3001;Ewa;Tuesday\n3002;Jan;Friday\n\n3002;Jan;Tuesday\n3003;=1+1;\n3004"
    shown = lecturer.post(f"{page}/roster", data={"roster": text}, headers=EN).text
    assert all(f"line {number}:" in shown for number in (5, 6, 7)) and 'name="apply"' not in shown
    refused = lecturer.post(f"{page}/roster", data={"roster": text, "apply": "yes"})
    assert refused.json()["error"]["code"] == "unread_roster"
    good = "\n".join(text.splitlines()[:3])
    assert 'value="yes">Apply changes: 2<' in lecturer.post(f"{page}/roster", data={"roster": good}, headers=EN).text
    assert "3001" not in lecturer.get(page).text
    assert lecturer.post(f"{page}/roster", data={"roster": good, "apply": "yes"}).status_code == 303
    seen = lecturer.get(page).text
    assert "3001" in seen and "Friday" in seen
    person = re.search(r"members/([\w-]+)/link", seen)
    assert person is not None
    assert "/links/" in lecturer.post(f"{page}/members/{person[1]}/link").text
    assert lecturer.post(f"{page}/members/{person[1]}", data={"role": "assistant", "group": ""}).status_code == 303
    assert lecturer.post(f"{page}/members/{person[1]}", data={"leave": "yes"}).status_code == 303
    assert lecturer.post(f"{page}/members/{person[1]}", data={"role": "student"}).status_code == 404
    code = lecturer.get(f"/api/v1{page}").json()["join_code"]
    assert lecturer.post(f"{page}/code", data={"open": "yes"}).status_code == 303
    assert school.browser().get(f"/join/{code}").status_code == 404
    lecturer.post(f"{page}/code", data={"open": "no"})
    assert lecturer.get(f"/api/v1{page}").json()["join_code"] is None


@pytest.mark.parametrize("zone", ["Mars/Olympus", "../../etc/passwd", "", "\0"])
def test_a_time_zone_that_is_none_is_refused(school: School, zone: str) -> None:
    body = {"title": "Statics", "time_zone": zone}
    assert school.browser("lecturer").post("/api/v1/courses", json=body).status_code == 422


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_page_is_worded_in_every_language(school: School, language: str) -> None:
    lecturer = school.browser("lecturer")
    for path in ("/home", "/account", f"/courses/{school.course}"):
        page = lecturer.get(f"{path}?lang={language}")
        assert page.status_code == 200 and f'<html lang="{language}"' in page.text
        assert not re.search(r"\sstyle=|\son\w+=|<style", page.text)
        named = set(re.findall(r'<label[^>]* for="([^"]+)"', page.text))
        for field in re.findall(r"<(?:input|textarea|select)[^>]*>", page.text):
            own = re.search(r' id="([^"]+)"', field)
            assert "hidden" in field or "aria-label" in field or (own and own[1] in named), field
    for path in ("/signin", f"/join/{CODE}"):
        assert school.browser().get(f"{path}?lang={language}").status_code == 200
