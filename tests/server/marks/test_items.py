"""A class of twelve, whose answers are made here: what is told of the tasks, and that nobody can be told from it."""

from __future__ import annotations

from dataclasses import replace
from datetime import timedelta
from typing import Any

import pytest

from server.marks.gradebook import Material, computed
from server.marks.items import _items, shown_item, worded
from server.storage import Handed
from server.storage.courses import Member
from server.storage.marks import DealtCard
from server.storage.people import Person
from server.storage.sets import Line
from server.web.language import LANGUAGES
from tests.server.sets.classroom import NOW, draft
from tests.server.sets.conftest import Course

SET = draft(slots=1)
SLOT = SET.slots[0].id


def line(person: str, code: str, mistake: str | None) -> tuple[Line, Handed]:
    """A submission with one answer, a quarter of an hour after the opening."""
    grade: dict[str, Any] = {"score": float(code == "right"), "mistake": mistake, "slip": None}
    grade["verdicts"] = {"l3": {"code": code, "score": grade["score"]}}
    at = NOW + timedelta(minutes=15)
    handed = Handed(person, person, person, {"l3": "7 mm" if mistake else "1 m"}, at, None, "b", "d", "pl")
    return Line(SLOT, person, person, person, at, grade, True), handed


def classroom() -> tuple[Material, list[Line], dict[str, Handed]]:
    """Five make the same mistake with the same text, seven are right."""
    people = [Person(f"p{n}", f"p{n}", f"P {n}", "student", NOW) for n in range(12)]
    students = [(Member(one, "student", None, NOW), "") for one in people]
    made = [line(p.id, "wrong" if n < 5 else "right", "lost_minus" if n < 5 else None) for n, p in enumerate(people)]
    cards = [DealtCard(SLOT, p.id, p.id, p.id, "slider_crank", 1, n, 1, NOW) for n, p in enumerate(people)]
    lines = [one for one, _ in made]
    return Material(SET, students, lines, cards, {}, {}, {}), lines, {one.receipt: one for _, one in made}


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_task_is_summed_up_in_every_language(language: str) -> None:
    (item,) = _items(*classroom())
    shown = shown_item(item, language)
    assert (shown.students, shown.solved, shown.attempts, shown.minutes) == (12, 7 / 12, 1, 15)
    assert [(one.name, one.share) for one in shown.mistakes] == [("slider_crank:lost_minus", 5 / 12)]
    assert [(one.answer, one.text, one.students) for one in shown.wrong] == [("l3", "7 mm", 5)]
    assert shown.wrong[0].mistake == shown.mistakes[0].text != "lost_minus"
    assert "p1" not in shown.model_dump_json() and "P 1" not in shown.model_dump_json()


def test_a_mistake_that_is_known_no_more_keeps_its_name() -> None:
    assert worded("slider_crank:gone", "en") == "gone" and worded(":opposite_sign", "en") != "opposite_sign"


def test_a_class_below_five_is_told_nothing_and_students_see_no_analysis(course: Course) -> None:
    number = course.published(title="Few")
    course.hand_in(course.variant(number), {"l3": "1 mm"})
    (item,) = course.lecturer.get(f"/api/v1/task-sets/{number}/statistics").json()
    assert (item["students"], item["solved"], item["wrong"], item["groups"]) == (0, None, [], [])
    page = course.lecturer.get(f"/sets/{number}/analysis?lang=en").text
    assert "Fewer than five have been judged." in page and "Fisher" in page
    for path in (f"/api/v1/task-sets/{number}/statistics", f"/sets/{number}/analysis"):
        assert course.student.get(path).status_code == 403


def test_late_work_loses_points_but_its_task_is_solved() -> None:
    found, lines, handed = classroom()
    due = NOW + timedelta(minutes=5)
    task_set = replace(found.task_set, due=due, closes=None, rules={"late": "reduced", "late_loss": 0.25})
    late = replace(found, task_set=task_set)
    (item,), (cell, *_) = _items(late, lines, handed), computed(late).rows[-1].cells
    assert (item.found.solved, item.found.success) == (7 / 12, 7 / 12)
    assert (cell.state, cell.late, cell.points) == ("right", True, 0.75 * SET.slots[0].points)
