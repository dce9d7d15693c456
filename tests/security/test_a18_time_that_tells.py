"""A18: how long an answer takes does not tell whether a number is right.

In practice the verdict itself comes back. In an examination it is held back, while a wrong number is looked through for
slips and a right one is not; so judging lasts as long for either. Formulas may take longer than that, right or wrong.
"""

from __future__ import annotations

import time

import pytest

from exercises.exercise import Submission
from exercises.grading import grade, reference
from exercises.variants import deal
from graders import Code
from server.sets import handing
from tests.graders.effort import effort
from tests.server.sets.conftest import Course

NUMBERS = [
    ("slider_crank", "l3", "123 mm"), ("four_bar", "assemblies", "(87.6; 147.4); (-89.9; -148.0)"),
    ("simple_beam", "R_A", "123 kN"),
]  # fmt: skip


def test_an_examination_answers_right_and_wrong_after_the_same_time(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(handing, "EXAM_SECONDS", 0.25)
    number = course.published(rules={"mode": "exam"}, item={"attempts": None})
    variant = course.variant(number)
    right = reference(handing.variant_of(course.card(number)))["l3"]
    for typed in (right, "123 mm", ""):
        begun = time.monotonic()
        assert course.hand_in(variant, {"l3": typed}).status_code == 201
        assert time.monotonic() - begun >= handing.EXAM_SECONDS


@pytest.mark.parametrize(("exercise", "answer", "wrong"), NUMBERS)
def test_a_wrong_number_is_judged_within_that_time(exercise: str, answer: str, wrong: str) -> None:
    handed = Submission(deal(exercise, 7), {answer: wrong})
    assert grade(handed).verdicts[answer].code is Code.WRONG
    assert effort(lambda: grade(handed), 5) < handing.EXAM_SECONDS / 2
