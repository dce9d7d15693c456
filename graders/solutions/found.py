"""What comparing two sets of solutions found."""

from __future__ import annotations

from dataclasses import dataclass

from graders.equality import Finding


@dataclass(frozen=True, slots=True)
class Found:
    """What comparing two sets of solutions found.

    Attributes:
        finding: The finding.
        witness: A point at which one is proved true and the other not.
        lost: Whether the reference is the one that is true there, so that a solution is lost.
    """

    finding: Finding
    witness: tuple[tuple[str, float], ...] = ()
    lost: bool = False


UNDECIDED, EQUAL = Found(Finding.UNDECIDED), Found(Finding.EQUAL)
