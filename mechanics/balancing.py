"""Balancing: rotors in one and two planes, substitution of masses, static balance of a four-bar (domain BV-1..7).

Axis of the rotor x, angles counter-clockwise in the plane across it; an unbalance is D = m r, a complex number in
kg m whose argument is its angle.
"""

from __future__ import annotations

import sys
from cmath import phase, rect
from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, pi
from typing import Literal

from mechanics.checks import finite, in_range, positive
from mechanics.linkage import principal
from mechanics.vectors import ZERO, Vector, add, check_vector, cross, scaled

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


@dataclass(frozen=True, slots=True)
class Substitution:
    """Point masses in place of a link; the defect is J_S less the inertia of the points about S."""

    m_A: float  # kg
    m_B: float  # kg
    m_S: float  # kg, 0 for two points
    defect: float  # kg m^2


def two_points(m: float, l_AS: float, l_BS: float, J_S: float = 0.0) -> Substitution:
    """Replace a link by masses in A and B with its mass and its mass centre (BV-6, static).

    Args:
        m: Mass of the link, in kg.
        l_AS: Distance of A from the mass centre S, in metres.
        l_BS: Distance of B from S, in metres.
        J_S: Inertia of the link about S, in kg m^2; only the defect depends on it.

    Raises:
        ValueError: A mass or a distance is not positive and finite.
    """
    _link(m, l_AS, l_BS)
    m_A, m_B = m * l_BS / (l_AS + l_BS), m * l_AS / (l_AS + l_BS)
    return Substitution(m_A, m_B, 0.0, J_S - (m_A * l_AS**2 + m_B * l_BS**2))


def three_points(m: float, l_AS: float, l_BS: float, J_S: float) -> Substitution:
    """Replace a link by masses in A, B and S with its mass, its mass centre and its inertia (BV-6, dynamic).

    Arguments as for `two_points`.

    Raises:
        ValueError: A mass, an inertia or a distance is not positive and finite.
    """
    _link(m, l_AS, l_BS)
    positive("inertia J_S", J_S, "kg m^2")
    span = l_AS + l_BS
    return Substitution(J_S / (l_AS * span), J_S / (l_BS * span), m - J_S / (l_AS * l_BS), 0.0)


def _link(m: float, l_AS: float, l_BS: float) -> None:
    positive("mass m", m, "kg")
    positive("distance l_AS", l_AS, "m")
    positive("distance l_BS", l_BS, "m")


@dataclass(frozen=True, slots=True)
class FourBarLinks:
    """A four-bar on pivots A (0, 0) and D (l4, 0): lengths, masses, centres from the first joint along the link."""

    l1: float  # crank AB, m
    l2: float  # coupler BC, m
    l3: float  # rocker CD, m
    l4: float  # frame AD, m
    m1: float  # kg
    m2: float  # kg
    m3: float  # kg
    s1: float  # A to the centre of the crank, m
    s2: float  # B to the centre of the coupler, m
    s3: float  # D to the centre of the rocker, m

    def __post_init__(self) -> None:
        for name in ("l1", "l2", "l3", "l4"):
            positive(name, getattr(self, name), "m")
        for name in ("s1", "s2", "s3"):
            finite(name, getattr(self, name), "m")
        for name in ("m1", "m2", "m3"):
            if not 0 <= getattr(self, name) < inf:
                raise ValueError(f"{name} = {getattr(self, name)} kg must be finite and not negative")
        if not self.m1 + self.m2 + self.m3:
            raise ValueError("m1, m2, m3: a four-bar without mass has no mass centre")

    def shared(self) -> tuple[tuple[float, float], ...]:
        """Share each link's mass between its joints: (A, B), (B, C), (D, C), kg; the pair keeps the mass centre."""
        links = ((self.m1, self.s1, self.l1), (self.m2, self.s2, self.l2), (self.m3, self.s3, self.l3))
        return tuple((m * (length - s) / length, m * s / length) for m, s, length in links)


@dataclass(frozen=True, slots=True)
class FourBarBalance:
    """Counterweights that keep the mass centre of a four-bar at rest, and its place on the line of the pivots.

    A negative counterweight stands for as much mass on the link's own side of its pivot.
    """

    m1k: float  # on the crank, kg
    m2k: float  # on the rocker, kg
    m_I: float  # all masses at A, kg
    m_II: float  # all masses at D, kg
    x_S: float  # m from A
    y_S: float = 0.0  # m, on the line of the pivots


def four_bar(links: FourBarLinks, e1: float, e3: float) -> FourBarBalance:
    """Balance a four-bar statically by counterweights behind A and D.

    Args:
        links: Lengths, masses and mass centres.
        e1: Distance of the crank's counterweight from A, m, positive.
        e3: Distance of the rocker's counterweight from D, m, positive.

    Raises:
        ValueError: A distance is not positive and finite, the counterweights take all mass away, or the answer is
            beyond the range of floats.

    Source:
        Domain BV-7: m_k1 = (m_1B + m_2B) l1/e1, m_k2 = (m_2C + m_3C) l3/e3.
    """
    positive("distance e1", e1, "m")
    positive("distance e3", e3, "m")
    (m1A, m1B), (m2B, m2C), (m3D, m3C) = links.shared()
    m1k, m2k = (m1B + m2B) * links.l1 / e1, (m2C + m3C) * links.l3 / e3
    m_I, m_II = m1A + m1B + m2B + m1k, m3D + m3C + m2C + m2k
    in_range(m1k + m2k)
    if not m_I + m_II > 0:
        raise ValueError(f"m1k = {m1k:g} kg and m2k = {m2k:g} kg leave no mass in the linkage")
    return FourBarBalance(m1k, m2k, m_I, m_II, links.l4 * m_II / (m_I + m_II))


def opposite(angle: float) -> float:
    """Give the opposite direction, rad in (-pi, pi]."""
    return principal(angle + pi)


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


def inertia_forces(
    masses: Sequence[float], places: Sequence[Vector], accelerations: Sequence[Vector]
) -> tuple[Vector, Vector]:
    """Find main vector and main moment about the origin of the inertia forces of point masses.

    Args:
        masses: m_k, in kilograms.
        places: r_k, in metres.
        accelerations: a_k, in m/s^2.

    Returns:
        P = -sum m_k a_k (N) and M_O = sum r_k x (-m_k a_k) (N m).

    Raises:
        ValueError: There are not as many places and accelerations as masses, or a number is not finite.

    Source:
        Domain BV-1.
    """
    if not len(masses) == len(places) == len(accelerations):
        raise ValueError(f"{len(masses)} masses, {len(places)} places and {len(accelerations)} accelerations")
    force, moment = ZERO, ZERO
    for m, place, a in zip(masses, places, accelerations, strict=True):
        finite("mass", m, "kg")
        check_vector("place", place, "m")
        check_vector("acceleration", a, "m/s^2")
        own = scaled(-m, a)
        force, moment = add(force, own), add(moment, cross(place, own))
    return force, moment
