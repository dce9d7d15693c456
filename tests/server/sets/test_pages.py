"""The pages of sets work as plain forms: publish, open, answer, see the points, move deadlines."""

from __future__ import annotations

import re
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest

from tests.server.sets.builder import fields, saved, started
from tests.server.sets.conftest import EXERCISE, Course, moment


def test_a_set_is_built_published_and_answered_without_script(course: Course) -> None:
    path, lecturer, student = started(course), course.lecturer, course.student
    saved(lecturer, path, add="planetary")
    page = saved(lecturer, path, add=EXERCISE, **{"slot.1.points": "2,5"})
    assert fields(page.text)["slot.1.points"] == "2.5" and 'value="planetary"' in page.text
    home = f"/courses/{course.school.course}"
    assert 0 < page.text.index(f'href="{home}"') < page.text.index(f'href="{home}/sets"')  # the way back, widest first
    page = saved(lecturer, path, move="2", **{"slot.2.limits": "l1 0,05000001 0,08", "slot.2.attempts": "2"})
    assert fields(page.text)["slot.1.limits"] == "l1 0.05000001 0.08"
    page = saved(lecturer, path, remove="2", due="2030-01-31T12:00")
    assert "slot.2.pool" not in fields(page.text) and "31 Jan 2030, 12:00" in page.text
    assert student.get(path).status_code == 404
    page = saved(lecturer, path, then="publish")
    assert 'name="then"' not in page.text and "sheets.pdf" in page.text
    assert "Set 7" in student.get(f"/courses/{course.school.course}/sets").text
    opened = student.post(f"{path}/items/1", data={"another": "no"})
    workspace = student.get(opened.headers["location"] + "?lang=en")
    assert "Check answers (attempt 1 of 2)" in workspace.text and "31 Jan 2030, 12:00" in workspace.text
    code = course.card(path.rsplit("/", 1)[1]).code
    assert code in workspace.text and code in student.get(path).text
    graded = student.post(opened.headers["location"], data={"answer.l3": "1 m"})
    assert graded.status_code == 303, graded.text
    workspace = student.get(graded.headers["location"].split("#")[0] + "&lang=en")
    assert "Check answers (attempt 2 of 2)" in workspace.text and "1 of 2" in workspace.text
    assert re.search(r"<small data-left=[^>]*>\d+ d \d+ h left</small>", workspace.text)


def test_all_open_deadlines_of_a_course_move_together(course: Course) -> None:
    one, other, page = course.published(), course.published(), f"/courses/{course.school.course}"
    closed = course.published()
    course.move(closed, hours=3)
    before = {number: due(course, number) for number in (one, other, closed)}
    form = {"minutes": " 15 ", "seen": seen(course, page)}
    reply = course.lecturer.post(f"{page}/extend", data=form)
    onward, at = reply.headers["location"].split("#")
    moved = int(onward.removeprefix(f"{page}?moved="))
    told = course.lecturer.get(f"{onward}&lang=en").text
    assert f"Sets moved: {moved}." in told and moved >= 2 and f'id="{at}"' in told
    assert due(course, one) - before[one] == due(course, other) - before[other] == timedelta(minutes=15)
    assert due(course, closed) == before[closed]
    again = course.lecturer.post(f"{page}/extend", data=form)  # a second click
    assert (again.status_code, again.json()["error"]["code"]) == (409, "deadlines_moved")
    assert due(course, one) - before[one] == timedelta(minutes=15)
    for minutes in ("0", "-5", "x", "", "1e3", "1000000"):
        assert course.lecturer.post(f"{page}/extend", data={"minutes": minutes}).status_code == 422


def seen(course: Course, page: str) -> str:
    """What the form that moves deadlines says of those it was made for."""
    (found,) = re.findall(r'name="seen" value="(\w+)"', course.lecturer.get(page).text)
    return str(found)


def due(course: Course, number: str) -> datetime:
    return datetime.fromisoformat(course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"])


def test_a_course_is_copied_with_its_sets_and_later_dates_and_nobody(course: Course) -> None:
    number, page = course.published(title="Set to copy"), f"/courses/{course.school.course}"
    reply = course.lecturer.post(f"{page}/copy", data={"title": "TMM next year", "days": "364"})
    fresh = reply.headers["location"]
    sets = course.lecturer.get(f"/api/v1{fresh}/task-sets").json()
    copy = next(one for one in sets if one["title"] == "Set to copy")
    assert copy["state"] == "draft" and len(sets) == len(course.lecturer.get(f"/api/v1{page}/task-sets").json())
    assert timedelta(days=363) < due(course, copy["id"]) - due(course, number) < timedelta(days=365)
    members = course.lecturer.get(f"/api/v1{fresh}/members").json()
    assert [(one["login"], one["role"]) for one in members] == [("lecturer", "lecturer")]
    for form in ({"title": "", "days": "7"}, {"title": "x", "days": "4000"}, {"title": "x"}):
        assert course.lecturer.post(f"{page}/copy", data=form).status_code == 422


def test_a_student_sees_the_rules_and_the_points_before_the_click(course: Course) -> None:
    number = course.published(rules={"mode": "exam", "minutes": 90}, opens=moment(hours=-1))
    page = course.student.get(f"/sets/{number}?lang=en").text
    for said in ("This is an examination", "90 min", "Worth: 10 pt", "Attempts used: 0 of 2", "Open task 1"):
        assert said in page
    path = course.student.post(f"/sets/{number}/items/1", data={"another": "no"}).headers["location"]
    graded = course.student.post(path, data={"answer.l3": "1 m"}).headers["location"].split("#")[0]
    assert "You see the result after the set has closed for everybody." in course.student.get(f"{graded}&lang=en").text


@pytest.mark.parametrize(("rules", "told"), [({}, False), ({"ladder": True}, True)])
def test_the_ladder_of_hints_is_the_sets_to_give_and_closed_in_practice_meanwhile(
    course: Course, rules: dict[str, bool], told: bool
) -> None:
    number = course.published(rules=rules)
    assert ("They cost nothing" in course.student.get(f"/sets/{number}?lang=en").text) is told
    practised = course.student.post(f"/exercises/{EXERCISE}", data={"seed": ""}).headers["location"]
    for path, open_ in ((f"/variants/{course.variant(number)}", told), (practised, False)):
        graded = course.student.post(path, data={"answer.l3": "9 m"}).headers["location"].split("#")[0]
        assert ("Hint: what it follows from" in course.student.get(f"{graded}&lang=en").text) is open_
    course.move(number, hours=1)


def test_a_draft_is_deleted_and_a_published_set_stays(course: Course) -> None:
    page, sets = started(course), f"/courses/{course.school.course}/sets"
    saved(course.lecturer, page, add=EXERCISE, title="Draft to go")
    number = page.rsplit("/", 1)[1]
    given = f"/api/v1/task-sets/{number}/accommodations/{course.school.people['student']}"
    assert course.lecturer.put(given, json={"minutes": 5}).status_code == 200
    assert f'action="{page}/remove"' in course.lecturer.get(page).text
    for who in (course.student, course.school.browser("assistant")):
        assert who.post(f"{page}/remove").status_code == who.delete(f"/api/v1/task-sets/{number}").status_code == 403
    assert course.lecturer.post(f"{page}/remove").headers["location"] == sets
    assert course.lecturer.get(page).status_code == 404 and "Draft to go" not in course.lecturer.get(sets).text
    assert "title: Draft to go" in course.lecturer.get(f"/courses/{course.school.course}/audit?lang=en").text
    published = course.published()
    assert f'action="/sets/{published}/remove"' not in course.lecturer.get(f"/sets/{published}").text
    refused = course.lecturer.delete(f"/api/v1/task-sets/{published}")
    assert (refused.status_code, refused.json()["error"]["code"]) == (409, "set_frozen")
    assert course.lecturer.delete(f"/api/v1/task-sets/{course.built()}").status_code == 204


def test_extra_time_is_given_on_the_page_of_a_student_and_taken_back(course: Course) -> None:
    number, person = course.published(), course.school.people["student"]
    page, given = f"/sets/{number}/students/{person}", f"/api/v1/task-sets/{number}/accommodations"
    for minutes in ("30", "0"):
        reply = course.lecturer.post(f"{page}/time", data={"minutes": minutes, "reason": "<dyslexia>"})
        assert (reply.status_code, reply.headers["location"]) == (303, page)
        assert (
            course.lecturer.get(given).json()
            == [{"person": person, "minutes": int(minutes), "reason": "<dyslexia>"}][: int(minutes)]
        )
        shown = course.lecturer.get(f"{page}?lang=en").text
        assert ("extra time: 30 min" in shown, 'value="&lt;dyslexia&gt;"' in shown) == (minutes == "30",) * 2
    for minutes in ("-1", "x", "", "100001"):
        assert course.lecturer.post(f"{page}/time", data={"minutes": minutes}).status_code == 422
    lecturer = course.school.people["lecturer"]
    assert course.lecturer.post(f"/sets/{number}/students/{lecturer}/time", data={"minutes": "5"}).status_code == 404
    log = course.lecturer.get(f"/courses/{course.school.course}/audit?lang=en").text
    assert "extra time given" in log and "set: Set 4; minutes: 30" in log and number not in log
    assistant = course.school.browser("assistant")
    assert assistant.post(f"{page}/time", data={"minutes": "5"}).status_code == 403
    form = f'action="{page}/time"'
    assert form in course.lecturer.get(page).text and form not in assistant.get(page).text


def test_a_task_of_a_student_is_named_in_the_language_of_who_reads(course: Course) -> None:
    number = course.published()
    course.variant(number)
    page, shown = f"/sets/{number}/students/{course.school.people['student']}", course.card(number).shown
    for language in ("pl", "en", "ru"):
        assert f"1. {shown[language]['title']}</h2>" in course.lecturer.get(f"{page}?lang={language}").text


def test_deadlines_move_and_sets_are_copied_from_the_page(course: Course) -> None:
    number = course.published()
    before = course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"]
    form = {"minutes": "15", "seen": seen(course, f"/sets/{number}")}
    assert [course.lecturer.post(f"/sets/{number}/extend", data=form).status_code for _ in range(2)] == [303, 409]
    assert course.lecturer.get(f"/api/v1/task-sets/{number}").json()["due"] > before
    assert course.lecturer.post(f"/sets/{number}/extend", data={"minutes": "x"}).status_code == 422
    copied = course.lecturer.post(f"/sets/{number}/copy").headers["location"]
    assert 'name="then"' in course.lecturer.get(copied).text


def test_the_page_says_why_nothing_more_can_be_handed_in(course: Course) -> None:
    number = course.published(title="Used up", item={"exercise": "slider_crank", "attempts": 1})
    variant = course.variant(number)
    path, button = f"/variants/{variant}?lang=en", 'data-sending="Checking…"'
    page = course.student.get(path).text
    assert "An unreadable answer costs nothing." in page and f"{button}>" in page
    page = course.lecturer.get(path).text
    assert "only the student can hand in" in page and button not in page
    course.hand_in(variant, {"l3": "1 mm"})
    page = course.student.get(path).text
    assert "The attempts of this task are used up." in page and f"{button} disabled" in page
    course.date(number, datetime.now(UTC) - timedelta(hours=2), datetime.now(UTC) - timedelta(hours=1))
    assert "This set is closed." in course.student.get(path).text


def test_an_examination_takes_nothing_that_it_could_not_read_and_says_so(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    place = f"/variants/{course.variant(number)}"
    typed = {"answer.alpha2": "12 deg", "answer.l3": "10 mm /"}
    refused = course.student.post(place, data=typed, follow_redirects=True).text
    assert "Your answers are not taken yet: mend what could not be read" in refused and "Not read" in refused
    assert "Your answers are taken" not in refused and "No attempt was counted." in refused
    taken = course.student.post(place, data={**typed, "answer.l3": "10 mm"}, follow_redirects=True).text
    assert "Your answers are taken" in taken and "not taken yet" not in taken


@pytest.mark.parametrize(("rules", "shown"), [({}, True), ({"mode": "exam"}, False)], ids=["practice", "exam"])
def test_a_section_of_a_report_tells_the_attempt_it_costs_and_an_examination_is_handed_in_whole(
    course: Course, rules: dict[str, Any], shown: bool
) -> None:
    number = course.published(item={"exercise": "tmm2_oop", "attempts": 3}, rules=rules)
    path = f"/variants/{course.variant(number)}?lang=en"
    page = course.student.get(path).text
    assert ("Check section 7 (attempt 1 of 3)" in page) is ('name="section"' in page) is shown
    assert "(attempt 1 of 3)</button>" in page.rpartition('class="btn main"')[2]


def test_a_task_tells_the_seconds_until_it_is_due(course: Course) -> None:
    path = f"/variants/{course.variant(course.published(due=moment(days=1)))}?lang=en"
    found = re.search(r'data-left="(\d+)" data-days="{first} d {second} h left"', course.student.get(path).text)
    assert found and 23 * 3600 < int(found[1]) <= 24 * 3600


def test_a_lecturer_finds_no_button_to_hand_in_a_laboratory_of_a_student(course: Course) -> None:
    path = f"/variants/{course.variant(course.published(item={'exercise': 'tmm2_oop'}))}"
    assert 'name="section"' in course.student.get(path).text
    assert 'name="section"' not in course.lecturer.get(path).text


@pytest.mark.parametrize(
    ("rules", "bounds", "ahead"),
    [
        ({}, {}, {"late": 3600, "closed": 3600}),
        ({"late": "accepted"}, {}, {"late": 3600}),
        ({"late": "accepted"}, {"closes": 2}, {"late": 3600, "closed": 7200}),
        ({"late": "reduced"}, {"due": -1, "closes": 2}, {"closed": 7200}),
    ],
)
def test_a_page_knows_what_its_task_becomes_and_when(
    course: Course, rules: dict[str, str], bounds: dict[str, int], ahead: dict[str, int]
) -> None:
    words = {"late": "past due, still taken", "closed": "closed"}
    variant = course.variant(course.published(rules=rules, **{one: moment(hours=bounds[one]) for one in bounds}))
    page = course.student.get(f"/variants/{variant}?lang=en").text
    found = dict(re.findall(r'data-(late|closed)-in="(\d+)"', page))
    assert list(found) == list(ahead)
    for stage, seconds in ahead.items():
        assert seconds - 120 < int(found[stage]) <= seconds
        assert f'data-{stage}="{words[stage]}"' in page


@pytest.mark.parametrize("mode", ["practice", "exam"])
def test_empty_answers_are_said_to_be_nothing_to_judge_and_nothing_else(course: Course, mode: str) -> None:
    variant = course.variant(course.published(rules={"mode": mode}))
    sent = course.student.post(f"/variants/{variant}", data={"answer.l3": " ", "answer.v3": ""})
    page = course.student.get(f"{sent.headers['location'].split('#')[0]}&lang=en").text
    assert "All answers are empty: there is nothing to judge, and no attempt is counted</h2>" in page
    for other in ("Your answers are taken", "No attempt was counted", "mend what", "after it has closed for all"):
        assert other not in page
