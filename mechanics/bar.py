"""Tension and compression of stepped bars: axial forces, stresses, displacements, supports, temperature, a gap
(domain SM-2 to SM-4).

Axis x from the left end. Forces and displacements positive along +x; N and sigma positive in tension; the axial force
N(x) is the sum of the external forces to the right of the section, the reaction included.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import accumulate, pairwise
from math import pi, sqrt
from typing import Literal, get_args

from mechanics.checks import finite, in_range, place, positive, summed

BarSupport = Literal["fixed_free", "free_fixed", "fixed_fixed", "fixed_gap"]
ROUNDING = 1e-12  # of the length: a printed place this near to an end of a segment is at that end


@dataclass(frozen=True, slots=True)
class BarSegment:
    """A stretch of one section and one material."""

    L: float  # length, m
    A: float  # area of the section, m^2
    E: float  # Young's modulus, Pa
    alpha: float = 0.0  # thermal expansion, 1/K
    dT: float = 0.0  # rise of temperature, K
    q: float = 0.0  # distributed force, N/m along +x

    def __post_init__(self) -> None:
        for name, value, unit in (("L", self.L, "m"), ("A", self.A, "m^2"), ("E", self.E, "Pa")):
            positive(f"segment {name}", value, unit)
        for name, value, unit in (("alpha", self.alpha, "1/K"), ("dT", self.dT, "K"), ("q", self.q, "N/m")):
            finite(f"segment {name}", value, unit)
        positive("axial stiffness E A", self.E * self.A, "N")


@dataclass(frozen=True, slots=True)
class AxialForce:
    """A concentrated force."""

    x: float  # place, m
    F: float  # along +x, N

    def __post_init__(self) -> None:
        finite("force place x", self.x, "m")
        finite(f"force at x = {self.x} m, F", self.F, "N")


@dataclass(frozen=True, slots=True)
class Bar:
    """A stepped bar; `fixed_gap` is fixed on the left and touches a wall on the right once the gap is closed.

    Raises:
        ValueError: A value is not finite, not positive where it must be, out of its place or unknown.
    """

    segments: tuple[BarSegment, ...]
    forces: tuple[AxialForce, ...] = ()
    support: BarSupport = "fixed_free"
    gap_right: float | None = None  # m, for fixed_gap only
    ends: tuple[float, ...] = field(init=False)  # where the segments end, m, in order, 0 first

    def __post_init__(self) -> None:
        if self.support not in get_args(BarSupport):
            raise ValueError(f"bar support {self.support!r} must be one of {', '.join(get_args(BarSupport))}")
        if not self.segments:
            raise ValueError("a bar needs at least one segment")
        if (self.gap_right is None) != (self.support != "fixed_gap"):
            raise ValueError("gap_right is given with the support fixed_gap, and only with it")
        if self.gap_right is not None and not 0 <= self.gap_right < float("inf"):
            raise ValueError(f"gap_right = {self.gap_right} m must be finite and not negative")
        ends = tuple(accumulate((segment.L for segment in self.segments), initial=0.0))
        positive("length of the bar", ends[-1], "m")
        object.__setattr__(self, "ends", ends)
        object.__setattr__(self, "forces", tuple(_placed(force, ends) for force in self.forces))


def _placed(force: AxialForce, ends: tuple[float, ...]) -> AxialForce:
    end = min(ends, key=lambda end: abs(end - force.x))
    if abs(end - force.x) <= ROUNDING * ends[-1]:
        return AxialForce(end, force.F)
    place("force", force.x, ends[-1])
    return force


@dataclass(frozen=True, slots=True)
class BarReactions:
    """What the supports do to the bar, along +x; zero at a free end."""

    left: float  # N
    right: float  # N


@dataclass(frozen=True, slots=True)
class BarPiece:
    """A stretch without a jump; N runs linearly from N1 to N2."""

    x1: float  # start, m
    x2: float  # end, m
    N1: float  # axial force just right of x1, N
    N2: float  # axial force just left of x2, N
    sigma1: float  # Pa
    sigma2: float  # Pa
    elongation: float  # temperature included, m


@dataclass(frozen=True, slots=True)
class Shift:
    """The displacement of a section."""

    x: float  # place, m
    u: float  # along +x, m


@dataclass(frozen=True, slots=True)
class BarResult:
    """The solved bar."""

    reactions: BarReactions
    pieces: tuple[BarPiece, ...]  # cut at the ends of segments and at forces
    u: tuple[Shift, ...]  # at the ends of pieces
    gap_closed: bool | None  # None without a gap

    @property
    def sigma_abs_max(self) -> float:
        """Give the largest magnitude of the stress, Pa."""
        return max(max(abs(piece.sigma1), abs(piece.sigma2)) for piece in self.pieces)


def solve(bar: Bar) -> BarResult:
    """Solve a stepped bar: equilibrium, and where both ends are held, the elongations add up to what they may.

    Raises:
        ValueError: The answer is beyond the range of floating-point numbers.

    Source:
        Domain SM-2, SM-3, SM-4: elongation = sum of (N l/(E A) + alpha dT l); N l taken at the middle of a stretch,
        which is exact for a linear N.
    """
    places = sorted({*bar.ends, *(force.x for force in bar.forces)})
    stretches = [(left, right, _segment(bar, right)) for left, right in pairwise(places)]
    outer = _outer(bar, places)
    right, closed = _right_reaction(bar, stretches, outer)
    left = 0.0 if bar.support == "free_fixed" else -_total(bar) - right
    pieces = tuple(_piece(stretch, N + right) for stretch, N in zip(stretches, outer, strict=True))
    found = BarResult(BarReactions(left, right), pieces, _shifts(bar, places, pieces), closed)
    in_range(found.sigma_abs_max + summed(shift.u for shift in found.u))
    return found


Stretch = tuple[float, float, BarSegment]


def _segment(bar: Bar, right: float) -> BarSegment:
    return next(one for one, end in zip(bar.segments, bar.ends[1:], strict=True) if right <= end)


def _total(bar: Bar) -> float:
    return summed([*(force.F for force in bar.forces), *(one.q * one.L for one in bar.segments)])


def _outer(bar: Bar, places: Sequence[float]) -> list[float]:
    """Give N at the right end of each stretch from the loads to its right, the right reaction left out."""
    found = []
    for right in places[1:]:
        forces = [force.F for force in bar.forces if force.x >= right]
        spread = [
            one.q * (end - max(right, start))
            for one, (start, end) in zip(bar.segments, pairwise(bar.ends), strict=True)
            if end > right
        ]
        found.append(summed([*forces, *spread]))
    return found


def _elongation(stretch: Stretch, N_right: float) -> float:
    x1, x2, one = stretch
    middle = N_right + one.q * (x2 - x1) / 2
    return (middle / (one.E * one.A) + one.alpha * one.dT) * (x2 - x1)


def _right_reaction(bar: Bar, stretches: Sequence[Stretch], outer: Sequence[float]) -> tuple[float, bool | None]:
    """Find the reaction of the right end, and whether the gap is closed."""
    if bar.support == "fixed_free":
        return 0.0, None
    if bar.support == "free_fixed":
        return -_total(bar), None
    free = summed(_elongation(stretch, N) for stretch, N in zip(stretches, outer, strict=True))
    allowed = bar.gap_right or 0.0
    if bar.support == "fixed_gap" and free <= allowed:
        return 0.0, free == allowed
    flexibility = summed((x2 - x1) / (one.E * one.A) for x1, x2, one in stretches)
    return (allowed - free) / flexibility, True if bar.support == "fixed_gap" else None


def _piece(stretch: Stretch, N2: float) -> BarPiece:
    x1, x2, one = stretch
    N1 = N2 + one.q * (x2 - x1)
    return BarPiece(x1, x2, N1, N2, N1 / one.A, N2 / one.A, _elongation(stretch, N2))


def _shifts(bar: Bar, places: Sequence[float], pieces: Sequence[BarPiece]) -> tuple[Shift, ...]:
    lengths = [piece.elongation for piece in pieces]
    if bar.support == "free_fixed":
        moved = [-u for u in accumulate(reversed(lengths), initial=0.0)][::-1]
    else:
        moved = list(accumulate(lengths, initial=0.0))
    return tuple(map(Shift, places, moved))


def required_diameter(force: float, sigma_allow: float) -> float:
    """Return the least diameter (m) of a round bar whose stress stays within the allowable one.

    Args:
        force: Largest axial force, N, of either sign.
        sigma_allow: Allowable stress, Pa, positive.

    Raises:
        ValueError: A value is not finite, or the stress not positive.

    Source:
        Domain SM-2: d = sqrt(4 N/(pi sigma)).
    """
    finite("axial force", force, "N")
    positive("allowable stress sigma_allow", sigma_allow, "Pa")
    return sqrt(4 * abs(force) / (pi * sigma_allow))
