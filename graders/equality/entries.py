"""Matrices of formulas, entry by entry: one program with many outputs."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from graders.equality.comparing import FEW, Comparison, compare, few
from graders.equality.deciding import PRECISIONS, Finding, exactly, zero
from graders.equality.turns import TURNING
from graders.judge import Formula, States
from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Tree

EQUAL = Comparison(Finding.EQUAL)


def compare_entries(answers: Sequence[Tree], references: Sequence[Tree], states: States) -> list[Comparison]:
    """Compare formulas pair by pair on the same states; what turns, or stays open, is compared alone."""
    builder = Builder(states.names)
    for name, line in states.lines:
        builder.define(name, line)
    right = [builder.add(tree) for tree in references]
    typed = [builder.add(tree) for tree in answers]
    smooth = not any(name in TURNING for name, _ in builder.operations)
    found = _together(builder.program(*right, *typed), states) if smooth else [None] * len(right)
    return [
        EQUAL if one == other else comparison or compare(answer, Formula(tree, states))
        for one, other, comparison, answer, tree in zip(right, typed, found, answers, references, strict=True)
    ]


def _together(program: Program, states: States) -> list[Comparison | None]:
    """Decide all entries at a few points at once; None where this does not settle an entry."""
    count = len(program.outputs) // 2
    found: list[Comparison | None] = [EQUAL] * count
    with precision(PRECISIONS[0]):
        runner = Runner(program, BALLS)
        for point in list(few(states.points))[:FEW]:
            try:
                values = runner.run(exactly(point))
            except UndefinedError:
                return [None] * count
            for at, finding in enumerate(map(_zero, values[:count], values[count:])):
                old = found[at]
                if finding is Finding.DIFFERENT and (old is None or old is EQUAL):
                    found[at] = Comparison(finding, tuple(zip(states.names, point, strict=True)))
                elif finding is None and old is EQUAL:
                    found[at] = None
    return found


def _zero(right: arb, typed: arb) -> Finding | None:
    return zero(right, typed, PRECISIONS[0])
