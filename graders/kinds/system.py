"""Judge of a system of equations: it holds at every true state, determines the unknowns, loses no assembly."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Formula, Samples
from graders.language.mathml import mathml_of
from graders.language.parser import parse_line
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Relation
from graders.verdict import Branches, Code, Verdict, wrong


@dataclass(frozen=True, slots=True)
class System:
    """Equations for several unknowns, parted by `;` or lines: `l1*cos(alpha1) + l2*cos(alpha2) = l3; …`.

    They must hold at every true state of the system, determine the unknowns, and have the solutions of the task's own
    equations between the ends of the spans. Their order, and how they are combined, does not count.

    Args:
        unknowns: The unknowns, steps in the order of solving; their formulas give their true values.
        spans: Least and greatest value of each, between which solutions count.
        equations: A right system, as a student could type it.
        weight: Share in the score.
    """

    unknowns: tuple[str, ...]
    spans: tuple[tuple[float, float], ...]
    equations: tuple[str, ...]
    weight: float = 1.0
    kind: ClassVar[str] = "system"
    symbolic: ClassVar[bool] = True

    @property
    def step(self) -> str:
        """Give the unknown that is solved last."""
        return self.unknowns[-1]

    def parse(self, text: str, symbols: Symbols) -> tuple[Relation, ...]:
        """Read the equations in the givens, the steps before the unknowns and these; raises AnswerSyntaxError."""
        from graders.solutions.typed import read_equations

        return read_equations(text, symbols, frozenset(self.unknowns))

    def check(self, answer: tuple[Relation, ...], reference: Formula) -> Verdict:
        """Judge each equation at the true states, then the system by its solutions."""
        from graders.solutions.posed import PART, Task, judged

        seen = judged(answer, self._right(), Task(self.unknowns, self.spans, reference))
        holding = sum(seen.holding)
        if holding < len(answer):
            share = round(PART * holding / max(len(answer), len(self.equations)), 6)
            parts = Branches(holding, len(answer))
            return Verdict(share, Code.SOME_EQUATIONS, parts) if holding else wrong(Code.NOT_SATISFIED)
        return seen.verdict

    def _right(self) -> tuple[Relation, ...]:
        found = tuple(tree for tree in map(parse_line, self.equations) if isinstance(tree, Relation))
        if len(found) != len(self.equations):
            raise TypeError(f"{self.equations!r} are not all equations")
        return found

    def show(self, reference: Formula) -> str:
        """Write the system as a student could type it."""
        return "; ".join(map(text_of, self._right()))

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        first, *others = (tuple(map(text_of, one.sides)) for one in self._right())
        turned = [f"2*({right}) = 2*({left})" for left, right in (*others, first)]
        added = f"{first[0]} + {others[0][0]} = {first[1]} + {others[0][1]}" if others else " = ".join(first)
        rest = [" = ".join(other) for other in others]
        good = (self.show(reference), "\n".join(turned), "; ".join([added, *rest]))
        off = (
            "; ".join([" = ".join(first)] * len(self.equations)) if others else "0 = 1",
            "; ".join([f"{first[0]} = {first[1]} + 1e-9", *rest]),
            "; ".join(["0 = 1", *rest]),
        )
        return Samples(good, off, ("", first[0], f"{first[0]} =", f"{' = '.join(first)}; )"))

    def echo(self, answer: tuple[Relation, ...], comma: bool = False) -> Echo:
        """Show the equations as they were read."""
        inner = [mathml_of(one, comma).removeprefix("<math>").removesuffix("</math>") for one in answer]
        marked = f"<math><mrow>{'<mo>;</mo>'.join(inner)}</mrow></math>"
        return Echo(marked, "; ".join(map(text_of, answer)))

    def carried(self, answer: tuple[Relation, ...]) -> None:
        """Nothing is solved from equations of the student."""

    def apart(self, one: Formula, other: Formula) -> float:
        """Two systems are equal or far apart."""
        from graders.solutions.posed import Task, holds

        alike = [holds(self._right(), Task(self.unknowns, self.spans, each)) for each in (one, other)]
        return 0.0 if alike[0] == alike[1] else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the unknowns."""
        return {"unknowns": list(self.unknowns)}
