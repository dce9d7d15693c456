"""The answer every planar linkage gives: positions, velocities, accelerations, and how near a dead position is."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import NamedTuple


class Singular(NamedTuple):
    measure: float  # 0 in a dead position, 1 farthest from it
    name: str  # which dead position


class LinkageMotion(NamedTuple):
    """The same names in `pos` (m, rad in (-pi, pi]), `vel` (m/s, rad/s) and `acc` (m/s^2, rad/s^2).

    A named tuple, as it is made for each position of a sweep: a frozen dataclass takes a microsecond more.
    """

    pos: Mapping[str, float]
    vel: Mapping[str, float]
    acc: Mapping[str, float]
    singular: Singular


def principal(angle: float) -> float:
    """Bring an angle into (-pi, pi], in radians."""
    if -pi < angle <= pi:
        return angle
    turned = angle % (2 * pi)
    return turned - 2 * pi if turned > pi else turned
