"""A table as students hand it in: CSV with any separator and decimal mark, columns in any order, or JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, TypeAlias

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import key, latin
from graders.units import fits, read_unit

Columns: TypeAlias = Sequence[Sequence[float]]

LARGEST = 500_000  # characters
MOST_ROWS = 10_000
MOST_COLUMNS = 24
GREATEST = 1e99
NUMBERS = re.compile(r"[-+0-9eE.;|,\t \n]*")
NUMBERING = ("nr", "no", "lp", "i", "#", "№", "n", "nr.", "lp.", "no.")
SPELLED = str.maketrans({"\ufeff": " ", "−": "-", "–": "-", "\u00a0": " ", "\u202f": " ", "\r": " "})
TIME, ANGLE, LENGTH = (0, 0, 1, 0, 0), (0, 0, 0, 1, 0), (1, 0, 0, 0, 0)
WORDS = {
    TIME: ("t", "time", "czas", "время"),
    ANGLE: ("angle", "kąt", "kat", "угол", "fi", "φ", "phi", "alpha", "alfa"),
    LENGTH: ("x", "s", "position", "displacement", "położenie", "polozenie", "przemieszczenie", "droga", "положение",
             "перемещение", "путь"),
    (1, 0, -1, 0, 0): ("v", "velocity", "speed", "prędkość", "predkosc", "скорость"),
    (1, 0, -2, 0, 0): ("a", "p", "acceleration", "przyspieszenie", "ускорение"),
    (0, 0, -1, 1, 0): ("ω", "omega", "angular velocity", "prędkość kątowa", "угловая скорость"),
    (0, 0, -2, 1, 0): ("ε", "epsilon", "eps", "angular acceleration", "przyspieszenie kątowe", "угловое ускорение"),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Column:
    """A column: its name, the unit printed for it, and the column of which it is the time derivative."""

    name: str
    unit: str
    rate_of: str = ""


@dataclass(frozen=True, slots=True)
class Table:
    """A table as read: the columns typed, by name, in SI units."""

    columns: Mapping[str, Sequence[float]]

    @property
    def rows(self) -> int:
        """The number of rows."""
        return len(next(iter(self.columns.values())))


def read_table(text: str, columns: Sequence[Column], abscissae: int) -> Table:
    """Read a table.

    Args:
        text: What is handed in.
        columns: The columns that mean something, the abscissae first.
        abscissae: How many of them may stand for the abscissa.

    Raises:
        AnswerSyntaxError: Too large, not a table, a column that means nothing or stands twice, a cell that is no
            number.
    """
    if len(text) > LARGEST:
        raise AnswerSyntaxError(Reason.TOO_LONG, LARGEST)
    plain = text.translate(SPELLED)
    if not plain.strip():
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    if text.lstrip()[:1] in "{[":
        return _table(*_json(text), columns, abscissae)
    first = plain.lstrip().partition("\n")[0]
    separator = _separator(first)
    named = not _is_number(first.split(separator)[0], separator)
    start = plain.index(first) + (len(first) if named else 0)
    values = _numbers(plain, start, separator)
    if named:
        names = [cell.strip().strip('"') for cell in first.strip().strip(separator or " ").split(separator)]
    else:
        names = _usual(values, columns, abscissae)
    return _table(names, values, columns, abscissae)


def _separator(line: str) -> str | None:
    """Find what parts the cells; None stands for blanks."""
    for mark in (";", "\t", "|"):
        if mark in line:
            return mark
    letters = any(c.isalpha() and c not in "eE" for c in line)
    return "," if "," in line and (letters or ", " in line or " " not in line.strip()) else None


def _is_number(cell: str, separator: str | None) -> bool:
    try:
        float(cell if separator == "," else cell.replace(",", "."))
    except ValueError:
        return False
    return True


def _numbers(plain: str, start: int, separator: str | None) -> Columns:
    """Read the cells at one go, and line by line only to tell what is wrong with them."""
    found = NUMBERS.match(plain, start)
    end = found.end() if found else start
    if end < len(plain):
        raise AnswerSyntaxError(Reason.NOT_A_TABLE, end, plain[end : end + 12].strip())
    body = plain[start:] if separator == "," else plain[start:].replace(",", ".")
    lines = [bare for line in body.split("\n") if (bare := line.strip(f"{separator or ''} \t"))]
    if len(lines) > MOST_ROWS:
        raise AnswerSyntaxError(Reason.TOO_LONG, start)
    if not lines:
        raise AnswerSyntaxError(Reason.NOT_A_TABLE, 0, plain.strip()[:12])
    width = len(lines[0].split(separator))
    for line in lines:
        if (line.count(separator) + 1 if separator else len(line.split())) != width:
            raise _misread(plain, line, start, Reason.RAGGED_MATRIX)
    try:
        cells = list(map(float, (separator or " ").join(lines).split(separator)))
    except ValueError:
        line = next(line for line in lines if not all(_is_number(cell, ",") for cell in line.split(separator)))
        raise _misread(plain, line, start, Reason.NOT_A_TABLE) from None
    if not max(map(abs, cells)) < GREATEST:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, start, lines[0][:20])
    return [cells[at::width] for at in range(width)]


def _misread(plain: str, line: str, start: int, reason: Reason) -> AnswerSyntaxError:
    """Find the line again in the text as typed."""
    place, wanted = start, line.replace(",", ".")
    for typed in plain[start:].split("\n"):
        found = typed.replace(",", ".").find(wanted)
        if found >= 0 and typed[:found].strip() == "" and typed[found + len(line) :].strip(" ;|\t") == "":
            return AnswerSyntaxError(reason, place + found, line[:20])
        place += len(typed) + 1
    return AnswerSyntaxError(reason, start, line[:20])


def _usual(values: Columns, columns: Sequence[Column], abscissae: int) -> list[str]:
    """Name the columns of a table without a head: the abscissa and the ordinates in the order asked for."""
    names = [column.name for column in columns]
    for usual in ([names[0], *names[abscissae:]], names):
        if len(values) == len(usual):
            return usual
    raise AnswerSyntaxError(Reason.NOT_A_TABLE, 0, "; ".join(f"{column[0]:g}" for column in values)[:20])


def _json(text: str) -> tuple[list[str], Columns]:
    """Read `{"t": [...], "x": [...]}` or `[{"t": 0, "x": 1}, ...]`."""
    try:
        held: Any = json.loads(text)
    except (ValueError, RecursionError):
        raise AnswerSyntaxError(Reason.NOT_A_TABLE, 0, text.strip()[:12]) from None
    if isinstance(held, list) and held and all(isinstance(row, dict) for row in held):
        names = list(held[0])
        cells = [[row.get(name) for row in held] for name in names]
    elif isinstance(held, dict) and held and all(isinstance(column, list) for column in held.values()):
        names = list(held)
        cells = list(held.values())
    else:
        raise AnswerSyntaxError(Reason.NOT_A_TABLE, 0, text.strip()[:12])
    if len({len(column) for column in cells}) != 1:
        raise AnswerSyntaxError(Reason.RAGGED_MATRIX, 0)
    if not 0 < len(cells[0]) <= MOST_ROWS:
        raise AnswerSyntaxError(Reason.TOO_LONG if cells[0] else Reason.NOT_A_TABLE, 0)
    return names, [_checked(column) for column in cells]


def _checked(cells: Sequence[Any]) -> list[float]:
    for cell in cells:
        if isinstance(cell, bool) or not isinstance(cell, int | float) or not abs(cell) < GREATEST:
            raise AnswerSyntaxError(Reason.NOT_A_NUMBER, 0, str(cell)[:12])
    return list(map(float, cells))


def _table(names: Sequence[str], values: Columns, columns: Sequence[Column], abscissae: int) -> Table:
    if len(names) != len(values) or len(names) > MOST_COLUMNS:
        raise AnswerSyntaxError(Reason.RAGGED_MATRIX, 0)
    found: dict[str, Sequence[float]] = {}
    for head, typed in zip(names, values, strict=True):
        if head.strip().lower() in NUMBERING:
            continue
        column, factor = _meant(head, columns, typed)
        if column.name in found:
            raise AnswerSyntaxError(Reason.REPEATED_ITEM, 0, column.name)
        found[column.name] = [factor * value for value in typed] if factor != 1.0 else typed
    if not any(column.name in found for column in columns[:abscissae]):
        raise AnswerSyntaxError(Reason.NO_SUCH_COLUMN, 0, columns[0].name)
    return Table(found)


def _meant(head: str, columns: Sequence[Column], typed: Sequence[float]) -> tuple[Column, float]:
    """Find the column of a heading such as `v [m/s]`, `x / mm`, `t, s` or `czas (s)`, and its factor to SI units."""
    cut = next((at for at, char in enumerate(head) if char in "[(/,"), len(head))
    name, unit = head[:cut].strip(), head[cut + 1 :].strip(" ])[(").strip()
    column = _named(name, columns)
    if column is None:
        raise AnswerSyntaxError(Reason.NO_SUCH_COLUMN, 0, head.strip()[:20])
    printed = read_unit(column.unit)
    if not unit or (_named(unit, columns) is not None and unit not in ("s",)):  # v(t) is no unit
        return column, 1.0 if _in_radians(column, typed) else printed.factor
    try:
        written = read_unit(unit)
    except AnswerSyntaxError as error:
        raise AnswerSyntaxError(Reason.UNKNOWN_UNIT, 0, unit[:12], error.proposal.meant) from None
    if not fits(written, printed):
        raise AnswerSyntaxError(Reason.UNKNOWN_UNIT, 0, unit[:12], column.unit)
    return column, written.factor


def _in_radians(column: Column, typed: Sequence[float]) -> bool:
    """Tell an angle without its unit that cannot be in degrees: a whole turn is 6.28 there, not 360."""
    return read_unit(column.unit).dimension == ANGLE and max(map(abs, typed)) < 2.2 * pi


def _named(name: str, columns: Sequence[Column]) -> Column | None:
    spellings = {key(name), key(latin(name)), key(name.lower())}
    for column in columns:
        if key(column.name) in spellings:
            return column
    for column in columns:
        words = WORDS.get(read_unit(column.unit).dimension, ())
        if name.lower() in words or key(name.lower()) in map(key, words):
            return column
    return None
