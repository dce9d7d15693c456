"""Judge of a matrix of formulas, entry by entry."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.formulas import checked
from graders.judge import Echo, Formula, Samples
from graders.kinds.matrix import read_grid
from graders.language.mathml import mathml_of
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Grid, Tree, names
from graders.verdict import RIGHT, UNDECIDED, Code, Entries, Verdict, wrong


@dataclass(frozen=True, slots=True)
class SymbolicMatrix:
    """A matrix of formulas in the givens and the earlier steps, equal to the step's matrix in every entry.

    Args:
        step: The step whose matrix is asked for.
        rows: Number of rows, shown as a grid.
        columns: Number of columns.
        weight: Share in the score.
    """

    step: str
    rows: int
    columns: int
    weight: float = 1.0
    kind: ClassVar[str] = "symbolic_matrix"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Grid:
        """Read `[[cos(q1); -sin(q1)], [sin(q1); cos(q1)]]`; the name of the matrix and `=` may stand in front."""
        tree = read_grid(text, symbols)
        for entry in _entries(tree):
            checked(entry, text, symbols)
        return tree

    def check(self, answer: Grid, reference: Formula) -> Verdict:
        """Judge each entry by ball arithmetic; credit falls to nothing when half of those with symbols are wrong."""
        true = reference.tree
        if not isinstance(true, Grid) or _shape(answer) != _shape(true):
            return wrong(Code.WRONG_SHAPE)
        from graders.equality import Finding, compare_entries

        found = [c.finding for c in compare_entries(_entries(answer), _entries(true), reference.states)]
        off = [at for at, finding in enumerate(found) if finding in (Finding.DIFFERENT, Finding.UNDEFINED)]
        if len(off) + found.count(Finding.EQUAL) < len(found):
            return UNDECIDED
        if not off:
            return RIGHT
        symbolic = sum(bool(names(entry)) for entry in _entries(true)) or len(found)
        score = max(0.0, 1 - 2 * len(off) / symbolic)
        places = tuple((at // len(true.rows[0]) + 1, at % len(true.rows[0]) + 1) for at in off)
        return Verdict(score, Code.SOME_ENTRIES if score else Code.WRONG, Entries(places, len(found)))

    def show(self, reference: Formula) -> str:
        """Write the matrix as a student could type it."""
        return text_of(reference.tree)

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        assert isinstance(reference.tree, Grid)
        texts = [[text_of(entry) for entry in row] for row in reference.tree.rows]
        twice = [[f"2*({text})/2" for text in row] for row in texts]
        off = [[f"({text}) + 1e-9" for text in row] for row in texts]
        right = (_nested(texts), _nested(twice), f"{self.step} = {_nested(texts)}")
        return Samples(right, (_nested(off), _nested([["1"]])), ("", "[[1; 2]", "3", _nested([[self.step]])))

    def echo(self, answer: Grid, comma: bool = False) -> Echo:
        """Show the matrix as it was read."""
        return Echo(mathml_of(answer, comma), text_of(answer))

    def carried(self, answer: Grid) -> Tree | None:
        """Give the student's matrix, if its shape is the one asked for."""
        return answer if _shape(answer) == (self.rows, self.columns) else None

    def apart(self, one: Formula, other: Formula) -> float:
        """Two matrices of formulas are equal or far apart."""
        same = isinstance(one.tree, Grid) and self.check(one.tree, other).code is Code.RIGHT
        return 0.0 if same else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the shape of the field."""
        return {"rows": self.rows, "columns": self.columns}


def _entries(grid: Grid) -> list[Tree]:
    return [entry for row in grid.rows for entry in row]


def _shape(grid: Grid) -> tuple[int, int]:
    return len(grid.rows), len(grid.rows[0])


def _nested(rows: list[list[str]]) -> str:
    return "[" + ", ".join("[" + "; ".join(row) + "]" for row in rows) + "]"
