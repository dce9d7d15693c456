"""A stepped shaft as a chain of torsion elements (stiffness method); the second way beside `shaft` (domain SM-7).

Torques and rotations about +x; T = sum of the external torques right of the section = G J_p d(phi)/dx.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass
from itertools import pairwise
from math import pi

from mechanics.checks import place
from mechanics.errors import UnbalancedError
from mechanics.members import Shaft
from mechanics.stiffness import settle

# The torques of a free shaft cancel to this part of the largest.
_BALANCED = 1e-9


@dataclass(frozen=True, slots=True)
class FrameShaft:
    """A shaft solved by the stiffness method; one entry for each element between segment ends and torques."""

    xs: tuple[float, ...]  # nodes, m
    rotations: tuple[float, ...]  # of the nodes, rad
    radii: tuple[float, ...]  # outer radii of the elements, m
    polar_moments: tuple[float, ...]  # of the elements, m^4
    torques: tuple[float, ...]  # T in the elements, N m
    ends: tuple[float, ...]  # of the segments, m, 0 first
    reactions: tuple[float, float]  # at the left and the right end, N m

    @property
    def twists(self) -> tuple[float, ...]:
        """Twist of each element, rad."""
        return tuple(right - left for left, right in pairwise(self.rotations))

    @property
    def segment_twists(self) -> tuple[float, ...]:
        """Twist of each segment of the shaft as given, rad."""
        return tuple(self.rotation(right) - self.rotation(left) for left, right in pairwise(self.ends))

    @property
    def stresses(self) -> tuple[float, ...]:
        """Magnitude of the stress T r/J_p at the surface of each element, Pa."""
        columns = zip(self.torques, self.radii, self.polar_moments, strict=True)
        return tuple(abs(T) * radius / polar for T, radius, polar in columns)

    def torque(self, x: float) -> float:
        """Return T (N m) at x (m); at a node the one to its left."""
        return self.torques[self._element(x)]

    def stress(self, x: float, radius: float) -> float:
        """Return the signed stress (Pa) at x and at a radius from the axis (m)."""
        element = self._element(x)
        return self.torques[element] * radius / self.polar_moments[element]

    def rotation(self, x: float) -> float:
        """Return phi (rad) at x (m)."""
        i = self._element(x)
        share = (x - self.xs[i]) / (self.xs[i + 1] - self.xs[i])
        return (1 - share) * self.rotations[i] + share * self.rotations[i + 1]

    def extreme_torque(self) -> tuple[float, float]:
        """Return the start (m) of the element with the largest |T|, the leftmost on a tie, and its signed T (N m)."""
        largest = max(map(abs, self.torques))
        return next((x, T) for x, T in zip(self.xs, self.torques, strict=False) if abs(T) >= largest * (1 - 1e-9))

    def _element(self, x: float) -> int:
        place("sample", x, self.xs[-1])
        return max(bisect_left(self.xs, x) - 1, 0)


def solve_shaft(shaft: Shaft) -> FrameShaft:
    """Solve a shaft as a chain of torsion springs.

    Raises:
        UnbalancedError: A shaft free at both ends is not in balance: holding it by the left end takes a torque.

    Source:
        Bar element k = G J_p/l: Przemieniecki, Theory of Matrix Structural Analysis, McGraw-Hill 1968, chapter 5.
    """
    xs = sorted({*shaft.ends, *(torque.x for torque in shaft.torques)})
    segments = [shaft.segments[bisect_left(shaft.ends, right) - 1] for right in xs[1:]]
    polar = [polar_moment(segment.D, segment.d) for segment in segments]
    springs = [shaft.G * J / (right - left) for J, (left, right) in zip(polar, pairwise(xs), strict=True)]
    loads = [sum(torque.T for torque in shaft.torques if torque.x == x) for x in xs]
    last = len(xs) - 1
    held = {"free_free": (0,), "fixed_free": (0,), "free_fixed": (last,), "fixed_fixed": (0, last)}[shaft.support]
    chain = [((i, i + 1), ((k, -k), (-k, k))) for i, k in enumerate(springs)]
    phi, surplus = settle(len(xs), chain, loads, {end: 0.0 for end in held})
    if shaft.support == "free_free" and abs(surplus[0]) > _BALANCED * max(map(abs, loads)):
        raise UnbalancedError(f"a free shaft is not in balance: it takes {surplus[0]} N m to hold its left end")
    torques = tuple(k * (right - left) for k, (left, right) in zip(springs, pairwise(phi), strict=True))
    reactions = (surplus[0] if shaft.support.startswith("fixed") else 0.0, surplus[last] if last in held else 0.0)
    radii = tuple(segment.D / 2 for segment in segments)
    return FrameShaft(tuple(xs), tuple(phi), radii, tuple(polar), torques, shaft.ends, reactions)


def polar_moment(outer: float, bore: float) -> float:
    """Return the polar second moment (m^4) of a round section: its rings 2 pi r^3 dr by Simpson's rule, exact here."""
    inside, outside = bore / 2, outer / 2
    middle = (inside + outside) / 2
    return (outside - inside) / 6 * 2 * pi * (inside**3 + 4 * middle**3 + outside**3)
