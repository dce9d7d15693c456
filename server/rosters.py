"""A roster as a lecturer pastes it: one student a line, index number; name; group."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass

from server.errors import Refused
from server.identity import login_of, name_of
from server.storage.courses import Row

MOST_ROWS = 1000
MOST_GROUP = 80
HEADINGS = {"index", "login", "indeks", "nr indeksu", "e-mail", "номер", "логин"}


@dataclass(frozen=True, slots=True)
class Unread:
    """A line that cannot be used, counted from 1, and the code of the reason."""

    line: int
    code: str


def read(text: str) -> tuple[list[Row], list[Unread]]:
    """Read a roster with commas, semicolons or tabs between the columns.

    Raises:
        Refused: 422, there are too many lines.
    """
    lines = text.removeprefix("\ufeff").splitlines()
    if len(lines) > MOST_ROWS:
        raise Refused(422, "long_roster", field="roster", most=MOST_ROWS)
    rows: list[Row] = []
    unread: list[Unread] = []
    for number, cells in enumerate(csv.reader(lines, delimiter=_delimiter(lines)), 1):
        cells = [cell.strip() for cell in cells]
        if not any(cells) or (number == 1 and cells[0].casefold() in HEADINGS):
            continue
        try:
            rows.append(_row(cells, rows))
        except Refused as refused:
            unread.append(Unread(number, refused.code))
    return rows, unread


def _delimiter(lines: Sequence[str]) -> str:
    first = next((line for line in lines if line.strip()), "")
    return max(";,\t", key=first.count)


def _row(cells: Sequence[str], before: Sequence[Row]) -> Row:
    login = login_of(cells[0])
    name = name_of(cells[1] if len(cells) > 1 else "")
    group = " ".join(cells[2].split()) if len(cells) > 2 else ""
    if group and (len(group) > MOST_GROUP or not group.isprintable() or group[0] in "=+-@"):
        raise Refused(422, "bad_group")
    if any(row.login == login for row in before):
        raise Refused(422, "twice_in_roster")
    return Row(login, name, group)
