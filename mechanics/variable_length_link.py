"""Triangle with a linear drive: a lever CB turned by a link AB of variable length, in closed form (domain VP-9).

A = (0, 0), C = (AC, 0), B above AC. beta is the angle ACB, alpha the angle BAC, both inside the triangle, so alpha is
also the angle of AB from +X; the lever CB points at pi - beta. VP-9 draws the mirror image: `mirrored` puts C at the
origin and A at (AC, 0), with the same angles.
"""

from __future__ import annotations

from math import atan2, cos, sin, sqrt

from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion, Singular

REACH = 1e-12  # a gap below this part of the size is rounding, not distance
DEAD = 1e-6  # sin beta below which a rounded length leaves beta unknown to 1e-9
DEAD_NAME = "A, B and C in line"


def solve(
    AC: float, BC: float, l_AB: float, dl_AB: float = 0.0, ddl_AB: float = 0.0, mirrored: bool = False
) -> LinkageMotion:
    """Solve position, velocity and acceleration of the triangle.

    Args:
        AC: Distance of the frame pivots, in metres, positive.
        BC: Length of the lever, in metres, positive.
        l_AB: Length of the driving link, in metres, positive.
        dl_AB: Its rate, in m/s.
        ddl_AB: Its second rate, in m/s^2.
        mirrored: C at the origin and A at (AC, 0), as drawn in the domain.

    Returns:
        ``beta``, ``alpha``, ``B_x``, ``B_y`` and their rates; the measure is sin beta, 0 where the three points are in
        line.

    Raises:
        ValueError: A length is not positive and finite, or a rate not finite.
        AssemblyError: The three lengths make no triangle; the message has the gap.
        SingularError: The three points are in line, where the drive does not determine the lever's velocity.

    Source:
        Domain VP-9: laws of cosines and sines, and their derivatives; alpha by the form that is safe for any angle.
    """
    for name, length in (("AC", AC), ("BC", BC), ("l_AB", l_AB)):
        positive(name, length, "m")
    finite("dl_AB", dl_AB, "m/s")
    finite("ddl_AB", ddl_AB, "m/s^2")
    beta = _angle_at_C(AC, BC, l_AB)
    c, s = cos(beta), sin(beta)
    if s < DEAD:
        raise SingularError(f"{DEAD_NAME} at l_AB = {l_AB:g} m: the angular velocity of the lever is not determined")
    omega = l_AB * dl_AB / (AC * BC * s)
    epsilon = (dl_AB**2 + l_AB * ddl_AB - AC * BC * c * omega**2) / (AC * BC * s)
    x, y = BC * c, BC * s  # B from C, along CA and above it
    vx, vy = -omega * y, omega * x
    ax, ay = -epsilon * y - omega * vy, epsilon * x + omega * vx
    alpha, toward_A = atan2(y, AC - x), AC - x
    omega_A = (toward_A * vy + y * vx) / l_AB**2
    epsilon_A = (toward_A * ay + y * ax) / l_AB**2 - 2 * dl_AB / l_AB * omega_A
    place, sign = (x, 1.0) if mirrored else (AC - x, -1.0)
    return LinkageMotion(
        {"beta": beta, "alpha": alpha, "B_x": place, "B_y": y},
        {"beta": omega, "alpha": omega_A, "B_x": sign * vx, "B_y": vy},
        {"beta": epsilon, "alpha": epsilon_A, "B_x": sign * ax, "B_y": ay},
        Singular(s, DEAD_NAME),
    )


def _angle_at_C(AC: float, BC: float, l_AB: float) -> float:
    """The law of cosines in its half-angle form, which keeps its digits near the dead positions."""
    lowest, highest = abs(AC - BC), AC + BC
    gap = max(lowest - l_AB, l_AB - highest)
    if gap > REACH * highest:
        side = "long" if l_AB > lowest else "short"
        raise AssemblyError(f"AB {l_AB:g} m is too {side} for AC {AC:g} m and BC {BC:g} m: {gap:.4g} m do not fit")
    above = max(0.0, (l_AB - lowest) * (l_AB + lowest))
    below = max(0.0, (highest - l_AB) * (highest + l_AB))
    return 2 * atan2(sqrt(above), sqrt(below))
