"""The time a set needs is told to those who build it and to those who plan when to begin."""

from __future__ import annotations

import pytest

from exercises import catalogue
from server.sets.duration import Span, needed
from tests.server.sets.conftest import Course

SHORT, LONG = sorted(catalogue.ids(), key=lambda one: catalogue.load(one).exercise.minutes)[:: len(catalogue.ids()) - 1]


def minutes(exercise: str) -> int:
    return catalogue.load(exercise).exercise.minutes


def test_tasks_are_added_up_and_a_pool_is_as_long_as_what_is_dealt_of_it() -> None:
    short, long = minutes(SHORT), minutes(LONG)
    assert short < long
    assert needed([[SHORT], [LONG]]) == Span(short + long, short + long)
    assert needed([[SHORT], [SHORT, LONG]]) == Span(2 * short, short + long)
    assert str(needed([[SHORT, LONG]])) == f"{short}–{long}"


def test_what_is_gone_from_the_catalogue_takes_no_time() -> None:
    assert needed([["gone"], [SHORT]]) == needed([[SHORT]])
    assert needed([]) == Span(0, 0)


@pytest.mark.parametrize(
    ("language", "said", "warned"),
    [
        ("pl", "około {} min", "więcej niż limit {} min"),
        ("en", "about {} min", "more than the limit of {} min"),
        ("ru", "около {} мин", "больше ограничения в {} мин"),
    ],
)
def test_the_builder_sums_the_time_and_compares_it_with_the_limit(
    course: Course, language: str, said: str, warned: str
) -> None:
    short = minutes(SHORT)
    items = [{"exercise": SHORT, "points": 1, "attempts": 1}] * 2
    for limit, warns in ((2 * short, False), (2 * short - 1, True)):
        number = course.built(items=items, rules={"minutes": limit})
        page = course.lecturer.get(f"/sets/{number}?lang={language}").text
        assert said.format(2 * short) in page
        assert (warned.format(limit) in page) is warns


def test_a_student_reads_the_time_before_the_first_task_is_opened(course: Course) -> None:
    number = course.published(items=[{"exercise": SHORT, "points": 1, "attempts": 1}] * 2)
    assert f"about {2 * minutes(SHORT)} min" in course.student.get(f"/sets/{number}?lang=en").text
