"""What one student is shown while another may still work, and what is kept of work at the very end."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest
from sqlalchemy import update

from server.database.sets import Sets
from server.sets import handing
from server.tables import deck
from tests.server.sets.conftest import Course, moment
from tests.server.sets.test_api import code_of, texts

FREE = "planetary"  # of no other set here


def begun(course: Course, variant: str, **ago: float) -> None:
    """Let a student have opened a card some time ago."""
    earlier = update(deck).where(deck.c.variant == variant).values(dealt=datetime.now(UTC) - timedelta(**ago))
    sets = course.school.bench.sets
    assert isinstance(sets, Sets)
    course.school.portal.call(sets._connections.write, lambda connection: connection.execute(earlier).rowcount)


def give_time(course: Course, number: str, minutes: int, who: str = "student") -> None:
    """Give a student more time in a set."""
    path = f"/api/v1/task-sets/{number}/accommodations/{course.school.people[who]}"
    assert course.lecturer.put(path, json={"minutes": minutes}).status_code == 200


def logged(course: Course, detail: str) -> int:
    """Tell how often something stands in the audit log of the course."""
    return course.lecturer.get(f"/courses/{course.school.course}/audit?lang=en").text.count(detail)


def shows_nothing(course: Course, number: str, variant: str, receipt: str) -> bool:
    """Whether neither results nor the solution of another student's work are shown to that student."""
    shown = course.other.get(f"/api/v1/submissions/{receipt}").json()
    mine = course.other.get(f"/api/v1/task-sets/{number}").json()
    told = course.other.get("/api/v1/me/data").json()["submissions"]
    (one,) = [one for one in told if one["receipt"] == receipt]
    solution = course.other.get(f"/api/v1/variants/{variant}/solution")
    assert mine["stage"] == "closed"
    return (
        shown["held"] and mine["held"] and one["held"] and shown["score"] is mine["share"] is mine["earned"] is None
        and code_of(solution) == (403, "set_solution_closed")
    )  # fmt: skip


def test_who_has_used_up_the_time_is_shown_nothing_while_others_may_begin(course: Course) -> None:
    number = course.published(rules={"mode": "exam", "minutes": 30})
    variant = course.variant(number, course.other)
    receipt = course.hand_in(variant, {"l3": "1 m"}, who=course.other).json()["receipt"]["id"]
    begun(course, variant, minutes=31)
    assert shows_nothing(course, number, variant, receipt)
    course.move(number, minutes=1)
    assert course.other.get(f"/api/v1/submissions/{receipt}").json()["score"] == 0
    assert course.other.get(f"/api/v1/variants/{variant}/solution").json()["lines"]


def test_nothing_is_shown_while_somebody_has_extra_time(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    variant, slow = course.variant(number, course.other), course.variant(number)
    receipt = course.hand_in(variant, {"l3": "1 m"}, who=course.other).json()["receipt"]["id"]
    give_time(course, number, 60)
    course.move(number, minutes=1)
    assert course.hand_in(slow, {"l3": "1 m"}).status_code == 201
    assert shows_nothing(course, number, variant, receipt)
    give_time(course, number, 0)
    assert course.other.get(f"/api/v1/submissions/{receipt}").json()["score"] == 0


def test_a_draft_that_comes_too_late_does_not_push_out_the_last_one_in_time(course: Course) -> None:
    number = course.published(rules={"mode": "exam"}, item={"attempts": 1})
    variant, right = course.variant(number), texts(course, number)
    path = f"/api/v1/variants/{variant}/draft"
    assert course.student.put(path, json={"answers": right, "revision": 0}).status_code == 200
    course.move(number, seconds=0)
    late = course.student.put(path, json={"answers": {"l3": "1 m"}, "revision": 1})
    assert code_of(late) == (403, "set_closed")
    read = course.student.post(f"/variants/{variant}/preview", data={"answer.l3": "1 m"})
    assert read.status_code == 200 and course.student.get(path).json()["answers"] == right
    bench = course.school.bench
    assert course.school.portal.call(handing.collect, bench, datetime.now(UTC)) == 1
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["share"] == 1


def test_what_a_draft_at_time_out_could_not_tell_is_not_said_to_have_cost_nothing(course: Course) -> None:
    number = course.published(rules={"mode": "exam"}, item={"attempts": 1})
    variant = course.variant(number)
    draft = {"answers": {"l3": "1 m", "v3": "9^9^9"}, "revision": 0}
    assert course.student.put(f"/api/v1/variants/{variant}/draft", json=draft).status_code == 200
    course.move(number, seconds=0)
    course.school.portal.call(handing.collect, course.school.bench, datetime.now(UTC))
    (line,) = course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["ledger"]
    graded = course.student.get(f"/api/v1/submissions/{line['receipt']}?lang=en").json()
    assert graded["counted"] and graded["verdicts"]["v3"]["outcome"] == "unreadable"
    assert graded["verdicts"]["v3"]["message"].startswith("Not read: ")
    page = course.student.get(f"/variants/{variant}?lang=en").text
    assert "No attempt was counted" not in graded["verdicts"]["v3"]["message"] + page


def test_a_draft_for_which_no_attempt_is_left_is_not_judged_again_and_again(course: Course) -> None:
    number = course.published(rules={"mode": "exam"}, item={"attempts": 1})
    variant = course.variant(number)
    course.hand_in(variant, {"l3": "1 m"})
    path = f"/api/v1/variants/{variant}/draft"
    assert course.student.put(path, json={"answers": {"l3": "2 m"}, "revision": 1}).status_code == 200
    waiting = course.school.portal.call(course.school.bench.sets.waiting)
    assert variant not in [one.variant for one in waiting]


def test_a_mark_by_hand_is_told_with_the_results(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    receipt = course.hand_in(course.variant(number), {"l3": "1 m"}).json()["receipt"]["id"]
    mark = {"receipt": receipt, "answer": "l3", "share": 0.25, "comment": "the sign alone"}
    assert course.lecturer.post(f"/api/v1/task-sets/{number}/marks", json=mark).status_code == 201
    assert not told(course, receipt)
    course.move(number, minutes=1)
    assert told(course, receipt)


def told(course: Course, receipt: str) -> bool:
    """Whether the acts that are given out to a student speak of a receipt."""
    return receipt in [act["details"].get("receipt") for act in course.student.get("/api/v1/me/data").json()["acts"]]


def test_a_lecturer_elsewhere_who_puts_a_student_on_a_roster_sees_no_card_of_this_course(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    variant = course.variant(number)
    receipt = course.hand_in(variant, {"l3": "1 m"}).json()["receipt"]["id"]
    problem = course.student.post(f"/api/v1/variants/{variant}/problems", json={"text": "the figure?"}).json()["id"]
    stranger = course.school.browser("stranger")
    own = stranger.get("/api/v1/courses").json()[0]["id"]
    roster = stranger.post(f"/api/v1/courses/{own}/roster", json={"csv": "student;Student", "apply": True})
    assert roster.json()["changes"][0]["what"] == "joins"
    paths = [f"/api/v1/variants/{variant}", f"/variants/{variant}", f"/variants/{variant}/solution"]
    for path in [*paths, f"/api/v1/variants/{variant}/solution", f"/api/v1/submissions/{receipt}"]:
        assert stranger.get(path).status_code == 404, path
        assert course.lecturer.get(path).status_code == 200, path
    assert problem not in [one["id"] for one in stranger.get("/api/v1/problems").json()["problems"]]
    assert stranger.post(f"/api/v1/problems/{problem}/settle").status_code == 404
    practice = course.student.post("/api/v1/exercises/planetary/variants").json()["id"]
    reported = course.student.post(f"/api/v1/variants/{practice}/problems", json={"text": "and here?"}).json()["id"]
    assert reported in [one["id"] for one in stranger.get("/api/v1/problems").json()["problems"]]
    assert course.lecturer.post(f"/api/v1/problems/{problem}/settle").status_code == 204


def test_an_assistant_does_not_mark_what_was_handed_in_as_a_student(course: Course) -> None:
    number = course.published()
    receipt = course.hand_in(course.variant(number, course.other), {"l3": "1 m"}, who=course.other).json()["receipt"][
        "id"
    ]
    member = f"/api/v1/courses/{course.school.course}/members/{course.school.people['other']}"
    mark = {"receipt": receipt, "share": 1.0, "comment": "well done"}
    assert course.lecturer.patch(member, json={"role": "assistant"}).status_code == 200
    try:
        assert code_of(course.other.post(f"/api/v1/task-sets/{number}/marks", json=mark)) == (403, "own_work")
        assert course.lecturer.post(f"/api/v1/task-sets/{number}/marks", json=mark).status_code == 201
    finally:
        course.lecturer.patch(member, json={"role": "student"})


def test_a_deadline_moves_where_late_work_is_taken_without_an_end(course: Course) -> None:
    number = course.published(rules={"late": "reduced"})
    path = f"/api/v1/task-sets/{number}"
    due = course.lecturer.get(path).json()["due"]
    (moved,) = course.lecturer.post(f"{path}/extend", json={"minutes": 15}).json()
    assert datetime.fromisoformat(moved["due"]) - datetime.fromisoformat(due) == timedelta(minutes=15)
    course.move(number, minutes=1)
    assert course.lecturer.post(f"{path}/extend", json={"minutes": 15}).json() == []


@pytest.mark.parametrize("dates", [{}, {"due": None}])
def test_moving_the_deadlines_lengthens_a_time_limit_that_runs(course: Course, dates: dict[str, None]) -> None:
    number = course.published(rules={"minutes": 30}, **dates)
    path, minutes = f"/api/v1/task-sets/{number}", timedelta(minutes=15)
    course.variant(number)
    before, unopened = (who.get(path).json()["closes"] for who in (course.student, course.other))
    assert len(course.lecturer.post(f"{path}/extend", json={"minutes": 15}).json()) == 1
    after, other = (who.get(path).json()["closes"] for who in (course.student, course.other))
    assert datetime.fromisoformat(after) - datetime.fromisoformat(before) == minutes
    assert other == (unopened and (datetime.fromisoformat(unopened) + minutes).isoformat().replace("+00:00", "Z"))
    course.variant(number, course.other)  # begun after the move: as long as the set says
    assert datetime.fromisoformat(course.other.get(path).json()["closes"]) < datetime.now(UTC) + 2 * minutes


def test_attempts_of_any_length_in_the_form_are_refused_by_name(course: Course) -> None:
    form = {"title": "x", "revision": "1", "slot.1.pool": FREE, "slot.1.attempts": "9" * 5000}
    refused = course.lecturer.post(f"/sets/{course.built()}", data=form)
    assert (refused.status_code, refused.json()["error"]["field"]) == (422, "items.0.attempts")


def test_a_time_limit_without_dates_holds_no_results_for_ever(course: Course) -> None:
    number = course.published(rules={"mode": "exam", "minutes": 30}, due=None)
    variant = course.variant(number)
    receipt = course.hand_in(variant, {"l3": "1 m"}).json()["receipt"]["id"]
    assert course.student.get(f"/api/v1/submissions/{receipt}").json()["held"]
    begun(course, variant, minutes=31)
    assert course.student.get(f"/api/v1/submissions/{receipt}").json()["score"] == 0


@pytest.mark.parametrize("late", ["refused", "accepted"])
def test_an_examination_that_would_hold_its_results_for_ever_is_not_published(course: Course, late: str) -> None:
    due = moment(hours=1) if late == "accepted" else None
    number = course.built(rules={"mode": "exam", "late": late}, due=due)
    refused = course.lecturer.post(f"/api/v1/task-sets/{number}/open")
    assert code_of(refused) == (422, "set_troubled") and course.open(number).status_code == 404
    course.lecturer.patch(f"/api/v1/task-sets/{number}", json={"revision": 1, "closes": moment(hours=2)})
    assert course.lecturer.post(f"/api/v1/task-sets/{number}/open").status_code == 200


def test_a_second_chance_tells_nothing_of_an_examination_under_way(course: Course) -> None:
    first = course.published(rules={"mode": "exam"})
    course.hand_in(course.variant(first), texts(course, first))
    second = course.published(rules={"second_chance_of": first})
    assert course.student.get(f"/api/v1/task-sets/{second}").json()["share"] is None
    assert "100 %" not in course.student.get(f"/sets/{second}?lang=en").text
    course.move(first, minutes=1)
    assert course.student.get(f"/api/v1/task-sets/{second}").json()["share"] == 1
    assert "100 %" in course.student.get(f"/sets/{second}?lang=en").text


def test_an_exercise_is_reserved_as_long_as_anybody_may_hand_in(course: Course) -> None:
    seeded = f"/api/v1/exercises/{FREE}/variants"
    late = course.published(item={"exercise": FREE}, rules={"late": "reduced"})
    course.move(late, minutes=1)
    assert code_of(course.student.post(seeded, json={"seed": 7})) == (403, "reserved")
    course.date(late, None, datetime.now(UTC))
    assert course.student.post(seeded, json={"seed": 7}).status_code == 201
    slow = course.published(item={"exercise": FREE})
    course.move(slow, minutes=1)
    assert course.student.post(seeded, json={"seed": 7}).status_code == 201
    give_time(course, slow, 60)
    assert code_of(course.student.post(seeded, json={"seed": 7})) == (403, "reserved")
    give_time(course, slow, 0)


def test_extra_time_that_opens_an_examination_again_warns_and_is_written_down(course: Course) -> None:
    number, person = course.published(rules={"mode": "exam"}), course.school.people["student"]
    course.variant(number)
    page, api = f"/sets/{number}/students/{person}", f"/api/v1/task-sets/{number}/accommodations/{person}"
    warning, told = "have been shown. Extra time can open it again", "The examination is open again for this student"
    before = logged(course, "opened after its results were shown: yes")
    assert warning not in course.lecturer.get(f"{page}?lang=en").text
    assert course.lecturer.put(api, json={"minutes": 5}).json()["reopened"] is False  # nothing has been shown yet
    course.move(number, minutes=10)
    assert warning in course.lecturer.get(f"{page}?lang=en").text
    assert course.lecturer.put(api, json={"minutes": 6}).json()["reopened"] is False  # it stays closed
    assert course.lecturer.put(api, json={"minutes": 60}).json()["reopened"] is True
    assert course.lecturer.put(api, json={"minutes": 61}).json()["reopened"] is False  # it is open already
    assert logged(course, "opened after its results were shown: yes") == before + 1
    course.lecturer.put(api, json={"minutes": 0})
    given = course.lecturer.post(f"{page}/time?lang=en", data={"minutes": "60", "reason": ""})
    assert told in course.lecturer.get(f"{given.headers['location']}&lang=en").text
    assert told not in course.lecturer.get(f"{page}?lang=en").text


def test_extra_time_that_opens_a_practice_set_again_tells_to_how_many_its_solutions_stood_open(course: Course) -> None:
    number, person = course.published(), course.school.people["student"]
    course.variant(number), course.variant(number, course.other)
    page, api = f"/sets/{number}/students/{person}", f"/api/v1/task-sets/{number}/accommodations/{person}"
    warning, told = "stand open already (students: 2)", "The set is open again for this student"
    assert "stand open already" not in course.lecturer.get(f"{page}?lang=en").text
    course.move(number, minutes=10)
    assert warning in course.lecturer.get(f"{page}?lang=en").text
    before = logged(course, "students to whom solutions stood open: 2")
    assert course.lecturer.put(api, json={"minutes": 60}).json()["reopened"] is True
    assert logged(course, "students to whom solutions stood open: 2") == before + 1
    course.lecturer.put(api, json={"minutes": 0})
    given = course.lecturer.post(f"{page}/time?lang=en", data={"minutes": "60", "reason": ""})
    assert told in course.lecturer.get(f"{given.headers['location']}&lang=en").text


def test_extra_time_in_practice_warns_of_nothing_where_no_solution_opens(course: Course) -> None:
    number, person = course.published(rules={"solutions": "never"}), course.school.people["student"]
    course.variant(number)
    course.move(number, minutes=10)
    page, api = f"/sets/{number}/students/{person}", f"/api/v1/task-sets/{number}/accommodations/{person}"
    assert "stand open already" not in course.lecturer.get(f"{page}?lang=en").text
    assert course.lecturer.put(api, json={"minutes": 60}).json()["reopened"] is False


def test_who_moves_deadlines_is_told_first_to_how_many_solutions_stand_open(course: Course) -> None:
    number = course.published(title="Homework 9", rules={"solutions": "after_last_attempt"})
    told = "The worked solutions of this set stand open already (students: 1)"
    pages = [f"/sets/{number}?lang=en", f"/courses/{course.school.course}?lang=en"]
    variant = course.variant(number)
    course.variant(number, course.other)
    course.hand_in(variant, {"l3": "1 m"})
    shown = [course.lecturer.get(page).text for page in pages]
    assert told not in shown[0] and f"Homework 9: {told}" not in shown[1]  # an attempt is left
    course.hand_in(variant, {"l3": "2 m"})
    assert course.student.get(f"/api/v1/variants/{variant}/solution").status_code == 200
    shown = [course.lecturer.get(page).text for page in pages]
    assert told in shown[0] and f"Homework 9: {told}" in shown[1]
    before = logged(course, "students to whom solutions stood open: 1")
    (moved,) = course.lecturer.post(f"/api/v1/task-sets/{number}/extend", json={"minutes": 15}).json()
    assert moved["solved_for"] == 1
    assert logged(course, "students to whom solutions stood open: 1") == before + 1


def test_solutions_of_a_set_without_dates_are_counted_by_the_time_of_each_student(course: Course) -> None:
    number, person = course.published(due=None, rules={"minutes": 30}), course.school.people["student"]
    over, running = course.variant(number, course.other), course.variant(number)
    begun(course, over, minutes=31)
    page = f"/sets/{number}/students/{person}?lang=en"
    assert running and "stand open already (students: 1)" in course.lecturer.get(page).text


def test_a_closed_set_says_that_its_deadlines_do_not_move(course: Course) -> None:
    number = course.published()
    assert "This set has closed" not in course.lecturer.get(f"/sets/{number}?lang=en").text
    course.move(number, minutes=1)
    shown = course.lecturer.get(f"/sets/{number}?lang=en").text
    assert "This set has closed" in shown and f"/sets/{number}/extend" not in shown
