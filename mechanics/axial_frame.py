"""A stepped bar as a chain of springs (stiffness method); the second way beside `bar` (domain SM-3)."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from mechanics.bar import Bar, BarSegment
from mechanics.stiffness import settle


@dataclass(frozen=True, slots=True)
class FrameBar:
    """A bar solved by the stiffness method; one entry for each spring between segment ends and forces."""

    xs: tuple[float, ...]  # nodes, m
    u: tuple[float, ...]  # of the nodes, m
    ends: tuple[tuple[float, float], ...]  # N at both ends of each spring, N
    reactions: tuple[float, float]  # N
    closed: bool


def solve_bar(bar: Bar) -> FrameBar:
    """Solve a bar as springs with thermal and distributed loads on their nodes.

    Source:
        Bar element k = E A/l: Przemieniecki, Theory of Matrix Structural Analysis, McGraw-Hill 1968, chapter 5.
    """
    xs = sorted({*bar.ends, *(force.x for force in bar.forces)})
    last = len(xs) - 1
    held = {"fixed_free": {0: 0.0}, "free_fixed": {last: 0.0}, "fixed_fixed": {0: 0.0, last: 0.0}}
    if bar.support != "fixed_gap":
        return _settled(bar, xs, held[bar.support], False)
    free = _settled(bar, xs, {0: 0.0}, False)
    gap = bar.gap_right or 0.0
    return free if free.u[-1] <= gap else _settled(bar, xs, {0: 0.0, last: gap}, True)


def _settled(bar: Bar, xs: list[float], held: dict[int, float], closed: bool) -> FrameBar:
    springs = [_spring(bar, left, right) for left, right in pairwise(xs)]
    loads = [sum(force.F for force in bar.forces if force.x == x) for x in xs]
    for i, (_, push, spread) in enumerate(springs):
        loads[i] += spread / 2 - push
        loads[i + 1] += spread / 2 + push
    chain = [((i, i + 1), ((k, -k), (-k, k))) for i, (k, _, _) in enumerate(springs)]
    u, surplus = settle(len(xs), chain, loads, held)
    ends = []
    for (k, push, spread), (left, right) in zip(springs, pairwise(u), strict=True):
        middle = k * (right - left) - push
        ends.append((middle + spread / 2, middle - spread / 2))
    reactions = tuple(surplus[end] if end in held else 0.0 for end in (0, len(xs) - 1))
    return FrameBar(tuple(xs), tuple(u), tuple(ends), (reactions[0], reactions[1]), closed)


def _spring(bar: Bar, left: float, right: float) -> tuple[float, float, float]:
    """Give stiffness (N/m), thermal push (N) and total distributed force (N) of the stretch."""
    middle = (left + right) / 2
    one: BarSegment = next(s for s, (a, b) in zip(bar.segments, pairwise(bar.ends), strict=True) if a <= middle <= b)
    stiffness = one.E * one.A
    return stiffness / (right - left), stiffness * one.alpha * one.dT, one.q * (right - left)
