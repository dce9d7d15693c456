"""A10: an interval, a list or a sum of different quantities instead of a number is unreadable or a dimension error."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Quantity, Symbols, Verdict

NOTHING = Symbols(())
REFERENCE = 12500.0  # N
LISTS = [
    "[12; 13]", "[12, 13]", "12; 13", "12,5; 13", "12,5;12,5", "12.5 ± 0.1", "12 .. 13", "12...13", "{12,5}",
   
    "12 < 12,5",
    "12 <= 12.5 <= 13", "(12; 13)", "12,5 or 13", "12,5 lub 13", "12,5 и 13", "12-13 kN; 12", "[[12,5]]",
    "12,5 kN; 12,5 kN", "12 kN, 12,5 kN", "min(12; 12,5; 13", "12…13", "12 13", "12,5 12,5", "12,5 = 12,5",
]  # fmt: skip
SUMS = [
    "0*kN + 12,5 m", "12,5 kN + 0 m", "12 kN + 0,5 kN", "12,5 kN * 1", "12,5 kN/1 m", "0 kN + 12500 N", "kN*12,5",
    "12,5 + kN", "12,5 kN^0*m", "12,5 + 0 mm mm/",
]  # fmt: skip
WRONG_DIMENSIONS = [
    "12,5 m",
    "12500 m/m",
    "12,5 kN/kN",
    "12,5 kN*m",
    "12,5 kN^2",
    "12,5 1/kN",
    "12,5 %",
    "12,5 kN·s",
    "12,5 kg",
]


def judged(text: str) -> Verdict | AnswerSyntaxError:
    judge = Quantity("kN")
    try:
        return judge.check(judge.parse(text, NOTHING), REFERENCE)
    except AnswerSyntaxError as error:
        return error


@pytest.mark.parametrize("text", LISTS)
def test_a_list_or_interval_is_no_number(text: str) -> None:
    assert isinstance(judged(text), AnswerSyntaxError)


@pytest.mark.parametrize("text", SUMS)
def test_a_sum_of_quantities_is_no_number(text: str) -> None:
    found = judged(text)
    assert isinstance(found, AnswerSyntaxError) or found.code in (Code.WRONG_DIMENSION, Code.WRONG_UNIT)


@pytest.mark.parametrize("text", WRONG_DIMENSIONS)
def test_a_right_number_of_another_dimension_earns_nothing(text: str) -> None:
    found = judged(text)
    assert isinstance(found, Verdict)
    assert (found.code, found.score) == (Code.WRONG_DIMENSION, 0)


@pytest.mark.parametrize("text", ["12,5 N", "12.5 MN", "12,5 mN"])
def test_half_credit_is_kept_for_another_unit_of_the_same_dimension(text: str) -> None:
    found = judged(text)
    assert isinstance(found, Verdict)
    assert (found.code, found.score) == (Code.WRONG_UNIT, 0.5)
