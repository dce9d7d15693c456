"""An answer beside a reference: what balls say of the two at chosen points."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from operator import itemgetter
from typing import TypeAlias

from graders.equality.alike import alike
from graders.equality.cases import Cases
from graders.equality.deciding import PRECISIONS, Balls, Finding, fineness
from graders.equality.following import narrowed
from graders.equality.multiples import of_other_angles
from graders.equality.probing import Row, Search, all_met, looks, open_turns
from graders.equality.steep import steep, summits
from graders.equality.turns import TURNING, Joint, Places, Turn, may_be_steep, needed, places, together, turns
from graders.judge import Domain, Formula
from graders.language.doubles import DOUBLES, domain_test
from graders.language.intervals import Interval
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Number, Tree, names
from graders.states import INSIDE, Point

CASES = 3  # points that settle one case of what turns
FEW = 3  # points that settle two analytic formulas
POINTS = 4  # that balls settle where something turns
GLANCE = 6  # points at which doubles look for a difference before cases are gone through
WORST = 2  # points at which doubles see the greatest difference, asked before anything is searched
NEW = 8  # points with signs that were not met before, asked before anything more is searched
FIRST = (0, INSIDE, INSIDE + 1, 1)  # points that are asked first: inside, two corners, inside
OPEN = 4  # points that may stay unsettled
MOST_TURNS = 16  # that are searched for their borders; more stay undecided where no difference is found
LEAST_ASKED = 24  # points that balls settle, whatever they cost
WORK = 24_000  # operations of balls behind which no more points are asked
NEAR = 1e-11  # how close by, as a share of a domain
SEEN = 1e-9  # a relative difference that doubles see
BLIND = 3.0  # more than any: where doubles see nothing
NOTHING = Number("0")


@dataclass(frozen=True, slots=True)
class Comparison:
    """A finding with the point that proves a difference."""

    finding: Finding
    witness: tuple[tuple[str, float], ...] = ()


EQUAL = Comparison(Finding.EQUAL)


Place: TypeAlias = tuple[Point, object, bool]  # a point, the signs of all turns there, whether it is asked about anyway


def few(points: Sequence[Point]) -> Iterator[Point]:
    """Put a point inside, two corners and another inside in front: an analytic difference shows at any of them."""
    yield from (points[at] for at in FIRST if at < len(points))
    yield from (point for at, point in enumerate(points) if at not in FIRST)


@dataclass(frozen=True, slots=True)
class Turned:
    """What turns in a pair.

    Attributes:
        program: The pair, with the values of what turns as further outputs.
        turns: What may turn in the box, as far as it is searched.
        where: The functions that turn, and where they do.
        functions: Slots of the functions in which it does.
        slots: The ranges of all slots on the box.
        steep: Slots of the exponentials and high powers that range widely.
        signed: Slots that have one sign inside the box.
    """

    program: Program
    turns: list[Turn]
    where: Places
    functions: frozenset[int]
    slots: list[Interval]
    steep: frozenset[int]
    signed: frozenset[int]


class Pair:
    """An answer beside a reference: their common program, and what turns in it, found when it is first asked for."""

    __slots__ = (
        "_doubles", "_early", "_glance", "_once", "_rows", "_sides", "_turned", "balls", "builder", "lines",
        "most_turns", "mutual", "points", "program", "searched", "smooth", "states", "turning",
    )  # fmt: skip

    def __init__(self, answer: Tree, reference: Formula, mutual: bool, most_turns: int = MOST_TURNS) -> None:
        self.states, self.mutual, self.points = reference.states, mutual, reference.states.points
        self.builder = builder = Builder(self.states.names)
        lines = _needed(self.states.lines, reference.tree, answer)
        self.lines = tuple([builder.define(name, line) for name, line in lines])
        self.program: Program = builder.program(builder.add(reference.tree), builder.add(answer))
        functions = {name for name, _ in builder.operations}
        self.turning = not TURNING.isdisjoint(functions)
        self.smooth = not self.turning and not any(map(may_be_steep, functions))
        self.balls = Balls(self.program, mutual, self.lines, fineness(self.states))
        self._once = False
        self._early: Comparison | None = None
        self._turned: Turned | None = None
        self._glance: list[Row] | None = None
        self._sides: tuple[set[int], set[int]] | None = None
        self._rows: list[Row] | None = None
        self._doubles: Runner | None = None
        self.searched, self.most_turns = True, most_turns

    @property
    def turned(self) -> Turned:
        """Give what turns; only what may turn in the box counts."""
        if self._turned is None:
            self._turned = self._look()
        return self._turned

    def _look(self) -> Turned:
        if self.smooth:
            return Turned(self.program, [], {}, frozenset(), [], frozenset(), frozenset())
        where = places(self.builder) if self.turning else {}
        slots: list[Interval] = []
        signed: frozenset[int] = frozenset()
        found = turns(where, self.sides) if where else []
        if self.states.box:
            found, slots, signed = self._opened(found)
            where, found = self._narrowed(where, found, slots, signed)
        opened = {turn.slot for turn in found}
        functions = frozenset(at for at, several in where.items() if any(slot in opened for slot, _ in several))
        if len(found) > self.most_turns:
            self.searched, found = False, found[: self.most_turns]
        return Turned(self._with(found), found, where, functions, slots, steep(self.program, slots), signed)

    def _opened(self, found: Sequence[Turn]) -> tuple[list[Turn], list[Interval], frozenset[int]]:
        """Give what may turn in the box, the ranges of all slots there, and the slots that have one sign."""
        return open_turns(self._with(found), self.states.box, found)

    def _narrowed(
        self, where: Places, found: list[Turn], slots: Sequence[Interval], signed: frozenset[int]
    ) -> tuple[Places, list[Turn]]:
        """Leave out directions that are never cut, and arcs whose ends are never reached."""
        return narrowed(self.builder, where, found, slots, signed, self.points)

    def _all_met(self, groups: Sequence[Joint]) -> bool:
        """Tell whether the points that were drawn hold all that a search could find."""
        return not self.turned.steep and all_met(self.turns, groups, self.rows, self.mutual)

    def _with(self, found: Sequence[Turn]) -> Program:
        return self.builder.program(*self.program.outputs, *(turn.slot for turn in found))

    @property
    def rows(self) -> list[Row]:
        """Give what doubles see at all points."""
        if self._rows is None:
            more = looks(self.doubles, self.points[GLANCE:]) if self.turns else []
            self._rows = [*self.glance, *more] if self.turns else []
        return self._rows

    @property
    def glance(self) -> list[Row]:
        """Give what doubles see at the first points."""
        if self._glance is None:
            self._glance = looks(self.doubles, self.points[:GLANCE])
        return self._glance

    @property
    def doubles(self) -> Runner:
        """Give the pair and what turns in it ready to run in doubles."""
        if self._doubles is None:
            self._doubles = Runner(self.turned.program, DOUBLES)
        return self._doubles

    @property
    def turns(self) -> list[Turn]:
        """Give what may turn."""
        return self.turned.turns

    @property
    def values(self) -> int:
        """The number of points at which one of the two has a value."""
        finite = math.isfinite
        return sum([finite(row[0]) or finite(row[1]) for row in self.rows])

    def at_once(self) -> Comparison | None:
        """Give a difference that the very first point proves, or equality in every case: most answers end here."""
        if not self._once:
            self._once = True
            self._early = self._first(self.points[:1])
            if self._early is None and (self.turns or self.turned.steep):
                self._early = self._first(self._seen_apart()) or self._in_every_case()
        return self._early

    def compared(self) -> Comparison:
        """Compare the two."""
        if self.smooth:
            return self._smooth()
        found = self.at_once() or self._at_summits()
        if found is not None or not self.turns:
            return found or self._smooth()
        places: list[Place] = []
        for stage in self._stages():
            met = {pattern for _, pattern, _ in places}
            new = {pattern: point for point, pattern, _ in reversed(stage) if pattern not in met}
            worst = [point for point, _, asked in stage[:WORST] if asked]
            early = self._first([*worst, *islice(new.values(), NEW)])
            if early is not None:
                return early
            places += stage
        places.sort(key=lambda place: not place[2])
        return self._settled(places)

    def _seen_apart(self) -> list[Point]:
        """Give one of a few points at which doubles see a difference, if there is one."""
        rows = zip(self.glance, self.points, strict=False)
        return next(([point] for row, point in rows if SEEN < _far(row) < BLIND), [])

    def _in_every_case(self) -> Comparison | None:
        """Give equality that does not hang on what turns or is steep."""
        points, program = self.points[:CASES], self.program
        if len(set(points)) < CASES or self.balls.at(points[0]) is not Finding.EQUAL:
            return None
        columns = {turn.slot: [row[2 + at] for row in self.glance] for at, turn in enumerate(self.turns)}
        if alike(program, self.turned.where, self.turned.functions, self.sides, columns) and self._agree(parted=False):
            return EQUAL
        return None if of_other_angles(program, self.sides) or not self._agree(parted=True) else EQUAL

    @property
    def sides(self) -> tuple[set[int], set[int]]:
        """Give the slots that the reference, with the earlier names, and the answer stand on."""
        if self._sides is None:
            right, typed = self.program.outputs
            self._sides = needed(self.program, (right, *self.lines)), needed(self.program, (typed,))
        return self._sides

    def _agree(self, parted: bool) -> bool:
        """Tell whether the two are shown to agree whatever turns."""
        turned, fine = self.turned, self.balls.fine
        turning, points = turned.functions | turned.steep, self.points[:CASES]
        cases = Cases(
            self.program, self.sides, points, turned.slots, turned.signed, turning, self.mutual, fine, parted
        )  # fmt: skip
        return cases.agree(self.balls.runner(PRECISIONS[0]))

    def _at_summits(self) -> Comparison | None:
        """Give a difference that steep parts hide at most points."""
        if not self.states.box or not self.turned.steep:
            return None
        rows = zip(looks(Runner(self.program, DOUBLES), self.points), self.points, strict=True)
        worst = [point for point, _, asked in self._places(rows, None)[:WORST] if asked]
        steep_slots, box = self.turned.steep, self.states.box
        return self._first(worst) or self._first(summits(self.program, steep_slots, box, self.points))

    def _smooth(self) -> Comparison:
        """Ask the balls at a few points: an analytic difference that is zero there is zero."""
        settled = unsure = 0
        for point in few(self.points):
            found = self.balls.at(point)
            if found is Finding.EQUAL:
                settled += 1
                if settled == FEW:
                    return EQUAL
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
        far = [(_far(row), row, point) for row, point in looked]
        far.sort(key=itemgetter(0), reverse=True)
        every = touched is not None or not self.states.box
        return [
            (point, touched if touched is not None else tuple([x > 0 for x in row[2:]]), every or apart > SEEN)
            for apart, row, point in far
        ]

    def _stages(self) -> Iterator[list[Place]]:
        """Give points to ask about, each stage when the one before has shown no difference.

        First those that were drawn, then those on both sides of everything that turns, those where signs go together,
        and those around touched zeros, each of which is asked about.
        """
        turned, doubles = self.turned, self.doubles
        yield self._places(zip(self.rows, self.points, strict=True), None)
        if not self.states.box:
            return
        groups = together(self.builder, turned.where, turned.turns, self.program.outputs)
        if self._all_met(groups):
            return
        box, slots = self.states.box, turned.slots
        search = Search(turned.program, doubles, box, self.points, self.rows, self.mutual, self.lines, slots)
        found = list(search.beside(turned.turns))
        crossed = [point for point, touched in found if not touched]
        rows = looks(doubles, crossed)
        yield self._places(zip(rows, crossed, strict=True), None)
        joint = list(search.joint(turned.turns, groups, [*self.rows, *rows])) if groups else []
        yield self._places(zip(looks(doubles, joint), joint, strict=True), None)
        touching = [point for point, touched in found if touched]
        rows = looks(doubles, touching)
        yield [self._places([one], at)[0] for at, one in enumerate(zip(rows, touching, strict=True))]
        self.searched = self.searched and not search.open

    def _first(self, points: Iterable[Point]) -> Comparison | None:
        """Give the first proved difference."""
        for point in points:
            found = self.balls.at(point)
            if found in (Finding.DIFFERENT, Finding.UNDEFINED) and self._lasting(found, point):
                return self._witnessed(found, point)
        return None

    def _settled(self, places: Sequence[Place]) -> Comparison:
        """Ask the balls, one point a pattern and four at least, until a difference is proved."""
        settled: set[object] = set()
        unsure: set[tuple[object, Point]] = set()
        count = 0
        most = max(LEAST_ASKED, WORK // (1 + len(self.program.operations)))
        for point, pattern, asked in places:
            if not asked and count >= POINTS and pattern in settled:
                continue
            if count >= most:
                return Comparison(Finding.UNDECIDED)
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
        if not self.searched or {pattern for pattern, _ in unsure} - settled:
            return Comparison(Finding.UNDECIDED)
        return self._without_more(count, len(unsure))

    def _witnessed(self, found: Finding, point: Point) -> Comparison:
        return Comparison(found, tuple(zip(self.states.names, point, strict=True)))

    def _assembled(self, point: Point) -> bool:
        """Tell whether all earlier names have a value, also those that neither formula stands on."""
        return domain_test(NOTHING, self.states.names, self.states.lines)(point)

    def _lasting(self, found: Finding, point: Point) -> bool:
        """Tell whether a difference is there close by as well: a hole or a jump met by chance does not count."""
        if found is Finding.DIFFERENT and not self.turning:
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
    if right == typed:
        return 0.0 if right - typed == 0 else BLIND
    difference = abs(right - typed)
    return difference / max(abs(right), abs(typed)) if difference < math.inf else BLIND
