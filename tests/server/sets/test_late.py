"""Until when late work is taken stands where the due time stands, for the student and the lecturer."""

from __future__ import annotations

import re
from datetime import UTC, datetime

import pytest

from server.sets import clock
from tests.server.sets.conftest import Course

DUE, CLOSES = datetime(2030, 1, 10, 11, tzinfo=UTC), datetime(2030, 1, 12, 11, tzinfo=UTC)


@pytest.mark.parametrize(("late", "told"), [("reduced", True), ("accepted", True), ("refused", False)])
def test_the_end_of_late_work_stands_beside_the_due_time(course: Course, late: str, told: bool) -> None:
    number = course.published(due=DUE.isoformat(), closes=CLOSES.isoformat(), rules={"late": late})
    variant, person = course.variant(number), course.school.people["student"]
    end = clock.spoken("en", CLOSES, clock.zone("Europe/Warsaw"))
    pages = [course.student.get(path) for path in (f"/sets/{number}?lang=en", f"/variants/{variant}?lang=en")]
    pages.append(course.lecturer.get(f"/sets/{number}/students/{person}?lang=en"))
    found = [re.search(r"late work until <time[^>]*>([^<]*)</time>", page.text) for page in pages]
    assert [one and one[1] for one in found] == [end if told else None] * 3
