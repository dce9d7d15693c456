"""Formulas: equal as functions or proved different."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Expression, Formula, States, Symbols
from graders.language import Reason, parse_line
from graders.verdict import Witness
from tests.graders.judging import NAMES, OMEGA2, STATES, SYMBOLS, judged


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("-l1*ω1*cos(α1)/(l2*cos(α2))", Code.RIGHT),
        ("-l1*ω1*cos(α1)/sqrt(l2^2 - l1^2*sin(α1)^2)", Code.RIGHT),
        ("ω1 cos α1 (-l1)/(l2 cos α2)", Code.RIGHT),
        ("ω2 = -l1 ω1 cos(α1)/(l2 cos(α2))", Code.RIGHT),
        ("-l1*ω1*cos(α1)/(l2*cos(α2)) * (1 + 1e-9)", Code.WRONG),
        ("-l1*ω1*cos(α1)/(l2*cos(α2)) + 1e-12", Code.WRONG),
        ("-l1*ω1*sin(α1)/(l2*cos(α2))", Code.WRONG),
        ("sqrt(-1 - l1)", Code.UNDEFINED),
        ("1/(l1 - l1)", Code.UNDEFINED),
        ("-l1*ω1*cos(α1)/(l2*cos(α2)).", Code.RIGHT),
        ("2", Code.NO_SYMBOLS),
        ("-0,09*12*cos(30°)/0,25", Code.NO_SYMBOLS),
    ],
)
def test_formulas_are_equal_as_functions_or_proved_different(typed: str, code: Code) -> None:
    assert judged(Expression("omega2"), typed, OMEGA2, SYMBOLS) is code


@pytest.mark.parametrize("front", ["w2 = ", "i=", "= ", "ω_2 = ", "Omega = ", r"\omega_2=", "скорость = "])
def test_what_the_result_is_called_says_nothing(front: str) -> None:
    assert judged(Expression("omega2"), front + "-l1*ω1*cos(α1)/(l2*cos(α2))", OMEGA2, SYMBOLS) is Code.RIGHT


@pytest.mark.parametrize(
    "front",
    [
        r"\dot{\alpha}_2 = ",
        r"\dot{\alpha_2} = ",
        "α̇₂ = ",
        "alpha2' = ",
        "alpha_2_dot = ",
        "ω2 = α̇2 = ",
        "dα2/dt = ",
        "ω₂ = d(alpha_2)/dt = ",
        r"\omega_2=\frac{\mathrm{d}\alpha_2}{\mathrm{d}t}=",
    ],
)
def test_the_rate_that_is_asked_for_may_stand_in_front(front: str) -> None:
    judge = Expression("omega2", rates=("alpha2_d",))
    assert judged(judge, front + "-l1*ω1*cos(α1)/(l2*cos(α2))", OMEGA2, SYMBOLS) is Code.RIGHT


@pytest.mark.parametrize("front", [r"\dot{\alpha}_1 = ", "dα1/dt = ", "α̈2 = ", "alpha2'' = ", "l2 = dα2/dt = "])
def test_another_rate_in_front_is_asked_about(front: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        judged(Expression("omega2", rates=("alpha2_d",)), front + "l1*ω1", OMEGA2, SYMBOLS)


@pytest.mark.parametrize(
    "front", ["l2 = ", "l2ω2 = ", "l2*ω2 = ", "2 = ", "pi = ", "sin = ", "x y = ", "i = u = ", "alpha2 = "]
)
def test_another_quantity_in_front_makes_an_equation(front: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        judged(Expression("omega2"), front + "-l1*ω1*cos(α1)/(l2*cos(α2))", OMEGA2, SYMBOLS)


def test_a_different_formula_comes_with_a_witness() -> None:
    judge = Expression("omega2")
    verdict = judge.check(judge.parse("l1", SYMBOLS), OMEGA2)
    assert isinstance(verdict.details, Witness)
    assert [name for name, _ in verdict.details.point] == list(NAMES)


@pytest.mark.parametrize(
    ("typed", "reason", "place"),
    [
        ("omega2", Reason.FORBIDDEN_NAME, 0),
        ("l1 + ω2", Reason.FORBIDDEN_NAME, 5),
        ("l1 = l2", Reason.NOT_AN_EXPRESSION, 0),
    ],
)
def test_the_unknown_itself_is_no_answer(typed: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Expression("omega2").parse(typed, SYMBOLS)
    assert (refused.value.reason, refused.value.position) == (reason, place)


def test_a_formula_that_cancels_to_zero_is_accepted_for_zero() -> None:
    zero = Formula(parse_line("sin(alpha1)^2 + cos(alpha1)^2 - 1"), STATES)
    assert judged(Expression("z"), "0", zero, SYMBOLS) is Code.RIGHT


def test_brackets_that_open_inside_the_domain_are_seen() -> None:
    states = States(("x", "a"), tuple((0.2 * k + 0.03, 1.5) for k in range(16)))
    reference = Formula(parse_line("macaulay(x - a; 1)"), states)
    names = Symbols(["x", "a"])
    assert judged(Expression("M"), "<x-a>", reference, names) is Code.RIGHT
    assert judged(Expression("M"), "x - a", reference, names) is Code.WRONG
    assert judged(Expression("M"), "(x - a + |x - a|)/2", reference, names) is Code.RIGHT
