"""Slider-crank in closed form, centric and offset (domain VP-2, VP-3).

Crank pivot at the origin, guide parallel to OX at y = offset. Angles counter-clockwise from +X; the rod angle is
that of the vector from crank pin to slider. Closure: l1 e(alpha1) + l2 e(alpha2) = slider + i offset.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, sin, sqrt
from typing import Literal, get_args

from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion, Singular, principal

Branch = Literal["slider_right", "slider_left"]

REACH = 1e-12  # a gap below this part of the rod is rounding, not distance
DEAD = 1e-7  # cos alpha2 below this cannot be told from 0: it is the root of a rounding error


@dataclass(frozen=True, slots=True)
class Position:
    rod_angle: float  # alpha2, rad, in (-pi, pi]
    slider: float  # l3, slider coordinate along OX, m


@dataclass(frozen=True, slots=True)
class _Geometry:
    sin1: float
    cos1: float
    sin2: float
    cos2: float


def position(
    crank: float, rod: float, crank_angle: float, offset: float = 0.0, branch: Branch = "slider_right"
) -> Position:
    """Solve the position problem.

    Args:
        crank: Crank length l1, in metres, positive.
        rod: Connecting-rod length l2, in metres, positive.
        crank_angle: Crank angle alpha1, in radians, any finite value.
        offset: Ordinate h of the guide, in metres.
        branch: "slider_right" when the rod points towards +X (cos alpha2 >= 0), "slider_left" otherwise.

    Returns:
        Rod angle alpha2 (rad, in (-pi, pi]) and slider coordinate l3 (m).

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or the branch unknown.
        AssemblyError: The rod is shorter than the distance of the crank pin from the guide.

    Source:
        Domain VP-2 (4), (5); VP-3: sin a2 = (h - l1 sin a1)/l2.
    """
    at = _geometry(crank, rod, crank_angle, offset, branch)
    return Position(principal(atan2(at.sin2, at.cos2)), crank * at.cos1 + rod * at.cos2)


def _geometry(crank: float, rod: float, crank_angle: float, offset: float, branch: Branch) -> _Geometry:
    positive("crank l1", crank, "m")
    positive("rod l2", rod, "m")
    finite("crank angle alpha1", crank_angle, "rad")
    finite("offset", offset, "m")
    if branch not in get_args(Branch):
        raise ValueError(f"branch must be slider_right or slider_left, not {branch!r}")
    sin1 = sin(crank_angle)
    climb = offset - crank * sin1
    gap = abs(climb) - rod
    if gap > REACH * rod:
        raise AssemblyError(f"rod {rod:g} m cannot reach the guide at {crank_angle:g} rad: {gap:.4g} m are missing")
    sin2 = max(-1.0, min(1.0, climb / rod))
    cos2 = sqrt((1 - sin2) * (1 + sin2))
    return _Geometry(sin1, cos(crank_angle), sin2, cos2 if branch == "slider_right" else -cos2)


def solve(
    l1: float,
    l2: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    offset: float = 0.0,
    branch: Branch = "slider_right",
    point_S_fraction_of_l2: float = 0.5,
) -> LinkageMotion:
    """Solve position, velocity and acceleration of rod, slider and a point of the rod.

    Args:
        l1: Crank length, in metres, positive.
        l2: Connecting-rod length, in metres, positive.
        alpha1: Crank angle, in radians.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.
        offset: Ordinate h of the guide, in metres.
        branch: The assembly, as for `position`.
        point_S_fraction_of_l2: Place of S on the rod's line, 0 at the crank pin, 1 at the slider.

    Returns:
        ``alpha2``, ``slider_x``, ``S_x``, ``S_y`` and their rates; the measure is |cos alpha2|, 0 where the rod is
        perpendicular to the guide.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or the branch unknown.
        AssemblyError: The rod cannot reach the guide.
        SingularError: The rod is perpendicular to the guide, where its rates are not determined.

    Source:
        Domain VP-2 (4), (5), (8), (9), (12), (13); VP-3.
    """
    finite("omega1", omega1, "rad/s")
    finite("epsilon1", epsilon1, "rad/s^2")
    finite("point_S_fraction_of_l2", point_S_fraction_of_l2, "")
    at = _geometry(l1, l2, alpha1, offset, branch)
    s1, c1, s2, c2 = at.sin1, at.cos1, at.sin2, at.cos2
    if abs(c2) < DEAD:
        raise SingularError(f"rod perpendicular to the guide at {alpha1:g} rad: its angular velocity is not determined")
    omega2 = -l1 * omega1 * c1 / (l2 * c2)  # (8)
    epsilon2 = (l1 * (omega1**2 * s1 - epsilon1 * c1) + l2 * omega2**2 * s2) / (l2 * c2)  # (12)
    pin = _arm(l1, c1, s1, omega1, epsilon1)
    rod = _arm(l2, c2, s2, omega2, epsilon2)
    angles = principal(atan2(s2, c2)), omega2, epsilon2
    return _motion(angles, pin, rod, point_S_fraction_of_l2, Singular(abs(c2), "rod perpendicular to the guide"))


def _motion(
    angles: tuple[float, ...], pin: tuple[float, ...], rod: tuple[float, ...], fraction: float, singular: Singular
) -> LinkageMotion:
    slider = [p + r for p, r in zip(pin, rod, strict=True)]  # (5), (9), (13)
    point = [p + fraction * r for p, r in zip(pin, rod, strict=True)]
    pos, vel, acc = (
        {"alpha2": angle, "slider_x": slider[k], "S_x": point[k], "S_y": point[k + 3]} for k, angle in enumerate(angles)
    )
    return LinkageMotion(pos, vel, acc, singular)


def _arm(length: float, c: float, s: float, omega: float, epsilon: float) -> tuple[float, ...]:
    """x and its two derivatives, then y and its two, of a turning vector."""
    return (
        length * c,
        -length * omega * s,
        -length * (omega**2 * c + epsilon * s),
        length * s,
        length * omega * c,
        length * (epsilon * c - omega**2 * s),
    )


def stroke(crank: float, rod: float, offset: float = 0.0) -> float:
    """Find the travel of the slider over a full turn of the crank, in metres.

    Raises:
        ValueError: A length is not positive and finite, or the offset not finite.
        AssemblyError: The crank cannot turn fully (l1 + |h| > l2).

    Source:
        Domain VP-3: sqrt((l1 + l2)^2 - h^2) - sqrt((l2 - l1)^2 - h^2).
    """
    positive("crank l1", crank, "m")
    positive("rod l2", rod, "m")
    finite("offset", offset, "m")
    missing = crank + abs(offset) - rod
    if missing > REACH * rod:
        raise AssemblyError(f"crank {crank:g} m cannot turn fully: rod {rod:g} m is {missing:.4g} m too short")
    far, near = crank + rod, rod - crank
    return sqrt((far - offset) * (far + offset)) - sqrt(max(0.0, (near - offset) * (near + offset)))
