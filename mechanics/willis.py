"""Gear ratios by rolling pitch circles and by inversion: the independent way to check a gear train.

No equations are solved: turns are passed from wheel to wheel over pitch points (domain TR-3, TR-4), and an epicyclic
train is first seen from its carrier (Willis; TR-5, TR-6). Ratios are exact, + for the same sense of rotation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi, sin
from typing import Literal

from mechanics.checks import count
from mechanics.errors import TrainError

Exact = int | Fraction


@dataclass(frozen=True, slots=True)
class Stage:
    """A mesh passed from the driving to the driven wheel."""

    driving_z: int
    driven_z: int
    type: Literal["external", "internal"] = "external"

    def __post_init__(self) -> None:
        if min(self.driving_z, self.driven_z) < 1:
            raise ValueError(f"teeth {self.driving_z} and {self.driven_z} must be positive")
        if self.type not in ("external", "internal"):
            raise ValueError(f"mesh type {self.type!r} must be external or internal")

    def centre_distance(self) -> Fraction:
        """Distance of the axes for the module 1."""
        if self.type == "external":
            return Fraction(self.driving_z + self.driven_z, 2)
        return Fraction(abs(self.driven_z - self.driving_z), 2)


def fixed_axis_ratio(stages: Sequence[Stage]) -> Fraction:
    """Find u = omega_first/omega_last of wheels on fixed axes, driven wheel and next driving wheel on one shaft.

    Args:
        stages: The meshes in the order of the power flow.

    Returns:
        The signed ratio: the first shaft is turned once, each pitch point passes its speed on without slip.

    Source:
        Domain TR-3, TR-4.
    """
    first, last = _turns(stages)
    return Fraction(first, last)


def _turns(stages: Sequence[Stage]) -> tuple[int, int]:
    """Give whole numbers in the proportion of the turns of the first and the last shaft.

    A pitch circle has the radius z/2 for the module 1, so wheels that roll make turns z_driven and z_driving.
    """
    first = last = 1
    for stage in stages:
        first *= stage.driven_z
        last *= stage.driving_z if stage.type == "internal" else -stage.driving_z  # the point lies between the axes
    return first, last


def planetary_ratio(stages: Sequence[Stage], fixed: Literal["first", "last"]) -> Fraction:
    """Find the ratio of the free central wheel to the carrier when the other central wheel is fixed.

    Args:
        stages: The meshes from the first central wheel over the planets to the last, as seen from the carrier.
        fixed: The central wheel that stands still.

    Returns:
        u_1H = 1 - u_1n^H for the last wheel fixed, u_nH = 1 - 1/u_1n^H for the first.

    Source:
        Domain TR-5.
    """
    first, last = _turns(stages)  # as seen from the carrier
    return Fraction(last - first, last) if fixed == "last" else Fraction(first - last, first)


def third_speed(
    stages: Sequence[Stage], first: Exact | None = None, last: Exact | None = None, carrier: Exact | None = None
) -> Fraction:
    """Find the third of the speeds of a differential from the two that are given.

    Args:
        stages: The meshes from the first central wheel to the last, as seen from the carrier.
        first: Speed of the first central wheel, in rad/s, or None when asked for.
        last: Speed of the last central wheel, in rad/s, or None when asked for.
        carrier: Speed of the carrier, in rad/s, or None when asked for.

    Raises:
        TrainError: Not exactly one speed is asked for, or the train turns as one body (u_1n^H = 1), which leaves the
            carrier free.

    Source:
        Domain TR-6: omega_1 - u0 omega_n = (1 - u0) omega_H.
    """
    seen = fixed_axis_ratio(stages)
    if first is not None and last is not None and carrier is None:
        if seen == 1:
            raise TrainError("the carrier is free: seen from it the two central wheels turn alike")
        return (first - seen * last) / (1 - seen)
    if first is None and last is not None and carrier is not None:
        return carrier + seen * (last - carrier)
    if last is None and first is not None and carrier is not None:
        return carrier + (first - carrier) / seen
    raise TrainError("exactly one of the speeds of first, last and carrier is asked for")


def coaxial(first: Stage, second: Stage) -> bool:
    """Tell whether two stages of one module can return to the first axis: their centre distances agree (TR-4)."""
    return first.centre_distance() == second.centre_distance()


def coaxial_wheel(first: Stage, driving_z: int, type: Literal["external", "internal"]) -> int:
    """Find the teeth of the last wheel that bring a second stage of the same module back to the first axis.

    Raises:
        TrainError: No wheel fits: its number of teeth would not be a positive whole one.

    Source:
        Domain TR-4: z1 + z2 = z2' + z3 (external), z1 + z2 = z3 - z2' (internal).
    """
    twice = 2 * first.centre_distance()
    teeth = twice - driving_z if type == "external" else twice + driving_z
    if teeth < 1:
        raise TrainError(
            f"no coaxial wheel: {driving_z} teeth are too many for a centre distance of {twice / 2} modules"
        )
    return int(teeth)


def can_be_assembled(sun_z: int, ring_z: int, planets: int) -> bool:
    """Tell whether equally spaced planets fit the teeth: (z_s + z_r)/K is whole (TR-5).

    Raises:
        ValueError: The number of planets is no whole positive number.
    """
    count("planets", planets)
    return (sun_z + ring_z) % planets == 0


def planets_clear(sun_z: int, planet_z: int, planets: int) -> bool:
    """Tell whether neighbouring planets do not touch: (z_s + z_p) sin(pi/K) > z_p + 2 (TR-5); one has no neighbour.

    Raises:
        ValueError: The number of planets is no whole positive number.
    """
    count("planets", planets)
    return planets == 1 or (sun_z + planet_z) * sin(pi / planets) > planet_z + 2
