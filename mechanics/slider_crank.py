"""Slider-crank in closed form, centric and offset (domain VP-2, VP-3).

Crank pivot at the origin, guide parallel to OX at y = offset. Angles counter-clockwise from +X; the rod angle is
that of the vector from crank pin to slider. Closure: l1 e(alpha1) + l2 e(alpha2) = slider + i offset.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from math import asin, atan2, copysign, cos, pi, sin, sqrt
from typing import Literal, get_args

from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion, Singular, principal

Branch = Literal["slider_right", "slider_left"]

REACH = 1e-12  # a gap below this part of the rod is rounding, not distance
DEAD = 1e-6  # cos alpha2 below which a rounded crank angle leaves alpha2 unknown to 1e-9
DEAD_NAME = "rod perpendicular to the guide"
_LARGEST = sys.float_info.max


@dataclass(frozen=True, slots=True)
class Position:
    rod_angle: float  # alpha2, rad, in (-pi, pi]
    slider: float  # l3, slider coordinate along OX, m


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
    finite("crank angle alpha1", crank_angle, "rad")
    y2 = offset - crank * sin(crank_angle)
    x2 = sqrt(_square(crank, rod, crank_angle, offset, branch, y2))
    if branch == "slider_left":
        x2 = -x2
    return Position(principal(atan2(y2, x2)), crank * cos(crank_angle) + x2)


def _square(crank: float, rod: float, crank_angle: float, offset: float, branch: str, y2: float) -> float:
    """Check all values and give the square of the rod's projection on the guide."""
    if not (0 < crank <= _LARGEST and 0 < rod <= _LARGEST and abs(crank_angle) + abs(offset) <= _LARGEST):
        positive("crank l1", crank, "m")
        positive("rod l2", rod, "m")
        finite("crank angle alpha1", crank_angle, "rad")
        finite("offset", offset, "m")
    if branch not in ("slider_right", "slider_left"):
        raise ValueError(f"branch must be {' or '.join(get_args(Branch))}, not {branch!r}")
    gap = abs(y2) - rod
    if gap > REACH * rod:
        raise AssemblyError(f"rod {rod:g} m cannot reach the guide at {crank_angle:g} rad: {gap:.4g} m are missing")
    return max(0.0, (rod - y2) * (rod + y2))


def motion(
    l1: float,
    l2: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    offset: float = 0.0,
    branch: Branch = "slider_right",
) -> tuple[float, float, float, float, float, float]:
    """Give alpha2, slider, omega2, slider speed, epsilon2, slider acceleration; arguments and errors as for `solve`.

    The plain numbers of `solve`, for long sweeps.
    """
    if not abs(alpha1) + abs(omega1) + abs(epsilon1) <= _LARGEST:
        _refuse(alpha1, omega1, epsilon1)
    x1, y1 = l1 * cos(alpha1), l1 * sin(alpha1)
    y2 = offset - y1
    square = (l2 - y2) * (l2 + y2)
    if not (0 < l1 <= _LARGEST and 0 < l2 <= _LARGEST and DEAD * DEAD * l2 * l2 <= square) or branch != "slider_right":
        square = _square(l1, l2, alpha1, offset, branch, y2)
        if square < DEAD * DEAD * l2 * l2:
            raise SingularError(f"{DEAD_NAME} at {alpha1:g} rad: the angular velocity of the rod is not determined")
    x2 = sqrt(square) if branch == "slider_right" else -sqrt(square)
    omega2 = -omega1 * x1 / x2  # (8)
    square1, square2 = omega1 * omega1, omega2 * omega2
    epsilon2 = (square1 * y1 - epsilon1 * x1 + square2 * y2) / x2  # (12)
    alpha2 = atan2(y2, x2)
    return (
        alpha2 if alpha2 > -pi else pi,
        x1 + x2,  # (5)
        omega2,
        -omega1 * y1 - omega2 * y2,  # (9)
        epsilon2,
        -square1 * x1 - epsilon1 * y1 - square2 * x2 - epsilon2 * y2,  # (13)
    )


def _refuse(alpha1: float, omega1: float, epsilon1: float) -> None:
    finite("crank angle alpha1", alpha1, "rad")
    finite("omega1", omega1, "rad/s")
    finite("epsilon1", epsilon1, "rad/s^2")


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
        Domain VP-2 (4), (5), (8), (9), (12), (13); VP-3. S divides the way from crank pin to slider.
    """
    k = point_S_fraction_of_l2
    finite("point_S_fraction_of_l2", k, "")
    alpha2, x, omega2, v, epsilon2, a = motion(l1, l2, alpha1, omega1, epsilon1, offset, branch)
    x1, y1 = l1 * cos(alpha1), l1 * sin(alpha1)
    vx, vy = -omega1 * y1, omega1 * x1
    ax, ay = -epsilon1 * y1 - omega1 * vy, epsilon1 * x1 + omega1 * vx
    return LinkageMotion(
        {"alpha2": alpha2, "slider_x": x, "S_x": x1 + k * (x - x1), "S_y": y1 + k * (offset - y1)},
        {"alpha2": omega2, "slider_x": v, "S_x": vx + k * (v - vx), "S_y": vy - k * vy},
        {"alpha2": epsilon2, "slider_x": a, "S_x": ax + k * (a - ax), "S_y": ay - k * ay},
        Singular(abs(cos(alpha2)), DEAD_NAME),
    )


def stroke(crank: float, rod: float, offset: float = 0.0) -> float:
    """Find the travel of the slider over a full turn of the crank; all in metres.

    Raises:
        ValueError: A length is not positive and finite, or the offset not finite.
        AssemblyError: The crank cannot turn fully (l1 + |h| > l2).

    Source:
        Domain VP-3: sqrt((l1 + l2)^2 - h^2) - sqrt((l2 - l1)^2 - h^2).
    """
    far, near = _reach(crank, rod, offset)
    return sqrt((far - offset) * (far + offset)) - sqrt(max(0.0, (near - offset) * (near + offset)))


def turning_points(crank: float, rod: float, offset: float = 0.0) -> tuple[float, float]:
    """Give the crank angles at which the slider on the side of +X turns round: farthest, then nearest.

    Counter-clockwise the crank turns by the second less the first while the slider goes in, by the rest of the turn
    while it goes out; at a constant speed the times are as these angles.

    Args:
        crank: Crank length l1, in metres, positive.
        rod: Connecting-rod length l2, in metres, longer than the crank.
        offset: Ordinate h of the guide, in metres.

    Returns:
        Two angles, in radians: in [-pi/2, pi/2] with crank and rod stretched, in [pi/2, 3 pi/2] with them folded.

    Raises:
        ValueError: A length is not positive and finite, or the offset not finite.
        AssemblyError: The crank cannot turn fully (l1 + |h| > l2).
        SingularError: Crank and rod are of one length: folded they may point anywhere.

    Source:
        Domain VP-3: sin a1 = h/(l1 + l2), a1 = pi + arcsin(h/(l2 - l1)).
    """
    far, near = _reach(crank, rod, offset)
    if near <= REACH * rod:
        raise SingularError(f"crank and rod are both {rod:g} m long: folded on one another they may point anywhere")
    return asin(offset / far), pi + asin(min(1.0, max(-1.0, offset / near)))


def _reach(crank: float, rod: float, offset: float) -> tuple[float, float]:
    """Give l2 + l1 and l2 - l1 of a crank that turns fully."""
    positive("crank l1", crank, "m")
    positive("rod l2", rod, "m")
    finite("offset", offset, "m")
    missing = crank + abs(offset) - rod
    if missing > REACH * rod:
        raise AssemblyError(f"crank {crank:g} m cannot turn fully: rod {rod:g} m is {missing:.4g} m too short")
    return rod + crank, rod - crank


def dead_positions(crank: float, rod: float, offset: float = 0.0) -> tuple[float, ...]:
    """Give the crank angles in (-pi, pi] where the rod is perpendicular to the guide, rising; lengths in metres.

    Raises:
        ValueError: A length is not positive and finite, or the offset not finite.

    Source:
        The closure with cos alpha2 = 0: l1 sin alpha1 = h - l2 or h + l2.
    """
    positive("crank l1", crank, "m")
    positive("rod l2", rod, "m")
    finite("offset", offset, "m")
    found: set[float] = set()
    for climb in (offset - rod, offset + rod):
        if abs(abs(climb) - crank) <= REACH * crank:
            found.add(copysign(pi / 2, climb))
        elif abs(climb) < crank:
            angle = asin(climb / crank)
            found |= {angle, principal(pi - angle)}
    return tuple(sorted(found))
