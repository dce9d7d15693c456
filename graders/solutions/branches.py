"""Starts on both sides of every bracket, absolute value, quadrant and edge of the two sides of a comparison."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce

from graders.equality.probing import Search, look, looks, open_turns
from graders.equality.turns import needed, places, together, turns
from graders.judge import Domain
from graders.language.doubles import DOUBLES
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Tree
from graders.solutions.scene import Effort, Scene

MOST_TURNS = 12  # that are looked at
COST = 60  # runs that the search for one turn takes, about
NEAREST = 2  # points from which a corner is climbed to
SWEEPS = 2
END = 1e-3  # of a range: near its end
CORNERS = (0.01, 0.5, 0.99)


@dataclass(frozen=True, slots=True)
class Branches:
    """Points in the branches that were found; whether there is proved to be no other."""

    points: list[list[float]]
    proved: bool


NONE = Branches([], True)


def branch_starts(scene: Scene, sides: tuple[Sequence[Tree], Sequence[Tree]], effort: Effort, most: int) -> Branches:
    """Give points in every branch, deep in it and beside its border, also where it is a corner of the box.

    Args:
        scene: The box.
        sides: The trees of the two sides.
        effort: What is spent.
        most: How many points at most.
    """
    builder = Builder(scene.names)
    lines = [builder.define(name, line) for name, line in scene.lines]
    outputs = [_joined(builder, trees) for trees in sides]
    where = places(builder)
    found = turns(where, [needed(builder, slots) for slots in ((outputs[0], *lines), outputs[1:])])
    if not found:  # nothing in them turns
        return NONE
    box = tuple(Domain(low, high) for low, high in scene.ranges)
    program = builder.program(*outputs, *(turn.slot for turn in found))
    effort.spend(2 * len(program.operations))
    found, slots, _ = open_turns(program, box, found)
    if not found:
        return NONE
    every, found = len(found), found[:MOST_TURNS]
    program = builder.program(*outputs, *(turn.slot for turn in found))
    effort.spend(COST * len(found) * (len(program.operations) // 2 + 2))
    turning = Turning(scene, program, Runner(program, DOUBLES))
    rows = looks(turning.runner, scene.points)
    search = Search(program, turning.runner, box, scene.points, rows, True, tuple(lines), slots)
    beside = list(search.beside(found))
    groups = together(builder, where, found, outputs)
    if groups:
        looked = looks(turning.runner, [point for point, _ in beside])
        beside += [(point, False) for point in search.joint(found, groups, [*rows, *looked])]
    deep = [*scene.points, *turning.climbed(rows), *_ends(scene)]
    chosen = [*turning.one_each(deep), *(point for point, touched in beside if touched)]
    chosen += turning.one_each([point for point, touched in beside if not touched])
    points = [list(point) for point in dict.fromkeys(map(tuple, chosen))]
    return Branches(points[:most], every <= MOST_TURNS and not search.open)


def _joined(builder: Builder, trees: Sequence[Tree]) -> int:
    """Give a slot that has a value where all trees have one."""
    return reduce(lambda one, other: builder.apply("+", one, other), map(builder.add, trees))


def _ends(scene: Scene) -> Iterator[list[float]]:
    """Move each symbol in turn near both ends of its range."""
    for at, (low, high) in enumerate(scene.ranges):
        for k, share in enumerate((END, 1 - END)):
            point = scene.points[(2 * at + k) % len(scene.points)]
            yield [*point[:at], low + share * (high - low), *point[at + 1 :]]


@dataclass(frozen=True, slots=True)
class Turning:
    """What turns in the two sides: behind the two outputs of the program."""

    scene: Scene
    program: Program
    runner: Runner

    def one_each(self, points: Sequence[Sequence[float]]) -> list[Sequence[float]]:
        """Choose one point for each pattern of signs."""
        rows = looks(self.runner, [tuple(point) for point in points])
        found: dict[tuple[bool, ...], Sequence[float]] = {}
        for point, row in zip(points, rows, strict=True):
            found.setdefault(tuple(value > 0 for value in row), point)
        return list(found.values())

    def climbed(self, rows: Sequence[Sequence[float]]) -> Iterator[list[float]]:
        """Look in the corners of the box for the sign that an argument has at no point."""
        for at in range(2, len(self.program.outputs)):
            signed = [(row[at], point) for row, point in zip(rows, self.scene.points, strict=True) if row[at]]
            signs = {value > 0 for value, _ in signed if math.isfinite(value)}
            if len(signs) == 1:
                nearest = sorted(signed, key=lambda pair: abs(pair[0]))[:NEAREST]
                part = Runner(self.program.only(self.program.outputs[at]), DOUBLES)
                ends = (self._climbed(part, point, 1.0 if True in signs else -1.0) for _, point in nearest)
                yield from (end for end in ends if end is not None)

    def _climbed(self, part: Runner, start: Sequence[float], sign: float) -> list[float] | None:
        """Move one symbol after another to the end that lowers the argument times its sign."""
        point, least = list(start), math.inf
        for _ in range(SWEEPS):
            for at, (low, high) in enumerate(self.scene.ranges):
                for share in CORNERS:
                    tried = [*point[:at], low + share * (high - low), *point[at + 1 :]]
                    value = sign * look(part, tuple(tried))[0]
                    if value < least:
                        point, least = tried, value
        return point if least < 0 else None
