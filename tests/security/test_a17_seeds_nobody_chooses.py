"""A17: guessing or choosing seeds, rolling again, shopping for variants: the server's secret deals, and deals once."""

from __future__ import annotations

import json
from typing import Any

import pytest

from server.sets import dealing
from tests.server.sets.conftest import EXERCISE, Course


@pytest.mark.parametrize("wish", [{"seed": 7}, {"turn": 2}, {"person": "x"}, {"card": 3}])
def test_nothing_can_be_wished_for_in_a_set(course: Course, wish: dict[str, Any]) -> None:
    number = course.published()
    refused = course.open(number, **wish)
    assert refused.status_code == 422 and refused.json()["error"]["code"] == "extra_field"


def test_opening_again_and_again_deals_no_other_card(course: Course) -> None:
    number = course.published()
    first = course.open(number).json()
    assert all(course.open(number).json() == first for _ in range(5))
    assert course.open(number, another=True).json()["error"]["code"] == "card_is_sound"


def test_the_seed_needs_the_secret_and_cannot_be_replayed_in_practice(course: Course) -> None:
    number = course.published()
    course.open(number)
    card, person = course.card(number), course.school.people["student"]
    guessed = {dealing.seed(b"", person, card.slot, 1, redraw) for redraw in range(50)}
    assert card.seed not in guessed
    refused = course.student.post(f"/api/v1/exercises/{EXERCISE}/variants", json={"seed": card.seed})
    assert refused.json()["error"]["code"] == "reserved"


def test_no_seed_stands_in_anything_a_student_reaches(course: Course) -> None:
    number = course.published()
    variant = course.variant(number)
    receipt = course.hand_in(variant, {"l3": "1 m"}).json()["receipt"]["id"]
    course.student.post(f"/api/v1/variants/{variant}/problems", json={"text": "unclear"})
    seed = str(course.card(number).seed)
    for path in (
        f"/api/v1/variants/{variant}", f"/api/v1/task-sets/{number}", f"/api/v1/submissions/{receipt}",
        f"/variants/{variant}", f"/variants/{variant}?receipt={receipt}",
        f"/api/v1/courses/{course.school.course}/task-sets",
    ):  # fmt: skip
        assert seed not in course.student.get(path).text, path
    assert seed not in json.dumps(course.open(number).json())
