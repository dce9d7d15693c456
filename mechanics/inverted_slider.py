"""Crank with a rocking slide (inverted slider-crank) in closed form (domain VP-1).

Crank pivot at the origin, crank pin B = l1 e(alpha1). A guide turns about its frame pivot O and always passes through
B; phi is the direction from O to B, s their distance. Angles counter-clockwise from +X. Closure: O + s e(phi) = B.
The slide moves along a guide that turns, so B has the Coriolis acceleration 2 ds/dt omega across the guide.
"""

from __future__ import annotations

from math import atan2, cos, hypot, sin

from mechanics.checks import finite, positive
from mechanics.errors import SingularError
from mechanics.linkage import LinkageMotion, Singular, principal

DEAD = 1e-6  # part of the longest slide below which rounded numbers leave the direction unknown to 1e-9
DEAD_NAME = "crank pin on the guide pivot"


def solve(
    l1: float,
    alpha1: float,
    omega1: float = 0.0,
    epsilon1: float = 0.0,
    guide_pivot: tuple[float, float] = (0.0, 0.0),
    guide_point_distance: float = 0.0,
) -> LinkageMotion:
    """Solve position, velocity and acceleration of the guide, the slide and a point P of the guide.

    Args:
        l1: Crank length, in metres, positive.
        alpha1: Crank angle, in radians.
        omega1: Crank angular velocity, in rad/s.
        epsilon1: Crank angular acceleration, in rad/s^2.
        guide_pivot: The frame pivot O of the guide, in metres.
        guide_point_distance: Place of P on the guide from O, towards B positive, in metres.

    Returns:
        ``phi``, ``s``, ``P_x``, ``P_y`` and their rates; the measure is s over its longest value l1 + |O|, 0 where the
        crank pin meets the pivot of the guide.

    Raises:
        ValueError: The length is not positive and finite, or another value not finite.
        SingularError: The crank pin is on the pivot of the guide, whose direction is not determined there.

    Source:
        Domain VP-1: v = l1 w1 sin(phi - a1), w = l1 w1 cos(phi - a1)/s; the accelerations by (2.6), across
        the guide s epsilon + 2 v w, the last the Coriolis acceleration.
    """
    _check(l1, alpha1, omega1, epsilon1, (*guide_pivot, guide_point_distance))
    pivot_x, pivot_y = guide_pivot
    x1, y1 = l1 * cos(alpha1), l1 * sin(alpha1)
    dx, dy = x1 - pivot_x, y1 - pivot_y
    s, longest = hypot(dx, dy), l1 + hypot(pivot_x, pivot_y)
    if s < DEAD * longest:
        raise SingularError(f"{DEAD_NAME} at {alpha1:g} rad: the direction of the guide is not determined")
    c, n = dx / s, dy / s
    vx, vy = -omega1 * y1, omega1 * x1
    ax, ay = -epsilon1 * y1 - omega1 * vy, epsilon1 * x1 + omega1 * vx
    v, omega = vx * c + vy * n, (vy * c - vx * n) / s
    a, epsilon = ax * c + ay * n + s * omega**2, (ay * c - ax * n - 2 * v * omega) / s
    px, py = guide_point_distance * c, guide_point_distance * n
    return LinkageMotion(
        {"phi": principal(atan2(dy, dx)), "s": s, "P_x": pivot_x + px, "P_y": pivot_y + py},
        {"phi": omega, "s": v, "P_x": -omega * py, "P_y": omega * px},
        {"phi": epsilon, "s": a, "P_x": -epsilon * py - omega**2 * px, "P_y": epsilon * px - omega**2 * py},
        Singular(s / longest, DEAD_NAME),
    )


def _check(l1: float, alpha1: float, omega1: float, epsilon1: float, guide: tuple[float, ...]) -> None:
    positive("crank l1", l1, "m")
    finite("crank angle alpha1", alpha1, "rad")
    finite("omega1", omega1, "rad/s")
    finite("epsilon1", epsilon1, "rad/s^2")
    for name, value in zip(("guide_pivot x", "guide_pivot y", "guide_point_distance"), guide, strict=True):
        finite(name, value, "m")
