"""Edges that are never reached: of an arc whose argument stays within one, as that of a law of cosines does.

Its distance from one, `1 - u^2`, is then often a multiple of a product or a quotient of two parts that have one sign on
the box. Doubles look for such parts by how they grow from one point to another, balls show it to thirty digits.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from typing import Any

from graders.equality.deciding import PRECISIONS, Finding, exactly, zero
from graders.equality.turns import Places, Turn, arcs, uncut
from graders.language.balls import BALLS, precision
from graders.language.doubles import DOUBLES
from graders.language.intervals import Interval
from graders.language.program import Builder, Program, Runner
from graders.states import Point

POINTS = 3  # at which a product is compared
FIGURES = 7  # of a growth by which parts are found


def narrowed(
    builder: Builder, where: Places, found: Sequence[Turn], slots: Sequence[Interval], signed: Collection[int],
    points: Sequence[Point],
) -> tuple[Places, list[Turn]]:  # fmt: skip
    """Leave out directions that are never cut, and arcs of one side whose ends are never reached.

    Args:
        builder: Holds the functions.
        where: Those that turn, and where they do.
        found: What may turn in the box.
        slots: The ranges of all slots there.
        signed: Slots that have one sign.
        points: Points of the box.
    """
    if not found:
        return where, []
    where = uncut(builder, where, slots, signed)
    kept = {slot for several in where.values() for slot, _ in several}.intersection(turn.slot for turn in found)
    ends = arcs(builder, where).intersection(turn.slot for turn in found if turn.right is not turn.typed) & kept
    if ends:
        turning = [at for at, several in where.items() if any(slot in kept for slot, _ in several)]
        kept -= unreached(builder.program(*ends), ends, signed, turning, points)
    return where, [turn for turn in found if turn.slot in kept]


def unreached(
    program: Program, edges: Collection[int], signed: Collection[int], turning: Collection[int], points: Sequence[Point]
) -> set[int]:
    """Give the edges that have one sign inside the box because of parts that have.

    Args:
        program: Its operations.
        edges: Slots `1 - u^2`.
        signed: Slots that have one sign inside the box.
        turning: Slots of the functions that may turn there: what stands on one is another function elsewhere.
        points: Points of the box.
    """
    loose = _standing_on(program, turning)
    parts, firm = [slot for slot in signed if slot not in loose], [edge for edge in edges if edge not in loose]
    if not parts or not firm or len(set(points[:POINTS])) < POINTS:
        return set()
    try:
        growth = _growth(program, points)
        likely = {edge: list(_likely(_cleared(program, edge), parts, growth)) for edge in firm}
        return {edge for edge, found in likely.items() if found and _is_product(program, found[0], points)}
    except (ValueError, ArithmeticError):
        return set()


def _standing_on(program: Program, slots: Collection[int]) -> set[int]:
    """Give the slots that stand on some slots, with these."""
    found = set(slots)
    for slot, (_, arguments) in enumerate(program.operations, len(program.inputs)):
        if not found.isdisjoint(arguments):
            found.add(slot)
    return found


def _growth(program: Program, points: Sequence[Point]) -> list[float]:
    """Give the logarithm of the growth of every slot from the first point to the second; NaN where there is none."""
    one, other = (Runner(program, DOUBLES).slots(point) for point in points[:2])
    return [math.log(b / a) if a and b / a > 0 else math.nan for a, b in zip(one, other, strict=True)]


def _cleared(program: Program, edge: int) -> list[tuple[int, ...]]:
    """Give the factors of `1 - u^2`, and those of the same without the fraction: `1 - (p/q)^2` times `q*q`."""
    first = len(program.inputs)
    square = program.operations[edge - first][1][1]
    inside = program.operations[square - first][1][0]
    name, arguments = program.operations[inside - first] if inside >= first else ("", ())
    return [(edge,), (edge, arguments[1], arguments[1])] if name == "/" else [(edge,)]


def _likely(
    forms: Sequence[tuple[int, ...]], parts: Sequence[int], growth: Sequence[float]
) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Give factors above and below whose product stays the same from one point to another."""
    known = {round(growth[part], FIGURES): part for part in parts if math.isfinite(growth[part])}
    for factors in forms:
        grown = sum(growth[factor] for factor in factors)
        if not math.isfinite(grown):
            continue
        if round(grown, FIGURES) in known:
            yield factors, (known[round(grown, FIGURES)],)
        for own, part in list(known.items()):
            if round(grown - growth[part], FIGURES) in known:
                yield factors, (part, known[round(grown - growth[part], FIGURES)])
            if round(grown + own, FIGURES) in known:
                yield (*factors, part), (known[round(grown + own, FIGURES)],)


def _is_product(program: Program, sides: tuple[tuple[int, ...], tuple[int, ...]], points: Sequence[Point]) -> bool:
    """Tell whether one product is a multiple of another at some points, to thirty digits."""
    with precision(PRECISIONS[0]):
        runner = Runner(program, BALLS)
        rows = [runner.slots(exactly(point)) for point in points[:POINTS]]
        one, other = ([_product(row, side) for row in rows] for side in sides)
        pairs = zip(one[1:], other[1:], strict=True)
        return all(zero(a * other[0], one[0] * b, PRECISIONS[0]) is Finding.EQUAL for a, b in pairs)


def _product(row: Sequence[Any], slots: Sequence[int]) -> Any:
    return math.prod((row[slot] for slot in slots[1:]), start=row[slots[0]])
