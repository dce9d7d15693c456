"""Judge of an equation for one unknown: the same solutions, however it is written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Formula, Samples
from graders.language.mathml import mathml_of
from graders.language.parser import parse_line
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Name, Relation
from graders.verdict import Code, Verdict, wrong


@dataclass(frozen=True, slots=True)
class Equation:
    """An equation for one unknown: `l1*sin(alpha1) + l2*sin(alpha2) = 0`; sides, signs, factors, powers do not count.

    It must hold at every true state of the system, determine the unknown, and have the solutions of the task's own
    equation between the ends of the span.

    Args:
        step: The unknown; its formula gives its true value.
        span: Least and greatest value of the unknown between which solutions count.
        equation: A right equation, as a student could type it; by default the unknown equals its formula.
        branch: Whether the task tells which solution is meant, so that an equation with that one alone is right too.
        weight: Share in the score.
    """

    step: str
    span: tuple[float, float]
    equation: str = ""
    branch: bool = False
    weight: float = 1.0
    kind: ClassVar[str] = "equation"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Relation:
        """Read an equation in the givens, the earlier steps and the unknown; raises AnswerSyntaxError."""
        from graders.solutions.typed import read_equation

        return read_equation(text, symbols, frozenset((self.step,)))

    def check(self, answer: Relation, reference: Formula) -> Verdict:
        """Judge at the true states first, then by all solutions; what is open is kept for the lecturer."""
        from graders.solutions.posed import Task, judged

        task = Task((self.step,), (self.span,), reference)
        seen = judged((answer,), (self._right(reference),), task)
        if not all(seen.holding):
            return wrong(Code.NOT_SATISFIED)
        if self.branch and seen.verdict.code is Code.LOST_SOLUTION:
            return judged((answer,), (self._solved(reference),), task).verdict
        return seen.verdict

    def _solved(self, reference: Formula) -> Relation:
        return Relation(("=",), (Name(self.step), reference.tree))

    def _right(self, reference: Formula) -> Relation:
        """Give the task's own equation; that of a replaced step where the written one does not hold."""
        from graders.solutions.posed import Task, holds

        solved = self._solved(reference)
        written = parse_line(self.equation) if self.equation else solved
        if not isinstance(written, Relation):
            raise TypeError(f"{self.equation!r} is no equation")
        return written if holds((written,), Task((self.step,), (self.span,), reference)) else solved

    def show(self, reference: Formula) -> str:
        """Write the equation as a student could type it."""
        return text_of(self._right(reference))

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        left, right = map(text_of, self._right(reference).sides)
        good = (f"{left} = {right}", f"2*({right}) - 2*({left}) = 0", f"-({left}) = -({right})")
        off = (f"{self.step} = {self.step}", "0 = 1", f"{left} = {right} + 1e-9*(1 + {self.step}^2)")
        return Samples(good, off, ("", left, f"{left} =", f"({left} = {right}", f"{left} < {right}"))

    def echo(self, answer: Relation, comma: bool = False) -> Echo:
        """Show the equation as it was read."""
        return Echo(mathml_of(answer, comma), text_of(answer))

    def carried(self, answer: Relation) -> None:
        """Nothing is solved from an equation of the student."""

    def apart(self, one: Formula, other: Formula) -> float:
        """Two equations are equal or far apart."""
        return 0.0 if self.check(self._right(one), other).code is Code.RIGHT else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the unknown."""
        return {"unknowns": [self.step]}
