"""Bending of a straight beam: reactions, shear force V, bending moment M, deflection and their exact extremes, by
initial parameters (domain SM-11 to SM-14, SM-17).

Axis x from the left end, y and v positive up. V(x) = sum of the upward forces left of x; M > 0 sags;
EI v'' = M, theta = v' (counter-clockwise). Forces and distributed loads positive up, couples positive
counter-clockwise: a force jumps V by +F, a couple jumps M by -M0. Loads add up; at a load's own x the value is the
one to its left, at x = 0 the one inside the beam.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from mechanics.checks import in_range, place
from mechanics.members import Beam, Distributed, Force, Load, Moment, Reaction, Support
from mechanics.roots import crossings
from mechanics.stability import degree, require_stable
from mechanics.sweep import State, Station, Stretch, carry, sweep

__all__ = [
    "Beam",
    "BeamResult",
    "Distributed",
    "Force",
    "Load",
    "Moment",
    "Piece",
    "Reaction",
    "Sample",
    "Support",
    "solve",
]

# Two extremes that differ by less than this part are a tie, and the leftmost is named.
_TIE = 1e-11


@dataclass(frozen=True, slots=True)
class Sample:
    """The state of the beam at one place."""

    x: float  # place, m
    V: float  # shear force, N
    M: float  # bending moment, N m
    v: float  # deflection, up, m
    theta: float  # slope, rad


class Piece(NamedTuple):
    """A stretch without a jump inside: its state at the left end and the load on it (a tuple: made in great number)."""

    x1: float  # start, m
    x2: float  # end, m
    V: float  # shear force at the start, N
    M: float  # bending moment at the start, N m
    theta: float  # slope at the start, rad
    v: float  # deflection at the start, m
    w: float  # load at the start, up, N/m
    k: float  # growth of the load, N/m^2
    EI: float  # bending stiffness, N m^2

    def shear(self, t: float) -> float:
        """Return V at the distance t (m) from the start."""
        return self.V + t * (self.w + t * self.k / 2)

    def moment(self, t: float) -> float:
        """Return M at the distance t (m) from the start."""
        return self.M + t * (self.V + t * (self.w / 2 + t * self.k / 6))

    def slope(self, t: float) -> float:
        """Return theta at the distance t (m) from the start."""
        return self.theta + t * (self.M + t * (self.V / 2 + t * (self.w / 6 + t * self.k / 24))) / self.EI

    def deflection(self, t: float) -> float:
        """Return v at the distance t (m) from the start."""
        bent = self.M / 2 + t * (self.V / 6 + t * (self.w / 24 + t * self.k / 120))
        return self.v + t * (self.theta + t * bent / self.EI)


class BeamResult(NamedTuple):
    """The solved beam; stresses are None where no section is given."""

    reactions: tuple[Reaction, ...]  # by rising x
    pieces: tuple[Piece, ...]
    degree: int  # degree of static indeterminacy
    M_max: float  # N m
    M_min: float  # N m
    M_abs_max: float  # N m
    x_M_abs_max: float  # m
    V_abs_max: float  # N
    v_extreme: float  # signed deflection of the largest magnitude, m
    x_v_extreme: float  # m
    I: float  # second moment of area, m^4
    W: float | None  # section modulus, m^3
    sigma_max: float | None  # largest bending stress, Pa
    tau_max: float | None  # largest shear stress at the neutral axis, Pa

    def at(self, x: float) -> Sample:
        """Sample the beam at x (m): where the state jumps, the value to the left; at x = 0 the one inside the beam.

        Raises:
            ValueError: x is not on the beam.
        """
        place("sample", x, self.pieces[-1].x2)
        piece = self.pieces[bisect_left(self.pieces, x, key=lambda piece: piece.x2)]
        t = x - piece.x1
        return Sample(x, piece.shear(t), piece.moment(t), piece.deflection(t), piece.slope(t))


def solve(beam: Beam) -> BeamResult:
    """Solve a beam on any supports, with hinges and overhangs, of any degree of static indeterminacy.

    Returns:
        Reactions, the pieces of V, M, theta and v, and the extremes, exact: at the ends of the pieces and where the
        derivative changes sign inside one.

    Raises:
        UnstableError: The supports do not hold the beam; the part that moves is named.
        ValueError: The answer is beyond the range of floating-point numbers.

    Source:
        Method of initial parameters (domain SM-11, SM-13, SM-14, SM-17); EI v'' = M, dM/dx = V, dV/dx = w.
    """
    require_stable(beam)
    stations = _stations(beam)
    stretches = _stretches(beam, stations)
    starts = sweep(stations, stretches)
    pieces, ends = _pieces(beam, stations, stretches, starts)
    return _result(beam, _reactions(beam.L, stations, starts, ends), pieces, ends)


def _stations(beam: Beam) -> list[Station]:
    """Where something jumps, by rising place; lengths in parts of L, everything else in newtons."""
    L = beam.L
    found = {0.0: Station(0.0), L: Station(L)}
    for load in beam.loads:
        if isinstance(load, Distributed):
            _at(found, load.x1), _at(found, load.x2)
        elif isinstance(load, Force):
            _at(found, load.x).force += load.F
        else:
            _at(found, load.x).couple += load.M / L
    stiffness = beam.E * beam.second_moment / L / L / L
    for support in beam.supports:
        station = _at(found, support.x)
        station.held, station.fixed = True, support.type == "fixed"
        station.settlement = support.settlement * stiffness
    for x in beam.hinges:
        _at(found, x).hinge = True
    return [found[x] for x in sorted(found)]


def _at(stations: dict[float, Station], x: float) -> Station:
    station = stations.get(x)
    if station is None:
        station = stations[x] = Station(x)
    return station


def _stretches(beam: Beam, stations: list[Station]) -> list[Stretch]:
    L = beam.L
    spread = [load for load in beam.loads if isinstance(load, Distributed)]
    found: list[Stretch] = []
    for left, right in pairwise(stations):
        w = k = 0.0
        for load in spread:
            if load.x1 <= left.x and right.x <= load.x2:
                growth = (load.w2 - load.w1) / (load.x2 - load.x1)
                w += load.w1 + growth * (left.x - load.x1)
                k += growth
        found.append(((right.x - left.x) / L, w * L, k * L * L))
    return found


def _pieces(
    beam: Beam, stations: list[Station], stretches: list[Stretch], starts: list[State]
) -> tuple[list[Piece], list[State]]:
    """The pieces, and the states at their right ends."""
    L, EI = beam.L, beam.E * beam.second_moment
    turn = L * L / EI
    pieces, ends = [], []
    x1 = 0.0
    for station, start, (h, w, k) in zip(stations[1:], starts, stretches, strict=True):
        v, theta, M, V = start
        pieces.append(Piece(x1, station.x, V, M * L, theta * turn, v * turn * L, w / L, k / L / L, EI))
        ends.append(carry(start, h, w, k))
        x1 = station.x
    return pieces, ends


def _reactions(L: float, stations: list[Station], starts: list[State], ends: list[State]) -> tuple[Reaction, ...]:
    """What is missing to the jumps of V and M at a support."""
    outside: State = (0.0, 0.0, 0.0, 0.0)
    found = []
    for station, before, after in zip(stations, [outside, *ends], [*starts, outside], strict=True):
        if station.held:
            moment = before[2] - after[2] - station.couple if station.fixed else 0.0
            found.append(Reaction(station.x, after[3] - before[3] - station.force, moment * L))
    return tuple(found)


def _result(beam: Beam, reactions: tuple[Reaction, ...], pieces: list[Piece], ends: list[State]) -> BeamResult:
    shears, moments, sags = _candidates(pieces, ends, beam.L)
    M_max, M_min, M_far, x_M = _extremes(*moments)
    _, _, v_far, x_v = _extremes(*sags)
    V_far = max(max(shears), -min(shears))
    total = M_far + V_far + v_far
    for reaction in reactions:
        total += reaction.Fy
    in_range(total)
    M_far = abs(M_far)
    W, sigma, tau = _stresses(beam, M_far, V_far)
    I, free = beam.second_moment, degree(beam)
    found = M_max, M_min, M_far, x_M, V_far, v_far, x_v, I, W, sigma, tau  # in the order of the fields
    return BeamResult(reactions, tuple(pieces), free, *found)


def _stresses(beam: Beam, M: float, V: float) -> tuple[float | None, float | None, float | None]:
    """sigma = M/W; tau = V Q/(I t) at the neutral axis (domain SM-12; Zhuravskii)."""
    section = beam.section
    if section is None:
        return None, None, None
    W = section.section_modulus
    return W, M / W, V * section.first_moment / (beam.second_moment * section.neutral_width)


_NOWHERE: Sequence[float] = ()
_Candidates = tuple[list[float], list[float]]  # rising places, m, and the values there


def _candidates(pieces: list[Piece], ends: list[State], L: float) -> tuple[list[float], _Candidates, _Candidates]:
    """Give V, M and v, the last two with their places, wherever they may be extreme.

    That is at the ends of the pieces, and where a derivative changes its sign inside one. V is monotone between the
    sign changes of w, M between those of V, theta between those of M; so without an inner one of these the signs at
    the two ends tell whether there is a crossing to look for.
    """
    shears: list[float] = []
    moments: _Candidates = [], []
    sags: _Candidates = [], []
    (x_M, all_M), (x_v, all_v) = moments, sags
    for piece, (_, end_theta, end_M, end_V) in zip(pieces, ends, strict=True):
        x1, x2, V, M, theta, v, w, k, EI = piece
        h = x2 - x1
        peaks = zeros = inflections = _NOWHERE
        shears += V, end_V
        x_M.append(x1)
        all_M.append(M)
        x_v.append(x1)
        all_v.append(v)
        if k:
            peaks = crossings((w, k, 0.0, 0.0, 0.0), h)
            for t in peaks:
                shears.append(piece.shear(t))
        if peaks or (V < 0) != (end_V < 0):
            zeros = crossings((V, w, k / 2, 0.0, 0.0), h, peaks)
            for t in zeros:
                x_M.append(x1 + t)
                all_M.append(piece.moment(t))
        if zeros or (M < 0) != (end_M < 0):
            inflections = crossings((M, V, w / 2, k / 6, 0.0), h, zeros)
        if inflections or (theta < 0) != (end_theta < 0):
            for t in crossings((EI * theta, M, V / 2, w / 6, k / 24), h, inflections):
                x_v.append(x1 + t)
                all_v.append(piece.deflection(t))
        x_M.append(x2)
        all_M.append(end_M * L)
    x_v.append(x2)
    all_v.append(piece.deflection(h))
    return shears, moments, sags


def _extremes(places: list[float], values: list[float]) -> tuple[float, float, float, float]:
    """The largest value, the smallest, the one of the largest magnitude and its place, the leftmost on a tie."""
    high, low = max(values), min(values)
    bar = max(high, -low) * (1 - _TIE)
    number = 0
    while -bar < values[number] < bar:
        number += 1
    return high, low, values[number], places[number]
