"""The class II group of two bars hinged to each other (RRR), hung between two points whose motion is known.

Bars PQ (l5) and GQ (l6), vectors counter-clockwise from +X. The way from P to G is d: PQ - GQ = d. Written out by
components, as it is the inner loop of every linkage with such a group (domain VP-4, STR-8).
"""

from __future__ import annotations

import sys
from math import sqrt
from typing import NamedTuple

from mechanics.checks import in_range
from mechanics.errors import AssemblyError, SingularError

LARGEST = sys.float_info.max
REACH = 1e-12  # a gap below this part of the size is rounding, not distance
DEAD = 1e-6  # sine of the angle between the bars below which a rounded crank angle leaves theirs unknown to 1e-9


Vectors = tuple[float, float, float, float, float]  # PQ, GQ and their cross product
Rates = tuple[float, float, float, float]  # omega5, omega6, epsilon5, epsilon6


class Names(NamedTuple):
    """How messages call the two points and the two bars."""

    start: str
    end: str
    first: str
    second: str


def vectors(dx: float, dy: float, l5: float, l6: float, left: bool, names: Names) -> Vectors:
    """Give PQ, GQ and their cross product: Q is the corner of the triangle over PG, its height by Heron's formula.

    Args:
        dx: The way from P to G along X, in metres.
        dy: The same along Y.
        l5: Bar PQ, in metres, positive.
        l6: Bar GQ, in metres, positive.
        left: Whether Q lies to the left of the way from P to G.
        names: Words for a refusal.

    Raises:
        ValueError: A number on the way is beyond the range of floats.
        AssemblyError: P and G are too far apart or too near for the bars to meet; the message has the gap.
        SingularError: P and G are one point, and the bars are of one length.
    """
    square = dx * dx + dy * dy
    apart = sqrt(square)
    heron = (l5 + l6 + apart) * (l5 + l6 - apart) * (l6 - l5 + apart) * (l5 - l6 + apart)
    if not 0.0 < heron <= LARGEST:
        in_range(heron)
        heron = _stretched(apart, l5, l6, names)
    double = 2 * square
    along = (l5 * l5 - l6 * l6 + square) / double
    across = sqrt(heron) / double if left else -sqrt(heron) / double
    x5, y5 = along * dx - across * dy, along * dy + across * dx
    x6, y6 = x5 - dx, y5 - dy
    return x5, y5, x6, y6, x5 * y6 - y5 * x6


def _stretched(apart: float, l5: float, l6: float, names: Names) -> float:
    """Let a gap of rounding pass as bars in line; refuse a real one, and bars of one length over a single point."""
    gap = max(apart - l5 - l6, abs(l5 - l6) - apart)
    if apart == 0.0 and gap <= REACH * max(l5, l6):
        raise SingularError(
            f"{names.start} and {names.end} fall together: {names.first} and {names.second}, both {l5:g} m, may point "
            "anywhere"
        )
    if gap > REACH * max(apart, l5, l6):
        side = "too far for" if apart > abs(l5 - l6) else "too near for"
        raise AssemblyError(
            f"{names.start} and {names.end} are {apart:.6g} m apart, {side} {names.first} {l5:g} m and "
            f"{names.second} {l6:g} m to meet: {gap:.4g} m are missing"
        )
    return 0.0


def rates(
    at: Vectors,
    velocity: tuple[float, float],
    acceleration: tuple[float, float],
) -> Rates:
    """Give the angular velocities of PQ and GQ, then their angular accelerations.

    Args:
        at: What `vectors` gives, its cross product not zero.
        velocity: Velocity of G less that of P, in m/s.
        acceleration: Acceleration of G less that of P, in m/s^2.

    Source:
        The closure PQ - GQ = d, differentiated and multiplied by the other vector.
    """
    x5, y5, x6, y6, cross = at
    vx, vy = velocity
    omega5, omega6 = (vx * x6 + vy * y6) / cross, (vx * x5 + vy * y5) / cross
    square5, square6 = omega5 * omega5, omega6 * omega6
    kx = acceleration[0] + square5 * x5 - square6 * x6
    ky = acceleration[1] + square5 * y5 - square6 * y6
    return omega5, omega6, (kx * x6 + ky * y6) / cross, (kx * x5 + ky * y5) / cross


def measure(cross: float, l5: float, l6: float, place: str) -> float:
    """Give |sin| of the angle between the bars.

    Args:
        cross: Cross product of the two bars, in m^2.
        l5: First bar, in metres.
        l6: Second bar, in metres.
        place: Words for a refusal: which bars are in line, and where.

    Raises:
        SingularError: The bars are in line, where their rates are not determined.
    """
    found = abs(cross) / (l5 * l6)
    if found < DEAD:
        raise SingularError(f"{place}: their angular velocities are not determined")
    return min(1.0, found)
