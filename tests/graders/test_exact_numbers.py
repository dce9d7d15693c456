"""Whole numbers and ratios: read however they are typed, judged exactly."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import Code, Integer, Rational
from tests.graders.judging import judged


@pytest.mark.parametrize("typed", ["45", " z3 = 45 ", "+45", "45,0", "45.00"])
def test_a_whole_number_is_read_however_it_is_typed(typed: str) -> None:
    assert judged(Integer(), typed, 45.0) is Code.RIGHT


def test_a_whole_number_of_the_opposite_sign_is_named() -> None:
    assert judged(Integer(), "−45", 45.0) is Code.OPPOSITE_SIGN


@pytest.mark.parametrize(
    ("judge", "typed", "code"),
    [
        (Rational(), "-8/3", Code.RIGHT),
        (Rational(), "−8 : 3", Code.RIGHT),
        (Rational(), "i_14 = -8/3", Code.RIGHT),
        (Rational(), "8/(-3)", Code.RIGHT),
        (Rational(), "-(80/20)*(40/60)", Code.RIGHT),
        (Rational(), "-2 - 2/3", Code.RIGHT),
        (Rational(), r"-\frac{8}{3}", Code.RIGHT),
        (Rational(), r"i_{14}=-\frac83", Code.RIGHT),
        (Rational(), "8/3", Code.OPPOSITE_SIGN),
        (Rational(), "-3/8", Code.INVERTED_RATIO),
        (Rational(), "3/8", Code.WRONG),
        (Rational(), "-2,667", Code.NOT_EXACT),
        (Rational(), "-2.666666666666667", Code.NOT_EXACT),
        (Rational(), "0", Code.WRONG),
        (Rational(rtol=0.005), "-2,667", Code.RIGHT),
        (Rational(rtol=0.005), "-2,69", Code.NOT_PRECISE),
        (Rational(either=True), "-3:8", Code.RIGHT),
        (Rational(either=True), "3:8", Code.WRONG),
        (Rational(), "(2^3)/(-3)", Code.RIGHT),
    ],
)
def test_a_ratio_is_judged_by_its_declared_direction_and_exactly(judge: Rational, typed: str, code: Code) -> None:
    assert judged(judge, typed, -8 / 3) is code


@given(st.integers(-200_000, 200_000).filter(bool), st.integers(1, 200_000))
def test_a_product_of_teeth_is_recovered_from_its_double(over: int, under: int) -> None:
    assert judged(Rational(), f"{over}/{under}", over / under) is Code.RIGHT


@pytest.mark.parametrize(("one", "other", "apart"), [(2.0, 2.0, 0), (2.0, 2.02, 0.990099), (4.0, 0.25, 93.75)])
def test_ratios_with_a_tolerance_lie_apart_by_it(one: float, other: float, apart: float) -> None:
    assert Rational(rtol=0.01).apart(one, other) == pytest.approx(apart, rel=1e-5)
    assert Rational().apart(one, other) == (math.inf if apart else 0)
    assert Rational(either=True).apart(4.0, 0.25) == 0
