"""Segments and torques of a shaft, each with its own lines of the solution (domain SM-7).

Torques positive about +x by the right-hand rule, x to the right.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from exercises.exercise import given
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.stepped_shaft import Givens


@dataclass(frozen=True, slots=True)
class Solid:
    """A solid segment."""

    l: float = given(0.2, 1)  # length, m
    d: float = given(0.02, 0.1)  # diameter, m

    J = "pi*d{i}^4/32"
    W = "pi*d{i}^3/16"
    W_difference = W

    def part(self) -> members.Segment:
        """Give the same segment to the solvers."""
        return members.Segment(self.l, self.d)


@dataclass(frozen=True, slots=True)
class Tube:
    """A hollow segment."""

    l: float = given(0.2, 1)  # length, m
    D: float = given(0.05, 0.1)  # outer diameter, m
    d: float = given(0.02, 0.045)  # bore, m

    J = "pi*(D{i}^4 - d{i}^4)/32"
    W = "pi*(D{i}^4 - d{i}^4)/(16*D{i})"
    W_difference = "pi*D{i}^3/16 - pi*d{i}^3/16"

    def part(self) -> members.Segment:
        """Give the same segment to the solvers."""
        return members.Segment(self.l, self.D, self.d)


@dataclass(frozen=True, slots=True)
class Along:
    """A torque about +x."""

    M: float = given(100, 1e3)  # N m

    about_x = "M{i}"
    against_x = "-M{i}"

    @property
    def value(self) -> float:
        """The torque about +x, N m."""
        return self.M


@dataclass(frozen=True, slots=True)
class Against:
    """A torque about -x."""

    M: float = given(100, 1e3)  # N m

    about_x = "-M{i}"
    against_x = "M{i}"

    @property
    def value(self) -> float:
        """The torque about +x, N m."""
        return -self.M


Segment: TypeAlias = Solid | Tube
Torque: TypeAlias = Along | Against


def structure(givens: Givens) -> members.Shaft:
    """Give the same shaft to the solvers."""
    parts = tuple(segment.part() for segment in givens.segments)
    ends = [sum(part.L for part in parts[:i]) for i in range(len(parts) + 1)]
    loaded = ends[1:] if givens.wall == "left" else ends[:-1]
    return members.Shaft(
        G=givens.G,
        segments=parts,
        torques=tuple(members.Torque(x, torque.value) for x, torque in zip(loaded, givens.torques, strict=True)),
        support="fixed_free" if givens.wall == "left" else "free_fixed",
        tau_allow=givens.tau_adm,
        theta_allow_rad_per_m=givens.theta_adm,
    )
