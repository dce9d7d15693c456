"""In the sum of a course a set and its second chance count once, as the rule of second chances weighs them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from exercises.grading import reference
from server.sets import handing
from tests.conftest import Laid
from tests.server.conftest import SECRET
from tests.server.marks.test_export import cells
from tests.server.sets.conftest import Course, made


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[tuple[Course, float]]:
    """A course with a set and a second chance, and what the student had in the first; the other took one alone."""
    for course in made(laid_for_all(tmp_path_factory.mktemp("school"), secret=SECRET, limited=False)):
        first = course.published(title="First")
        right = reference(handing.variant_of(_card(course, first, "student")))
        had = course.hand_in(course.variant(first), {**right, "l3": "9 m"}).json()["score"]
        course.hand_in(
            course.variant(first, course.other),
            reference(handing.variant_of(_card(course, first, "other"))),
            who=course.other,
        )
        second = course.published(title="Second", rules={"second_chance_of": first}, item={"points": 4})
        course.hand_in(course.variant(second), reference(handing.variant_of(_card(course, second, "student"))))
        yield course, had


def _card(course: Course, number: str, who: str) -> Any:
    course.variant(number, getattr(course, who))
    return course.card(number, who)


def test_the_sum_of_a_course_weighs_a_second_chance_with_the_first(pair: tuple[Course, float]) -> None:
    course, had = pair
    book = course.lecturer.get(f"/api/v1/courses/{course.school.course}/gradebook").json()
    sums = {row["student"]["name"]: row["points"] for row in book["students"]}
    assert book["points"] == 10
    assert sums == {"Student": pytest.approx(9 + had, abs=0.001), "Other": 10, "Leaver": 0}


def test_the_page_tells_the_sum_and_its_rule(pair: tuple[Course, float]) -> None:
    course, _ = pair
    page = course.lecturer.get(f"/courses/{course.school.course}/results?lang=en").text
    assert "Points of 10<" in page and "count once in the sum" in page


def test_an_export_tells_what_the_second_chance_changed(pair: tuple[Course, float]) -> None:
    course, had = pair
    path = f"/api/v1/courses/{course.school.course}/marks.csv?lang=en"
    head, *found = cells(course.lecturer.get(path).content, ",")
    (row,) = [dict(zip(head, line, strict=True)) for line in found if line[3] == "Student"]
    told = [float(row[name]) for name in ("Points before deductions", "Second chances", "Points", "Points to reach")]
    assert told == pytest.approx([10 * had, 9 - 9 * had, 9 + had, 10], abs=0.001)


def test_a_second_chance_to_a_draft_is_not_published(course: Course) -> None:
    first = course.built(title="Still a draft")
    second = course.built(rules={"second_chance_of": first})
    refused = course.lecturer.post(f"/api/v1/task-sets/{second}/open?lang=en")
    assert refused.status_code == 422 and "not published" in refused.json()["error"]["message"]
    assert course.lecturer.get(f"/api/v1/task-sets/{second}").json()["state"] == "draft"
    assert course.lecturer.post(f"/api/v1/task-sets/{first}/open").status_code == 200
    assert course.lecturer.post(f"/api/v1/task-sets/{second}/open").status_code == 200
