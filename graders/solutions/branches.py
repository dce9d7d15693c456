"""Starts on both sides of every bracket, absolute value and quadrant, also where one side is a corner of the box."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.program import Builder, Runner
from graders.language.tree import Binary, Call, Tree, names, walk
from graders.solutions.scene import Effort, Scene

BRANCHING = frozenset(
    ("abs", "sign", "min", "max", "macaulay", "atan2", "sqrt", "root", "asin", "acos", "acot", "ln", "log", "log_base")
)
MOST = 8  # arguments that are looked at
CLIMBED = 2  # points from which a corner is climbed to
SWEEPS = 2


def branch_starts(scene: Scene, trees: Sequence[Tree], effort: Effort) -> list[list[float]]:
    """Give a point on the rarer side of each argument whose sign chooses a branch."""
    found: list[list[float]] = []
    arguments = dict.fromkeys(argument for tree in trees for argument in _arguments(tree))
    for argument in list(arguments)[:MOST]:
        rarer = Argument(scene, argument, effort).rarer()
        if rarer is not None:
            found.append(rarer)
    return found


def _arguments(tree: Tree) -> Iterator[Tree]:
    for node in walk(tree):
        match node:
            case Call(function="abs" | "sign" | "macaulay", arguments=(inside, *_)):
                yield inside
            case Call(function="atan2", arguments=both):
                yield from both
            case Call(function="min" | "max", arguments=all_of):
                yield from (Binary("-", a, b) for a, b in pairwise(all_of))


class Argument:
    """An argument whose sign chooses a branch, over a scene."""

    def __init__(self, scene: Scene, tree: Tree, effort: Effort) -> None:
        builder = Builder(scene.names)
        for name, line in scene.lines:
            builder.define(name, line)
        self.runner = Runner(builder.program(builder.add(tree)), DOUBLES)
        self.scene, self.effort = scene, effort
        self.used = [at for at, name in enumerate(scene.names) if scene.lines or name in names(tree)]

    def value(self, point: Sequence[float]) -> float:
        """Give the argument at a point; NaN where it has no value."""
        self.effort.spend(len(self.runner.code) // 2 + 2)
        try:
            return float(run(self.runner, list(point))[0])
        except UndefinedError:
            return math.nan

    def rarer(self) -> list[float] | None:
        """Give a point of the sign that fewer points have, or one that is climbed to; None where there is no other."""
        signed = [(value, point) for point in self.scene.points for value in (self.value(point),) if value]
        below = [point for value, point in signed if value < 0]
        above = [point for value, point in signed if value > 0]
        if below and above:
            return list(min(below, above, key=len)[0])
        sign = 1.0 if above else -1.0
        nearest = sorted(signed, key=lambda pair: abs(pair[0]))[:CLIMBED]
        return next((end for _, point in nearest for end in (self._climbed(point, sign),) if end is not None), None)

    def _climbed(self, start: Sequence[float], sign: float) -> list[float] | None:
        """Move one symbol after another to the end that lowers the argument times its sign."""
        point, least = list(start), math.inf
        for _ in range(SWEEPS):
            for at in self.used:
                low, high = self.scene.ranges[at]
                for share in (0.01, 0.5, 0.99):
                    tried = [*point[:at], low + share * (high - low), *point[at + 1 :]]
                    value = sign * self.value(tried)
                    if value < least:
                        point, least = tried, value
        return point if least < 0 else None
