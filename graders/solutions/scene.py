"""Where solutions are looked for: a box over the symbols, points in it, and the residuals of an answer run there."""

from __future__ import annotations

import hashlib
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import accumulate
from typing import Any

from flint import arb, ctx

from graders.equality.probing import looks
from graders.language.balls import BALLS
from graders.language.doubles import DOUBLES, UndefinedError
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Tree, names

BITS = 256
POINTS = 24
WORK = 60_000  # operations of one comparison; beyond it is undecided
TOGETHER = 4  # runs of all residuals at once, behind which those that are asked for run alone
EDGE = 2.0**-10  # points keep this share of a range away from its ends


class TooMuchWork(ArithmeticError):
    """The comparison would take longer than a student waits."""


@dataclass(frozen=True, slots=True)
class Scene:
    """A box over the symbols with points in it.

    Attributes:
        names: The symbols, the unknowns among them.
        ranges: Least and greatest value of each.
        points: Points inside the box.
        lines: Formulas of names that follow from the symbols, in the order of solving.
    """

    names: tuple[str, ...]
    ranges: tuple[tuple[float, float], ...]
    points: tuple[tuple[float, ...], ...]
    lines: tuple[tuple[str, Tree], ...] = ()

    def width(self, at: int) -> float:
        """Give the width of a range."""
        low, high = self.ranges[at]
        return high - low

    def inside(self, at: int, value: arb) -> bool:
        """Tell whether a value may lie in a range; one that touches an end does."""
        low, high = self.ranges[at]
        return not (value < low or value > high)


@lru_cache(maxsize=512)
def scene_of(names: tuple[str, ...], ranges: tuple[tuple[float, float], ...], seed: bytes = b"") -> Scene:
    """Fill a box evenly with points that depend on the seed."""
    points = tuple(
        tuple(low + (high - low) * share for (low, high), share in zip(ranges, shares, strict=True))
        for shares in unit_points(len(ranges), seed)
    )
    return Scene(names, ranges, points)


@lru_cache(maxsize=256)
def unit_points(count: int, seed: bytes) -> tuple[tuple[float, ...], ...]:
    """Give points of the unit cube, inside it, none of them in a special position.

    Source:
        Kronecker sequence of the powers of the generalized golden ratio: M. Roberts, The unreasonable effectiveness of
        quasirandom sequences, 2018.
    """
    ratio = 2.0
    for _ in range(64):
        ratio = (1 + ratio) ** (1 / (count + 1))
    starts = [_start(seed, at) for at in range(count)]
    return tuple(
        tuple(
            EDGE + (1 - 2 * EDGE) * math.fmod(start + (k + 1) * ratio ** -(at + 1), 1.0)
            for at, start in enumerate(starts)
        )
        for k in range(POINTS)
    )


def extreme(scene: Scene) -> tuple[tuple[float, ...], ...]:
    """Give the points of a scene in turn as they are and pushed towards the corners of the box."""
    return _extreme(scene.points, scene.ranges)


@lru_cache(maxsize=512)
def _extreme(
    points: tuple[tuple[float, ...], ...], ranges: tuple[tuple[float, float], ...]
) -> tuple[tuple[float, ...], ...]:
    pushed = (tuple([_pushed(x, *ends) for x, ends in zip(point, ranges, strict=True)]) for point in points)
    return tuple([point for pair in zip(points, pushed, strict=True) for point in pair])


def used_symbols(scene: Scene, trees: Sequence[Tree]) -> list[int]:
    """Give the places of the symbols that stand in trees; all of them where lines define names."""
    used = frozenset[str]().union(*map(names, trees))
    return [at for at, name in enumerate(scene.names) if scene.lines or name in used]


def _pushed(value: float, low: float, high: float) -> float:
    share = (value - low) / (high - low) if high > low else 0.0
    share = 4 * share**3 if share < 0.5 else 1 - 4 * (1 - share) ** 3
    return low + (high - low) * share


def _start(seed: bytes, at: int) -> float:
    digest = hashlib.sha256(seed + at.to_bytes(4, "big")).digest()
    return int.from_bytes(digest[:6], "big") / 2**48


@dataclass(slots=True)
class Effort:
    """Counts the operations of one comparison."""

    left: int = WORK

    def spend(self, operations: int) -> None:
        """Take operations; raises TooMuchWork when none are left."""
        self.left -= operations
        if self.left < 0:
            raise TooMuchWork


class Residuals:
    """The residuals of the reference and of the answer over the names of a scene, ready to run."""

    def __init__(self, scene: Scene, sides: Sequence[Sequence[Tree]], effort: Effort) -> None:
        self.scene, self.effort = scene, effort
        self.sides = tuple(tuple(trees) for trees in sides)
        self.program = self._program([tree for trees in self.sides for tree in trees])
        self.cost = len(self.program.operations) + 4
        self.starts = list(accumulate(map(len, self.sides), initial=0))
        self._balls: dict[tuple[int, tuple[int, ...]], Runner] = {}
        self._doubles: dict[int, Runner] = {}
        self._asked = Counter[tuple[int, ...]]()

    def _program(self, trees: Sequence[Tree]) -> Program:
        builder = Builder(self.scene.names)
        for name, line in self.scene.lines:
            builder.define(name, line)
        return builder.program(*[builder.add(tree) for tree in trees])

    def _runner(self, outputs: tuple[int, ...] = ()) -> Runner:
        """Make ready the program, or what some outputs need, for the precision of now."""
        runner = self._balls.get((ctx.prec, outputs))
        if runner is None:
            program = self.program.only(*(self.program.outputs[at] for at in outputs)) if outputs else self.program
            runner = self._balls[ctx.prec, outputs] = Runner(program, BALLS)
        return runner

    def balls(self, point: Sequence[arb]) -> list[arb | None]:
        """Enclose all residuals at a point; None stands for one that is not proved to exist."""
        self.effort.spend(self.cost)
        try:
            values = self._runner().run(point)
        except (ArithmeticError, ValueError, TypeError):
            return [self.ball(point, output) for output in range(len(self.program.outputs))]
        return [value if value.is_finite() else None for value in values]

    def some(self, point: Sequence[arb], outputs: tuple[int, ...]) -> list[arb] | None:
        """Enclose some residuals; None where one of them is not proved to exist."""
        self.effort.spend(self.cost)
        runner = self._balls.get((ctx.prec, outputs))
        if runner is None:
            self._asked[outputs] += 1
            values = self._together(point, outputs) if self._asked[outputs] <= TOGETHER else None
            if values is not None:
                return values if all(value.is_finite() for value in values) else None
            runner = self._runner(outputs)
        try:
            values = runner.run(point)
        except (ArithmeticError, ValueError, TypeError):
            return None
        return values if all([value.is_finite() for value in values]) else None

    def _together(self, point: Sequence[arb], outputs: tuple[int, ...]) -> list[arb] | None:
        """Enclose some residuals by a run of all; a program of their own pays only where they are asked for often."""
        try:
            slots = self._runner().slots(point)
        except (ArithmeticError, ValueError, TypeError):
            return None
        return [slots[self.program.outputs[at]] for at in outputs]

    def ball(self, point: Sequence[arb], output: int) -> arb | None:
        """Enclose one residual alone."""
        found = self.some(point, (output,))
        return found[0] if found is not None else None

    def nowhere(self, point: Sequence[arb], output: int) -> bool:
        """Tell whether one residual is proved to have no value at a point."""
        self.effort.spend(self.cost)
        try:
            self._runner((output,)).run(point)
        except UndefinedError:
            return True
        except (ArithmeticError, ValueError, TypeError):
            return False
        return False

    def _doubles_of(self, which: int) -> Runner:
        runner = self._doubles.get(which)
        if runner is None:
            runner = self._doubles[which] = Runner(self._program(self.sides[which]), DOUBLES)
        return runner

    def along(self, place: tuple[int, int], base: Sequence[float], at: int, values: Sequence[float]) -> list[float]:
        """Give one residual in doubles along a symbol, by its side and its place there; NaN where it has no value."""
        before, after = tuple(base[:at]), tuple(base[at + 1 :])
        return self.many(place, [(*before, value, *after) for value in values])

    def many(self, place: tuple[int, int], points: Sequence[tuple[float, ...]]) -> list[float]:
        """Give one residual in doubles at points, by its side and its place there; NaN where it has no value."""
        runner = self._doubles_of(place[0])
        self.effort.spend(len(points) * (len(runner.code) // 2 + 2))
        return [float(row[place[1]]) for row in looks(runner, points)]

    def doubles(self, which: int, point: Sequence[float]) -> list[float] | None:
        """Give the residuals of one side in doubles; None where they have no finite value."""
        runner = self._doubles.get(which) or self._doubles_of(which)
        self.effort.spend(len(runner.code) // 2 + 2)
        try:
            values = runner.run(point)
            return values if all(map(math.isfinite, values)) else None
        except (ValueError, ArithmeticError, TypeError):
            return None


@dataclass(frozen=True, slots=True)
class Side:
    """The residuals of one side, 0 the reference and 1 the answer, or only some of them."""

    pair: Residuals
    which: int
    only: tuple[int, ...] = ()
    places: tuple[int, ...] = field(init=False)  # of its residuals among all outputs

    def __post_init__(self) -> None:
        start, count = self.pair.starts[self.which], len(self.pair.sides[self.which])
        object.__setattr__(self, "places", tuple([start + at for at in self.only or range(count)]))

    @property
    def scene(self) -> Scene:
        """Give the scene."""
        return self.pair.scene

    def balls(self, point: Sequence[arb]) -> list[arb] | None:
        """Enclose the residuals; None where one of them is not proved to exist."""
        return self.pair.some(point, self.places)

    def ball(self, point: Sequence[arb], index: int) -> arb | None:
        """Enclose one residual; None where it is not proved to exist."""
        return self.pair.ball(point, self.places[index])

    def nowhere(self, point: Sequence[arb]) -> bool:
        """Tell whether one of the residuals is proved to have no value at a point."""
        return any(self.pair.nowhere(point, place) for place in self.places)

    def doubles(self, point: Sequence[float]) -> list[float] | None:
        """Give the residuals in doubles; None where they have no finite value."""
        values = self.pair.doubles(self.which, point)
        return values if values is None or not self.only else [values[index] for index in self.only]


def moved(point: Sequence[Any], at: int, value: Any) -> list[Any]:
    """Give a point with one coordinate replaced."""
    found = list(point)
    found[at] = value
    return found


def exactly(points: Sequence[Sequence[float]]) -> Iterator[list[arb]]:
    """Give points of doubles as exact balls."""
    return (list(exact(tuple(point))) for point in points)


@lru_cache(maxsize=4096)
def exact(point: tuple[float, ...]) -> tuple[arb, ...]:
    """Give the numbers of a point as balls of no width; points are used again and again."""
    return tuple(map(arb, point))
