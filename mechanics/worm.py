"""Worm and wheel: axes that cross, so the ratio has no sign (domain TR-3)."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mechanics.checks import count


@dataclass(frozen=True, slots=True)
class Worm:
    """A worm on a member of a train and the wheel it drives.

    Raises:
        ValueError: Starts or teeth are no whole positive number.
    """

    on: str
    worm_starts: int
    wheel_z: int

    def __post_init__(self) -> None:
        count("worm_starts", self.worm_starts)
        count("wheel_z", self.wheel_z)

    @property
    def ratio(self) -> Fraction:
        """Turns of the worm for one turn of the wheel, z2/k."""
        return Fraction(self.wheel_z, self.worm_starts)
