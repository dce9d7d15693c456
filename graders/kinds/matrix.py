"""Judge of a numeric matrix, entry by entry."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from itertools import combinations
from math import inf, pi, remainder
from typing import Any, ClassVar, TypeVar

from graders.angles import is_angle
from graders.common_slips import NONE, CommonSlip, Slips, off_by
from graders.judge import Echo, Samples
from graders.judge import Matrix as Rows
from graders.language import doubles
from graders.language.bare_grids import bracketed
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_source import is_latex
from graders.language.mathml import mathml_of
from graders.language.parser import parse
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Grid, Number, Relation, Tree, names, walk
from graders.measured import measured, units_in
from graders.units import Unit, fits, read_unit
from graders.verdict import RIGHT, Code, Entries, Verdict, wrong

GREATEST = 1e99
T = TypeVar("T")
CLOSE = 0.01  # relative, of an entry that is off by a slip
ANGLE = (0, 0, 0, 1, 0)
ALL = frozenset((CommonSlip.OPPOSITE_SIGN, CommonSlip.KILO_PREFIX, CommonSlip.DEGREES_RADIANS))


@dataclass(frozen=True, slots=True)
class Typed:
    """A matrix as typed and its numbers."""

    tree: Grid
    rows: Rows


@dataclass(frozen=True, slots=True)
class Matrix:
    """A matrix of numbers; an entry is right within rtol of max(1, largest entry), both in SI units.

    Args:
        rows: Number of rows, shown as a grid.
        columns: Number of columns.
        rtol: Tolerance of an entry over the scale max(1, |largest entry|).
        units: The unit of each column, in which its bare numbers are read; empty for SI units. In a column of angles
            a degree sign speaks for itself, and whole turns do not count.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
    """

    rows: int
    columns: int
    rtol: float = 0.002
    units: tuple[str, ...] = ()
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "matrix"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> Typed:
        """Read `[[1; 0], [0; 1]]`, `[1, 0; 0, 1]` or bare rows; entries are constants such as `cos(30°)`, `1.5 m`."""
        try:
            tree = read_grid(text, symbols)
        except AnswerSyntaxError:
            units = units_in(text)
            if not units:
                raise
            tree = read_grid(text, Symbols(units.values()))
        return Typed(tree, tuple(tuple(self._value(at, e, text) for at, e in enumerate(row)) for row in tree.rows))

    def _unit(self, column: int) -> Unit:
        return read_unit(self.units[column] if column < len(self.units) else "1")

    def _value(self, column: int, entry: Tree, text: str) -> float:
        unit = self._unit(column)
        if names(entry):
            return _measured(entry, unit, text)
        own = unit.dimension == ANGLE and is_angle(entry)
        return _number(entry, text) * (1.0 if own else unit.factor)

    def _differences(self, one: Rows, other: Rows) -> Rows:
        """Give |a - b| of all entries; ValueError when the shapes differ."""
        angles = [self._unit(column).dimension == ANGLE for column in range(len(one[0]))]
        return tuple(
            tuple(abs(remainder(a - b, 2 * pi) if turns else a - b) for a, b, turns in zip(x, y, angles, strict=True))
            for x, y in zip(one, other, strict=True)
        )

    def check(self, answer: Typed, reference: Rows) -> Verdict:
        """Judge each entry; credit falls to nothing when half of the entries are wrong."""
        if (len(answer.rows), len(answer.rows[0])) != (len(reference), len(reference[0])):
            return wrong(Code.WRONG_SHAPE)
        bound = self.rtol * _scale(reference) * (1 + 1e-12)
        off = tuple(
            (i, j)
            for i, row in enumerate(self._differences(answer.rows, reference), 1)
            for j, difference in enumerate(row, 1)
            if not difference <= bound
        )
        if not off:
            return RIGHT
        total = len(reference) * len(reference[0])
        score = max(0.0, 1 - 2 * len(off) / total)
        return Verdict(score, Code.SOME_ENTRIES if score else Code.WRONG, Entries(off, total))

    def slips(self, answer: Typed, reference: Rows) -> Slips:
        """Tell whether rows stand for columns, or one slip explains each entry that is off."""
        if (len(answer.rows), len(answer.rows[0])) != (len(reference), len(reference[0])):
            return NONE
        if any(self.apart(other, reference) <= 1 for other in _transposed(answer.rows)):
            return frozenset((CommonSlip.ROWS_FOR_COLUMNS,))
        if any(self.apart(other, reference) <= 1 for other in _exchanged(answer.rows)):
            return frozenset((CommonSlip.EXCHANGED,))
        bound, found = self.rtol * _scale(reference), ALL
        for typed, true, off in zip(answer.rows, reference, self._differences(answer.rows, reference), strict=True):
            for column, (one, other, difference) in enumerate(zip(typed, true, off, strict=True)):
                if difference > bound:
                    found &= self._off_by(column, one, other)
        return found

    def agrees(self, answer: Typed, value: Rows) -> bool:
        """Tell whether each entry is that of the value on its own scale: one huge entry excuses no other."""
        if (len(answer.rows), len(answer.rows[0])) != (len(value), len(value[0])):
            return False
        rows = zip(self._differences(answer.rows, value), value, strict=True)
        return all(
            difference <= self.rtol * max(1.0, abs(entry))
            for differences, entries in rows
            for difference, entry in zip(differences, entries, strict=True)
        )

    def _off_by(self, column: int, one: float, other: float) -> Slips:
        if abs(other) <= 9 * self.rtol:
            return NONE
        return off_by(one / other, min(self.rtol / abs(other), CLOSE), self._unit(column).dimension) & ALL

    def show(self, reference: Rows) -> str:
        """Write a reference in the printed units with eight decimals."""
        return "[" + ", ".join("[" + "; ".join(row) + "]" for row in self._written(reference)) + "]"

    def _written(self, rows: Rows) -> list[list[str]]:
        return [[_decimal(e / self._unit(at).factor) for at, e in enumerate(row)] for row in rows]

    def samples(self, reference: Rows) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        flat = "; ".join(" , ".join(row) for row in self._written(reference))
        off = tuple(tuple(e + 9 * _scale(reference) for e in row) for row in reference)
        return Samples((self.show(reference), f"[{flat}]"), (self.show(off), "[[1]]"), ("", "[[1; 2]", "3", "[[a]]"))

    def echo(self, answer: Typed, comma: bool = False) -> Echo:
        """Say which matrix was read."""
        return Echo(mathml_of(answer.tree, comma), text_of(answer.tree))

    def carried(self, answer: Typed) -> Rows | None:
        """Give the numbers, if the shape is the one asked for."""
        return answer.rows if (len(answer.rows), len(answer.rows[0])) == (self.rows, self.columns) else None

    def apart(self, one: Rows, other: Rows) -> float:
        """Give the largest difference of an entry in tolerances."""
        if (len(one), len(one[0])) != (len(other), len(other[0])):
            return inf
        bound = self.rtol * max(_scale(one), _scale(other))
        return max(max(row) for row in self._differences(one, other)) / bound

    def describe(self) -> Mapping[str, Any]:
        """Give shape, tolerance and units of the field."""
        units = {"units": list(self.units)} if self.units else {}
        return {"rows": self.rows, "columns": self.columns, "rtol": self.rtol, **units}


def read_grid(text: str, symbols: Symbols) -> Grid:
    """Read a matrix with or without its brackets, `A = …` in front of it or not.

    Raises:
        AnswerSyntaxError: It is none, or cannot be read; an entry left empty is told by its row and column.
    """
    tree = _read(text, symbols)
    if isinstance(tree, Relation) and tree.operators == ("=",):
        tree = tree.sides[1]
    if not isinstance(tree, Grid):
        raise AnswerSyntaxError(Reason.WRONG_SHAPE, 0, text.strip()[:20])
    return tree


def _read(text: str, symbols: Symbols) -> Tree:
    try:
        tree = parse(text, symbols)
    except AnswerSyntaxError as error:
        rows, place = _in_rows(text, symbols), error.position
        if rows:
            return rows
        if error.reason is not Reason.NEEDS_OPERAND or is_latex(text) or text[place : place + 1] not in (";", ",", "]"):
            raise
        row, column = _entry_at(text[:place])
        raise AnswerSyntaxError(Reason.MISSING_ENTRY, place, f"({row}, {column})") from None
    return tree if isinstance(tree, Grid | Relation) else _in_rows(text, symbols) or tree


def _in_rows(text: str, symbols: Symbols) -> Tree | None:
    """Read rows without their brackets; None where there are none."""
    plain = bracketed(text)
    with suppress(AnswerSyntaxError):
        return parse(plain, symbols) if plain else None
    return None


def _entry_at(before: str) -> tuple[int, int]:
    """Give the row and column of the entry behind a text."""
    if before.count("[") > 1:
        row, entries = before.count("]"), before.rpartition("[")[2]
        return row + 1, (entries.count(";") or entries.count(",")) + 1
    return before.count(";") + 1, before.rpartition(";")[2].count(",") + 1


def _transposed(rows: Rows) -> Iterator[Rows]:
    """Exchange rows and columns of a square matrix; of a homogeneous one perhaps those of its rotation alone."""
    if len(rows) == len(rows[0]):
        turned = tuple(zip(*rows, strict=True))
        yield turned
        if len(rows) == 4:
            yield (*((*turned[at][:3], rows[at][3]) for at in range(3)), rows[3])


def _exchanged(rows: Rows) -> Iterator[Rows]:
    """Exchange two rows, or two entries of a row."""
    for one, other in combinations(range(len(rows)), 2):
        yield _swapped(rows, one, other)
    for at, row in enumerate(rows):
        for one, other in combinations(range(len(row)), 2):
            yield (*rows[:at], _swapped(row, one, other), *rows[at + 1 :])


def _swapped(items: tuple[T, ...], one: int, other: int) -> tuple[T, ...]:
    found = list(items)
    found[one], found[other] = found[other], found[one]
    return tuple(found)


def _scale(rows: Rows) -> float:
    return max(1.0, *(abs(e) for row in rows for e in row))


def _decimal(entry: float) -> str:
    return f"{entry:.8f}".rstrip("0").rstrip(".") if abs(entry) >= 5e-9 else "0"


def _measured(entry: Tree, asked: Unit, text: str) -> float:
    """Give the value in SI units of an entry that says its unit."""
    name = min(names(entry))
    place = max(0, text.find(name))
    try:
        found = measured(entry) if any(isinstance(node, Number) for node in walk(entry)) else None
    except (ArithmeticError, ValueError):
        found = None
    if found is None or not abs(found[0] * found[1].factor) <= GREATEST:
        raise AnswerSyntaxError(Reason.NOT_A_NUMBER, place, name)
    if not fits(found[1], asked):
        raise AnswerSyntaxError(Reason.OTHER_UNIT, place, text_of(entry)[:20])
    return found[0] * found[1].factor


def _number(entry: Tree, text: str) -> float:
    if names(entry):
        name = min(names(entry))
        raise AnswerSyntaxError(Reason.NOT_A_NUMBER, max(0, text.find(name)), name)
    try:
        (value,) = doubles.run(doubles.line_runner(entry), [])
    except (doubles.UndefinedError, ValueError):
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, 0, text_of(entry)[:20]) from None
    if not isinstance(value, float) or not abs(value) <= GREATEST:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, 0, text_of(entry)[:20])
    return value
