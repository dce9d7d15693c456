"""Open chains as drawn: freedoms of the last link, spare ones, rod functional groups (domain STR-9, STR-10).

An axis is a line: a revolute turns about it, a prismatic joint slides along it. Lengths in metres.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, sqrt
from typing import Literal, get_args

from mechanics.checks import finite
from mechanics.vectors import ZERO, Vector, cross, dot, unit

Kind = Literal["R", "P"]
PARALLEL = 1e-9  # sine of the angle below which directions are parallel
RANK = 1e-9  # of the size of a twist, below which it adds no freedom


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint of one freedom.

    Raises:
        ValueError: The kind is unknown, a number is not finite, or the direction is zero.
    """

    kind: Kind
    direction: Vector
    at: Vector = ZERO  # a point of the axis, m; for a slide of no matter

    def __post_init__(self) -> None:
        if self.kind not in get_args(Kind):
            raise ValueError(f"joint kind {self.kind!r} must be R or P")
        for name, values, measure in (("direction", self.direction, ""), ("at", self.at, "m")):
            for value in values:
                finite(f"axis: {name}", value, measure)
        if not hypot(*self.direction):
            raise ValueError("axis: the direction must not be zero")

    @property
    def unit(self) -> Vector:
        """The direction as a unit vector."""
        return unit(self.direction)

    def twist(self, size: float) -> list[float]:
        """Angular velocity, then velocity of the origin, for a unit rate; lengths over the size of the chain."""
        if self.kind == "P":
            return [0.0, 0.0, 0.0, *self.unit]
        x, y, z = (value / size for value in self.at)
        return [*self.unit, *cross((x, y, z), self.unit)]


def tip_freedom(axes: Sequence[Axis]) -> int:
    """Count the degrees of freedom of the last link: the rank of the twists of all joints, at most 6.

    The plane needs no rule of its own: parallel axes and slides across them have rank 3 at most.
    """
    size = max((abs(value) for axis in axes for value in axis.at), default=0.0) or 1.0
    basis: list[list[float]] = []
    for axis in axes:
        row = axis.twist(size)
        for _ in range(2):  # twice, so that rounding leaves nothing of what the basis holds
            for known in basis:
                part = sum(one * other for one, other in zip(row, known, strict=True))
                row = [one - part * other for one, other in zip(row, known, strict=True)]
        length = sqrt(sum(value * value for value in row))
        if length > RANK:
            basis.append([value / length for value in row])
    return len(basis)


def spare_freedoms(axes: Sequence[Axis]) -> int:
    """Count the freedoms left when the gripper is held: mobility less the freedoms of the last link (STR-9)."""
    return len(axes) - tip_freedom(axes)


def functional_group(axes: Sequence[Axis]) -> int | None:
    """Classify a chain of three joints as a rod functional group.

    Args:
        axes: The joints in the order from the base.

    Returns:
        1 PPP, 2 RPP, 3 RRP, 4 PRR, 5 RRR, 6 PRP where the directions obey the rule of the group, else None.

    Raises:
        ValueError: There are not three joints.

    Source:
        Domain STR-10. What is parallel only in the drawn position does not count: a group keeps its rule as it moves.
    """
    if len(axes) != 3:
        raise ValueError(f"a rod functional group has three joints, not {len(axes)}")
    one, two, three = (axis.unit for axis in axes)
    fits = {
        "PPP": (1, abs(dot(cross(one, two), three)) > PARALLEL),
        "RPP": (2, _along_and_across(one, two, three) or _along_and_across(one, three, two)),
        "RRP": (3, not _parallel(one, two) and not _parallel(two, three)),
        "PRR": (4, _parallel(one, two) and _parallel(two, three)),
        "RRR": (5, _parallel(one, two) != _parallel(two, three)),
        "PRP": (6, _along_and_across(two, one, three)),
    }
    number, holds = fits.get("".join(axis.kind for axis in axes), (0, False))
    return number if holds else None


def _along_and_across(axis: Vector, along: Vector, across: Vector) -> bool:
    return _parallel(axis, along) and abs(dot(axis, across)) <= PARALLEL


def _parallel(one: Vector, other: Vector) -> bool:
    return hypot(*cross(one, other)) <= PARALLEL
