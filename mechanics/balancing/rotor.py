"""Balancing of rotors in one plane and in two (domain BV-2 to BV-5).

Axis of the rotor x, angles counter-clockwise in the plane across it; an unbalance is D = m r, a complex number in
kg m whose argument is its angle.
"""

from __future__ import annotations

import sys
from cmath import phase, rect
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from mechanics.checks import finite, positive
from mechanics.motion import principal

BALANCED = 1e-9  # of the sum of magnitudes: what counts as no couple


@dataclass(frozen=True, slots=True)
class PointMass:
    """A mass fixed to the rotor."""

    m: float  # kg
    r: float  # distance from the axis, m
    angle: float  # rad
    x: float = 0.0  # place along the axis, m

    def __post_init__(self) -> None:
        for name, value, unit in (
            ("m", self.m, "kg"),
            ("r", self.r, "m"),
            ("angle", self.angle, "rad"),
            ("x", self.x, "m"),
        ):
            finite(f"mass: {name}", value, unit)
        if self.m < 0 or self.r < 0:
            raise ValueError(f"mass: m = {self.m} kg and r = {self.r} m must not be negative")

    @property
    def unbalance(self) -> complex:
        """D = m r as a vector, kg m."""
        return rect(self.m * self.r, self.angle)


@dataclass(frozen=True, slots=True)
class Plane:
    """A plane in which a correction can be fixed at a radius."""

    x: float  # m
    r: float  # m

    def __post_init__(self) -> None:
        finite("plane: x", self.x, "m")
        positive("plane: r", self.r, "m")


@dataclass(frozen=True, slots=True)
class Correction:
    """A mass to add in a plane."""

    mr: float  # kg m
    m: float  # kg
    angle: float  # rad, in (-pi, pi]

    @property
    def unbalance(self) -> complex:
        """D = m r as a vector, kg m."""
        return rect(self.mr, self.angle)


@dataclass(frozen=True, slots=True)
class Balance:
    """Corrections, and what is left of force and couple, both over omega^2."""

    corrections: tuple[Correction, ...]
    residual_force: float  # |sum D|, kg m
    residual_moment: float  # |sum x D| about x = 0, kg m^2
    static: bool  # a couple is left: one plane balances the rotor statically only


def balance(masses: Sequence[PointMass], planes: Sequence[Plane]) -> Balance:
    """Balance a rotor in one plane (statically) or in two.

    Raises:
        ValueError: There are no masses, not one or two planes, or both planes are one.

    Source:
        Domain BV-3, BV-5: D_II = -sum (x - x_I) D/(x_II - x_I), D_I = -sum D - D_II.
    """
    if not masses:
        raise ValueError("a rotor without masses has nothing to balance")
    total = sum((mass.unbalance for mass in masses), 0j)
    if len(planes) == 1:
        found = [-total]
    elif len(planes) == 2:
        one, two = planes
        if one.x == two.x:
            raise ValueError(f"both planes stand at x = {one.x} m: two planes must be apart")
        second = -sum(((mass.x - one.x) * mass.unbalance for mass in masses), 0j) / (two.x - one.x)
        found = [-total - second, second]
    else:
        raise ValueError(f"{len(planes)} planes: a rotor is balanced in one plane or in two")
    return _left(masses, planes, found)


def _left(masses: Sequence[PointMass], planes: Sequence[Plane], found: Sequence[complex]) -> Balance:
    corrections = tuple(
        Correction(abs(D), abs(D) / plane.r, principal(phase(D)) if D else 0.0)
        for D, plane in zip(found, planes, strict=True)
    )
    force = sum((mass.unbalance for mass in masses), sum(found, 0j))
    moment = sum((mass.x * mass.unbalance for mass in masses), 0j)
    moment += sum((plane.x * D for plane, D in zip(planes, found, strict=True)), 0j)
    arms = sum(abs(mass.x * mass.unbalance) for mass in masses)
    arms += sum(abs(plane.x * D) for plane, D in zip(planes, found, strict=True))
    couple = abs(moment) > max(BALANCED * arms, sys.float_info.min)  # smaller numbers have no figures to compare
    return Balance(corrections, abs(force), abs(moment) if couple else 0.0, couple)


def shared_by_planes(unbalance: float, l_I: float, l_II: float) -> tuple[float, float]:
    """Share a static unbalance (kg m) between planes at distances l_I and l_II (m) on both sides of S (BV-4).

    Raises:
        ValueError: A distance is not positive and finite, or the unbalance not finite.
    """
    finite("unbalance", unbalance, "kg m")
    positive("distance l_I", l_I, "m")
    positive("distance l_II", l_II, "m")
    return unbalance * l_II / (l_I + l_II), unbalance * l_I / (l_I + l_II)


UnbalanceKind = Literal["balanced", "static", "moment", "dynamic"]
KINDS: dict[tuple[bool, bool], UnbalanceKind] = {  # whether a force, whether a couple is left
    (False, False): "balanced", (True, False): "static", (False, True): "moment", (True, True): "dynamic"
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Unbalance:
    """Unbalance of a rotor and what it does to the bearings when it turns (BV-2)."""

    static: complex  # D_C = sum m r, kg m
    dynamic: complex  # D_D = sum m x r, kg m^2
    force: float  # omega^2 |D_C|, N
    moment: float  # omega^2 |D_D| about x = 0, N m
    kind: UnbalanceKind


def unbalance(masses: Sequence[PointMass], omega: float, x_S: float = 0.0) -> Unbalance:
    """Find the unbalance of a rotor and its class.

    Args:
        masses: Masses fixed to the rotor, or what they exceed a balanced rotor by.
        omega: Angular velocity, in rad/s.
        x_S: Place along the axis of the plane in which a static unbalance alone would stand, in metres.

    Returns:
        Unbalances, force and moment; "static" without a couple about x_S, "moment" without a force.

    Raises:
        ValueError: The speed or the place is not finite.

    Source:
        Domain BV-2: P = m omega^2 r_S, M = omega^2 sum m_k l_k r_k.
    """
    finite("omega", omega, "rad/s")
    finite("x_S", x_S, "m")
    total = sum((mass.unbalance for mass in masses), 0j)
    arms = sum((mass.x * mass.unbalance for mass in masses), 0j)
    size = sum(abs(mass.unbalance) for mass in masses)
    reach = max((abs(mass.x - x_S) for mass in masses), default=0.0)
    forced, turned = abs(total) > BALANCED * size, abs(arms - x_S * total) > BALANCED * size * reach
    square = omega**2
    return Unbalance(total, arms, abs(total) * square, abs(arms) * square, KINDS[forced, turned])
