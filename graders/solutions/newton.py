"""Zeros of several residuals at once, by Newton's method in doubles and then in balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import arb

from graders.solutions.beside import Beside, beside
from graders.solutions.scene import Side
from graders.solutions.zeros import DELTA, Zero

STEPS = 14
OVERHEAD = 30  # operations that a step costs for each symbol, beside the residuals
POLISHING = 7
CLOSE = 1e-7  # of a range: near enough to go on in balls
DEPENDENT = 1e-9  # a pivot below this share of the largest one says that the equations depend on one another
LAST = arb(2) ** -180  # of a range: the last step
BESIDE = 2.0**-90  # of a range: where slopes in balls are taken
Values = Callable[[list[Any]], list[Any] | None]


def projected(side: Side, start: Sequence[float], used: Sequence[int]) -> Zero | None:
    """Find a zero of all residuals near a start by the shortest steps in all symbols, kept inside the box."""
    try:
        return _projected(side, start, used)
    except (ZeroDivisionError, OverflowError):  # slopes beyond doubles lead nowhere
        return None


def _projected(side: Side, start: Sequence[float], used: Sequence[int]) -> Zero | None:
    scene, point, moving = side.scene, list(start), [at for at in used if side.scene.width(at)]
    for _ in range(STEPS):
        side.pair.effort.spend(OVERHEAD * len(moving))
        here = side.doubles(point)
        rows = _slopes(side, point, moving, here) if here is not None else None
        step = shortest(rows, here) if rows is not None and here is not None else None
        if step is None or rows is None:
            return None
        share = max(map(abs, step))
        if share < CLOSE:
            free = _steepest(side, point, moving, rows)
            return _polished(side, point, free, [scene.width(at) for at in free]) if free else None
        damp = min(1.0, 0.5 / share)
        for at, s in zip(moving, step, strict=True):
            low, high = scene.ranges[at]
            point[at] = min(high, max(low, point[at] - damp * s * scene.width(at)))
    return None


def _slopes(side: Side, point: list[float], moving: Sequence[int], here: Sequence[float]) -> list[list[float]] | None:
    """Give the slopes of the residuals, (n, symbols), over shares of the ranges."""
    columns = []
    for at in moving:
        low, high = side.scene.ranges[at]
        kept, share = point[at], 1e-7 if point[at] < (low + high) / 2 else -1e-7
        point[at] = kept + share * (high - low)
        there = side.doubles(point)
        point[at] = kept
        if there is None:
            return None
        columns.append([(b - a) / share for a, b in zip(here, there, strict=True)])
    return [list(row) for row in zip(*columns, strict=True)]


def shortest(rows: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """Give the shortest solution of a linear system with more unknowns than equations."""
    if not rows or not rows[0]:
        return None
    sizes = [max(map(abs, row)) or 1.0 for row in rows]
    scaled = [[e / size for e in row] for row, size in zip(rows, sizes, strict=True)]
    products = [[sum(a * b for a, b in zip(one, two, strict=True)) for two in scaled] for one in scaled]
    factors = solution(products, [r / size for r, size in zip(right, sizes, strict=True)], 0.0)
    return [sum(f * row[j] for f, row in zip(factors, scaled, strict=True)) for j in range(len(rows[0]))]


def _steepest(side: Side, point: Sequence[float], moving: Sequence[int], rows: Any) -> list[int]:
    """Choose as many symbols as there are equations, those that move the residuals most and have room to move."""
    room = [1.0 if _has_room(side, point, at) else 1e-3 for at in moving]
    left, chosen = [[e * r for e, r in zip(row, room, strict=True)] for row in rows], list[int]()
    for row in left:
        size = max(map(abs, row)) or 1.0
        row[:] = [e / size for e in row]
    for _ in rows:
        size, i, j = max((abs(e), i, j) for i, row in enumerate(left) for j, e in enumerate(row))
        if size < DEPENDENT:
            break
        chosen.append(moving[j])
        pivot = left.pop(i)
        left = [[a - row[j] / pivot[j] * b for a, b in zip(row, pivot, strict=True)] for row in left]
        if not left:
            break
    return chosen


def _has_room(side: Side, point: Sequence[float], at: int) -> bool:
    low, high = side.scene.ranges[at]
    return low + 1e-6 * (high - low) < point[at] < high - 1e-6 * (high - low)


def _polished(side: Side, start: Sequence[float], free: Sequence[int], widths: Sequence[float]) -> Zero | None:
    point = [arb(x) for x in start]
    for _ in range(POLISHING):
        step = _step(side.balls, point, free, [arb(width) * BESIDE for width in widths], arb(0))
        if step is None:
            return None
        for at, s in zip(free, step, strict=True):
            point[at] = arb((point[at] - s).mid())
        if all(abs(s) < LAST * width for s, width in zip(step, widths, strict=True)):
            if not all(side.scene.inside(at, point[at]) for at in free):
                return None
            for at, width in zip(free, widths, strict=True):
                point[at] = arb(point[at], DELTA * width)
            zero = Zero(tuple(point), tuple(free))
            return zero if beside(side, zero) is Beside.ZERO else None
    return None


def _step(values: Values, point: list[Any], free: Sequence[int], shifts: Sequence[Any], nothing: Any) -> Any:
    """Give Newton's step in the free symbols; None where a value is missing."""
    here = values(point)
    if here is None:
        return None
    columns = []
    for at, shift in zip(free, shifts, strict=True):
        kept = point[at]
        point[at] = kept + shift
        there = values(point)
        point[at] = kept
        if there is None:
            return None
        columns.append([(b - a) / shift for a, b in zip(here, there, strict=True)])
    return solution([list(row) for row in zip(*columns, strict=True)], list(here), nothing)


def solution(rows: list[list[Any]], right: list[Any], nothing: Any) -> list[Any]:
    """Solve a linear system by elimination with full pivoting.

    Unknowns that equations which depend on one another leave free stay zero.
    """
    scales = [max(map(_size, row)) or 1.0 for row in rows]
    rows = [[e / scale for e in row] for row, scale in zip(rows, scales, strict=True)]
    right = [e / scale for e, scale in zip(right, scales, strict=True)]
    count, largest = len(rows[0]), 0.0
    left, pivots = set(range(len(rows))), list[tuple[int, int]]()
    while left:
        used = {column for _, column in pivots}
        size, row, column = max(
            ((_size(rows[i][j]), i, j) for i in left for j in range(count) if j not in used), default=(0.0, -1, -1)
        )
        largest = max(largest, size)
        if size <= DEPENDENT * largest or size == 0:
            break
        left.discard(row)
        pivots.append((row, column))
        for i in left:
            factor = rows[i][column] / rows[row][column]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[row], strict=True)]
            right[i] = right[i] - factor * right[row]
    return _substituted(rows, right, pivots, [nothing] * count)


def _substituted(rows: list[list[Any]], right: list[Any], pivots: list[tuple[int, int]], found: list[Any]) -> list[Any]:
    for row, column in reversed(pivots):
        rest = right[row]
        for j, value in enumerate(found):
            if j != column:
                rest = rest - rows[row][j] * value
        found[column] = rest / rows[row][column]
    return found


def _size(value: Any) -> float:
    return abs(value) if isinstance(value, float) else float(abs(value).mid())
