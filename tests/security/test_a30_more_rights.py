"""A30: neither invitation nor import, link, role change or token gives anybody more than was meant."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from tests.server.school import CODE, PASSWORD, School
from tests.server.sets.conftest import Course


def members(school: School) -> dict[str, str]:
    found = school.browser("administrator").get(f"/api/v1/courses/{school.course}/members").json()
    return {member["login"]: member["role"] for member in found}


@pytest.mark.parametrize("more", [{"role": "lecturer"}, {"course_role": "lecturer"}, {"id": "x"}])
def test_who_joins_is_a_student(school: School, more: dict[str, str]) -> None:
    form = {"code": CODE, "login": "2001", "name": "Olga", "password": "a lever and a place"}
    browser = school.browser()
    assert browser.post("/api/v1/join", json=form | more).json()["error"]["code"] == "extra_field"
    assert browser.post(f"/join/{CODE}", data=form | more).status_code == 303
    assert browser.get("/api/v1/me").json()["role"] == "student" and members(school)["2001"] == "student"


def test_joining_again_changes_no_role(school: School) -> None:
    assert school.browser("lecturer").post("/api/v1/join", json={"code": CODE}).status_code == 201
    assert members(school)["lecturer"] == "lecturer"


def test_a_roster_makes_students_and_changes_no_role(school: School) -> None:
    place, lecturer = f"/api/v1/courses/{school.course}/roster", school.browser("lecturer")
    roster = "login;name;group;role\n4001;Ewa;A;lecturer\nassistant;A;A\nadministrator;Boss;A;administrator"
    without_headings = "4001;Ewa;lecturer\nassistant;A;A\nadministrator;Boss;administrator"
    for csv in (roster, without_headings):
        assert lecturer.post(place, json={"csv": csv, "apply": True}).status_code == 200
    roles = {"lecturer": "lecturer", "assistant": "assistant"}
    others = ("student", "other", "leaver", "4001", "administrator")
    assert members(school) == roles | dict.fromkeys(others, "student")


def test_no_link_leads_into_an_account_with_more_rights(school: School) -> None:
    lecturer, place = school.browser("lecturer"), f"/api/v1/courses/{school.course}"
    everybody = "administrator;B\nstranger;S\nassistant;A\noutsider;O"
    assert lecturer.post(f"{place}/roster", json={"csv": everybody, "apply": True}).status_code == 200
    for who in ("administrator", "stranger", "assistant", "lecturer"):
        reply = lecturer.post(f"{place}/members/{school.people[who]}/link")
        assert (reply.status_code, reply.json()["error"]["code"]) == (403, "no_reset"), who
    assert lecturer.post(f"{place}/members/{school.people['leaver']}/link").status_code == 201


def test_an_account_of_a_roster_with_more_rights_is_not_claimed_by_a_code(school: School) -> None:
    roster = {"csv": "administrator;B", "apply": True}
    assert school.browser("lecturer").post(f"/api/v1/courses/{school.course}/roster", json=roster).status_code == 200
    form = {"login": "administrator", "name": "B", "password": "another password"}
    assert school.browser().post(f"/join/{CODE}", data=form).status_code == 409
    assert school.browser("administrator").get("/api/v1/me").status_code == 200


@pytest.mark.parametrize(("who", "code"), [("student", "forbidden"), ("assistant", "forbidden"),
                                           ("lecturer", "own_role")])  # fmt: skip
def test_nobody_changes_the_own_role(school: School, who: str, code: str) -> None:
    browser, mine = school.browser(who), f"/courses/{school.course}/members/{school.people[who]}"
    role = "student" if who == "lecturer" else "lecturer"
    assert browser.patch(f"/api/v1{mine}", json={"role": role}).json()["error"]["code"] == code
    assert browser.post(mine, data={"role": role}).json()["error"]["code"] == code
    assert browser.delete(f"/api/v1{mine}").json()["error"]["code"] == code


def test_a_lecturer_of_a_course_is_no_lecturer_of_the_server(school: School) -> None:
    place = f"/api/v1/courses/{school.course}/members/{school.people['student']}"
    assert school.browser("lecturer").patch(place, json={"role": "lecturer"}).status_code == 200
    browser = school.browser("student")
    assert browser.get(f"/api/v1/courses/{school.course}/members").status_code == 200
    assert browser.post("/api/v1/courses", json={"title": "Mine"}).status_code == 403
    assert browser.post("/api/v1/compare", json={}).status_code == 403


def test_copying_a_course_starts_one_and_needs_the_right_to_do_so(school: School) -> None:
    """Who lectures one course only does not become a lecturer of new ones by copying it."""
    place = f"/api/v1/courses/{school.course}"
    promoted = school.browser("lecturer").patch(
        f"{place}/members/{school.people['student']}", json={"role": "lecturer"}
    )
    assert promoted.status_code == 200
    browser, body = school.browser("student"), {"title": "Mine", "days": 7}
    assert browser.post(f"{place}/copy", json=body).json()["error"]["code"] == "forbidden"
    assert browser.post(f"/courses/{school.course}/copy", data=body).json()["error"]["code"] == "forbidden"
    assert [course["title"] for course in browser.get("/api/v1/courses").json()] == ["TMM"]
    assert school.browser("assistant").post(f"{place}/copy", json=body).status_code == 403
    assert school.browser("lecturer").post(f"{place}/copy", json=body).status_code == 201


def test_a_token_has_no_more_rights_and_makes_no_tokens(school: School) -> None:
    student, lecturer = school.browser("student"), school.browser("lecturer")
    for role in ("lecturer", "administrator", "anonymous", "dean"):
        assert student.post("/api/v1/tokens", json={"name": "x", "role": role}).status_code == 403
        assert student.post("/account/tokens", data={"name": "x", "role": role, "days": "1"}).status_code == 403
    token = lecturer.post("/api/v1/tokens", json={"name": "x", "role": "student"}).json()["token"]
    bearer = {"authorization": f"Bearer {token}"}
    again = school.browser().post("/api/v1/tokens", json={"name": "y", "role": "student"}, headers=bearer)
    assert again.status_code == 403
    old = {"old": PASSWORD, "password": "another password"}
    assert school.browser().post("/account/password", data=old, headers=bearer).status_code == 403


def roster(browser: TestClient, course: str, login: str) -> None:
    body = {"csv": f"{login};X", "apply": True}
    assert browser.post(f"/api/v1/courses/{course}/roster", json=body).json()["applied"]


def test_a_roster_does_not_open_the_account_of_a_student_of_another_course(school: School) -> None:
    """Naming somebody's index number must not be a way to that person's password."""
    stranger = school.browser("stranger")
    own = stranger.get("/api/v1/courses").json()[0]["id"]
    roster(stranger, own, "student")
    for place in (f"/api/v1/courses/{own}", f"/courses/{own}"):
        reply = stranger.post(f"{place}/members/{school.people['student']}/link")
        assert (reply.status_code, reply.json()["error"]["code"]) == (403, "no_reset_elsewhere")
    assert school.browser("student").get("/api/v1/me").status_code == 200
    own_lecturer = school.browser("lecturer").post(f"/courses/{school.course}/members/{school.people['student']}/link")
    assert own_lecturer.json()["error"]["code"] == "no_reset_elsewhere"  # from now on two lecturers share the student
    helped = school.browser("administrator").post(f"/courses/{own}/members/{school.people['student']}/link")
    assert helped.status_code == 200 and "/links/" in helped.text


def test_a_roster_does_not_open_an_account_that_was_there_before(school: School) -> None:
    """Also who is in no course practises; joining while signed in says that one trusts this lecturer."""
    lecturer, place = school.browser("lecturer"), f"/api/v1/courses/{school.course}"
    roster(lecturer, school.course, "outsider")
    link = f"{place}/members/{school.people['outsider']}/link"
    assert lecturer.post(link).json()["error"]["code"] == "no_reset_elsewhere"
    assert school.browser("outsider").post("/api/v1/join", json={"code": CODE}).status_code == 201
    assert lecturer.post(link).status_code == 201


def test_a_link_ends_when_its_student_joins_another_course(school: School) -> None:
    """A link made while the student was nowhere else must not outlive that."""
    lecturer, stranger = school.browser("lecturer"), school.browser("stranger")
    student = school.people["student"]
    link = lecturer.post(f"/api/v1/courses/{school.course}/members/{student}/link").json()["link"]
    path = link.removeprefix(school.bench.settings.address)
    assert school.browser().get(path).status_code == 200
    roster(stranger, stranger.get("/api/v1/courses").json()[0]["id"], "student")
    assert school.browser().get(path).status_code == 404


def test_taking_a_place_back_is_no_way_round(school: School) -> None:
    """Taking a claimed place back and making a first link for it would open what was done elsewhere."""
    lecturer, stranger = school.browser("lecturer"), school.browser("stranger")
    roster(lecturer, school.course, "2001")
    lecturer.post(f"/api/v1/courses/{school.course}/claims", json={"open": True})
    new = {"code": CODE, "login": "2001", "name": "Olga", "password": PASSWORD}
    person = school.browser().post("/api/v1/join", json=new).json()["id"]
    roster(stranger, stranger.get("/api/v1/courses").json()[0]["id"], "2001")
    reply = lecturer.post(f"/api/v1/courses/{school.course}/members/{person}/unclaim")
    assert (reply.status_code, reply.json()["error"]["code"]) == (403, "no_reset_elsewhere")


def test_who_was_taken_out_of_a_course_works_in_its_sets_no_more(course: Course) -> None:
    number = course.published(rules={"ladder": True, "hint_price": 0.2}, item={"attempts": None})
    variant, place = course.variant(number), f"/api/v1/courses/{course.school.course}/members"
    handed = course.hand_in(variant, {"l3": "9 m"}, "first").json()["receipt"]["id"]
    person = course.school.people["student"]
    assert course.lecturer.delete(f"{place}/{person}").status_code == 204
    for refused in (
        course.hand_in(variant, {"l3": "1 m"}),
        course.student.post(f"/variants/{variant}", data={"answer.l3": "1 m"}),
        course.student.post(f"/variants/{variant}/hints", data={"answer": "l3", "rung": "1"}),
    ):
        assert (refused.status_code, refused.json()["error"]["code"]) == (403, "left_course")
    assert course.student.get(f"/api/v1/submissions/{handed}").status_code == 200  # what was handed in stays theirs
    assert course.hand_in(variant, {"l3": "9 m"}, "first").status_code == 200
    roster = {"csv": "student;Student", "apply": True}
    assert course.lecturer.post(f"/api/v1/courses/{course.school.course}/roster", json=roster).status_code == 200
    assert course.hand_in(variant, {"l3": "1 m"}).status_code == 201
