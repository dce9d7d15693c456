"""Where balls should look: beside every place where a formula turns, found in doubles and intervals."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import combinations, product
from typing import Any, TypeAlias

from graders.equality.inside import one_signed
from graders.equality.rising import Trend, trends
from graders.equality.sides import Box, Found, Part, ends, whole
from graders.equality.turns import Joint, Turn, may_be_steep
from graders.judge import Domain
from graders.language.intervals import INTERVALS, Interval, side_of_zero
from graders.language.program import NO_VALUE, Program, Runner
from graders.states import Point

ALIKE = 1e-9  # relative difference of the ratios of two arguments that turn together

WORK, LESS_WORK = 3000, 400  # operations on intervals of one search: where its end matters, and elsewhere
MOST_JOINT = 24  # ways in which signs go together that are searched for
JOINT_WORK = 3000  # operations times symbols of all these ways; the dearest of 20,000 random formulas needs 600

Row: TypeAlias = list[float]
Way: TypeAlias = Callable[[Sequence[Interval]], Interval]


def look(runner: Runner, point: Point) -> Row:
    """Run in doubles; what has no value there is not a number."""
    return runner.run(point, math.nan)


def looks(runner: Runner, points: Sequence[Point]) -> list[Row]:
    """Run in doubles at many points; what has no value there is not a number."""
    try:
        return [list(row) for row in runner.columns(points)]
    except NO_VALUE:
        return [list(row) for row in runner.columns(points, _each)]


def _each(function: Callable[..., Any], *columns: Sequence[Any]) -> list[Any]:
    """Apply a function to columns of arguments; what has no value is not a number."""
    try:
        return list(map(function, *columns))
    except NO_VALUE:
        return [_tried(function, *arguments) for arguments in zip(*columns, strict=True)]


def _tried(function: Callable[..., Any], *arguments: Any) -> Any:
    try:
        return function(*arguments)
    except NO_VALUE:
        return math.nan


def open_turns(
    program: Program, box: Sequence[Domain], turns: Sequence[Turn]
) -> tuple[list[Turn], list[Interval], frozenset[int]]:
    """Give the turns that may change their sign in a box, or touch the zero of an edge inside.

    Beside them the ranges of all slots, and the slots that have one sign inside.
    """
    slots = Runner(program, INTERVALS).slots(whole(box))
    found = [turn for turn in turns if _open(turn, slots[turn.slot])]
    if not found and not any(may_be_steep(name) for name, _ in program.operations):
        return [], slots, frozenset()  # nobody asks for signs
    signed = one_signed(program, slots, box)
    return [turn for turn in found if turn.slot not in signed], slots, signed


@dataclass(frozen=True)
class Search:
    """A search of a box for both sides of what turns in a program.

    Attributes:
        program: Its first two outputs are the reference and the answer.
        doubles: The same ready to run in doubles.
        box: The domains of its inputs.
        points: Points of the box that were looked at.
        rows: Their outputs, and behind them the values of the turns.
        mutual: Whether a point where only the answer has a value is a state.
        lines: Slots of the earlier names, which have a value at every state.
        slots: The ranges of all slots on the box.
        known: Which way all slots go along the symbols that were asked for.
        open: Numbers of the turns that were neither found to have another side nor proved to have none.
    """

    program: Program
    doubles: Runner
    box: tuple[Domain, ...]
    points: Sequence[Point]
    rows: Sequence[Row]
    mutual: bool
    lines: tuple[int, ...]
    slots: Sequence[Interval]
    known: dict[int, list[Trend]] = field(default_factory=dict)
    open: list[int] = field(default_factory=list)

    def beside(self, turns: Sequence[Turn]) -> Iterator[tuple[Point, bool]]:
        """Give points beside each turn; those around a touched zero, where no sign changes, are marked."""
        ranges = [self.slots[turn.slot] for turn in turns]
        ends = [at for at, turn in enumerate(turns) if turn.edge and not ranges[at][0] >= 0]
        guarded = any(turns[at].right or self.mutual for at in ends)
        held = {at: self._held(at) for at in range(len(turns))}
        done: list[int] = []
        for at in range(len(turns)):
            alike = [other for other in done if turns[other].edge is turns[at].edge and _alike(held[at], held[other])]
            if not alike:
                one_sided, edge = (
                    not ranges[at][0] < 0 or (at in ends and self._both_end(turns, held, at)),
                    turns[at].edge,
                )
                sides = self._part((turns[at].slot,), guarded, itself, not edge).sides(held[at], one_sided, edge)
                if not (sides.proved or edge):
                    self.open.append(at)
                yield from ((point, sides.touched) for point in sides.points)
            done.append(at)

    def joint(self, turns: Sequence[Turn], groups: Sequence[Joint], rows: Sequence[Row]) -> Iterator[Point]:
        """Give a point for each way in which the signs of turns that act on one another go together.

        Args:
            turns: What turns.
            groups: Which of them act on one another.
            rows: The outputs at all points that are looked at.
        """
        rows = [row for row in rows if any(map(math.isfinite, row[: 1 + self.mutual]))]
        columns = [[row[2 + at] for row in rows] for at in range(len(turns))]
        guarded, work = any(turn.edge for turn in turns), 0
        for tries, (group, factors) in enumerate(_ways(groups, columns)):
            slots = tuple([turns[at].slot for at in group.turns])
            part = self._part(slots, guarded, _all_of(factors), group.apart)
            work += part.size * len(part.moving)
            if tries == MOST_JOINT or work > JOINT_WORK:
                self.open.append(group.turns[0])
                return
            found = part.below(
                min(((part.value(point), point) for point in self.points), key=lambda one: _number(one[0]))
            )
            if group.apart and not found.proved:
                self.open.append(group.turns[0])
            yield from found.points

    @cached_property
    def integers(self) -> tuple[int, ...]:
        """Give the numbers of the symbols that are whole numbers."""
        return tuple([at for at, domain in enumerate(self.box) if domain.integer])

    @cached_property
    def states(self) -> list[tuple[Row, Point]]:
        """Give the points that were looked at and are states, with their outputs."""
        rows = zip(self.rows, self.points, strict=True)
        return [(row, at) for row, at in rows if any(map(math.isfinite, row[: 1 + self.mutual]))]

    def _both_end(self, turns: Sequence[Turn], held: Mapping[int, list[Found]], at: int) -> bool:
        """Tell whether no state lies beyond an edge: the reference (if mutual: both sides) ends there."""
        like = [
            turn for other, turn in enumerate(turns) if turn.edge and other in held and _alike(held[at], held[other])
        ]
        right, typed = any(turn.right for turn in like), any(turn.typed for turn in like)
        return right and (typed or not self.mutual)

    def _held(self, number: int) -> list[Found]:
        """Give the values of a turn at the states that were looked at."""
        return [(row[2 + number], point) for row, point in self.states if math.isfinite(row[2 + number])]

    def _part(self, slots: tuple[int, ...], guarded: bool, way: Way, deep: bool) -> Part:
        doubles = self.doubles.only(*slots)
        intervals: list[Runner] = []
        run, output = doubles.slots, doubles.outputs[0]

        def value(point: Point) -> float:
            try:
                return float(run(point)[output])
            except NO_VALUE:
                return look(doubles, point)[0]

        def values(point: Point) -> float:
            return way([(one, one) for one in look(doubles, point)])[0]

        def bounds(box: Box) -> Interval:
            if not intervals:  # most zeros are found without
                intervals.append(Runner(self.program, INTERVALS).only(*slots))
            return way(intervals[0].run(box))

        state = self._state() if guarded else every
        size, work, moving = 1 + len(doubles.code), WORK if deep else LESS_WORK, doubles.moving
        return Part(
            value if way is itself else values, state, bounds, self.box, ends(self.box), moving, self.integers,
            size, work, deep, partial(self._trends, slots[0], moving) if way is itself else tuple,
        )  # fmt: skip

    def _trends(self, slot: int, moving: Sequence[int]) -> tuple[int, ...]:
        """Tell which way a slot goes along some symbols; nothing where it turns back along one of them."""
        found: list[int] = []
        for at in moving:
            if at not in self.known:
                self.known[at] = trends(self.program, self.slots, at)
            own = self.known[at][slot]
            if own is None:
                return ()
            found.append(own)
        return tuple(found)

    def _state(self) -> Callable[[Point], bool]:
        """Make a test that tells in doubles whether a point is a state."""
        guard = self.doubles.only(*self.program.outputs[: 1 + self.mutual], *self.lines)
        enough = any if self.mutual else all
        return lambda point: enough(map(math.isfinite, look(guard, point)))


def all_met(turns: Sequence[Turn], groups: Sequence[Joint], rows: Sequence[Row], mutual: bool) -> bool:
    """Tell whether the states that were looked at hold all that a search could find.

    Where each of what turns stands in a sum alone, two states that differ in its sign only tell what it does; where
    some act on one another, all ways in which signs go together do. Edges are always searched: they may be touched.
    """
    if any(turn.edge for turn in turns):
        return False
    states = [row for row in rows if math.isfinite(row[0]) or (mutual and math.isfinite(row[1]))]
    told = [row[2:] for row in states if all(0 < abs(value) < math.inf for value in row[2:])]
    columns = list(zip(*told, strict=True))
    apart = [column for at, column in enumerate(columns) if _first_tied(at, columns)[0] == at]
    met: set[tuple[bool, ...]] = set(zip(*([value > 0 for value in column] for column in apart), strict=True))
    if groups:
        return len(met) == 1 << len(apart)
    return len(met) > 1 and all(
        any((*way[:at], not way[at], *way[at + 1 :]) in met for way in met) for at in range(len(apart))
    )


def _ways(groups: Sequence[Joint], columns: Sequence[Sequence[float]]) -> Iterator[tuple[Joint, list[float]]]:
    """Give the unseen ways of the signs of each group as factors that make all of its turns negative.

    Turns that are proportional have one sign: a way that is another one but for these comes once.
    """
    done = set[tuple[bool, frozenset[tuple[int, bool]]]]()
    for group in groups:
        mine = [columns[at] for at in group.turns]
        sizes = [max(filter(math.isfinite, map(abs, column)), default=0.0) or 1.0 for column in mine]
        first = [_first_tied(at, columns) for at in group.turns]
        for signs in _unseen(mine):
            way = group.apart, frozenset((at, sign is same) for (at, same), sign in zip(first, signs, strict=True))
            if way not in done:
                done.add(way)
                yield group, [-1 / size if sign else 1 / size for size, sign in zip(sizes, signs, strict=True)]


def _first_tied(number: int, columns: Sequence[Sequence[float]]) -> tuple[int, bool]:
    """Give the first turn that is proportional to one, and whether the two have the same sign."""
    for other, column in enumerate(columns[:number]):
        for factor in (1, -1):
            if _tied(column, [factor * value for value in columns[number]]):
                return other, factor > 0
    return number, True


def _unseen(columns: Sequence[Sequence[float]]) -> list[tuple[bool, ...]]:
    """Give the ways in which signs go together at no point, but for turns that are proportional."""
    seen = {tuple([value > 0 for value in row]) for row in zip(*columns, strict=True)}
    tied = []
    for (one, first), (other, second) in combinations(enumerate(columns), 2):
        for factor in (1, -1):
            if _tied(first, [factor * value for value in second]):
                tied.append((one, other, factor > 0))
    ways = product((False, True), repeat=len(columns))
    return [
        way for way in ways
        if way not in seen and all((way[one] == way[other]) is same for one, other, same in tied)
    ]  # fmt: skip


def every(_: Point) -> bool:
    """Take any point for a state."""
    return True


def itself(values: Sequence[Interval]) -> Interval:
    """Give the only one of some values."""
    return values[0]


def _all_of(factors: Sequence[float]) -> Way:
    """Make the greatest of some values times their factors: it is negative where all of them are."""

    def greatest(values: Sequence[Interval]) -> Interval:
        ends = [sorted((low * k, high * k)) for k, (low, high) in zip(factors, values, strict=True)]
        return max(low for low, _ in ends), max(high for _, high in ends)

    return greatest


def _number(value: float) -> float:
    return math.inf if math.isnan(value) else value


def _open(turn: Turn, values: Interval) -> bool:
    """Tell whether an argument may change its sign in the box, or touch the zero of an edge."""
    return not side_of_zero(values) and (turn.edge or not values[0] >= 0)


def _alike(one: Sequence[Found], other: Sequence[Found]) -> bool:
    """Tell whether two arguments are proportional at all points, with a positive factor: they turn together."""
    if one is other:
        return True
    return _tied([value for value, _ in one], [value for value, _ in other])


def proportional(one: Sequence[float], other: Sequence[float]) -> bool:
    """Tell whether two columns are proportional, whatever the sign of the factor."""
    return _tied(one, other) or _tied(one, [-value for value in other])


def _tied(one: Sequence[float], other: Sequence[float]) -> bool:
    if len(one) != len(other) or len(one) < 4:
        return False
    ratios = [a / b if b else -1.0 for a, b in zip(one, other, strict=True)]
    return min(ratios) > 0 and max(ratios) <= min(ratios) * (1 + ALIKE)
