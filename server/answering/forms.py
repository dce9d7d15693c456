"""Answers as a form sends them: one field an answer, or one field an entry of a matrix and its text twin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from urllib.parse import parse_qsl

from fastapi import Request

from exercises.presenting import Field
from server.web.errors import Refused

PREFIX = "answer."
MOST_FIELDS = 2000  # the builder has 1,400 where 50 tasks offer every exercise
KEY = "key"
GRIDS = ("matrix", "symbolic_matrix", "dh_table")  # kinds that are typed entry by entry
TABLES = {"diagram": (12, 4)}  # kinds that are typed row by row, as long as they need: most rows, and columns
BY_CELLS = (*GRIDS, *TABLES)


@dataclass(frozen=True, slots=True)
class Form:
    """The fields of a form that was posted."""

    values: Mapping[str, str]
    every: Mapping[str, list[str]]  # all values of a name, as of the boxes ticked
    raw: bytes

    def answer(self, field: Field) -> str:
        """Give the text of one answer; for a grid or a table the text twin goes before it."""
        text = "; ".join(self.every.get(PREFIX + field.name, ()))
        if text.strip() or field.kind not in BY_CELLS:
            return text
        cells = [[self.values.get(name, "") for name in row] for row in cell_names(field)]
        return join_table(cells) if field.kind in TABLES else join(cells)


async def read(request: Request) -> Form:
    """Read a posted form.

    Raises:
        Refused: 422, the body is no form.
    """
    raw = await request.body()
    if not request.headers.get("content-type", "").startswith("application/x-www-form-urlencoded"):
        raise Refused(422, "not_a_form")
    try:
        pairs = parse_qsl(raw.decode("utf-8"), keep_blank_values=True, max_num_fields=MOST_FIELDS)
    except ValueError:
        raise Refused(422, "not_a_form") from None
    every: dict[str, list[str]] = {}
    for name, value in pairs:
        every.setdefault(name, []).append(value)
    return Form(dict(pairs), every, raw)


def cell_names(field: Field) -> list[list[str]]:
    """Name the fields of a grid, such as ``answer.T.2.3``; rows and columns from 1."""
    rows, columns = TABLES.get(field.kind, (field.rows, field.columns))
    return [[f"{PREFIX}{field.name}.{row + 1}.{column + 1}" for column in range(columns)] for row in range(rows)]


def apart(field: Field, text: str) -> list[list[str]] | None:
    """Give the cells that are typed as a text; None for a text that was written otherwise."""
    if field.kind in TABLES:
        return split_table(text, *TABLES[field.kind])
    return split(text, field.rows, field.columns)


def join(cells: list[list[str]]) -> str:
    """Write a grid in the answer language; semicolons part the entries, so a comma stays a decimal comma."""
    rows = [[entry.strip() for entry in row] for row in cells]
    if not any(map(any, rows)):
        return ""
    if len(rows[0]) == 1:
        return f"[{'; '.join(row[0] for row in rows)}]"
    return f"[{', '.join('[' + '; '.join(row) + ']' for row in rows)}]"


def split(text: str, rows: int, columns: int) -> list[list[str]] | None:
    """Take a text that `join` has written apart again; None for any other text."""
    inner = text.strip()[1:-1].strip()
    if columns == 1:
        found = [[entry.strip()] for entry in inner.split(";")]
    else:
        found = [[entry.strip() for entry in row.split(";")] for row in inner[1:-1].split("], [")]
    fits = len(found) == rows and all(len(row) == columns for row in found)
    return found if fits and join(found) == text else None


def join_table(cells: list[list[str]]) -> str:
    """Write a table line by line; rows that are empty and empty cells at the end of a row are left out."""
    rows = [[entry.strip() for entry in row] for row in cells]
    return "\n".join("; ".join(row[: max(2, _used(row))]) for row in rows if any(row))


def _used(row: list[str]) -> int:
    return max(place for place, entry in enumerate(row, 1) if entry)


def split_table(text: str, rows: int, columns: int) -> list[list[str]] | None:
    """Take a text that `join_table` has written apart again, filled up with empty cells; None for any other text."""
    lines = [[entry.strip() for entry in line.split(";")] for line in text.split("\n")]
    if len(lines) > rows or any(len(line) > columns for line in lines):
        return None
    found = [line + [""] * (columns - len(line)) for line in lines]
    found += [[""] * columns for _ in range(rows - len(found))]
    return found if join_table(found) == text else None
