"""Bending of a straight beam: reactions, V, M, deflection and their exact extremes, by initial parameters
(domain SM-11 to SM-14, SM-17).

Axis x from the left end, y and v positive up. V(x) = sum of the upward forces left of x; M > 0 sags;
EI v'' = M, theta = v' (counter-clockwise). Forces and distributed loads positive up, couples positive
counter-clockwise: a force jumps V by +F, a couple jumps M by -M0. Loads add up; at a load's own x the value is the
one to its left, at x = 0 the one inside the beam.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from mechanics.checks import finite, place
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


@dataclass(frozen=True, slots=True)
class BeamResult:
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
    ends = [carry(start, h, w, k) for start, (h, w, k) in zip(starts, stretches, strict=True)]
    pieces = _pieces(beam, stations, stretches, starts)
    return _result(beam, _reactions(beam, stations, starts, ends), pieces, ends)


def _stations(beam: Beam) -> list[Station]:
    """Where something jumps, by rising place; lengths in parts of L, everything else in newtons."""
    found: dict[float, Station] = {}

    def at(x: float) -> Station:
        if x not in found:
            found[x] = Station(x)
        return found[x]

    at(0.0), at(beam.L)
    for load in beam.loads:
        if isinstance(load, Force):
            at(load.x).force += load.F
        elif isinstance(load, Moment):
            at(load.x).couple += load.M / beam.L
        else:
            at(load.x1), at(load.x2)
    stiffness = beam.E * beam.second_moment / beam.L / beam.L / beam.L
    for support in beam.supports:
        at(support.x).hold(support.type == "fixed", support.settlement * stiffness)
    for x in beam.hinges:
        at(x).hinge = True
    return [found[x] for x in sorted(found)]


def _stretches(beam: Beam, stations: list[Station]) -> list[Stretch]:
    spread = [load for load in beam.loads if isinstance(load, Distributed)]
    found: list[Stretch] = []
    for left, right in pairwise(stations):
        w = k = 0.0
        for load in spread:
            if load.x1 <= left.x and right.x <= load.x2:
                growth = (load.w2 - load.w1) / (load.x2 - load.x1)
                w += load.w1 + growth * (left.x - load.x1)
                k += growth
        found.append(((right.x - left.x) / beam.L, w * beam.L, k * beam.L * beam.L))
    return found


def _pieces(beam: Beam, stations: list[Station], stretches: list[Stretch], states: list[State]) -> tuple[Piece, ...]:
    L, EI = beam.L, beam.E * beam.second_moment
    turn = L * L / EI
    return tuple(
        Piece(left.x, right.x, V, M * L, theta * turn, v * turn * L, w / L, k / L / L, EI)
        for (left, right), (_, w, k), (v, theta, M, V) in zip(pairwise(stations), stretches, states, strict=True)
    )


def _reactions(beam: Beam, stations: list[Station], starts: list[State], ends: list[State]) -> tuple[Reaction, ...]:
    """What is missing to the jumps of V and M at a support."""
    outside: State = (0.0, 0.0, 0.0, 0.0)
    found = []
    for station, before, after in zip(stations, [outside, *ends], [*starts, outside], strict=True):
        if station.held:
            moment = before[2] - after[2] - station.couple if station.fixed else 0.0
            found.append(Reaction(station.x, after[3] - before[3] - station.force, moment * beam.L))
    return tuple(found)


def _result(beam: Beam, reactions: tuple[Reaction, ...], pieces: tuple[Piece, ...], ends: list[State]) -> BeamResult:
    shears, moments, sags = _candidates(pieces, ends, beam.L)
    x_M, M_far = _farthest(moments)
    x_v, v_far = _farthest(sags)
    V_far = max(max(shears), -min(shears))
    finite("the sum of the answers", M_far + V_far + v_far + sum([r.Fy for r in reactions]), "")
    W, sigma, tau = _stresses(beam, abs(M_far), V_far)
    values = [M for _, M in moments]
    return BeamResult(
        reactions=reactions,
        pieces=pieces,
        degree=degree(beam),
        M_max=max(values),
        M_min=min(values),
        M_abs_max=abs(M_far),
        x_M_abs_max=x_M,
        V_abs_max=V_far,
        v_extreme=v_far,
        x_v_extreme=x_v,
        I=beam.second_moment,
        W=W,
        sigma_max=sigma,
        tau_max=tau,
    )


def _stresses(beam: Beam, M: float, V: float) -> tuple[float | None, float | None, float | None]:
    """sigma = M/W; tau = V Q/(I t) at the neutral axis (domain SM-12; Zhuravskii)."""
    section = beam.section
    if section is None:
        return None, None, None
    W = section.section_modulus
    return W, M / W, V * section.first_moment / (beam.second_moment * section.neutral_width)


_Candidates = list[tuple[float, float]]  # place, m, and value


def _candidates(pieces: tuple[Piece, ...], ends: list[State], L: float) -> tuple[list[float], _Candidates, _Candidates]:
    """Give V, M and v, the last two with their places, wherever they may be extreme, by rising place.

    That is at the ends of the pieces, and where a derivative changes its sign inside one. V is monotone between the
    sign changes of w, M between those of V, theta between those of M; so without an inner one of these the signs at
    the two ends tell whether there is a crossing to look for.
    """
    shears: list[float] = []
    moments: _Candidates = []
    sags: _Candidates = []
    for piece, (_, end_theta, end_M, end_V) in zip(pieces, ends, strict=True):
        x1, x2, V, M, theta, v, w, k, EI = piece
        h = x2 - x1
        peaks = crossings((w, k, 0.0, 0.0, 0.0), h) if k else ()
        zeros = crossings((V, w, k / 2, 0.0, 0.0), h, peaks) if peaks or (V < 0) != (end_V < 0) else ()
        inflections = crossings((M, V, w / 2, k / 6, 0.0), h, zeros) if zeros or (M < 0) != (end_M < 0) else ()
        shears += (V, end_V)
        moments.append((x1, M))
        sags.append((x1, v))
        if peaks:
            shears += [piece.shear(t) for t in peaks]
        if zeros:
            moments += [(x1 + t, piece.moment(t)) for t in zeros]
        if inflections or (theta < 0) != (end_theta < 0):
            turns = crossings((EI * theta, M, V / 2, w / 6, k / 24), h, inflections)
            sags += [(x1 + t, piece.deflection(t)) for t in turns]
        moments.append((x2, end_M * L))
    sags.append((x2, piece.deflection(h)))
    return shears, moments, sags


def _farthest(candidates: _Candidates) -> tuple[float, float]:
    """The place of the largest magnitude and the signed value there; the leftmost on a tie."""
    bar = max([abs(value) for _, value in candidates]) * (1 - _TIE)
    for x, value in candidates:
        if value >= bar or value <= -bar:
            return x, value
    return candidates[0]
