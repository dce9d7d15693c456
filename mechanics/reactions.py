"""Counting the equations and unknowns of a force analysis (domain DY-9).

A planar link has 3 equations of equilibrium, a spatial one 6; a pair of class k takes k freedoms in space, k - 3 in
the plane, and answers each with a component of reaction.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ReactionCount:
    """How many equations stand against how many unknowns."""

    equations: int
    reactions: int

    @property
    def drives(self) -> int:
        """Unknowns that are left for drives when the constraints are independent; negative: too many constraints."""
        return self.equations - self.reactions

    @property
    def determinate_group(self) -> bool:
        """Whether the links alone, without a drive, are statically determinate (the Assur condition)."""
        return self.drives == 0


def per_pair(klass: int, planar: bool = True) -> int:
    """Count the components of reaction in a pair of a class.

    Raises:
        ValueError: No such class: 4 and 5 in the plane, 1 to 5 in space.
    """
    least = 4 if planar else 1
    if not least <= klass <= 5:
        raise ValueError(f"class {klass} is none of {least} to 5")
    return klass - 3 if planar else klass


def count(moving: int, pairs: Mapping[int, int], planar: bool = True) -> ReactionCount:
    """Count the equations and the unknown reactions of a mechanism.

    Args:
        moving: Number n of moving links.
        pairs: Number of simple pairs by class.
        planar: Whether the mechanism is planar.

    Raises:
        ValueError: A count is negative, or a class unknown.

    Source:
        Domain DY-9: 3n = 2 p5 + p4 + F in the plane.
    """
    for number in (moving, *pairs.values()):
        if number < 0:
            raise ValueError(f"{number} links or pairs: a count is not negative")
    reactions = sum(per_pair(klass, planar) * number for klass, number in pairs.items())
    return ReactionCount((3 if planar else 6) * moving, reactions)
