"""Every choice of frames of the RRP arm is right, and every slip in any of them is wrong and called by its name."""

from __future__ import annotations

from itertools import product

import pytest

from exercises.exercise import Submission, Variant
from exercises.grading import grade
from exercises.manipulators.rrp_table import EXERCISE, Givens
from graders import Code
from graders.verdict import Flaws, Verdict
from tests.depth import amount
from tests.exercises.rrp_frames import CHOICES, RISES, right, slips, table, written

ARMS = [
    Variant("rrp_table", EXERCISE.version, 0, Givens(0.4, 0.12, -0.7, 0.6, 0.5, measure, side))
    for measure, side in product(RISES, ("left", "right"))
]


def judged(variant: Variant, text: str) -> Verdict:
    return grade(Submission(variant, {"P": text})).verdicts["P"]


def called(verdict: Verdict) -> list[str]:
    assert isinstance(verdict.details, Flaws)
    return [flaw.code.value.removeprefix("table_") for flaw in verdict.details.found]


@pytest.mark.parametrize("variant", ARMS, ids=lambda v: f"{v.givens.measure}-{v.givens.side}")
def test_every_sense_of_every_axis_is_right(variant: Variant) -> None:
    texts = right(variant.givens)
    assert len(texts) == len(CHOICES) == 32
    assert {judged(variant, text).code for text in texts} == {Code.RIGHT}


@pytest.mark.parametrize("variant", ARMS, ids=lambda v: f"{v.givens.measure}-{v.givens.side}")
def test_every_slip_in_any_choice_of_frames_is_wrong_and_called_by_its_name(variant: Variant) -> None:
    texts, number = right(variant.givens), ARMS.index(variant)
    for choice in CHOICES[number :: amount(16, 1)]:
        for rows, names in slips(table(variant.givens, choice)):
            text = written(rows)
            verdict = judged(variant, text)
            assert text not in texts
            assert verdict.code is not Code.RIGHT, text
            assert [name for name in called(verdict) if name in names.split()] == called(verdict), text


SHIFTED = [  # the slide has no place of its own: z2 may stand beside it, and M on another axis than across the slide
    "[[q1; L1; 0; pi/2]; [q2; 0; 0.3; pi/2]; [0; q3; -0.3; pi/2]]",
    "[[q1; L1; 0; pi/2]; [q2; 0; -L1; pi/2]; [pi; q3; -L1; -pi/2]]",
    "[[q1; L1; 0; pi/2]; [q2; -d; 0; pi/2]; [1; q3 - d; 0; 0]]",
    "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [-pi/2; q3 - d; d; 0]]",
]


@pytest.mark.parametrize("text", SHIFTED)
def test_frames_beside_the_slide_are_right(text: str) -> None:
    assert judged(ARMS[0], text).code is Code.RIGHT


@pytest.mark.parametrize("text", SHIFTED)
@pytest.mark.parametrize(("old", "new"), [("q3", "q3 + 0.01"), ("L1; 0", "L1; 0.01"), ("q2; ", "q2 + 0.01; ")])
def test_frames_beside_the_slide_that_miss_the_point_are_wrong(text: str, old: str, new: str) -> None:
    assert judged(ARMS[0], text.replace(old, new, 1)).code is not Code.RIGHT
