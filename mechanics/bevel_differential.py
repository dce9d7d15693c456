"""Symmetric bevel differential (domain TR-6): the carrier turns with the mean of the two sides."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Differential:
    """Members of a train joined so that omega_left + omega_right = 2 omega_carrier.

    Raises:
        ValueError: A member is named twice.
    """

    left: str
    right: str
    carrier: str

    def __post_init__(self) -> None:
        if len({self.left, self.right, self.carrier}) < 3:
            raise ValueError(f"the differential {self.left}-{self.right} on {self.carrier} names a member twice")

    def terms(self) -> tuple[tuple[str, int], ...]:
        """Members and their multiples in the equation of the differential, whose sum is zero."""
        return (self.left, 1), (self.right, 1), (self.carrier, -2)
