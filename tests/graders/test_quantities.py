"""Numbers with a unit: value, unit, sign, power of ten, angles and speeds are told apart."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Code, Quantity, Symbols
from graders.language import Reason
from tests.graders.judging import NOTHING, judged


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("12,5", Code.RIGHT),
        ("12500 kPa", Code.RIGHT),
        ("1,25e7 Pa", Code.RIGHT),
        ("12,5 N/mm²", Code.RIGHT),
        ("25/2", Code.RIGHT),
        ("12.5 [MPa]", Code.RIGHT),
        ("σ = 12,5 МПа", Code.RIGHT),
        ("1.25·10^7 N/m^2", Code.RIGHT),
        ("12.5625", Code.RIGHT),
        ("12.4375", Code.RIGHT),
        ("12.56251", Code.NOT_PRECISE),
        ("１２.5", Code.RIGHT),
        ("12.5 kPa", Code.WRONG_UNIT),
        ("12.5 mm", Code.WRONG_DIMENSION),
        ("12.5 N", Code.WRONG_DIMENSION),
        ("12.5 N/m", Code.WRONG_DIMENSION),
        ("-12.5", Code.OPPOSITE_SIGN),
        ("13 mm", Code.WRONG_DIMENSION),
        ("125", Code.FACTOR_OF_TEN),
        ("0.0125", Code.FACTOR_OF_TEN),
        ("40", Code.WRONG),
        ("0", Code.WRONG),
    ],
)
def test_value_unit_sign_and_power_of_ten_are_told_apart(typed: str, code: Code) -> None:
    assert judged(Quantity("MPa"), typed, 12.5e6) is code


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        ("1..2", Reason.BAD_CHARACTER),
        ("5 qq", Reason.UNKNOWN_UNIT),
        ("NaN", Reason.NOT_A_NUMBER),
        ("inf", Reason.NOT_A_NUMBER),
        ("1e400", Reason.OUT_OF_RANGE),
        ("9^9^9^9", Reason.OUT_OF_RANGE),
        ("MPa", Reason.NOT_A_NUMBER),
        ("", Reason.EMPTY),
        ("[1; 2]", Reason.NOT_A_NUMBER),
        ("0*kN + 5 m", Reason.UNKNOWN_UNIT),
        ("1e98 GPa", Reason.OUT_OF_RANGE),
        ("1/0", Reason.OUT_OF_RANGE),
        ("3 < 5", Reason.NOT_A_NUMBER),
        ("True", Reason.NOT_A_NUMBER),
    ],
)
def test_what_is_no_quantity_is_unreadable(typed: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("MPa").parse(typed, NOTHING)
    assert refused.value.reason is reason


@pytest.mark.parametrize("typed", ["-asin(l1*sin(alpha1)/l2)", "0,5*sin(alpha1)"])
def test_a_formula_where_a_number_is_asked_for_is_answered_by_asking_for_the_number(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("deg").parse(typed, Symbols(["l1", "l2", "alpha1"]))
    assert refused.value.reason is Reason.NOT_A_NUMBER


@given(st.floats(-math.pi, math.pi), st.integers(-3, 3))
def test_an_angle_is_right_modulo_a_full_turn(angle: float, turns: int) -> None:
    typed = f"{math.degrees(angle) + 360 * turns:.9f}"
    assert judged(Quantity("deg", atol=1e-6), typed, angle) is Code.RIGHT


@given(st.floats(1e-3, 1e6), st.sampled_from(["", " ", "\u00a0"]))
def test_four_figures_are_enough(value: float, gap: str) -> None:
    assert judged(Quantity("kN"), f"{value / 1e3:.4g}{gap}kN".replace(".", ","), value) is Code.RIGHT


@pytest.mark.parametrize("typed", ["-12,37°", "-12°22'20\"", "347.63", "-0.21593 rad", "-12.37 deg", "347,63 stopni"])
def test_angles_are_read_in_degrees_minutes_and_radians(typed: str) -> None:
    assert judged(Quantity("deg"), typed, -0.2159367698) is Code.RIGHT


@pytest.mark.parametrize(
    "typed",
    [
        "-asin(45*sin(105°)/220)",
        "-arcsin(45/220·sin105°)",
        "-asin(0.197576)",
        "-arcsin 0,197576 rad",
        "-asin(45*sin(105°)/220)*180/pi",
        "-180/π·arcsin(45·sin(105°)/220)",
        "180 - 191,3952°",
        "-0,198884·180/π °",
        "asin(0.802424*sin(90°)) - 64.7582°",
        "-11,3952 stopnia",
        "-11.3952 degrees",
        "-0.198884 radians",
        "-11,3952 градуса",
    ],
)
def test_a_computed_angle_is_read_in_the_unit_it_speaks_of(typed: str) -> None:
    assert judged(Quantity("deg"), typed, -0.198884) is Code.RIGHT


@pytest.mark.parametrize(
    ("unit", "reference", "typed"),
    [
        ("mm", 0.2040164, "45*cos(105°) + 220*cos(-11,3952°)"),
        ("mm", 0.2040164, "45·cos105° + 220·cos 11,3952°"),
        ("m", 0.1047198, "0,2*30°"),
        ("m", 0.1047198, "0.4*asin(0.2588190)"),
        ("1", 1.0, "tg45°"),
    ],
)
def test_a_degree_sign_inside_a_function_does_not_make_an_angle(unit: str, reference: float, typed: str) -> None:
    assert judged(Quantity(unit), typed, reference) is Code.RIGHT


def test_an_angle_where_none_is_asked_for_is_of_another_dimension() -> None:
    assert judged(Quantity("mm"), "30°", 0.03) is Code.WRONG_DIMENSION


def test_credit_for_a_number_in_the_wrong_unit_is_declared_by_the_task() -> None:
    assert Quantity("MPa").check(Quantity("MPa").parse("12.5 kPa", NOTHING), 12.5e6).score == 0.5
    strict = Quantity("MPa", unit_credit=0.0)
    assert strict.check(strict.parse("12.5 kPa", NOTHING), 12.5e6).score == 0


@pytest.mark.parametrize(
    ("unit", "reference", "typed"),
    [
        ("N*m", 25.0, "25 J"),
        ("kN*m", 25e3, "25 kJ"),
        ("rad/s", 25.0, "25 Hz"),
        ("Hz", 25.0, "25 rad/s"),
        ("Hz", 25.0, "1500 rpm"),
        ("rad", 0.5, "0,5 m"),
        ("W", 100.0, "100 J"),
    ],
)
def test_a_right_number_of_another_quantity_earns_nothing(unit: str, reference: float, typed: str) -> None:
    judge = Quantity(unit)
    verdict = judge.check(judge.parse(typed, NOTHING), reference)
    assert (verdict.code, verdict.score) == (Code.WRONG_DIMENSION, 0)


@pytest.mark.parametrize(
    "typed",
    ["1500", "1500 rpm", "1500 obr/min", "1500 об/мин", "1500 rev/min", "1500 obr./min", "25 obr/s", "25 об/с",
     "1500 1/min", "1500 min^-1", "1500 мин⁻¹", "25 1/s", "157,08 rad/s", "9000 deg/s"],
)  # fmt: skip
def test_a_speed_of_rotation_is_read_in_turns_or_radians(typed: str) -> None:
    assert judged(Quantity("rpm"), typed, 1500 * math.pi / 30) is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "code"),
    [("25 1/s", Code.RIGHT), ("25 rad/s", Code.RIGHT), ("25 obr/s", Code.WRONG_UNIT), ("25 Hz", Code.WRONG_DIMENSION)],
)
def test_a_bare_second_below_the_line_means_radians_where_radians_are_asked(typed: str, code: Code) -> None:
    assert judged(Quantity("rad/s"), typed, 25.0) is code
