"""A diagram as a student types it: pieces over ranges, one formula with brackets, or a table of ordinates."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from graders.amounts import Amount
from graders.kinds.quantity import Quantity
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.piece import Piece
from graders.language.program import Builder, Program, Runner
from graders.language.symbols import Symbols
from graders.language.tree import Tree, names
from graders.profile.polynomial import NotPolynomialError, Polynomial, arithmetic, value
from graders.profile.ranges import LONGEST, MOST, Ranged, read_formula, read_ranges
from graders.profile.stretches import Stretch
from graders.units import Unit, fits, read_unit

GREATEST = 1e30  # of a coefficient
FARTHEST = 1e6  # place, m
SHORTEST = 1e-9  # stretch of a table, m
NOTHING = Symbols(())
CELL = re.compile(r"[;\t|]")
ABSENT = ("", "-", "–", "—", "−", "x")


@dataclass(frozen=True, slots=True)
class Axes:
    """The variable along the bar, and the units of the two axes at the field."""

    x: str
    x_unit: str
    unit: str


@dataclass(frozen=True, slots=True)
class Part:
    """A typed piece: its ends in metres (None: the whole span), its formula, and the factors of x and of its value."""

    start: float | None
    end: float | None
    tree: Tree
    program: Program
    x_factor: float
    factor: float

    def stretches(self, first: float, last: float) -> Iterator[Stretch]:
        """Give the piece as polynomials, cut where a bracket opens.

        Args:
            first: Where the span starts, for a piece without a range.
            last: Where it ends.

        Raises:
            NotPolynomialError: A bracket that is closed leaves no value: 1/<x - 2>.
        """
        low = first if self.start is None else self.start
        high = last if self.end is None else self.end
        inner = sorted({x for x in self.borders() if low < x < high})
        middle = 0.0
        runner = Runner(self.program, arithmetic(lambda inside: value(inside, middle) > 0))
        for start, end in pairwise([low, *inner, high]):
            middle = (start + end) / 2 / self.x_factor
            curve = tuple(self.factor * c / self.x_factor**power for power, c in enumerate(_valued(runner)))
            yield Stretch(0.0, last, curve).part(start, end)

    def borders(self) -> list[float]:
        """Find where brackets open, in metres.

        Raises:
            NotPolynomialError: The formula is no polynomial, or a bracket does not open at one place.
        """
        found: list[float] = []

        def note(inside: Polynomial) -> bool:
            if len(inside) > 2:
                raise NotPolynomialError("a bracket opens at one place")
            if len(inside) == 2 and inside[1]:
                found.append(-inside[0] / inside[1] * self.x_factor)
            return True

        _run(Runner(self.program, arithmetic(note)))
        return found


def _valued(runner: Runner) -> Polynomial:
    try:
        return _run(runner)
    except (ValueError, ArithmeticError) as error:
        raise NotPolynomialError("no value") from error


def _run(runner: Runner) -> Polynomial:
    (found,) = runner.run([(0.0, 1.0)])
    if not isinstance(found, tuple) or not all(isinstance(c, float) and abs(c) < GREATEST for c in found):
        raise NotPolynomialError("no number")
    return found


def read_parts(text: str, axes: Axes) -> tuple[Part, ...]:
    """Read the pieces of a diagram.

    Raises:
        AnswerSyntaxError: A piece without its range, a range turned round, a formula that is no polynomial in x.
    """
    return tuple(_part(ranged, axes) for ranged in read_ranges(text))


def _part(ranged: Ranged, axes: Axes) -> Part:
    start = end = None
    x_factor = read_unit(axes.x_unit).factor
    if ranged.start is not None and ranged.end is not None:
        low, high = _amount(ranged.start, axes.x_unit), _amount(ranged.end, axes.x_unit)
        written = high.unit or low.unit
        x_factor = written.factor if written else x_factor
        start, end = _place(low, ranged.start, x_factor), _place(high, ranged.end, x_factor)
        if not start < end:
            raise AnswerSyntaxError(Reason.NEEDS_RANGE, ranged.start.place, ranged.start.text[:20])
    body, unit = _without_unit(ranged.body, read_unit(axes.unit))
    tree = read_formula(body, Symbols([axes.x]))
    part = Part(start, end, tree, _program(tree, axes.x, body), x_factor, unit.factor)
    try:
        opened = len(part.borders())
    except NotPolynomialError:
        raise AnswerSyntaxError(Reason.NOT_A_POLYNOMIAL, body.place, body.text[:20]) from None
    except (ValueError, ArithmeticError, TypeError, IndexError, AttributeError):
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, body.place, body.text[:20]) from None
    if opened > MOST:
        raise AnswerSyntaxError(Reason.TOO_LONG, body.place)
    return part


def _program(tree: Tree, x: str, body: Piece) -> Program:
    if names(tree) - {x}:
        raise AnswerSyntaxError(Reason.NOT_A_POLYNOMIAL, body.place, body.text[:20])
    builder = Builder((x,))
    try:
        return builder.program(builder.add(tree))
    except ValueError:
        raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, body.place, body.text[:20]) from None
    except RecursionError:
        raise AnswerSyntaxError(Reason.TOO_LONG, body.place) from None


def _place(amount: Amount, piece: Piece, factor: float) -> float:
    """Give a place in metres; a number without its unit is taken by the factor, if one is given."""
    x = amount.value if amount.unit or not factor else amount.number * factor
    if not abs(x) < FARTHEST:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, piece.place, piece.text[:20])
    return x


def _amount(piece: Piece, unit: str) -> Amount:
    amount = piece.read(lambda text: Quantity(unit).parse(text, NOTHING))
    if amount.unit is not None and not fits(amount.unit, read_unit(unit)):
        raise AnswerSyntaxError(Reason.UNKNOWN_UNIT, piece.place, amount.unit_text, unit)
    return amount


def _without_unit(body: Piece, expected: Unit) -> tuple[Piece, Unit]:
    """Cut off a unit written behind a formula: `7,5*x kN`, `12 [N*m]`."""
    opened = body.text.rfind("[") if body.text.endswith("]") else -1
    spaces = [at for at, char in enumerate(body.text) if char == " "]
    for at in [opened] if opened > 0 else spaces[-2:]:
        unit = _unit(body.text[at:].strip(" []"))
        if unit is not None and fits(unit, expected) and body.text[:at].strip():
            return body.part(0, at).bare, unit
    return body, expected


def _unit(text: str) -> Unit | None:
    if not text[:1].isalpha():
        return None
    try:
        return read_unit(text)
    except AnswerSyntaxError:
        return None


def is_table(text: str) -> bool:
    """Tell a table of ordinates from pieces: at least two lines of cells, no range among them."""
    rows = [line for line in text.splitlines() if line.strip()]
    return len(rows) > 1 and ":" not in text and all(CELL.search(row.strip(" ;|")) for row in rows)


def read_table(text: str, axes: Axes) -> tuple[Stretch, ...]:
    """Read rows `x; left; right; middle`: ordinates before and behind a place, and half-way to the next row.

    One ordinate stands for both sides; without a middle one the curve runs straight to the next row.

    Raises:
        AnswerSyntaxError: A cell that is no number, places that do not grow, too few or too many cells.
    """
    if len(text) > LONGEST:
        raise AnswerSyntaxError(Reason.TOO_LONG, LONGEST)
    rows = [row for row in _cells(text) if not _is_header(row)]
    if len(rows) > MOST + 1:
        raise AnswerSyntaxError(Reason.TOO_LONG, rows[MOST][0].place)
    if len(rows) < 2:
        raise AnswerSyntaxError(Reason.NEEDS_RANGE, 0, text[:20])
    return tuple(_between(one, other, axes) for one, other in pairwise(rows))


def _cells(text: str) -> Iterator[list[Piece]]:
    start = 0
    for line in text.split("\n"):
        row = Piece(line, start)
        start += len(line) + 1
        if row.text.strip():
            bare = row.bare
            framed = bare.text[0] == bare.text[-1] == "|"
            bare = bare.part(1, len(bare.text) - 1).bare if framed else bare
            marks = [-1, *(found.start() for found in CELL.finditer(bare.text)), len(bare.text)]
            cells = [bare.part(low + 1, high).bare for low, high in pairwise(marks)]
            yield cells


def _is_header(row: Sequence[Piece]) -> bool:
    return all(not cell.text[:1].isdigit() for cell in row) and row[0].text[:1] not in "-+−.,"


def _between(one: list[Piece], other: list[Piece], axes: Axes) -> Stretch:
    start, end = (_place(_amount(row[0], axes.x_unit), row[0], 0.0) for row in (one, other))
    if not end - start > SHORTEST:
        raise AnswerSyntaxError(Reason.NEEDS_RANGE, other[0].place, other[0].text[:20])
    for row in (one, other):
        if not 2 <= len(row) <= 4:
            raise AnswerSyntaxError(Reason.RAGGED_MATRIX, row[0].place)
    first = _amount(one[2] if len(one) > 2 and one[2].text else one[1], axes.unit).value
    last = _amount(other[1], axes.unit).value
    middle = (first + last) / 2
    if len(one) == 4 and one[3].text not in ABSENT:
        middle = _amount(one[3], axes.unit).value
    length = end - start
    bend = 2 * (first + last - 2 * middle) / length**2
    curve = (first, (last - first) / length - bend * length, bend)
    if not all(abs(c) < GREATEST for c in curve):
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, one[0].place)
    return Stretch(start, end, curve)
