"""Answers as a form sends them: one field an answer, or one field an entry of a matrix and its text twin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from urllib.parse import parse_qsl

from fastapi import Request

from exercises.presenting import Field
from server.errors import Refused

PREFIX = "answer."
MOST_FIELDS = 1000
KEY = "key"
GRIDS = ("matrix", "symbolic_matrix", "dh_table")  # kinds that are typed entry by entry


@dataclass(frozen=True, slots=True)
class Form:
    """The fields of a form that was posted."""

    values: Mapping[str, str]
    raw: bytes

    def answer(self, field: Field) -> str:
        """Give the text of one answer; for a grid the text twin goes before the grid."""
        text = self.values.get(PREFIX + field.name, "")
        if text.strip() or field.kind not in GRIDS:
            return text
        return join([[self.values.get(name, "") for name in row] for row in cell_names(field)])


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
    return Form(dict(pairs), raw)


def cell_names(field: Field) -> list[list[str]]:
    """Name the fields of a grid, such as ``answer.T.2.3``; rows and columns from 1."""
    columns = range(1, field.columns + 1)
    return [[f"{PREFIX}{field.name}.{row}.{column}" for column in columns] for row in range(1, field.rows + 1)]


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
