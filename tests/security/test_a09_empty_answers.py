"""A9: an empty answer, a missing part and what holds nothing never earn anything."""

from __future__ import annotations

import pytest

from exercises import catalogue
from exercises.exercise import Submission
from exercises.grading import grade
from exercises.solving import solved
from exercises.variants import deal
from graders import Code

EMPTY = ["", " ", "\t\n", "\u00a0", "\u2009\u202f"]
HOLLOW = ["=", "l3 =", "[]", "[[]]", "()", "<>", "||", ",", ".", ";", "-", "°", "mm", "[mm]", "[[];[]]", "0*", "''"]
HELD = {"text": Code.KEPT}  # a conclusion is read by the lecturer, whatever it holds


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_nothing_earns_nothing(exercise: str) -> None:
    variant = deal(exercise, 7)
    kinds = {name: judge.kind for name, judge in solved(variant).answers.items()}
    hollow = {name: HELD.get(kind, Code.UNREADABLE) for name, kind in kinds.items()}
    for text in (*EMPTY, *HOLLOW):
        graded = grade(Submission(variant, dict.fromkeys(kinds, text)))
        assert graded.score == 0 and graded.mistake is None and not graded.counted, text
        expected = dict.fromkeys(kinds, Code.EMPTY) if text in EMPTY else hollow
        assert {name: verdict.code for name, verdict in graded.verdicts.items()} == expected, text


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_missing_answers_are_empty_and_earn_nothing(exercise: str) -> None:
    graded = grade(Submission(deal(exercise, 7), {}))
    assert graded.score == 0 and not graded.counted and not graded.provisional
    assert {verdict.code for verdict in graded.verdicts.values()} == {Code.EMPTY}


def test_one_right_answer_earns_its_share_only() -> None:
    graded = grade(Submission(deal("slider_crank", 7), {"omega2_formula": "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))"}))
    assert graded.score == pytest.approx(0.2)
