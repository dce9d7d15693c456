"""Matrices of formulas, entry by entry: one program with many outputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graders.equality.comparing import between, spread_over
from graders.equality.deciding import PRECISIONS, Finding, exactly, fineness, share_of, zero
from graders.equality.pair import EQUAL, FEW, MOST_TURNS, Comparison, Pair, few
from graders.equality.turns import TURNING, may_be_steep
from graders.judge import Domain, Formula, States
from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Tree

ALL_TURNS = 64  # of a matrix that are searched, shared by its entries...
LEAST_TURNS = 4  # ...but so many in each


def compare_entries(answers: Sequence[Tree], references: Sequence[Tree], states: States) -> list[Comparison]:
    """Compare formulas pair by pair on the same states; what turns, or stays open, is compared alone.

    Behind the first that stays open none is compared: all of the work together is bounded.
    """
    together = _together(references, answers, states)
    most = max(LEAST_TURNS, min(MOST_TURNS, ALL_TURNS // max(1, together.count(None))))
    found = list[Comparison]()
    for done, answer, tree in zip(together, answers, references, strict=True):
        if found and found[-1].finding is Finding.UNDECIDED:
            found.append(found[-1])
        else:
            found.append(done or _alone(answer, Formula(tree, states), most))
    return found


def _alone(answer: Tree, reference: Formula, most: int) -> Comparison:
    return EQUAL if answer == reference.tree else Pair(answer, reference, mutual=False, most_turns=most).compared()


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
    functions = {name for name, _ in builder.operations}
    if not TURNING.isdisjoint(functions) or any(map(may_be_steep, functions)):
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
    with precision(PRECISIONS[0] + fineness(states)):
        runner = Runner(program, BALLS)
        points = [point for point, _ in zip(few(states.points), range(FEW), strict=False)]
        try:
            rows = [runner.run(exactly(point)) for point in points]
        except UndefinedError:
            return None
    return [(point, dict(zip(program.outputs, row, strict=True))) for point, row in zip(points, rows, strict=True)]


def _one(values: Values, one: int, other: int, states: States) -> Comparison | None:
    fine = fineness(states)
    share = share_of(fine)
    with precision(PRECISIONS[0] + fine):
        for point, row in values:
            finding = zero(row[one], row[other], PRECISIONS[0], share)
            if finding is Finding.DIFFERENT:
                return Comparison(finding, tuple(zip(states.names, point, strict=True)))
            if finding is None:
                return None
    return EQUAL
