"""Notations that many students use and that a narrow reader refuses; and those that stay refused."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Choice, Integer, Quantity, Symbols
from graders.language import parse

NOTHING = Symbols(())


@pytest.mark.parametrize(
    ("typed", "newtons"),
    [
        ("12.5 * 10^3", 12.5e6),
        ("12,5 ∙ 10 ^ 3 N", 12.5e3),
        ("1,25е4 N", 12.5e3),
        ("1.25 x 10^4 N", 12.5e3),
        ("1,25х10⁴ Н", 12.5e3),
        ("12.5 (kN)", 12.5e3),
        ("12.5(kN)", 12.5e3),
        ("≈ 12,5 kN", 12.5e3),
        ("= 12.5 kN", 12.5e3),
        ("F ≈ 12,5 kN", 12.5e3),
        ("12 500 N", 12.5e3),
        ("12 500,0 N", 12.5e3),
        ("-1 234 567 N", -1234567),
        ("25/2 kN", 12.5e3),
        ("2 pi kN", 6283.185307179586),
        ("12.5 кH", 12.5e3),
        ("1.25 daN", 12.5),
    ],
)
def test_a_force_is_read_as_it_is_meant(typed: str, newtons: float) -> None:
    assert Quantity("kN").parse(typed, NOTHING).value == pytest.approx(newtons, rel=1e-14)


@pytest.mark.parametrize(
    ("typed", "unit", "value"),
    [
        ("2 s-1", "1/s", 2),
        ("2 s–1", "1/s", 2),
        ("3 kN-m", "N*m", 3e3),
        ("3 kg-m2", "kg*m^2", 3),
        ("3 kNm²", "N*m^2", 3e3),
        ("90 obr./min", "rpm", 9.42477796076938),
        ("3 m./s.", "m/s", 3),
    ],
)
def test_a_unit_is_read_as_it_is_meant(typed: str, unit: str, value: float) -> None:
    assert Quantity(unit).parse(typed, NOTHING).value == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("typed", "place"),
    [
        ("2 125/1000 m", 2),
        ("12 34 N", 3),
        ("1 2345", 2),
        ("0,123 456", 6),
        ("12 500 qq", 7),
        ("2 m-", 4),
        ("5 N - 2", 6),
    ],
)
def test_what_may_mean_two_things_is_refused_at_its_place(typed: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("kN").parse(typed, NOTHING)
    assert refused.value.position == place


@pytest.mark.parametrize("typed", ["４５", "45.", "= 45", "z ≈ 45", "z₃ = 45", "3·20 − 15 = 45"])
def test_a_whole_number_is_read_as_it_is_meant(typed: str) -> None:
    assert Integer().parse(typed, NOTHING) == 45


@pytest.mark.parametrize("typed", ["(b)", "B.", "sense = b", "sense = stiffness", "в".upper()])
def test_an_option_is_read_as_it_is_meant(typed: str) -> None:
    assert Choice(("strength", "stiffness")).parse(typed, NOTHING) == "stiffness"


FORMULA = Symbols(["l1", "l2", "alpha1", "omega1", "a", "x"])


@pytest.mark.parametrize(
    ("typed", "plain"),
    [
        ("l1ω1", "l1 omega1"),
        ("l₁ω₁cosα₁", "l1 omega1 cos(alpha1)"),
        ("cosα1", "cos(alpha1)"),
        ("sinα1cosα1", "sin(alpha1) cos(alpha1)"),
        ("2l1l2^2", "2 l1 l2^2"),
        ("l1cos(α1)", "l1 cos(alpha1)"),
        ("sin(alfa1)*омега1", "sin(alpha1)*omega1"),
        ("альфа_1", "alpha1"),
    ],
)
def test_a_run_of_names_is_cut_at_its_visible_borders(typed: str, plain: str) -> None:
    assert parse(typed, FORMULA) == parse(plain, FORMULA)


@pytest.mark.parametrize(("typed", "place"), [("1 + ax", 4), ("l12", 0), ("l1b2", 0), ("sinα1l1", 5), ("1/l1ω1", 4)])
def test_a_run_without_visible_borders_is_asked_about(typed: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(typed, FORMULA)
    assert refused.value.position == place
