"""A2: power towers, factorials and huge literals are refused by bounds, or cost next to nothing."""

from __future__ import annotations

import pytest

from graders import Code
from graders.language import Reason
from graders.verdict import Reading
from tests.security.conftest import Attack

HUGE = ["1e999999999", "1e-999999999", "1e1000", "9" * 61, "1e" + "9" * 400, "0." + "1" * 60, "l1⁹⁹⁹⁹⁹"]
FACTORIALS = ["10!", "(10!)!", "l1!!", "99999!"]
TOWERS = [
    "9^9^9", "9^9^9^9^9", "10^10^10", "((((9^999)^999)^999)^999)^999", "l1^99999999999", "2^-9^9^9",
    "exp(exp(exp(exp(9))))", "exp(9^9^9)", "sinh(sinh(sinh(99)))", "root(2; 1e-300)", "(1+1e-300)^(1e300)",
    "9^9^9 - 9^9^9", "tan(9^9^9)", "sin(1e999)", "macaulay(l1 + 9^9^9; 9^9^9)", "<9>^<9>^<9>^999", "log(9^9^9^9; 2)",
    "max(9^9^9; l1)", "9**9**9**9", "9⁹⁹⁹^999", "(l1^1000)^1000^1000", "cos(exp(exp(9)))^999",
]  # fmt: skip


@pytest.mark.parametrize("text", HUGE)
@pytest.mark.parametrize("answer", ["omega2_formula", "l3"])
def test_a_huge_literal_is_refused_before_arithmetic(attack: Attack, text: str, answer: str) -> None:
    verdict = attack(text, answer)
    assert verdict.code is Code.UNREADABLE
    assert isinstance(verdict.details, Reading)
    assert verdict.details.reason in (Reason.TOO_LARGE, Reason.OUT_OF_RANGE, Reason.NOT_A_NUMBER)


@pytest.mark.parametrize("text", FACTORIALS)
def test_factorials_are_not_in_the_language(attack: Attack, text: str) -> None:
    assert attack(text).code is Code.UNREADABLE
    assert attack(text, "l3").code is Code.UNREADABLE


@pytest.mark.parametrize("text", TOWERS)
def test_a_tower_costs_nothing_and_earns_nothing(attack: Attack, text: str) -> None:
    assert attack(text).score == attack(text, "l3").score == 0
    assert attack(f"{text} + l1", "omega2_formula").score == 0
