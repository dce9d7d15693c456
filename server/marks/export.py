"""Marks as a table for other programs: CSV for either kind of spreadsheet, and XLSX. No cell can become a formula."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from server.marks.gradebook import Cell, Gradebook, Row
from server.marks.totals import totals
from server.web.language import say
from server.web.templating import decimal

Form: TypeAlias = Literal["csv", "xlsx"]
Separator: TypeAlias = Literal["comma", "semicolon"]
Value: TypeAlias = str | float | None
MEDIA = {
    "csv": "text/csv; charset=utf-8",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
}
FORMULA = frozenset("=+-@＝＋－＠")  # how a cell begins that a spreadsheet would compute


@dataclass(frozen=True, slots=True)
class Table:
    """A table of marks; what was never judged is empty, which is not nought."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[Value, ...], ...]


def of_set(book: Gradebook, course: str, language: str) -> Table:
    """Write the marks of a set: a column a task."""
    slots = book.task_set.slots
    tasks = [
        say(language, "marks.export_item", number=slot.number, points=decimal(language, slot.points)) for slot in slots
    ]
    rows = [
        (
            *_who(course, row), book.task_set.title, *map(_points, row.cells), *_taken_off([row]),
            row.points, book.worth, row.share, *_flags(language, [row]),
        )
        for row in book.rows
    ]  # fmt: skip
    header = (*_head(language), say(language, "marks.export_set"), *tasks, *_tail(language, share=True))
    return Table(say(language, "marks.results"), header, tuple(rows))


def of_course(books: Sequence[Gradebook], course: str, language: str) -> Table:
    """Write the marks of a course: a column a set; what second chances change stands in a column of its own."""
    whole = totals(books)
    titles = [f"{one.task_set.title} ({decimal(language, one.worth)})" for one in books]
    rows = [
        (
            *_who(course, one.rows[0]), *(row.points if row.taken else None for row in one.rows),
            *_taken_off([one.rows[number] for number in whole.firsts]), *([one.weighed] if whole.chances else []),
            one.points, whole.worth, *_flags(language, one.rows),
        )
        for one in whole.students
    ]  # fmt: skip
    header = (*_head(language), *titles, *_tail(language, share=False, chances=whole.chances))
    return Table(say(language, "marks.results"), header, tuple(rows))


def written(table: Table, form: Form, separator: Separator) -> bytes:
    """Write a table as a file."""
    return _xlsx(table) if form == "xlsx" else _csv(table, separator)


def inert(text: str) -> str:
    """Give a text that no spreadsheet takes for a formula: one that begins like a formula gets an apostrophe."""
    first = next((sign for sign in text if sign.isprintable() and not sign.isspace()), "")
    return f"'{text}" if first in FORMULA or text.startswith(("\t", "\r", "\n")) else text


def _csv(table: Table, separator: Separator) -> bytes:
    """Write CSV with a byte order mark; where semicolons part the cells, numbers have a decimal comma."""
    held = io.StringIO(newline="")
    lines = csv.writer(held, delimiter="," if separator == "comma" else ";", lineterminator="\r\n")
    lines.writerow(map(inert, table.header))
    lines.writerows([_text(value, separator) for value in row] for row in table.rows)
    return held.getvalue().encode("utf-8-sig")


def _text(value: Value, separator: Separator) -> str:
    if isinstance(value, str):
        return inert(value)
    number = "" if value is None else f"{value:.6f}".rstrip("0").rstrip(".")
    return number if separator == "comma" else number.replace(".", ",")


def _xlsx(table: Table) -> bytes:
    from openpyxl import Workbook  # it takes a while to load, and few requests need it
    from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE

    book = Workbook(write_only=True)
    sheet = book.create_sheet(table.title)
    for row in (table.header, *table.rows):
        sheet.append([ILLEGAL_CHARACTERS_RE.sub("", inert(one)) if isinstance(one, str) else one for one in row])
    held = io.BytesIO()
    book.save(held)
    return held.getvalue()


def _head(language: str) -> tuple[str, ...]:
    own = ("marks.export_course", "courses.group", "marks.export_login", "people.name")
    return tuple(say(language, key) for key in own)


def _tail(language: str, *, share: bool, chances: bool = False) -> tuple[str, ...]:
    own = (
        "before",
        "late_loss",
        "hint_loss",
        *(["second_chance"] if chances else []),
        "points",
        "worth",
        *(["share"] if share else []),
        "late",
        "provisional",
        "by_hand",
        "left",
    )
    return tuple(say(language, f"marks.export_{name}") for name in own)


def _who(course: str, row: Row) -> tuple[str, ...]:
    person = row.member.person
    return course, row.group, person.login or "", person.name


def _points(cell: Cell) -> Value:
    return None if cell.share is None else cell.points


def _taken_off(rows: Sequence[Row]) -> tuple[Value, ...]:
    """Give the points before anything was taken off, and what lateness and hints at a price took off."""
    parts = ([getattr(row, name) for row in rows] for name in ("before", "late_loss", "hint_loss"))
    return tuple(round(sum(part), 3) for part in parts)


def _flags(language: str, rows: Sequence[Row]) -> tuple[str, ...]:
    cells = [cell for row in rows for cell in row.cells]
    told = any(c.late for c in cells), any(c.provisional for c in cells), any(c.by_hand for c in cells), rows[0].left
    return tuple(say(language, "audit.value_true" if one else "audit.value_false") for one in told)
