"""The gradebook, a student's work and marks by hand over HTTP, with a real deck and real grades."""

from __future__ import annotations

import csv
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from starlette.testclient import TestClient

from exercises import grading
from exercises.exercise import Grade
from exercises.grading import reference
from graders.verdict import FAULT, UNDECIDED
from server.sets import handing
from tests.server.sets.conftest import Course, moment


def book(course: Course, number: str) -> dict[str, Any]:
    """The gradebook by name of student."""
    reply = course.lecturer.get(f"/api/v1/task-sets/{number}/gradebook")
    assert reply.status_code == 200, reply.text
    return {row["student"]["name"]: row for row in reply.json()["students"]}


def mark(course: Course, number: str, who: TestClient | None = None, **body: Any) -> Any:
    return (who or course.lecturer).post(f"/api/v1/task-sets/{number}/marks?lang=en", json=body)


def with_open_answer(course: Course, patch: pytest.MonkeyPatch, number: str, verdict: Any = UNDECIDED) -> Any:
    """Hand in right answers, one of which the judges leave open; gives the receipt and the answers."""
    judge = grading.grade

    def undecided(*args: Any, **rules: Any) -> Grade:
        found = judge(*args, **rules)
        return replace(found, provisional=True, verdicts={**found.verdicts, "omega2_formula": verdict})

    variant = course.variant(number)
    answers = reference(handing.variant_of(course.card(number)))
    with patch.context() as patched:
        patched.setattr(grading, "grade", undecided)
        graded = course.hand_in(variant, answers).json()
    return graded["receipt"]["id"], answers


def test_rows_are_students_by_group_and_name_and_show_what_the_student_is_told(course: Course) -> None:
    number = course.published()
    variant = course.variant(number)
    course.hand_in(variant, {"l3": "1 mm"})
    graded = course.hand_in(variant, reference(handing.variant_of(course.card(number)))).json()
    rows = book(course, number)
    assert list(rows) == ["Leaver", "Other", "Student"]
    (cell,) = rows["Student"]["items"]
    assert (cell["state"], cell["points"], cell["attempts"], cell["submissions"]) == ("right", 10, 2, 2)
    assert cell["receipt"] == graded["receipt"]["id"] and cell["variant"] == variant and not cell["provisional"]
    own = course.student.get(f"/api/v1/task-sets/{number}").json()
    assert own["earned"] == rows["Student"]["points"] == 10
    assert rows["Other"]["items"][0]["state"] == "open" and rows["Other"]["points"] == 0
    group = {"group": course.school.group}
    path = f"/api/v1/courses/{course.school.course}/members/{course.school.people['student']}"
    course.lecturer.patch(path, json=group)
    assert list(book(course, number)) == ["Student", "Leaver", "Other"]
    course.lecturer.patch(path, json={"group": ""})


def test_who_handed_in_and_is_a_student_no_more_stays_in_the_gradebook_and_is_marked_so(course: Course) -> None:
    number, empty = course.published(), course.published()
    person, place = course.school.people["leaver"], f"/api/v1/courses/{course.school.course}"
    who = course.school.browser("leaver")
    variant = course.variant(number, who)
    answers = reference(handing.variant_of(course.card(number, "leaver")))
    assert course.hand_in(variant, answers, who=who).status_code == 201
    assert not book(course, number)["Leaver"]["student"]["left"]
    assert course.lecturer.delete(f"{place}/members/{person}").status_code == 204
    try:
        row = book(course, number)["Leaver"]
        assert (row["points"], row["student"]["left"]) == (10, True)
        assert "Leaver" not in book(course, empty)
        for exported in (f"/api/v1/task-sets/{number}/marks.csv", f"{place}/marks.csv"):
            (line,) = table(course, exported, "Leaver")
            assert (line["Points"], line["No longer a student here"]) == ("10", "yes")
        pages = f"sets/{number}/results", f"courses/{course.school.course}/results", f"sets/{number}/students/{person}"
        assert all("(no longer a student here)" in course.lecturer.get(f"/{page}?lang=en").text for page in pages)
    finally:
        bench = course.school.bench
        course.school.portal.call(bench.courses.join, course.school.course, person, "assistant", datetime.now(UTC))
    assert book(course, number)["Leaver"]["student"]["left"]
    course.lecturer.patch(f"{place}/members/{person}", json={"role": "student"})
    assert not book(course, number)["Leaver"]["student"]["left"]


def table(course: Course, path: str, name: str) -> list[dict[str, str]]:
    """The lines of a student in an exported table."""
    text = course.lecturer.get(f"{path}?lang=en").content.decode("utf-8-sig")
    return [line for line in csv.DictReader(text.splitlines()) if line["Name"] == name]


def test_late_work_and_extra_time_are_counted_for_each_student(course: Course) -> None:
    rules = {"late": "reduced", "late_loss": 0.1}
    number = course.published(rules=rules, due=moment(hours=1), closes=moment(hours=99))
    for who in (course.student, course.other):
        course.variant(number, who)
    course.school.portal.call(
        course.school.bench.sets.accommodate, number, course.school.people["other"], 120, "illness"
    )
    course.date(number, _ago(hours=1), _ago(hours=-99))
    for name, who in (("student", course.student), ("other", course.other)):
        answers = reference(handing.variant_of(course.card(number, name)))
        assert course.hand_in(course.variant(number, who), answers, who=who).status_code == 201
    rows = book(course, number)
    assert (rows["Student"]["points"], rows["Student"]["items"][0]["late"]) == (9, True)  # one day begun: a tenth
    assert (rows["Other"]["points"], rows["Other"]["items"][0]["late"]) == (10, False)
    assert rows["Other"]["extra_minutes"] == 120


def _ago(**ago: float) -> datetime:
    return datetime.now(UTC) - timedelta(**ago)


def test_an_open_answer_is_settled_for_all_who_typed_it_and_stays_so(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    number = course.published()
    receipt, answers = with_open_answer(course, monkeypatch, number)
    (cell,) = book(course, number)["Student"]["items"]
    assert (cell["state"], cell["points"], cell["provisional"]) == ("undecided", 8, True)  # four of five answers
    path = f"/api/v1/task-sets/{number}/open-answers?lang=en"
    (left,) = course.lecturer.get(path).json()
    assert (left["answer"], left["text"], left["receipts"]) == (
        "omega2_formula", answers["omega2_formula"], [receipt],
    )  # fmt: skip
    wanted = {"item": 1, "answer": "omega2_formula", "text": left["text"], "share": 1}
    assert course.lecturer.post(path, json=wanted).json() == {"submissions": 1}
    assert course.lecturer.post(path, json=wanted).json()["error"]["code"] == "settled_already"
    (cell,) = book(course, number)["Student"]["items"]
    assert (cell["state"], cell["points"], cell["by_hand"]) == ("right", 10, True)
    seen = course.student.get(f"/api/v1/submissions/{receipt}").json()
    assert (seen["score"], seen["provisional"]) == (1, False)
    assert [one["share"] for one in seen["by_hand"]] == [1]
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["earned"] == 10
    newest = course.lecturer.get(f"/api/v1/courses/{course.school.course}/audit").json()["lines"][0]
    assert newest["action"] == "mark_given" and newest["details"]["submissions"] == 1


def test_a_mark_needs_a_reason_where_the_judges_had_decided(course: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    number = course.published()
    receipt, _ = with_open_answer(course, monkeypatch, number, FAULT)
    assert book(course, number)["Student"]["items"][0]["state"] == "fault"
    bare = mark(course, number, receipt=receipt, answer="l3", share=0)
    assert (bare.status_code, bare.json()["error"]["code"]) == (422, "mark_without_reason")
    assert mark(course, number, receipt=receipt, answer="omega2_formula", share=1).status_code == 201
    given = mark(course, number, receipt=receipt, answer="l3", share=0.5, comment="wrong figure").json()
    assert given["author"] == course.school.people["lecturer"] and given["comment"] == "wrong figure"
    assert book(course, number)["Student"]["points"] == 9
    unknown = mark(course, number, receipt=receipt, answer="none", share=1, comment="x")
    assert unknown.json()["error"]["code"] == "unknown_answer"
    for share in (-0.1, 1.1, "NaN", True):
        assert mark(course, number, receipt=receipt, share=share, comment="x").status_code == 422
    other = course.published()
    assert mark(course, other, receipt=receipt, share=1, comment="x").json()["error"]["code"] == "unknown_submission"
    assistant = course.school.browser("assistant")
    assert mark(course, number, assistant, receipt=receipt, share=0.25, comment="assistant").status_code == 201
    refused = mark(course, number, course.student, receipt=receipt, share=1, comment="mine")
    assert refused.json()["error"]["code"] == "forbidden"


def test_a_comment_is_held_back_with_the_results_of_an_examination(course: Course) -> None:
    number = course.published(rules={"mode": "exam"})
    receipt = course.hand_in(course.variant(number), {"l3": "1 mm"}).json()["receipt"]["id"]
    mark(course, number, receipt=receipt, share=0.5, comment="see page 3")
    held = course.student.get(f"/api/v1/submissions/{receipt}").json()
    assert (held["score"], held["by_hand"]) == (None, [])
    course.move(number, minutes=1)
    shown = course.student.get(f"/api/v1/submissions/{receipt}").json()
    assert (shown["score"], shown["by_hand"][0]["comment"]) == (0.5, "see page 3")


def test_a_student_s_work_is_what_was_kept_at_publishing(course: Course, monkeypatch: pytest.MonkeyPatch) -> None:
    number = course.published()
    variant = course.variant(number)
    shown = course.student.get(f"/api/v1/variants/{variant}?lang=ru").json()
    course.student.post(f"/api/v1/variants/{variant}/submissions?lang=ru", json={"answers": {"l3": "1 mm"}})
    path = f"/api/v1/variants/{variant}/draft"
    draft = {"answers": {"l3": "2 mm"}, "revision": course.student.get(path).json()["revision"]}
    assert course.student.put(path, json=draft).status_code == 200

    def broken(*_: Any) -> None:
        raise AssertionError("the installed exercise is asked to present what the deck holds")

    monkeypatch.setattr("exercises.presenting.presented", broken)
    path = f"/api/v1/task-sets/{number}/students/{course.school.people['student']}"
    (work,) = course.lecturer.get(path).json()["items"]
    (card,) = work["cards"]
    assert card["language"] == "ru" and card["statement"] == shown["statement"] and card["figure"] == shown["figure"]
    assert card["draft"] == {"l3": "2 mm"} and card["seed"] == course.card(number).seed
    (piece,) = card["submissions"]
    assert piece["answers"] == {"l3": "1 mm"} and piece["counts"] and piece["verdicts"]["l3"]["message"]
    stranger = course.school.people["stranger"]
    gone = course.lecturer.get(f"/api/v1/task-sets/{number}/students/{stranger}")
    assert gone.json()["error"]["code"] == "unknown_member"


def test_progress_counts_who_opened_handed_in_and_finished(course: Course) -> None:
    number = course.published(items=[{"exercise": "slider_crank"}, {"exercise": "slider_crank"}])
    path = f"/api/v1/task-sets/{number}/progress"
    assert course.lecturer.get(path).json() == {
        "students": 3, "opened": 0, "handed_in": 0, "finished": 0, "each": [],
    }  # fmt: skip
    for who in (course.student, course.other):
        course.variant(number, who)
    course.hand_in(course.variant(number), {"l3": "1 mm"})
    found = course.lecturer.get(path).json()
    assert (found["opened"], found["handed_in"], found["finished"]) == (2, 1, 0)
    second = course.student.post(f"/api/v1/task-sets/{number}/items/2/variant").json()["id"]
    course.hand_in(second, {"l3": "1 mm"})
    found = course.lecturer.get(path).json()
    assert (found["opened"], found["handed_in"], found["finished"]) == (2, 1, 1)
    mine = next(one for one in found["each"] if one["student"] == course.school.people["student"])
    assert (mine["opened"], mine["answered"], mine["submissions"], mine["finished"]) == (2, 2, 2, True)


def test_a_course_adds_its_sets_up(course: Course) -> None:
    number = course.published(title="Sum")
    course.hand_in(course.variant(number), reference(handing.variant_of(course.card(number))))
    found = course.lecturer.get(f"/api/v1/courses/{course.school.course}/gradebook").json()
    at = [one["id"] for one in found["sets"]].index(number)
    row = next(one for one in found["students"] if one["student"]["name"] == "Student")
    assert row["sets"][at] == {"points": 10, "share": 1, "taken": True, "provisional": False}
    assert row["points"] == pytest.approx(sum(one["points"] for one in row["sets"]))
    assert course.built() not in [one["id"] for one in found["sets"]]
