"""Matrices of formulas, entry by entry: one program with many outputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graders.equality.comparing import between, compare, spread_over
from graders.equality.deciding import PRECISIONS, Finding, exactly, zero
from graders.equality.pair import FEW, Comparison, few
from graders.equality.turns import TURNING
from graders.judge import Domain, Formula, States
from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Tree

EQUAL = Comparison(Finding.EQUAL)


def compare_entries(answers: Sequence[Tree], references: Sequence[Tree], states: States) -> list[Comparison]:
    """Compare formulas pair by pair on the same states; what turns, or stays open, is compared alone."""
    return [
        found or compare(answer, Formula(tree, states))
        for found, answer, tree in zip(_together(references, answers, states), answers, references, strict=True)
    ]


def between_entries(
    a: Sequence[Tree], b: Sequence[Tree], box: Mapping[str, Domain], chance: bytes = b""
) -> list[Comparison]:
    """Compare formulas pair by pair on a box; where only one of two has a value they differ."""
    found = _together(a, b, spread_over(tuple(box.items()), chance))
    return [done or between(one, other, box, chance) for done, one, other in zip(found, a, b, strict=True)]


def _together(right: Sequence[Tree], typed: Sequence[Tree], states: States) -> list[Comparison | None]:
    """Decide all pairs at a few points at once; None where this does not settle one."""
    builder = Builder(states.names)
    for name, line in states.lines:
        builder.define(name, line)
    sides = [builder.add(tree) for tree in right], [builder.add(tree) for tree in typed]
    if any(name in TURNING for name, _ in builder.operations):
        return [None] * len(right)
    apart = [(at, one, other) for at, (one, other) in enumerate(zip(*sides, strict=True)) if one != other]
    found: list[Comparison | None] = [EQUAL] * len(right)
    outputs = {slot: None for _, one, other in apart for slot in (one, other)} | dict.fromkeys(sides[0])
    values = _values(builder.program(*outputs), states)
    if values is None:
        return [None] * len(right)
    for at, one, other in apart:
        found[at] = _one(values, one, other, states)
    return found


Values = list[tuple[tuple[float, ...], dict[int, object]]]


def _values(program: Program, states: States) -> Values | None:
    """Give all outputs by their slots at a few points; None where one has no value."""
    with precision(PRECISIONS[0]):
        runner = Runner(program, BALLS)
        points = [point for point, _ in zip(few(states.points), range(FEW), strict=False)]
        try:
            rows = [runner.run(exactly(point)) for point in points]
        except UndefinedError:
            return None
    return [(point, dict(zip(program.outputs, row, strict=True))) for point, row in zip(points, rows, strict=True)]


def _one(values: Values, one: int, other: int, states: States) -> Comparison | None:
    with precision(PRECISIONS[0]):
        for point, row in values:
            finding = zero(row[one], row[other], PRECISIONS[0])
            if finding is Finding.DIFFERENT:
                return Comparison(finding, tuple(zip(states.names, point, strict=True)))
            if finding is None:
                return None
    return EQUAL
