"""The home of a student: what is due next with one button, all sets, the latest results."""

from __future__ import annotations

import re

from exercises.grading import reference
from server.sets import handing
from tests.server.sets.conftest import EXERCISE, Course, moment


def section(course: Course, name: str) -> str:
    """Give a section of the student's home; empty where there is none."""
    page = course.student.get("/home?lang=en").text
    found = re.search(f'<section aria-labelledby="h-{name}".*?</section>', page, re.DOTALL)
    return found[0] if found else ""


def answer(course: Course, number: str, **wrong: str) -> str:
    """Hand in the first task of a set, right but for what is given; gives the variant."""
    variant = course.variant(number)
    answers = reference(handing.variant_of(course.card(number))) | wrong
    assert course.hand_in(variant, answers).status_code == 201
    return variant


def test_the_set_that_is_due_next_is_gone_on_with_by_one_button(course: Course) -> None:
    assert not section(course, "next") and not section(course, "sets") and not section(course, "results")
    later, sooner = course.published(title="Later", due=moment(hours=5)), course.published(title="Sooner")
    draft = course.built(title="Draft")
    found = section(course, "next")
    assert "Sooner" in found and "0 of 1 tasks finished, 0 of 10 points so far" in found and "min left" in found
    assert f'<a class="btn main" href="/sets/{sooner}">Open the set</a>' in found
    listed = section(course, "sets")
    assert listed.index("Sooner") < listed.index("Later") and draft not in listed
    course.variant(sooner)
    assert f'action="/sets/{sooner}/items/1"' in section(course, "next")
    assert "Go on with task 1" in section(course, "next")
    variant = answer(course, sooner)
    assert "Later" in section(course, "next")
    assert f'<a href="/variants/{variant}">Sooner, task 1</a>' in section(course, "results")
    assert "10 / 10" in section(course, "results") and "1 of 1" in section(course, "sets")
    assert 'class="pip v-right"' in section(course, "results")
    for number in (later, sooner):
        course.move(number, hours=1)


def test_what_is_not_wholly_right_waits_until_the_attempts_are_used_up(course: Course) -> None:
    number = course.published(title="Twice")
    answer(course, number, l3="1 m")
    assert "Twice" in section(course, "next") and "0 of 1 tasks finished, 8 of 10 points" in section(course, "next")
    answer(course, number, l3="2 m")
    assert not section(course, "next") and "8 / 10" in section(course, "results")
    assert 'class="pip v-partly"' in section(course, "results")


def test_a_scale_shows_how_many_tasks_of_the_next_set_are_finished(course: Course) -> None:
    items = [{"exercise": EXERCISE, "points": 10, "attempts": 2}] * 3
    number = course.published(title="Three", items=items)
    answer(course, number)
    drawn = re.findall(r'<path[^>]* d="([^"]+)"', section(course, "next"))
    assert drawn == ["M0 14H3M0 8V20M1 8V20M2 8V20M3 8V20", "M0 14H1"]
    course.move(number, hours=1)


def test_the_figure_of_the_opened_task_stands_beside_it(course: Course) -> None:
    number = course.published(title="Drawn", items=[{"exercise": EXERCISE, "points": 10, "attempts": 2}])
    assert "<figure" not in section(course, "next")  # nothing of a task is shown before it is opened
    variant = course.variant(number)
    figure = course.student.get(f"/api/v1/variants/{variant}?lang=en").json()["figure"]
    found = section(course, "next")
    assert figure in found and "Task 1, Slider-crank by the vector polygon. Attempts used: 0 of 2." in found
    draft = {"answers": {"l3": "1 m"}, "revision": 0}
    assert course.student.put(f"/api/v1/variants/{variant}/draft", json=draft).status_code == 200
    assert re.search(r"Attempts used: 0 of 2; draft saved <time [^>]*>[^<]*\d\d:\d\d</time>\.", section(course, "next"))
    course.move(number, hours=1)


def test_a_set_past_due_that_is_still_taken_is_no_set_without_a_deadline(course: Course) -> None:
    number = course.published(title="Late", rules={"late": "accepted"})
    course.move(number, hours=1)
    found = section(course, "next")
    assert "Late" in found and "past due, still taken" in found and "without a deadline" not in found
    answer(course, number)


def test_home_tells_nothing_of_an_examination_whose_results_are_held(course: Course) -> None:
    number = course.published(title="Exam", rules={"mode": "exam"})
    assert "0 of 1 tasks finished<" in section(course, "next")
    answer(course, number, l3="1 m")
    assert not section(course, "next") and "Exam" not in section(course, "results")
    listed = section(course, "sets")
    assert "Exam" in listed and "after it has closed for all" in listed
    course.move(number, hours=1)
    assert "Exam, task 1" in section(course, "results")


def test_lecturers_see_their_courses_only(course: Course) -> None:
    page = course.lecturer.get("/home?lang=en").text
    assert "All courses" in page and "All sets" not in page
