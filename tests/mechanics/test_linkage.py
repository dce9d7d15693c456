"""Angles brought into one turn."""

from __future__ import annotations

from math import cos, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.linkage import principal
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)


@quick
@given(st.floats(-1000, 1000))
def test_principal_angle_is_the_same_direction_within_one_turn(angle: float) -> None:
    found = principal(angle)
    assert -pi < found <= pi
    assert (cos(found), sin(found)) == pytest.approx((cos(angle), sin(angle)), abs=1e-9)


@pytest.mark.parametrize("angle", [pi, -pi, 3 * pi])
def test_half_a_turn_is_given_as_plus_pi(angle: float) -> None:
    assert principal(angle) == pytest.approx(pi)
