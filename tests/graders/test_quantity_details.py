"""What is told of an amount beside right and wrong: other readings of a unit, slips, borders, scores, distances.

Five mutants of the verdict and the distance that mutmut leaves alive change nothing that can be seen:
`<` for `<=` on the border of five tolerances, `<` for `<=` and two changes of the slack of 1e-12 on the border of one,
and another least ratio whose power of ten is taken, far beyond the twelve that are told.
"""

from __future__ import annotations

from math import inf, pi

import pytest

from graders import AnswerSyntaxError, Code, Quantity, Symbols
from graders.language import Reason
from graders.verdict import Verdict

NOTHING = Symbols(())


def judged(judge: Quantity, text: str, reference: float) -> Verdict:
    return judge.check(judge.parse(text, NOTHING), reference)


@pytest.mark.parametrize(
    ("unit", "text", "reference", "code", "score"),
    [
        ("rad/s", "300 1/min", 10 * pi, Code.RIGHT, 1),  # turns a minute
        ("rad/s", "300 1/min", 5.0, Code.RIGHT, 1),  # or radians
        ("rad/s", "300 1/min", 7.0, Code.WRONG, 0),
        ("kN", "7 kN", 5000.0, Code.WRONG, 0),
        ("kN", "5 N", 5000.0, Code.WRONG_UNIT, 0.5),
        ("kN", "5 mm", 5000.0, Code.WRONG_DIMENSION, 0),
        ("kN", "0", 5000.0, Code.WRONG, 0),
        ("kN", "5", 0.0, Code.WRONG, 0),
        ("N", "5e12", 5.0, Code.FACTOR_OF_TEN, 0),
        ("N", "5e-12", 5.0, Code.FACTOR_OF_TEN, 0),
        ("N", "5e13", 5.0, Code.WRONG, 0),
        ("N", "102,4", 100.0, Code.NOT_PRECISE, 0),
        ("N", "102,9", 100.0, Code.WRONG, 0),
        ("N", "201", 200.0, Code.RIGHT, 1),
        ("N", "199", 200.0, Code.RIGHT, 1),
        ("N", "201.00000002", 200.0, Code.NOT_PRECISE, 0),
    ],
)
def test_each_amount_has_its_code_and_score(unit: str, text: str, reference: float, code: Code, score: float) -> None:
    verdict = judged(Quantity(unit, rtol=0.005), text, reference)
    assert verdict.code is code
    assert verdict.score == score


def test_amounts_are_apart_by_so_many_tolerances_of_the_greater() -> None:
    assert Quantity("N", rtol=0.01).apart(100.0, 103.0) == pytest.approx(3 / 1.03)
    assert Quantity("N", rtol=0.01, atol=6.0).apart(100.0, 103.0) == pytest.approx(0.5)
    assert Quantity("N", rtol=0.01).apart(0.0, 0.0) == inf


@pytest.mark.parametrize(
    ("typed", "place", "meant"),
    [
        ("204,O2", 4, "204,02"),
        ("204,O2 mm", 4, "204,02"),
        ("2O4 mm", 1, "204"),
        ("O.5 mm", 0, "0.5"),
        ("l = 20\u043e mm", 6, "200"),
        ("12,l5 mm", 3, "12,15"),
        ("-1OO", 2, "100"),
    ],
)
def test_a_letter_in_a_number_is_pointed_at(typed: str, place: int, meant: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("mm").parse(typed, NOTHING)
    assert (refused.value.position, refused.value.proposal.meant) == (place, meant)


@pytest.mark.parametrize("typed", ["12 obrx", "5 l", "7 Ohm", "12 oz"])
def test_a_letter_of_a_unit_is_no_figure(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("rad").parse(typed, NOTHING)
    assert refused.value.reason is Reason.UNKNOWN_UNIT
