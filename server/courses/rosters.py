"""A roster as a lecturer pastes or sends it: one student a line, index number; name; group."""

from __future__ import annotations

import codecs
import csv
from collections.abc import Sequence
from dataclasses import dataclass

from server.people.identity import login_of, name_of
from server.storage.courses import Row
from server.web.errors import Refused

MOST_ROWS = 1000
MOST_GROUP = 80
PEEKED = 4096  # bytes by which UTF-16 is told
SPREADSHEETS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")  # how XLSX and ODS begin, and XLS
HEADINGS = {"index", "login", "indeks", "nr indeksu", "e-mail", "номер", "логин"}


@dataclass(frozen=True, slots=True)
class Unread:
    """A line that cannot be used, counted from 1, and the code of the reason."""

    line: int
    code: str


def decoded(raw: bytes, language: str) -> str:
    """Give the text of a file as spreadsheets write it: UTF-8, UTF-16, or the code page of the course's language.

    Raises:
        Refused: 422, it is no text, such as a spreadsheet that was not saved as CSV.
    """
    if raw.startswith(SPREADSHEETS):
        raise Refused(422, "roster_spreadsheet", field="file")
    try:
        return raw.decode(_encoding(raw, "cp1251" if language == "ru" else "cp1250"))
    except UnicodeDecodeError:
        raise Refused(422, "roster_encoding", field="file") from None


def _encoding(raw: bytes, page: str) -> str:
    if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    for start, wide in ((1, "utf-16-le"), (0, "utf-16-be")):  # digits and separators have an empty half
        half = raw[start:PEEKED:2]
        if half and half.count(0) * 4 > len(half):
            return wide
    try:
        raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        return page
    return "utf-8-sig"


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
    delimiter = _delimiter(lines)
    for number, line in enumerate(lines, 1):
        try:
            cells = _cells(line, delimiter)
            if not any(cells) or (number == 1 and cells[0].casefold() in HEADINGS):
                continue
            rows.append(_row(cells, rows))
        except Refused as refused:
            unread.append(Unread(number, refused.code))
    return rows, unread


def _delimiter(lines: Sequence[str]) -> str:
    first = next((line for line in lines if line.strip()), "")
    return max(";,\t", key=first.count)


def _cells(line: str, delimiter: str) -> list[str]:
    """Part a line; a quotation mark that is not closed in it does not swallow the lines that follow."""
    try:
        return [cell.strip() for cells in csv.reader([line], delimiter=delimiter, strict=True) for cell in cells]
    except csv.Error:
        raise Refused(422, "bad_quotes") from None


def _row(cells: Sequence[str], before: Sequence[Row]) -> Row:
    if any(cells[3:]):
        raise Refused(422, "many_columns")
    login = login_of(cells[0])
    name = name_of(cells[1] if len(cells) > 1 else "")
    group = " ".join(cells[2].split()) if len(cells) > 2 else ""
    if group and (len(group) > MOST_GROUP or not group.isprintable() or group[0] in "=+-@"):
        raise Refused(422, "bad_group")
    if any(row.login == login for row in before):
        raise Refused(422, "twice_in_roster")
    return Row(login, name, group)
