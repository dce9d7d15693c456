"""Judge of an inequality: it holds at the same points, borders included."""

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
from graders.verdict import RIGHT, UNDECIDED, Code, Verdict, Witness, wrong

PART = 0.5  # of the score where only the borders differ
CLOSED = {"<": "<=", ">": ">="}
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}


@dataclass(frozen=True, slots=True)
class Inequality:
    """An inequality or a chain: `0 < x <= a`; it is right where it holds at the same points of the givens' domain.

    Args:
        inequality: A right one, as a student could type it.
        step: A formula that is positive inside, zero on the border and negative outside: the margin that is left.
        weight: Share in the score.
    """

    inequality: str
    step: str
    weight: float = 1.0
    kind: ClassVar[str] = "inequality"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Relation:
        """Read an inequality in the givens and the steps before the margin; raises AnswerSyntaxError."""
        from graders.solutions.typed import read_inequality

        return read_inequality(text, symbols)

    def check(self, answer: Relation, reference: Formula) -> Verdict:
        """Judge inside, on the borders and between them; a lost or surplus border and a turned sense are named."""
        from graders.equality import Finding
        from graders.solutions.inequalities import compare_inequalities
        from graders.solutions.posed import box_of

        scene, right = box_of(reference.states), self._right()
        found = compare_inequalities(answer, right, scene)
        if found.finding is Finding.EQUAL:
            return RIGHT
        if found.finding is Finding.UNDECIDED:
            return UNDECIDED
        near = [value for _, value in found.witness]
        closed = compare_inequalities(_written(answer, CLOSED), _written(right, CLOSED), scene, near)
        if closed.finding is Finding.EQUAL:
            return Verdict(PART, Code.BORDER, Witness(found.witness))
        turned = compare_inequalities(_written(answer, TURNED), right, scene, near)
        return wrong(Code.SENSE_TURNED if turned.finding is Finding.EQUAL else Code.WRONG, Witness(found.witness))

    def _right(self) -> Relation:
        tree = parse_line(self.inequality)
        if not isinstance(tree, Relation):
            raise TypeError(f"{self.inequality!r} is no inequality")
        return tree

    def show(self, reference: Formula) -> str:
        """Write the inequality as a student could type it."""
        return text_of(self._right())

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        right, margin = self._right(), text_of(reference.tree)
        strict = any(operator in CLOSED for operator in right.operators)
        good = (text_of(right), f"{margin} {'>' if strict else '>='} 0", f"-2*({margin}) {'<' if strict else '<='} 0")
        off = (text_of(_written(right, TURNED)), f"{margin} > 1e-9", f"{margin} {'>=' if strict else '>'} 0", "0 < 1")
        return Samples(good, off, ("", margin, f"{margin} >", f"{margin} = 0"))

    def echo(self, answer: Relation, comma: bool = False) -> Echo:
        """Show the inequality as it was read."""
        return Echo(mathml_of(answer, comma), text_of(answer))

    def carried(self, answer: Relation) -> None:
        """Nothing is solved from an inequality of the student."""

    def apart(self, one: Formula, other: Formula) -> float:
        """The inequality is the same whatever is replaced."""
        return 0.0

    def describe(self) -> Mapping[str, Any]:
        """An inequality has no unit and no tolerance."""
        return {}


def _written(chain: Relation, operators: Mapping[str, str]) -> Relation:
    return Relation(tuple(operators.get(operator, operator) for operator in chain.operators), chain.sides)
