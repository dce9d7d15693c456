"""Slips at an epicyclic train: which ratio is given, and of which members."""

from __future__ import annotations

from math import pi, sin
from typing import Literal

import pytest

from exercises import variants
from exercises.exercise import Submission, Variant
from exercises.grading import grade, reference
from exercises.solving import solved
from exercises.transmissions.planetary import Givens
from exercises.transmissions.planetary.wheels import Planet, Ring, Sun
from tests.depth import amount

WHEELS = Sun(20), Planet(31), Ring(82)


@pytest.mark.parametrize("seed", range(amount(60, 400)))
def test_three_planets_have_room_beside_one_another_in_both_planes(seed: int) -> None:
    wheels = variants.deal("planetary", seed).givens.wheels
    between = (wheels[0].z + wheels[1].z) * sin(pi / 3)  # axes of neighbours, in modules
    for rim in wheels[1:-1]:
        assert rim.z + 2 < between, wheels


@pytest.mark.parametrize("seed", range(amount(60, 400)))
def test_no_wheel_turns_faster_than_wheels_do(seed: int) -> None:
    values = solved(variants.deal("planetary", seed)).values
    for name in ("n_out", "n_2"):
        assert abs(values[name]) <= 6000 * pi / 30 * (1 + 1e-12), values  # type: ignore[arg-type]


def named(held: Literal["first", "last"], driver: Literal["wheel", "carrier"], **lines: str) -> str | None:
    """Give the mistake by which the answers that follow from other lines are explained."""
    variant = Variant("planetary", 1, 1, Givens(WHEELS, 100.0, held, driver))
    known = solved(variant)
    values = known.again(replaced=lines)
    typed = {name: judge.show(values[name]) for name, judge in known.answers.items() if not judge.symbolic}
    return grade(Submission(variant, {**reference(variant), **typed})).mistake


@pytest.mark.parametrize("driver", ["wheel", "carrier"])
def test_the_ratio_seen_from_the_carrier_is_taken_from_the_driver_to_the_driven(
    driver: Literal["wheel", "carrier"],
) -> None:
    upright, over = ("u0", "1/u0") if driver == "wheel" else ("1/u0", "u0")
    assert named("last", driver, u=upright) == named("first", driver, u=over) == "fixed_axes"
    assert named("last", driver, u=over) == named("first", driver, u=upright) == "fixed_reciprocal"


def test_a_planet_on_an_axis_at_rest_is_held_by_a_wheel_at_rest() -> None:
    assert named("first", "carrier", n_2="0") == named("last", "wheel", n_2="-z1/z2*n_in") == "carrier_forgotten"


def test_the_input_speed_over_the_ratio_seen_from_the_carrier_is_told() -> None:
    assert named("last", "wheel", n_out="n_in/u0") == "by_u0"
