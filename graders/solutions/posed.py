"""Equations beside the true states of a system: do they hold there, do they determine the unknowns, what is lost."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from graders.equality import Finding
from graders.judge import Formula, States
from graders.language.balls import BALLS, precision
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Name, Relation, Tree
from graders.solutions.equations import compare_equations
from graders.solutions.found import Found
from graders.solutions.reduction import reduced, residual
from graders.solutions.scene import BITS, Effort, Residuals, Scene, Side, moved, unit_points
from graders.solutions.systems import compare_systems
from graders.verdict import RIGHT, UNDECIDED, Code, Verdict, Witness, wrong

PART = 0.5  # of the score for equations that hold, but lose a solution, bring one, or hold only in part
STATES = 4  # true states at which equations are tested
SHIFT = arb(2) ** -90  # of a range: over which slopes are taken
FINE, SHRUNK = 2 * BITS, arb(2) ** -100  # a precision at which what is zero is so much nearer to it


@dataclass(frozen=True, slots=True)
class Task:
    """What is asked: the unknowns, between which values solutions count, and their truth.

    Attributes:
        unknowns: The unknowns in the order of solving; the reference is the formula of the last one.
        spans: Least and greatest value of each.
        reference: The formula of the last unknown over true states.
    """

    unknowns: tuple[str, ...]
    spans: tuple[tuple[float, float], ...]
    reference: Formula

    @property
    def states(self) -> States:
        """Give the true states."""
        return self.reference.states

    @property
    def scene(self) -> Scene:
        """Give the box over the givens and the unknowns, with the points of the states."""
        states, box = self.states, box_of(self.states).ranges
        shares = unit_points(len(self.unknowns), repr(states.points[0]).encode())
        points = tuple(
            (*point, *(low + (high - low) * share for (low, high), share in zip(self.spans, row, strict=True)))
            for point, row in zip(states.points, shares, strict=False)
        )
        lines = tuple((name, line) for name, line in states.lines if name not in self.unknowns)
        return Scene((*states.names, *self.unknowns), (*box, *self.spans), points, lines)

    def truths(self, trees: Sequence[Tree]) -> list[tuple[list[arb], list[arb | None]]]:
        """Give some true points of the scene, and what trees are there."""
        builder = Builder(self.states.names)
        for name, line in self.states.lines:
            builder.define(name, line)
        builder.define(self.unknowns[-1], self.reference.tree)
        program = builder.program(*(builder.add(tree) for tree in (*map(Name, self.unknowns), *trees)))
        found, count = [], len(self.unknowns)
        for point in self.states.points[:STATES]:
            exact = [arb(x) for x in point]
            values = [_value(program.only(output), exact) for output in program.outputs]
            truth = [value for value in values[:count] if value is not None]
            if len(truth) == count:
                found.append(([*exact, *truth], values[count:]))
        return found


def _value(program: Program, point: Sequence[arb]) -> arb | None:
    try:
        (value,) = Runner(program, BALLS).run(point)
    except (ArithmeticError, ValueError, TypeError):
        return None
    found: arb | None = value if value.is_finite() else None
    return found


def box_of(states: States) -> Scene:
    """Give the box over the givens of states, with their points and lines."""
    box = tuple((one.low, one.high) for one in states.box) or tuple(
        (min(column), max(column)) for column in zip(*states.points, strict=True)
    )
    return Scene(states.names, box, states.points, states.lines)


@dataclass(frozen=True, slots=True)
class Judged:
    """What equations are to a task.

    Attributes:
        holding: For each equation whether it holds at the true states.
        determined: Whether they determine the unknowns there; None where that is not sure.
        found: How their solutions compare with those of the task, where they hold and determine.
    """

    holding: tuple[bool, ...]
    determined: bool | None
    found: Found

    @property
    def verdict(self) -> Verdict:
        """Judge equations that hold: whether they determine the unknowns, lose a solution or bring one."""
        if self.determined is False:
            return wrong(Code.UNDETERMINED)
        if self.found.finding is Finding.EQUAL:
            return RIGHT
        if self.found.finding is Finding.UNDECIDED:
            return UNDECIDED
        code = Code.LOST_SOLUTION if self.found.lost else Code.SURPLUS_SOLUTION
        return Verdict(PART, code, Witness(self.found.witness))


def judged(answer: Sequence[Relation], reference: Sequence[Relation], task: Task) -> Judged:
    """Hold equations to the true states of a task, then compare all their solutions.

    Args:
        answer: The equations to judge.
        reference: Equations whose solutions are those of the task.
        task: The unknowns and their truth.
    """
    unknowns = frozenset(task.unknowns)
    with precision(BITS):
        written = [residual(equation) for equation in answer]
        trees = [reduced(tree, unknowns) for tree in written]
        truths = task.truths(trees)
        points = [point for point, _ in truths]
        holding = tuple(
            all((value := values[at]) is not None and value.contains(0) for _, values in truths)
            and (tree is whole or not _nowhere(whole, task, points))
            for at, (tree, whole) in enumerate(zip(trees, written, strict=True))
        )
        determined = all(holding) and determines(trees, task, points)
    if not determined:
        return Judged(holding, determined, Found(Finding.DIFFERENT if determined is False else Finding.UNDECIDED))
    return Judged(holding, determined, compared(answer, reference, task))


def _nowhere(tree: Tree, task: Task, points: Sequence[Sequence[arb]]) -> bool:
    """Tell whether a tree is proved to have no value at some true state: what is left of it may have one."""
    side = Side(Residuals(task.scene, [[tree]], Effort()), 0)
    return any(map(side.nowhere, points))


def determines(trees: Sequence[Tree], task: Task, points: Sequence[Sequence[arb]]) -> bool | None:
    """Tell whether the slopes by the unknowns have full rank at some true state; None where that is not sure."""
    found = _ranks(trees, task, points)
    if not all(rank.contains(0) for rank in found):
        return True
    with precision(FINE):
        finer = _ranks(trees, task, [point for point, _ in task.truths(trees)])
    settled = len(finer) == len(found) > 0 and all(
        fine.abs_upper() <= SHRUNK * rank.abs_upper() for fine, rank in zip(finer, found, strict=True)
    )
    return False if settled else None  # the slope of a sign at its zero is anything at any precision


def _ranks(trees: Sequence[Tree], task: Task, points: Sequence[Sequence[arb]]) -> list[arb]:
    """Give a number for each true state that is zero where the slopes have no full rank."""
    scene, count = task.scene, len(task.unknowns)
    side, first = Side(Residuals(scene, [trees], Effort()), 0), len(scene.names) - count
    found = []
    for point in points:
        columns = [column for at in range(first, first + count) if (column := _slopes(side, point, at)) is not None]
        if len(columns) == count:
            slopes = arb_mat(columns)
            found.append((slopes * slopes.transpose()).det())
    return found


def _slopes(side: Side, point: Sequence[arb], at: int) -> list[arb] | None:
    """Give the slopes along an unknown, by steps to that side on which all have a value."""
    here = side.balls(point)
    for step in (SHIFT * side.scene.width(at), -SHIFT * side.scene.width(at)):
        there = side.balls(moved(point, at, point[at] + step))
        if here is not None and there is not None:
            return [(b - a) / step for a, b in zip(here, there, strict=True)]
    return None


def compared(answer: Sequence[Relation], reference: Sequence[Relation], task: Task) -> Found:
    """Compare the solutions of equations with those of the task."""
    if len(answer) == len(reference) == 1:
        return compare_equations(answer[0], reference[0], task.scene, task.unknowns[0])
    return compare_systems(answer, reference, task.scene, task.unknowns)


def holds(equations: Sequence[Relation], task: Task) -> bool:
    """Tell whether equations hold at the true states, of which there are some."""
    with precision(BITS):
        truths = task.truths([residual(equation) for equation in equations])
        held = (value is not None and value.contains(0) for _, values in truths for value in values)
        return bool(truths) and all(held)
