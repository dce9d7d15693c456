"""Random beams, shafts and bars, many of them nearly singular, and how well the solvers satisfy the laws on them.

A structure is refused by a named error or solved; a solved one gives the greatest residual of its laws, as a part of
the forces or displacements that are about. `exact` solves a beam once more in fractions.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import factorial
from random import Random
from typing import TypeAlias

from mechanics import bar, beam, linear, shaft
from mechanics.bar import AxialForce, Bar, BarSegment
from mechanics.beam import BeamResult
from mechanics.members import Beam, Distributed, Force, Load, Moment, Segment, Shaft, Support, Torque
from mechanics.section import Ring

CELLS = 24


@dataclass
class Found:
    """What came of many structures."""

    solved: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    worst: float = 0.0
    at: object = None

    def add(self, made: Callable[[], tuple[object, float]]) -> None:
        """Count one structure: a residual, or the kind of its refusal."""
        try:
            structure, residual = made()
        except ValueError as refusal:
            self.refused[type(refusal).__name__] += 1
            assert str(refusal), "a refusal says why"
            return
        self.solved += 1
        if not residual <= self.worst:
            self.worst, self.at = residual, structure


def attack(seed: int, count: int, kind: str) -> Found:
    """Try structures of one kind: beam, shaft or bar."""
    found = Found()
    for number in range(count):
        rng = Random(f"{seed}/{number}")
        found.add(lambda rng=rng: KINDS[kind](rng))  # type: ignore[misc]
    return found


def _beam(rng: Random) -> tuple[object, float]:
    made = random_beam(rng)
    return made, max(beam_residuals(made, beam.solve(made)))


def _shaft(rng: Random) -> tuple[object, float]:
    made = random_shaft(rng)
    return made, max(shaft_residuals(made, shaft.solve(made)))


def _bar(rng: Random) -> tuple[object, float]:
    made = random_bar(rng)
    return made, max(bar_residuals(made, bar.solve(made)))


KINDS: dict[str, Callable[[Random], tuple[object, float]]] = {"beam": _beam, "shaft": _shaft, "bar": _bar}


def _places(rng: Random, L: float, count: int) -> Iterator[float]:
    """Places on a grid, anywhere, at the ends, or beside an earlier one by almost nothing."""
    earlier = [0.0, L]
    for _ in range(count):
        draw = rng.random()
        if draw < 0.5:
            x = rng.randint(0, CELLS) * L / CELLS
        elif draw < 0.7:
            x = rng.uniform(0, L)
        elif draw < 0.8:
            x = rng.choice(earlier)
        else:
            x = rng.choice(earlier) + rng.choice([-1, 1]) * L * 10 ** rng.uniform(-14, -2)
        earlier.append(x)
        yield min(max(x, 0.0), L)


def _power(rng: Random, low: float, high: float) -> float:
    return float(10 ** rng.uniform(low, high))


def _signed(rng: Random, low: float = 0.0, high: float = 5.0) -> float:
    return rng.choice([-1, 1]) * _power(rng, low, high)


def random_beam(rng: Random) -> Beam:
    """Make a beam; raises ValueError."""
    L = _power(rng, -2, 2)
    EI = _power(rng, 2, 8)
    kinds = ("pin", "roller", "fixed")
    drop = L * 1e-4 if rng.random() < 0.3 else 0.0
    spots = list(_places(rng, L, 13))
    supports = tuple(
        Support(x, rng.choice(kinds), drop * rng.uniform(-1, 1))  # type: ignore[arg-type]
        for x in spots[: rng.randint(1, 5)]
    )
    hinges = tuple(x for x in spots[5 : 5 + rng.choice([0, 0, 0, 1, 2])] if 0 < x < L)
    loads = tuple(_load(rng, *sorted(rng.sample(spots, 2))) for _ in range(rng.randint(0, 5)))
    return Beam(L, 2e11, supports, loads, hinges, I=EI / 2e11)


def _load(rng: Random, x1: float, x2: float) -> Load:
    draw = rng.random()
    if draw < 0.4 or x1 == x2:
        return Force(x1, _signed(rng))
    if draw < 0.6:
        return Moment(x1, _signed(rng))
    w = _signed(rng)
    return Distributed(x1, x2, w, rng.choice([w, 0.0, -w, w * (1 + _signed(rng, -15, -6)), _signed(rng)]))


def beam_residuals(made: Beam, found: BeamResult) -> Iterator[float]:
    """Equilibrium of the whole, and every condition at a support, a hinge and between the pieces."""
    L, EI = made.L, made.E * found.I
    forces = [(one.x, one.Fy) for one in found.reactions]
    couples = [one.M for one in found.reactions]
    for load in made.loads:
        if isinstance(load, Force):
            forces.append((load.x, load.F))
        elif isinstance(load, Moment):
            couples.append(load.M)
        else:
            h = load.x2 - load.x1
            forces += [(load.x1 + h / 3, load.w1 * h / 2), (load.x2 - h / 3, load.w2 * h / 2)]
    force = sum(abs(F) for _, F in forces) + sum(map(abs, couples)) / L or 1.0
    sag = force * L**3 / EI + abs(found.v_extreme)
    yield abs(sum(F for _, F in forces)) / force
    yield abs(sum(F * x for x, F in forces) + sum(couples)) / force / L
    for support in made.supports:
        yield abs(found.at(support.x).v - support.settlement) / sag
        if support.type == "fixed":
            yield abs(found.at(support.x).theta) * L / sag
    for x in made.hinges:
        yield abs(found.at(x).M) / force / L
    for left, right in pairwise(found.pieces):
        yield abs(left.deflection(left.x2 - left.x1) - right.v) / sag


Source: TypeAlias = tuple[float, int]  # a place, and the power of its bracket in EI v'': force 1, couple 0, kink -1


def exact(made: Beam) -> tuple[list[tuple[Fraction, Fraction]], Callable[[float], tuple[Fraction, Fraction]]]:
    """Solve a beam in fractions: one system for v and theta at the left end, all reactions and the kinks at hinges.

    Macaulay's brackets over the whole length, so nothing of the sweep is used.

    Returns:
        Reactions (force, couple) in the order of the supports, and a function that gives M and EI v at a place that
        is no place of a load.
    """
    unknown, known = _unknown(made), [*_known(made)]
    conditions = [*_conditions(made)]
    matrix = [[_influence(one, x, below) for one in unknown] for x, below, _ in conditions]
    right = [value - _sum(known, x, below) for x, below, value in conditions]
    sizes = linear.solve(matrix, right)
    everything = [*zip(unknown, sizes, strict=True), *known]
    rest, reactions = iter(sizes[2:]), []
    for support in made.supports:
        force = next(rest)
        reactions.append((force, -next(rest) if support.type == "fixed" else Fraction(0)))
    return reactions, lambda x: (_sum(everything, x, 0), _sum(everything, x, 2))


def _unknown(made: Beam) -> list[Source]:
    found: list[Source] = [(-1.0, -2), (-1.0, -1)]  # EI v, EI theta at the left end
    for support in made.supports:
        found += [(support.x, 1), (support.x, 0)] if support.type == "fixed" else [(support.x, 1)]
    return [*found, *((x, -1) for x in made.hinges)]


def _known(made: Beam) -> Iterator[tuple[Source, Fraction]]:
    for load in made.loads:
        if isinstance(load, Force):
            yield (load.x, 1), Fraction(load.F)
        elif isinstance(load, Moment):
            yield (load.x, 0), -Fraction(load.M)
        else:
            growth = (Fraction(load.w2) - Fraction(load.w1)) / (Fraction(load.x2) - Fraction(load.x1))
            for x, w, sign in ((load.x1, load.w1, 1), (load.x2, load.w2, -1)):
                yield (x, 2), sign * Fraction(w)
                yield (x, 3), sign * growth


def _conditions(made: Beam) -> Iterator[tuple[float, int, Fraction]]:
    """Give what is known of the beam: where, which integral, its value."""
    yield made.L, 0, Fraction(0)
    yield made.L, -1, Fraction(0)
    for support in made.supports:
        yield support.x, 2, Fraction(support.settlement) * Fraction(made.E) * Fraction(made.second_moment)
        if support.type == "fixed":
            yield support.x, 1, Fraction(0)
    for x in made.hinges:
        yield x, 0, Fraction(0)


def _influence(source: Source, x: float, below: int) -> Fraction:
    """M (below 0), EI theta (1), EI v (2), V (-1) at x, just right of all that stands there, of a unit source."""
    place, power = source[0], source[1] + below
    if place > x or power < 0:
        return Fraction(0)
    return (Fraction(x) - max(Fraction(place), Fraction(0))) ** power / factorial(power)


def _sum(sources: Iterable[tuple[Source, Fraction]], x: float, below: int) -> Fraction:
    return sum((size * _influence(one, x, below) for one, size in sources), Fraction(0))


def exact_error(made: Beam) -> float:
    """Give the greatest error of reactions, M and v against the exact solution, each as a part of its greatest value.

    Where a load goes straight into a support, moments and deflections are rounding: then the parts are of a thousandth
    of F L and of a hundred thousandth of F L^3/EI.
    """
    found = beam.solve(made)
    reactions, at = exact(made)
    own = {one.x: one for one in found.reactions}
    L, EI = made.L, made.E * made.second_moment
    forces = [(own[support.x].Fy, float(F)) for support, (F, _) in zip(made.supports, reactions, strict=True)]
    couples = [(own[support.x].M, float(M)) for support, (_, M) in zip(made.supports, reactions, strict=True)]
    couple = max(abs(M) for _, M in couples)
    force = max(*(abs(F) for _, F in forces), found.V_abs_max, couple / L) or 1.0
    moment = max(couple, found.M_abs_max, force * L * 1e-3)
    sag = max(abs(found.v_extreme), force * L**3 / EI * 1e-5)
    errors = [abs(one - other) / force for one, other in forces]
    errors += [abs(one - other) / moment for one, other in couples]
    for piece in found.pieces:
        x = (piece.x1 + piece.x2) / 2
        if piece.x1 < x < piece.x2:
            sample, (M, v) = found.at(x), at(x)
            errors += [abs(sample.M - float(M)) / moment, abs(sample.v - float(v) / EI) / sag]
    return max(errors)


def random_shaft(rng: Random) -> Shaft:
    """Make a shaft; raises ValueError."""
    segments = tuple(_segment(rng) for _ in range(rng.randint(1, 4)))
    length = sum(segment.L for segment in segments)
    torques = tuple(Torque(x, _signed(rng)) for x in _places(rng, length, rng.randint(0, 5)))
    if rng.random() < 0.3:
        torques += (Torque(length, -sum(torque.T for torque in torques)),)
    support = rng.choice(["fixed_free", "free_fixed", "free_free", "fixed_fixed"])
    return Shaft(8e10, segments, torques, support, 6e7, 0.0087, rng.choice([0.0, 0.5, 0.99]))  # type: ignore[arg-type]


def _segment(rng: Random) -> Segment:
    D = _power(rng, -3, 0)
    return Segment(_power(rng, -6, 1), D, D * rng.choice([0.0, 0.5, 1 - _power(rng, -9, -1)]))


def shaft_residuals(made: Shaft, found: shaft.ShaftResult) -> Iterator[float]:
    """Equilibrium of the whole and of each section, and rotations zero at the walls."""
    ends = found.reactions
    size = sum(abs(torque.T) for torque in made.torques) + abs(ends.left) + abs(ends.right) or 1.0
    yield abs(sum(torque.T for torque in made.torques) + ends.left + ends.right) / size
    for piece in found.pieces:
        outer = sum(torque.T for torque in made.torques if torque.x >= piece.x2) + ends.right
        yield abs(piece.T - outer) / size
    turned = size * sum(one.L / made.G / Ring(one.D, one.d).torsion_constant for one in made.segments)
    if made.support != "free_fixed":
        yield abs(found.phi[0].phi) / turned
    if made.support in ("free_fixed", "fixed_fixed"):
        yield abs(found.phi[-1].phi) / turned


def random_bar(rng: Random) -> Bar:
    """Make a bar; raises ValueError."""
    segments = tuple(
        BarSegment(
            _power(rng, -6, 1), _power(rng, -6, -2), _power(rng, 9, 12), rng.choice([0.0, 1.2e-5]),
            rng.uniform(-80, 80), rng.choice([0.0, _signed(rng)]),
        )
        for _ in range(rng.randint(1, 4))
    )  # fmt: skip
    length = sum(segment.L for segment in segments)
    forces = tuple(AxialForce(x, _signed(rng)) for x in _places(rng, length, rng.randint(0, 5)))
    support = rng.choice(["fixed_free", "free_fixed", "fixed_fixed", "fixed_gap"])
    gap = rng.choice([0.0, _power(rng, -9, -2)]) if support == "fixed_gap" else None
    return Bar(segments, forces, support, gap)  # type: ignore[arg-type]


def bar_residuals(made: Bar, found: bar.BarResult) -> Iterator[float]:
    """Equilibrium, Hooke's law of each piece by its mean force, walls met or not reached."""
    ends = found.reactions
    loads = [force.F for force in made.forces] + [one.q * one.L for one in made.segments]
    thermal = max(abs(one.E * one.A * one.alpha * one.dT) for one in made.segments)
    size = sum(map(abs, loads)) + abs(ends.left) + abs(ends.right) + thermal or 1.0
    yield abs(sum(loads) + ends.left + ends.right) / size
    moved = size * sum(one.L / one.E / one.A for one in made.segments)
    if made.support != "free_fixed":
        yield abs(found.u[0].u) / moved
    if made.support in ("free_fixed", "fixed_fixed"):
        yield abs(found.u[-1].u) / moved
    if made.gap_right is not None:
        over = found.u[-1].u - made.gap_right
        yield abs(over) / (moved + made.gap_right) if found.gap_closed else max(over, 0.0)
        yield max(ends.right, 0.0) / size
