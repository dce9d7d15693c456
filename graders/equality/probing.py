"""Where balls should look: beside every place where a formula turns, found in doubles and intervals."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from graders.equality.sides import Found, Part, whole
from graders.equality.turns import Turn
from graders.judge import Domain
from graders.language.doubles import DOUBLES
from graders.language.intervals import INTERVALS, Interval
from graders.language.program import Program, Runner
from graders.states import Point

ALIKE = 1e-9  # relative difference of the ratios of two arguments that turn together
MARGIN = 1e-12  # of an interval's ends, which are not rounded outwards

Row: TypeAlias = list[float]


def look(runner: Runner, point: Point) -> Row:
    """Run in doubles; what has no value there is not a number."""
    try:
        return runner.run(point)
    except (ValueError, ArithmeticError, TypeError):
        return _patiently(runner, point)


def _patiently(runner: Runner, point: Point) -> Row:
    slots: list[Any] = [*point, *runner.tail]
    for function, slot, count, first, second in runner.code:
        arguments = (first, second)[:count] if count else first
        try:
            slots[slot] = function(*[slots[argument] for argument in arguments])
        except (ValueError, ArithmeticError, TypeError):
            slots[slot] = math.nan
    return [slots[slot] for slot in runner.outputs]


def looks(runner: Runner, points: Sequence[Point]) -> list[Row]:
    """Run in doubles at many points."""
    try:
        return [list(row) for row in runner.columns(points)]
    except (ValueError, ArithmeticError, TypeError):
        return [look(runner, point) for point in points]


def open_turns(program: Program, box: Sequence[Domain], turns: Sequence[Turn]) -> tuple[list[Turn], list[Interval]]:
    """Give the turns that may change their sign in a box, or touch the zero of an edge, and their ranges."""
    slots = Runner(program, INTERVALS).slots(whole(box))
    found = [turn for turn in turns if _open(turn, slots[turn.slot])]
    return found, [slots[turn.slot] for turn in found]


@dataclass(frozen=True, slots=True)
class Search:
    """A search of a box for both sides of what turns in a program.

    Attributes:
        program: Its first two outputs are the reference and the answer.
        box: The domains of its inputs.
        points: Points of the box that were looked at.
        rows: Their outputs, and behind them the values of the turns.
        mutual: Whether a point where only the answer has a value is a state.
        lines: Slots of the earlier names, which have a value at every state.
    """

    program: Program
    box: tuple[Domain, ...]
    points: Sequence[Point]
    rows: Sequence[Row]
    mutual: bool
    lines: tuple[int, ...] = ()

    def beside(self, turns: Sequence[Turn], ranges: Sequence[Interval]) -> Iterator[tuple[Point, bool]]:
        """Give points beside each turn; those around a touched zero, where no sign changes, are marked."""
        ends = [at for at, turn in enumerate(turns) if turn.edge and not ranges[at][0] >= 0]
        guarded = any(turns[at].right or self.mutual for at in ends)
        held = {at: self._held(at) for at in range(len(turns))}
        done: list[int] = []
        for at in range(len(turns)):
            alike = [other for other in done if turns[other].edge is turns[at].edge and _alike(held[at], held[other])]
            if not alike:
                one_sided = ranges[at][0] >= 0 or (at in ends and self._both_end(turns, held, at))
                yield from self._part(turns[at], guarded).sides(held[at], one_sided)
            done.append(at)

    def _both_end(self, turns: Sequence[Turn], held: Mapping[int, list[Found]], at: int) -> bool:
        """Tell whether no state lies beyond an edge: the reference (if mutual: both sides) ends there."""
        like = [
            turn for other, turn in enumerate(turns) if turn.edge and other in held and _alike(held[at], held[other])
        ]
        right, typed = any(turn.right for turn in like), any(turn.typed for turn in like)
        return right and (typed or not self.mutual)

    def _held(self, number: int) -> list[Found]:
        """Give the values of a turn at the states that were looked at."""
        return [
            (row[2 + number], point)
            for row, point in zip(self.rows, self.points, strict=True)
            if math.isfinite(row[2 + number]) and any(map(math.isfinite, row[: 1 + self.mutual]))
        ]

    def _part(self, turn: Turn, guarded: bool) -> Part:
        alone = self.program.only(turn.slot)
        inputs = {slot for _, arguments in alone.operations for slot in arguments} | set(alone.outputs)
        guard = Runner(self.program.only(*self.program.outputs[: 1 + self.mutual], *self.lines), DOUBLES)
        enough = any if self.mutual else all

        def state(point: Point) -> bool:
            return not guarded or enough(map(math.isfinite, look(guard, point)))

        doubles, intervals = Runner(alone, DOUBLES), Runner(alone, INTERVALS)
        moving = tuple(at for at in range(len(self.box)) if at in inputs)
        return Part(
            lambda point: look(doubles, point)[0],
            state,
            lambda box: intervals.run(box)[0],
            self.box,
            moving,
            1 + len(alone.operations),
        )


def _open(turn: Turn, values: Interval) -> bool:
    """Tell whether an argument may change its sign in the box, or touch the zero of an edge."""
    low, high = values
    margin = MARGIN * max(abs(low), abs(high))
    return not (low > margin or high < -margin or (low >= 0 and not turn.edge))


def _alike(one: Sequence[Found], other: Sequence[Found]) -> bool:
    """Tell whether two arguments are proportional at all points, with a positive factor: they turn together."""
    if one is other:
        return True
    if len(one) != len(other) or len(one) < 4:
        return False
    ratios = [a / b if b else -1.0 for (a, _), (b, _) in zip(one, other, strict=True)]
    return min(ratios) > 0 and max(ratios) <= min(ratios) * (1 + ALIKE)
