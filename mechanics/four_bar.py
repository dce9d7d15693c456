"""Four-bar linkage in closed form, both assemblies, with a point of the coupler (domain VP-4).

Frame pivots A = (0, 0) and D = (l4, 0), crank AB, coupler BC, rocker DC. Angles counter-clockwise from +X; alpha2 is
that of BC, alpha3 that of DC. Closure: l1 e(alpha1) + l2 e(alpha2) = l4 + l3 e(alpha3).
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from math import atan2, cos, sin, sqrt
from typing import Literal, get_args

from mechanics import dyad
from mechanics.checks import finite, positive
from mechanics.linkage import LinkageMotion, Singular

Mode = Literal["C_left_of_BD", "C_right_of_BD"]

NAMES = dyad.Names("B", "D", "coupler", "rocker")
DEAD_NAME = "coupler and rocker in line"
_LARGEST = sys.float_info.max


@dataclass(frozen=True, slots=True)
class Position:
    coupler_angle: float  # alpha2, rad, in (-pi, pi]
    rocker_angle: float  # alpha3, rad, in (-pi, pi]


def position(l1: float, l2: float, l3: float, l4: float, alpha1: float, mode: Mode = "C_left_of_BD") -> Position:
    """Solve the position problem.

    Args:
        l1: Crank length, in metres, positive.
        l2: Coupler length, in metres, positive.
        l3: Rocker length, in metres, positive.
        l4: Distance of the frame pivots, in metres, positive.
        alpha1: Crank angle, in radians, any finite value.
        mode: On which side of the way from B to D the joint C lies.

    Returns:
        Angles of coupler and rocker, in (-pi, pi].

    Raises:
        ValueError: A length is not positive and finite, the angle not finite, or the mode unknown.
        AssemblyError: B and D are too far apart or too near for coupler and rocker to meet.
        SingularError: B falls on D, and coupler and rocker are of one length.

    Source:
        Domain VP-4.
    """
    _check(l1, l2, l3, l4, alpha1, mode)
    dx, dy = l4 - l1 * cos(alpha1), -l1 * sin(alpha1)
    x2, y2, x3, y3, _ = dyad.vectors(dx, dy, l2, l3, mode == "C_left_of_BD", NAMES)
    return Position(atan2(y2, x2), atan2(y3, x3))


def assemblies(l1: float, l2: float, l3: float, l4: float, alpha1: float) -> tuple[Position, Position]:
    """Solve the position problem of both assemblies: C left of BD, then right; arguments as for `position`."""
    left = position(l1, l2, l3, l4, alpha1, "C_left_of_BD")
    return left, position(l1, l2, l3, l4, alpha1, "C_right_of_BD")


def _check(l1: float, l2: float, l3: float, l4: float, alpha1: float, mode: str) -> None:
    if not (
        0 < l1 <= _LARGEST and 0 < l2 <= _LARGEST and 0 < l3 <= _LARGEST and 0 < l4 <= _LARGEST
        and -_LARGEST <= alpha1 <= _LARGEST
    ):  # fmt: skip
        for name, length in (("crank l1", l1), ("coupler l2", l2), ("rocker l3", l3), ("frame l4", l4)):
            positive(name, length, "m")
        finite("crank angle alpha1", alpha1, "rad")
    if mode not in ("C_left_of_BD", "C_right_of_BD"):
        raise ValueError(f"mode must be {' or '.join(get_args(Mode))}, not {mode!r}")


def motion(
    l1: float,
    l2: float,
    l3: float,
    l4: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    mode: Mode = "C_left_of_BD",
) -> tuple[float, float, float, float, float, float]:
    """Give alpha2, alpha3, omega2, omega3, epsilon2, epsilon3; arguments and errors as for `solve`.

    The plain numbers of `solve`, for long sweeps.
    """
    _, _, at, rates = _state(l1, l2, l3, l4, alpha1, omega1, epsilon1, mode)
    return atan2(at[1], at[0]), atan2(at[3], at[2]), *rates


def _state(
    l1: float, l2: float, l3: float, l4: float, alpha1: float, omega1: float, epsilon1: float, mode: Mode
) -> tuple[float, float, dyad.Vectors, dyad.Rates]:
    """Give AB, then what `dyad.vectors` and `dyad.rates` know of coupler and rocker."""
    _check(l1, l2, l3, l4, alpha1, mode)
    if not abs(omega1) + abs(epsilon1) <= _LARGEST:
        finite("omega1", omega1, "rad/s")
        finite("epsilon1", epsilon1, "rad/s^2")
    x1, y1 = l1 * cos(alpha1), l1 * sin(alpha1)
    at = dyad.vectors(l4 - x1, -y1, l2, l3, mode == "C_left_of_BD", NAMES)
    if abs(at[4]) < dyad.DEAD * l2 * l3:
        dyad.measure(at[4], l2, l3, f"{DEAD_NAME} at {alpha1:g} rad")
    square = omega1 * omega1
    acceleration = epsilon1 * y1 + square * x1, square * y1 - epsilon1 * x1
    return x1, y1, at, dyad.rates(at, (omega1 * y1, -omega1 * x1), acceleration)


def solve(
    l1: float,
    l2: float,
    l3: float,
    l4: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    mode: Mode = "C_left_of_BD",
    coupler_point: tuple[float, float] = (0.0, 0.0),
) -> LinkageMotion:
    """Solve position, velocity and acceleration of coupler, rocker and a point P of the coupler.

    Args:
        l1, l2, l3, l4, alpha1, mode: As for `position`.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.
        coupler_point: P in the axes of the coupler, in metres: u along BC from B, v to the left of BC.

    Returns:
        ``alpha2``, ``alpha3``, ``P_x``, ``P_y`` and their rates; the measure is |sin(alpha3 - alpha2)|, 0 where
        coupler and rocker are in line.

    Raises:
        ValueError: A length is not positive and finite, another value not finite, or the mode unknown.
        AssemblyError: Coupler and rocker cannot meet; the message has the gap.
        SingularError: Coupler and rocker are in line, where their rates are not determined, or B falls on D.

    Source:
        Domain VP-4; the rates from the closure times the direction of the other vector.
    """
    u, v = coupler_point
    if not abs(u) + abs(v) <= _LARGEST:
        _refuse_point(u, v)
    state = _state(l1, l2, l3, l4, alpha1, omega1, epsilon1, mode)
    return _with_point(l2, l3, omega1, epsilon1, state, u, v)


def _refuse_point(u: float, v: float) -> None:
    finite("coupler point u", u, "m")
    finite("coupler point v", v, "m")


def _with_point(
    l2: float,
    l3: float,
    omega1: float,
    epsilon1: float,
    state: tuple[float, float, dyad.Vectors, dyad.Rates],
    u: float,
    v: float,
) -> LinkageMotion:
    """Name what is known, and let P ride on the coupler: AP = AB + BP."""
    x1, y1, (x2, y2, x3, y3, cross), (omega2, omega3, epsilon2, epsilon3) = state
    px, py = (u * x2 - v * y2) / l2, (u * y2 + v * x2) / l2  # BP
    square1, square2 = omega1 * omega1, omega2 * omega2
    return LinkageMotion(
        {"alpha2": atan2(y2, x2), "alpha3": atan2(y3, x3), "P_x": x1 + px, "P_y": y1 + py},
        {"alpha2": omega2, "alpha3": omega3, "P_x": -omega1 * y1 - omega2 * py, "P_y": omega1 * x1 + omega2 * px},
        {
            "alpha2": epsilon2,
            "alpha3": epsilon3,
            "P_x": -epsilon1 * y1 - square1 * x1 - epsilon2 * py - square2 * px,
            "P_y": epsilon1 * x1 - square1 * y1 + epsilon2 * px - square2 * py,
        },
        Singular(min(1.0, abs(cross) / (l2 * l3)), DEAD_NAME),
    )


def crank_turns(l1: float, l2: float, l3: float, l4: float) -> bool:
    """Tell whether the crank turns fully (Grashof): coupler and rocker can span both |l1 - l4| and l1 + l4 (m).

    Args:
        l1, l2, l3, l4: As for `dead_positions`; lengths that fit but for a rounding do.

    Raises:
        ValueError: A length is not positive and finite.
    """
    _check(l1, l2, l3, l4, 0.0, "C_left_of_BD")
    rounding = dyad.REACH * max(l1, l2, l3, l4)
    return l1 + l4 <= l2 + l3 + rounding and abs(l1 - l4) >= abs(l2 - l3) - rounding


def dead_positions(l1: float, l2: float, l3: float, l4: float) -> tuple[float, ...]:
    """Give the crank angles in [0, pi] where coupler and rocker are in line, rising; their mirror images are others.

    Args:
        l1: Crank length, in metres, positive.
        l2: Coupler length, in metres, positive.
        l3: Rocker length, in metres, positive.
        l4: Distance of the frame pivots, in metres, positive.

    Returns:
        None, one or two angles, in radians.

    Raises:
        ValueError: A length is not positive and finite.

    Source:
        The law of cosines in the triangle ABD with BD = |l2 - l3| and BD = l2 + l3, by half of the angle.
    """
    _check(l1, l2, l3, l4, 0.0, "C_left_of_BD")
    near, far = abs(l1 - l4), l1 + l4
    found = []
    for apart in (abs(l2 - l3), l2 + l3):
        above, below = apart - near, far - apart
        if min(above, below) >= -dyad.REACH * far:
            sine, cosine = (sqrt(max(0.0, gap)) * sqrt(apart + side) for gap, side in ((above, near), (below, far)))
            found.append(2 * atan2(sine, cosine))
    return tuple(found)
