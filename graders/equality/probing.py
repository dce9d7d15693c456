"""Where balls should look: beside every place where a formula turns, found in doubles and intervals."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from graders.equality.sides import Box, Part
from graders.equality.turns import Turn
from graders.judge import Domain
from graders.language.doubles import DOUBLES
from graders.language.intervals import INTERVALS
from graders.language.program import Program, Runner
from graders.states import Point

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


@dataclass(frozen=True, slots=True)
class Search:
    """A search of a box for both sides of what turns in a program.

    Attributes:
        program: Its first two outputs are the reference and the answer.
        box: The domains of its inputs.
        points: Points of the box that were looked at.
        rows: Their outputs, and behind them the values of the turns.
        mutual: Whether a point where only the answer has a value is a state.
    """

    program: Program
    box: tuple[Domain, ...]
    points: Sequence[Point]
    rows: Sequence[Row]
    mutual: bool

    def beside(self, turns: Sequence[Turn]) -> Iterator[tuple[Point, bool]]:
        """Give points beside each turn; those around a touched zero, where no sign changes, are marked."""
        whole: Box = tuple([(domain.low, domain.high) for domain in self.box])
        slots = Runner(self.program, INTERVALS).slots(whole)
        ranges = [slots[turn.slot] for turn in turns]
        ends = [turn.edge and not low >= 0 for turn, (low, _) in zip(turns, ranges, strict=True)]
        guarded = any(end and (turn.shared or self.mutual) for turn, end in zip(turns, ends, strict=True))
        for number, (turn, (low, high)) in enumerate(zip(turns, ranges, strict=True)):
            margin = MARGIN * max(abs(low), abs(high))
            if not (low > margin or high < -margin or (low >= 0 and not turn.edge)):
                one_sided = low >= 0 or (turn.edge and turn.shared and not self.mutual)
                yield from self._part(turn, guarded).sides(self._held(number), one_sided)

    def _held(self, number: int) -> list[tuple[float, Point]]:
        """Give the values of a turn at the states that were looked at."""
        return [
            (row[2 + number], point)
            for row, point in zip(self.rows, self.points, strict=True)
            if math.isfinite(row[2 + number]) and any(map(math.isfinite, row[: 1 + self.mutual]))
        ]

    def _part(self, turn: Turn, guarded: bool) -> Part:
        alone = self.program.only(turn.slot)
        inputs = {slot for _, arguments in alone.operations for slot in arguments} | set(alone.outputs)
        guard = Runner(self.program.only(*self.program.outputs[: 1 + self.mutual]), DOUBLES) if guarded else None

        def state(point: Point) -> bool:
            return guard is None or any(map(math.isfinite, look(guard, point)))

        doubles, intervals = Runner(alone, DOUBLES), Runner(alone, INTERVALS)
        moving = tuple(at for at in range(len(self.box)) if at in inputs)
        return Part(lambda point: look(doubles, point)[0], state, lambda box: intervals.run(box)[0], self.box, moving)
