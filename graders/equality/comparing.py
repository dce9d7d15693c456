"""Equality of two formulas as functions on the true states of a system.

Doubles choose where to look; balls decide. `different` is proved at a named point; `equal` is zero to 30 digits,
relative to the larger side, at several points and on both sides of everything that turns; anything else is undecided.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from graders.equality.deciding import Balls, Finding
from graders.equality.probing import Row, Search, looks
from graders.equality.rounding import Rounded, rounded
from graders.equality.turns import Turn, turns
from graders.judge import Domain, Formula, States
from graders.language.doubles import DOUBLES, UndefinedError, domain_test
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Number, Tree, names
from graders.states import INSIDE, Point, drawn, spread

FEW = 3  # points that settle two analytic formulas
POINTS = 4  # that balls settle where something turns
WORST = 2  # points at which doubles see the greatest difference, asked before anything is searched
LEAST = 8  # points at which a formula that turns has a value
OPEN = 4  # points that may stay unsettled
NEAR = 1e-11  # how close by, as a share of a domain
NOTHING = Number("0")
SEEN = 1e-9  # a relative difference that doubles see


@dataclass(frozen=True, slots=True)
class Comparison:
    """A finding with the point that proves a difference."""

    finding: Finding
    witness: tuple[tuple[str, float], ...] = ()


class Place(NamedTuple):
    """A point for the balls: the signs of all turns there, and whether it is asked about even if these were seen."""

    point: Point
    pattern: object
    asked: bool


def compare(answer: Tree, reference: Formula, figures: int = 0) -> Comparison:
    """Compare an answer with a reference on the states of the reference.

    Args:
        answer: What was typed.
        reference: What it should be equal to.
        figures: The significant figures to which the decimals of the answer may be rounded, at least; 0: none may.
    """
    if answer == reference.tree:
        return Comparison(Finding.EQUAL)
    found = _Pair(answer, reference, mutual=False).compared()
    if not figures or found.finding is not Finding.DIFFERENT:
        return found
    fitting = rounded(answer, reference, figures)
    return found if fitting is None else _fitted(fitting, reference.states)


def _fitted(fitting: Rounded, states: States) -> Comparison:
    """Ask at every point whether the rounded answer holds the reference."""
    findings = set()
    for point in states.points:
        finding = fitting.at(point)
        if finding is Finding.DIFFERENT:
            return Comparison(finding, tuple(zip(states.names, point, strict=True)))
        findings.add(finding)
    return Comparison(Finding.EQUAL if findings - {Finding.NOWHERE} == {Finding.EQUAL} else Finding.UNDECIDED)


def between(a: Tree, b: Tree, box: Mapping[str, Domain], chance: bytes = b"") -> Comparison:
    """Compare two formulas on a box; where only one of them has a value they differ.

    Args:
        a: One formula.
        b: The other.
        box: The domain of each symbol.
        chance: What the points depend on.
    """
    pair = _Pair(b, Formula(a, spread_over(tuple(box.items()), chance)), mutual=True)
    if not pair.turns or pair.values >= LEAST:
        return pair.compared()
    one, other = domain_test(a, tuple(box), ()), domain_test(b, tuple(box), ())
    try:
        states = drawn(box, chance, lambda point: one(point) or other(point))
    except UndefinedError:
        return pair.compared()
    return _Pair(b, Formula(a, states), mutual=True).compared()


@lru_cache(maxsize=256)
def spread_over(box: tuple[tuple[str, Domain], ...], chance: bytes) -> States:
    """Draw points of a box once."""
    return spread(dict(box), chance)


def few(points: Sequence[Point]) -> Iterator[Point]:
    """Put a point inside, two corners and another inside in front: an analytic difference shows at any of them."""
    first = [at for at in (0, INSIDE, INSIDE + 1, 1) if at < len(points)]
    yield from (points[at] for at in first)
    yield from (point for at, point in enumerate(points) if at not in first)


class _Pair:
    """An answer beside a reference: their common program and what doubles see of it."""

    __slots__ = ("balls", "doubles", "lines", "mutual", "points", "program", "rows", "states", "turns", "wide")

    def __init__(self, answer: Tree, reference: Formula, mutual: bool) -> None:
        self.states, self.mutual = reference.states, mutual
        builder = Builder(self.states.names)
        lines = _needed(self.states.lines, reference.tree, answer)
        self.lines = tuple([builder.define(name, line) for name, line in lines])
        right, typed = builder.add(reference.tree), builder.add(answer)
        self.turns: list[Turn] = turns(builder, (right, *self.lines), typed)
        self.program: Program = builder.program(right, typed)
        self.balls = Balls(self.program, mutual, self.lines)
        self.points, self.rows = self.states.points, list[Row]()
        if self.turns:
            self.wide = builder.program(right, typed, *(turn.slot for turn in self.turns))
            self.doubles = Runner(self.wide, DOUBLES)
            self.rows = looks(self.doubles, self.points)

    @property
    def values(self) -> int:
        """The number of points at which one of the two has a value."""
        return sum(any(map(math.isfinite, row[:2])) for row in self.rows)

    def compared(self) -> Comparison:
        if not self.turns:
            return self._smooth()
        places = self._places(zip(self.rows, self.points, strict=True), None)
        worst = self._first(place for place in places[:WORST] if place.asked)
        if worst is not None:
            return worst
        if self.states.box:
            places += self._beside()
        places.sort(key=lambda place: not place.asked)
        return self._settled(places)

    def _smooth(self) -> Comparison:
        """Ask the balls at a few points: an analytic difference that is zero there is zero."""
        settled = unsure = 0
        for point in few(self.points):
            found = self.balls.at(point)
            if found is Finding.EQUAL:
                settled += 1
                if settled == FEW:
                    return Comparison(found)
            elif found is Finding.UNDECIDED:
                unsure += 1
                if unsure > OPEN:
                    return Comparison(found)
            elif found is not Finding.NOWHERE and self._lasting(found, point):
                return self._witnessed(found, point)
        return self._without_more(settled, unsure)

    def _without_more(self, settled: int, unsure: int) -> Comparison:
        if not settled:
            return Comparison(Finding.UNDECIDED if unsure else Finding.NOWHERE)
        return Comparison(Finding.EQUAL if settled >= min(FEW, len(set(self.points))) else Finding.UNDECIDED)

    def _places(self, looked: Iterable[tuple[Row, Point]], touched: int | None) -> list[Place]:
        """Order points by how far doubles see the two apart, with the signs of what turns there."""
        ordered = sorted(((_far(row), row, point) for row, point in looked), key=lambda one: -one[0])
        every = touched is not None or not self.states.box
        return [
            Place(point, touched if touched is not None else tuple([x > 0 for x in row[2:]]), every or far > SEEN)
            for far, row, point in ordered
        ]

    def _beside(self) -> list[Place]:
        """Give points on both sides of everything that turns; each one around a touched zero is asked about."""
        search = Search(self.wide, self.states.box, self.points, self.rows, self.mutual, self.lines)
        found = list(search.beside(self.turns))
        crossed = [point for point, touched in found if not touched]
        touching = [point for point, touched in found if touched]
        places = self._places(zip(looks(self.doubles, crossed), crossed, strict=True), None)
        for number, (row, point) in enumerate(zip(looks(self.doubles, touching), touching, strict=True)):
            places += self._places([(row, point)], number)
        return places

    def _first(self, places: Iterable[Place]) -> Comparison | None:
        """Give the first proved difference."""
        for place in places:
            found = self.balls.at(place.point)
            if found in (Finding.DIFFERENT, Finding.UNDEFINED) and self._lasting(found, place.point):
                return self._witnessed(found, place.point)
        return None

    def _settled(self, places: Sequence[Place]) -> Comparison:
        """Ask the balls, one point a pattern and four at least, until a difference is proved."""
        settled, unsure, count = set[object](), set[tuple[object, Point]](), 0
        for point, pattern, asked in places:
            if not asked and count >= POINTS and pattern in settled:
                continue
            found = self.balls.at(point)
            if found is Finding.EQUAL:
                settled.add(pattern)
                count += 1
            elif found is Finding.UNDECIDED:
                unsure.add((pattern, point))
                if len(unsure) > OPEN:
                    return Comparison(found)
            elif found is not Finding.NOWHERE and self._lasting(found, point):
                return self._witnessed(found, point)
        if {pattern for pattern, _ in unsure} - settled:
            return Comparison(Finding.UNDECIDED)
        return self._without_more(count, len(unsure))

    def _witnessed(self, found: Finding, point: Point) -> Comparison:
        return Comparison(found, tuple(zip(self.states.names, point, strict=True)))

    def _assembled(self, point: Point) -> bool:
        """Tell whether all earlier names have a value, also those that neither formula stands on."""
        return domain_test(NOTHING, self.states.names, self.states.lines)(point)

    def _lasting(self, found: Finding, point: Point) -> bool:
        """Tell whether a difference is there close by as well: a hole or a jump met by chance does not count."""
        if found is Finding.DIFFERENT and not self.turns:
            return True
        if self.states.lines and point not in self.points and not self._assembled(point):
            return False
        return self.balls.at(_near(point, self.states.box)) is found


def _needed(lines: Sequence[tuple[str, Tree]], *trees: Tree) -> list[tuple[str, Tree]]:
    """Leave out the lines that no tree stands on: what turns in them does not concern the two."""
    wanted = frozenset[str]().union(*map(names, trees)) if lines else frozenset()
    kept = []
    for name, line in reversed(lines):
        if name in wanted:
            kept.append((name, line))
            wanted |= names(line)
    return kept[::-1]


def _near(point: Point, box: Sequence[Domain]) -> Point:
    """Give a point close by, inside the box; whole numbers stay."""
    if not box:
        return tuple([x + NEAR * (abs(x) or 1.0) for x in point])
    return tuple([_nudged(x, domain) for x, domain in zip(point, box, strict=True)])


def _nudged(x: float, domain: Domain) -> float:
    if domain.integer:
        return x
    step = NEAR * (domain.high - domain.low)
    return x + step if x + step < domain.high else x - step


def _far(row: Row) -> float:
    """Give the relative difference in doubles; what doubles cannot tell is worth a look first."""
    right, typed = row[0], row[1]
    difference, scale = abs(right - typed), max(abs(right), abs(typed))
    if not math.isfinite(difference):
        return 3.0
    return difference / scale if scale else 0.0
