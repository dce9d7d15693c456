"""The method of sections: loads on the cut-off part reduced to the centre of the section (domain SM-1).

Right-handed axes, x the outer normal of the kept face. The results act on the kept face; the opposite face carries
the opposite ones. N > 0 pulls, Qy and Qz are shear forces, Mx is the torque, My and Mz bend.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import fsum

from mechanics.vectors import ZERO, Vector, add, check_vector, cross, subtract


@dataclass(frozen=True, slots=True)
class PointLoad:
    """A force, a couple or both, somewhere on the cut-off part."""

    F: Vector  # N
    at: Vector  # its place, m
    M: Vector = ZERO  # N m

    def __post_init__(self) -> None:
        for name, vector, unit in (("force", self.F, "N"), ("place", self.at, "m"), ("couple", self.M, "N m")):
            check_vector(name, vector, unit)


@dataclass(frozen=True, slots=True)
class InternalForces:
    """The six resultants in a section."""

    N: float  # N
    Qy: float  # N
    Qz: float  # N
    Mx: float  # torque, N m
    My: float  # N m
    Mz: float  # N m


def internal_forces(loads: Sequence[PointLoad], centre: Vector = ZERO) -> InternalForces:
    """Reduce the loads on the cut-off part to the centre of the section (m).

    Source:
        Domain SM-1: forces add up, M = sum of (r - r_C) x F and of the couples.
    """
    moments = [_moment(load, centre) for load in loads]
    N, Qy, Qz = (fsum(load.F[axis] for load in loads) for axis in range(3))
    Mx, My, Mz = (fsum(moment[axis] for moment in moments) for axis in range(3))
    return InternalForces(N, Qy, Qz, Mx, My, Mz)


def _moment(load: PointLoad, centre: Vector) -> Vector:
    return add(load.M, cross(subtract(load.at, centre), load.F))
