"""Judge of a formula: equality as functions, never equality of shape."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Formula, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.mathml import mathml_of
from graders.language.parser import parse
from graders.language.symbols import Symbols, key
from graders.language.text import text_of
from graders.language.tree import Grid, Index, Name, Relation, Tree, names, walk
from graders.verdict import RIGHT, UNDECIDED, Code, Verdict, Witness, wrong


@dataclass(frozen=True, slots=True)
class Expression:
    """A formula in the givens and the earlier steps.

    Args:
        step: The step whose formula is asked for.
        weight: Share in the score.
    """

    step: str
    weight: float = 1.0
    kind: ClassVar[str] = "expression"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Tree:
        """Read a formula; `omega2 = …` in front is allowed, the unknown itself inside is not."""
        tree = parse(text, symbols)
        if isinstance(tree, Relation) and tree.operators == ("=",) and tree.sides[0] == Name(self.step):
            tree = tree.sides[1]
        if any(isinstance(node, Relation | Grid | Index) for node in walk(tree)):
            raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, 0, text.strip()[:20])
        forbidden = sorted(names(tree) - symbols.names)
        if forbidden:
            raise AnswerSyntaxError(Reason.FORBIDDEN_NAME, _place(text, forbidden[0]), forbidden[0])
        return tree

    def check(self, answer: Tree, reference: Formula) -> Verdict:
        """Judge by ball arithmetic on true states; what cannot be decided is kept for the lecturer."""
        if answer == reference.tree:  # the reference has a value at all of its points
            return RIGHT
        from graders.equality import Finding, compare

        found = compare(answer, reference)
        if found.finding is Finding.EQUAL:
            return RIGHT
        if found.finding is Finding.UNDECIDED:
            return UNDECIDED
        code = Code.UNDEFINED if found.finding is Finding.UNDEFINED else Code.WRONG
        return wrong(code, Witness(found.witness))

    def show(self, reference: Formula) -> str:
        """Write the formula as a student could type it."""
        return text_of(reference.tree)

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        text = text_of(reference.tree)
        right = (text, f"2*({text})/2", f"({text}) + 1 - 1", f"{self.step} = {text}")
        return Samples(
            right, (f"-({text})", f"2*({text})", f"({text}) + 1e-9*({text})"), ("", f"({text}", "1 +", self.step)
        )

    def echo(self, answer: Tree, comma: bool = False) -> Echo:
        """Show the formula as it was read."""
        return Echo(mathml_of(answer, comma), text_of(answer))

    def carried(self, answer: Tree) -> Tree:
        """Give the student's formula, from which later answers are solved."""
        return answer

    def apart(self, one: Formula, other: Formula) -> float:
        """Two formulas are equal or far apart."""
        return 0.0 if self.check(one.tree, other).code is Code.RIGHT else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """A formula has no unit and no tolerance."""
        return {}


def _place(text: str, name: str) -> int:
    """Find where a symbol was typed, whatever its spelling."""
    for length in range(1, 20):
        for start in range(len(text) - length + 1):
            if key(text[start : start + length]) == key(name):
                return start
    return 0
