"""Zeros on a closed loop, where they are known."""

from __future__ import annotations

from math import cos, inf, pi, sin

import pytest

from mechanics.errors import SingularError
from mechanics.loop import zeros

TINY = 1e-15


def test_the_zeros_of_a_sine_are_its_half_turns() -> None:
    found = zeros(lambda t: sin(3 * t - 1), TINY)
    assert [zero.at for zero in found] == pytest.approx([(1 + k * pi) / 3 for k in range(6)], abs=1e-12)
    assert not any(zero.double for zero in found)


def test_two_zeros_between_neighbours_are_seen() -> None:
    found = zeros(lambda t: cos(t - 0.5) - cos(1e-5), TINY)
    assert [zero.at for zero in found] == pytest.approx([0.5 - 1e-5, 0.5 + 1e-5], abs=1e-9)


def test_a_tangency_is_one_double_zero() -> None:
    (found,) = zeros(lambda t: 1 - cos(t - 0.51), TINY)
    assert found.double and found.at == pytest.approx(0.51, abs=1e-6)


def test_a_near_miss_is_no_zero() -> None:
    assert zeros(lambda t: 1 + 1e-9 - cos(t - 0.5), TINY) == []


def test_a_zero_on_a_sample_is_counted_once() -> None:
    assert [zero.at for zero in zeros(sin, TINY)] == pytest.approx([0, pi], abs=1e-12)


def test_three_zeros_within_one_cell_are_told_apart() -> None:
    places = (1.003, 1.00304, 1.03)
    found = zeros(lambda t: sin((t - places[0]) / 2) * sin((t - places[1]) / 2) * sin(t - places[2]), TINY)
    near = [zero.at for zero in found if zero.at < 2]
    assert near == pytest.approx(places, abs=1e-9)


def test_zeros_beside_a_narrow_turn_are_not_passed_over() -> None:
    found = zeros(lambda t: (1e-8 + sin((t - 1.0321) / 2) ** 2) ** 0.5 - 0.001, TINY)
    assert len(found) == 2 and found[0].at + found[1].at == pytest.approx(2 * 1.0321, abs=1e-9)


def test_a_function_that_is_zero_along_a_part_is_refused() -> None:
    with pytest.raises(SingularError, match="zero from"):
        zeros(lambda t: max(0.0, sin(t)), TINY)


def test_a_value_that_is_not_finite_is_refused() -> None:
    with pytest.raises(OverflowError, match="range of floats"):
        zeros(lambda t: inf if t > 3 else 1.0, TINY)
