"""Judge of a table of a cycle: ordinates over the time or the angle of the driver, column by column."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import Any, ClassVar

from graders.common_slips import NONE, Slips
from graders.cycle.curve import Rows, cycle_of
from graders.cycle.slips import Rule, beside, coverage, off, remarks
from graders.cycle.table import Column, Table, read_table
from graders.judge import Echo
from graders.judge import Samples as Texts
from graders.language.symbols import Symbols
from graders.remarks import Remarks
from graders.units import read_unit
from graders.verdict import RIGHT, Code, Verdict, wrong


@dataclass(frozen=True, slots=True)
class Series:
    """A table of a cycle from a spreadsheet (CSV) or as JSON, with a head such as `t [s]; x [mm]; v [m/s]`.

    Each column of ordinates is judged for itself. The reference is a matrix of the columns in SI units, its rows at
    equal steps of the abscissae, the last one a whole cycle after the first.

    Args:
        columns: The columns in the order of the reference, the abscissae first.
        abscissae: How many of them may stand for the abscissa: the time, and the angle of a driver of constant speed.
        rtol: Tolerance of an ordinate over the amplitude of its column, half of its range.
        least: The least number of rows.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
    """

    columns: tuple[Column, ...]
    abscissae: int = 1
    rtol: float = 0.01
    least: int = 24
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "samples"
    symbolic: ClassVar[bool] = False

    @property
    def _rule(self) -> Rule:
        return Rule(self.columns, self.abscissae, self.rtol, self.least)

    def parse(self, text: str, symbols: Symbols) -> Table:
        """Read a table with a head such as `t [s]; x [mm]; v [m/s]`; raises AnswerSyntaxError."""
        return read_table(text, self.columns, self.abscissae)

    def check(self, answer: Table, reference: Rows) -> Verdict:
        """Judge each column at the rows typed, and name what is off."""
        seen = beside(answer, cycle_of(reference, self.abscissae), self._rule)
        total = len(self._rule.ordinates)
        gap = coverage(seen, answer.rows)
        if gap is not None:
            return wrong(Code.NO_MARKS, Remarks(0, total, (gap,)))
        off_ = off(seen)
        right = len(seen.typed) - len(off_)
        if right == total:
            return RIGHT
        details = Remarks(right, total, tuple(remarks(seen, answer, off_)))
        return Verdict(round(right / total, 6), Code.SOME_MARKS, details) if right else wrong(Code.NO_MARKS, details)

    def right(self, answer: Table, reference: Rows) -> bool:
        """Tell whether every column is right."""
        seen = beside(answer, cycle_of(reference, self.abscissae), self._rule)
        return len(seen.typed) == len(self._rule.ordinates) and not off(seen) and coverage(seen, answer.rows) is None

    def slips(self, answer: Table, reference: Rows) -> Slips:
        """Leave the slips to the remarks, which name them column by column."""
        return NONE

    def show(self, reference: Rows) -> str:
        """Write the table over its first abscissa, a row a line."""
        return self._written(reference, (0, *range(self.abscissae, len(self.columns))))

    def _written(self, rows: Rows, order: tuple[int, ...]) -> str:
        columns = [self.columns[at] for at in order]
        factors = [read_unit(column.unit).factor for column in columns]
        head = "; ".join(f"{column.name} [{column.unit}]" for column in columns)
        lines = (
            "; ".join(f"{row[at] / factor:.8g}" for at, factor in zip(order, factors, strict=True)) for row in rows
        )
        return "\n".join([head, *lines])

    def samples(self, reference: Rows) -> Texts:
        """Give texts that must be judged right, wrong and unreadable."""
        turned = (*range(len(self.columns) - 1, self.abscissae - 1, -1), self.abscissae - 1)
        comma = self._written(reference, turned).replace("; ", "\t").replace(".", ",")
        off_ = tuple((*row[: self.abscissae], *(-1.7 * value for value in row[self.abscissae :])) for row in reference)
        unreadable = ("", "abc", f"{self.columns[0].name}; qq\n1; 2", self.show(reference) + "\n1; 2; 3; 4; 5; 6")
        return Texts((self.show(reference), comma), (self.show(off_), self.show(reference[:9])), unreadable)

    def echo(self, answer: Table, comma: bool = False) -> Echo:
        """Say how many rows of which columns were read."""
        units = {column.name: column.unit for column in self.columns}
        named = "; ".join(f"{name} [{units[name]}]" for name in answer.columns)
        return Echo("", f"{answer.rows} × ({named})")

    def carried(self, answer: Table) -> Rows:
        """Give the rows typed."""
        return tuple(zip(*answer.columns.values(), strict=True))

    def apart(self, one: Rows, other: Rows) -> float:
        """Give the largest difference in tolerances, of the length of a cycle too."""
        if len(one) != len(other):
            return inf
        first, second = cycle_of(one, self.abscissae), cycle_of(other, self.abscissae)
        pairs = [(a, b, max(abs(a), abs(b))) for a, b in zip(first.turns, second.turns, strict=True)]
        scales = map(max, first.scales, second.scales)
        for x, y, scale in zip(first.ordinates, second.ordinates, scales, strict=True):
            pairs += [(a, b, scale) for a, b in zip(x, y, strict=True)]
        return max(abs(a - b) / (self.rtol * scale) for a, b, scale in pairs if scale)

    def describe(self) -> Mapping[str, Any]:
        """Give the columns with their units, the least number of rows and the tolerance."""
        columns = [{"name": column.name, "unit": column.unit} for column in self.columns]
        return {"columns_asked": columns, "least_rows": self.least, "amplitude": self.rtol}
