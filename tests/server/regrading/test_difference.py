"""What changes between two grades, and which of them stays in force."""

from __future__ import annotations

from typing import Any

import pytest

from server.regrading.difference import Answer, Effect, Said, difference

RIGHT = {"code": "right", "score": 1.0, "details": None}
WRONG = {"code": "wrong", "score": 0.0, "details": None}
SIGN = WRONG | {"code": "opposite_sign"}


def grade(version: str, score: float, **verdicts: Any) -> dict[str, Any]:
    return {"verdicts": verdicts, "score": score, "mistake": None, "grader_version": version}


@pytest.mark.parametrize(
    ("old", "new", "allow_lower", "effect", "in_force"),
    [
        (grade("1", 0.5, a=RIGHT, b=WRONG), grade("2", 1.0, a=RIGHT, b=RIGHT), False, Effect.RAISED, True),
        (grade("1", 1.0, a=RIGHT), grade("2", 0.0, a=WRONG), False, Effect.WITHHELD, False),
        (grade("1", 1.0, a=RIGHT), grade("2", 0.0, a=WRONG), True, Effect.LOWERED, True),
        (grade("1", 0.0, a=WRONG), grade("2", 0.0, a=SIGN), False, Effect.REWORDED, True),
        (grade("1", 1.0, a=RIGHT), grade("2", 1.0, a=RIGHT), False, Effect.SAME, False),
        (grade("1", 1.0, a=RIGHT), grade("1", 1.0, a=RIGHT), True, Effect.SAME, False),
    ],
)
def test_a_lower_score_replaces_a_higher_one_only_if_allowed(
    old: Any, new: Any, allow_lower: bool, effect: Effect, in_force: bool
) -> None:
    found = difference(old, new, allow_lower)
    assert (found.effect, found.in_force, found.old, found.new) == (effect, in_force, old["score"], new["score"])


def test_the_answers_that_differ_are_told_old_and_new() -> None:
    found = difference(grade("1", 0.5, a=RIGHT, b=WRONG), grade("2", 0.5, b=SIGN, c=RIGHT), False)
    right, wrong, sign = Said("right", "right", 1.0), Said("wrong", "wrong", 0.0), Said("wrong", "opposite_sign", 0.0)
    assert found.answers == (Answer("a", right, None), Answer("b", wrong, sign), Answer("c", None, right))


def test_another_recognised_slip_is_another_reason() -> None:
    old = grade("1", 0.0, a=WRONG)
    found = difference(old, old | {"mistake": "lost_minus"}, False)
    assert (found.effect, found.answers) == (Effect.REWORDED, ())


def test_a_code_that_is_not_given_any_more_is_told_as_it_was() -> None:
    old = grade("0", 0.0, a={"code": "misspelt", "score": 0.0})
    assert difference(old, grade("1", 1.0, a=RIGHT), False).answers[0].old == Said("undecided", "misspelt", 0.0)
