"""Ratios by rolling and by inversion, and the conditions a planetary gear must meet."""

from __future__ import annotations

from fractions import Fraction
from math import cos, hypot, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import TrainError
from mechanics.willis import (
    Stage,
    can_be_assembled,
    coaxial,
    coaxial_wheel,
    fixed_axis_ratio,
    planetary_ratio,
    planets_clear,
    third_speed,
)
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

teeth = st.integers(12, 120)
BLOCK = [Stage(51, 50), Stage(49, 52)]
SUN_RING = [Stage(20, 25), Stage(25, 70, "internal")]


def test_published_ratios_hold() -> None:
    assert fixed_axis_ratio([Stage(18, 45)]) == Fraction(-5, 2)  # TR-3
    assert fixed_axis_ratio([Stage(20, 40), Stage(15, 45)]) == 6  # TR-4
    assert fixed_axis_ratio([Stage(20, 40), Stage(15, 75, "internal")]) == -10
    assert float(fixed_axis_ratio(BLOCK)) == pytest.approx(1.040416166)  # TR-5
    assert float(1 / fixed_axis_ratio(BLOCK)) == pytest.approx(0.9611538462)
    assert float(planetary_ratio(BLOCK, "first")) == pytest.approx(0.03884615385)
    assert planetary_ratio(SUN_RING, "last") == Fraction(9, 2)
    assert float(planetary_ratio(SUN_RING, "first")) == pytest.approx(1.285714286)
    assert fixed_axis_ratio(SUN_RING) == Fraction(-7, 2)  # TR-6
    assert float(third_speed(SUN_RING, first=100, last=-10)) == pytest.approx(14.44444444)


@quick
@given(teeth, teeth, teeth)
def test_an_idler_changes_the_sense_and_not_the_size(first: int, idler: int, last: int) -> None:
    assert fixed_axis_ratio([Stage(first, idler), Stage(idler, last)]) == -fixed_axis_ratio([Stage(first, last)])


@quick
@given(teeth, teeth)
def test_the_carrier_of_a_sun_and_ring_is_their_weighted_mean(sun: int, planet: int) -> None:
    ring = sun + 2 * planet
    drawn = [Stage(sun, planet), Stage(planet, ring, "internal")]
    assert third_speed(drawn, first=30, last=-7) == Fraction(30 * sun - 7 * ring, sun + ring)
    assert coaxial(*drawn)


def test_the_third_speed_needs_two() -> None:
    assert third_speed(BLOCK, last=0, carrier=1) == 1 - fixed_axis_ratio(BLOCK)
    for given_speeds in ({}, {"first": 1}, {"first": 1, "last": 1, "carrier": 1}):
        with pytest.raises(TrainError, match="exactly one"):
            third_speed(BLOCK, **given_speeds)


def test_a_carrier_that_sees_both_wheels_turn_alike_is_free() -> None:
    with pytest.raises(TrainError, match="the carrier is free"):
        third_speed([Stage(20, 30), Stage(30, 20)], first=1, last=1)


@pytest.mark.parametrize(("kind", "z3"), [("external", 45), ("internal", 75)])
def test_published_coaxial_wheels_hold(kind: str, z3: int) -> None:
    assert coaxial_wheel(Stage(20, 40), 15, kind) == z3  # type: ignore[arg-type]
    assert coaxial(Stage(20, 40), Stage(15, z3, kind))  # type: ignore[arg-type]
    assert not coaxial(Stage(20, 40), Stage(15, z3 + 1, kind))  # type: ignore[arg-type]


def test_a_wheel_that_fills_the_centre_distance_leaves_no_coaxial_wheel() -> None:
    with pytest.raises(TrainError, match="60 teeth are too many for a centre distance of 30 modules"):
        coaxial_wheel(Stage(20, 40), 60, "external")


def test_equally_spaced_planets_need_whole_quotients() -> None:
    assert [k for k in range(1, 7) if can_be_assembled(20, 70, k)] == [1, 2, 3, 5, 6]


@quick
@given(teeth, teeth, st.integers(2, 8))
def test_planets_are_clear_when_their_tip_circles_are(sun: int, planet: int, planets: int) -> None:
    radius, tip = (sun + planet) / 2, planet / 2 + 1  # module 1
    between = hypot(radius * cos(2 * pi / planets) - radius, radius * sin(2 * pi / planets))
    if abs(between - 2 * tip) > 1e-9:
        assert planets_clear(sun, planet, planets) == (between > 2 * tip)


def test_a_planet_alone_has_no_neighbour_and_none_is_no_number() -> None:
    assert planets_clear(20, 31, 1) and can_be_assembled(20, 82, 1)
    for planets in (0, -3):
        with pytest.raises(ValueError, match=rf"planets = {planets} must be a whole positive number"):
            planets_clear(20, 31, planets)
        with pytest.raises(ValueError, match=rf"planets = {planets} must be a whole positive number"):
            can_be_assembled(20, 82, planets)


@pytest.mark.parametrize("stage", [(0, 20, "external"), (20, -1, "external"), (20, 20, "bevel")])
def test_impossible_stages_are_refused(stage: tuple[int, int, str]) -> None:
    with pytest.raises(ValueError, match=r"teeth|mesh type"):
        Stage(*stage)  # type: ignore[arg-type]
