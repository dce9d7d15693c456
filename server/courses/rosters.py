"""A roster as a lecturer pastes or sends it: one student a line, under headings, or else index number; name; group."""

from __future__ import annotations

import codecs
import csv
from collections.abc import Sequence
from dataclasses import dataclass

from server.courses.headings import IN_ORDER, Column, Meaning, is_login, understood
from server.people.identity import login_of, name_of
from server.storage.courses import Row
from server.web.errors import Refused

MOST_ROWS = 1000
MOST_GROUP = 80
PEEKED = 4096  # bytes by which UTF-16 is told
SPREADSHEETS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")  # how XLSX and ODS begin, and XLS
NEAR = 15  # lines from the top, among which the headings stand
PAGES = ("cp1250", "cp1251")  # of Windows


@dataclass(frozen=True, slots=True)
class Unread:
    """A line that cannot be used, counted from 1, and the code of the reason; the line above that has its login."""

    line: int
    code: str
    repeats: int | None = None


@dataclass(frozen=True, slots=True)
class Repeated:
    """A line that says the same as another one above it, and is passed over."""

    line: int
    repeats: int


@dataclass(frozen=True, slots=True)
class Reading:
    """What was read of a roster: its students, lines that cannot be used, what the columns hold, the lines above
    the headings, which say nothing of students, and those that only repeat another line."""

    rows: tuple[Row, ...]
    unread: tuple[Unread, ...]
    columns: tuple[Column, ...]
    above: tuple[int, ...]
    repeated: tuple[Repeated, ...] = ()


def decoded(raw: bytes, language: str) -> str:
    """Give the text of a file as spreadsheets write it: UTF-8, UTF-16, or a code page of Windows.

    Of the pages, it is the one by which more headings are understood, else that of the course's language.

    Raises:
        Refused: 422, it is no text, such as a spreadsheet that was not saved as CSV.
    """
    if raw.startswith(SPREADSHEETS):
        raise Refused(422, "roster_spreadsheet", field="file")
    try:
        return raw.decode(_encoding(raw, language))
    except UnicodeDecodeError:
        raise Refused(422, "roster_encoding", field="file") from None


def _encoding(raw: bytes, language: str) -> str:
    if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    for start, wide in ((1, "utf-16-le"), (0, "utf-16-be")):  # digits and separators have an empty half
        half = raw[start:PEEKED:2]
        if half and half.count(0) * 4 > len(half):
            return wide
    try:
        raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        return _page(raw, language)
    return "utf-8-sig"


def _page(raw: bytes, language: str) -> str:
    pages = PAGES[::-1] if language == "ru" else PAGES
    return max(pages, key=lambda page: _understood(raw[:PEEKED].decode(page, "replace")))


def _understood(text: str) -> int:
    """Count the headings that are understood."""
    lines = text.splitlines()
    columns = _headed(lines, _delimiter(lines))[1]
    return sum(one.meaning is not Meaning.UNUSED for one in columns if one.heading)


def read(text: str) -> Reading:
    """Read a roster with commas, semicolons or tabs between the columns, under headings or index; name; group.

    Raises:
        Refused: 422, there are too many lines.
    """
    lines = text.removeprefix("\ufeff").splitlines()
    if len(lines) > MOST_ROWS:
        raise Refused(422, "long_roster", field="roster", most=MOST_ROWS)
    delimiter = _delimiter(lines)
    begin, columns = _headed(lines, delimiter)
    students: list[tuple[int, Row]] = []
    unread: list[Unread] = []
    filled: set[int] = set()
    for number, line in enumerate(lines[begin:], begin + 1):
        try:
            cells = _cells(line, delimiter)
            filled |= {at for at, cell in enumerate(cells, 1) if cell}
            if any(cells):
                students.append((number, _row(cells, columns)))
        except Refused as refused:
            unread.append(Unread(number, refused.code))
    rows, twice, repeated = _once(students)
    above = [number for number, line in enumerate(lines[: max(0, begin - 1)], 1) if line.strip(" ;,\t")]
    told = [one for one in columns if one.number in filled or one.heading]
    unusable = sorted([*unread, *twice], key=lambda one: one.line)
    return Reading(rows, tuple(unusable), tuple(told), tuple(above), repeated)


def _once(students: Sequence[tuple[int, Row]]) -> tuple[tuple[Row, ...], list[Unread], tuple[Repeated, ...]]:
    """Take each login once; a line that says of it what another one said, and no more, does no harm."""
    first: dict[str, tuple[int, Row]] = {}
    twice: list[Unread] = []
    repeated: list[Repeated] = []
    for number, row in students:
        line, known = first.setdefault(row.login, (number, row))
        if known != row:
            twice.append(Unread(number, "twice_in_roster", line))
        elif line != number:
            repeated.append(Repeated(number, line))
    return tuple(row for _, row in first.values()), twice, tuple(repeated)


def _headed(lines: Sequence[str], delimiter: str) -> tuple[int, tuple[Column, ...]]:
    """Find the headings near the top; gives how many lines they end, and what the columns hold."""
    first = None
    for number, line in enumerate(lines[:NEAR], 1):
        cells = _parted(line, delimiter)
        columns = understood(cells)
        if columns is not None:
            return number, columns
        if first is None and any(cells):
            first = number if is_login(cells[0]) else 0
    return first or 0, IN_ORDER


def _parted(line: str, delimiter: str) -> list[str]:
    try:
        return _cells(line, delimiter) or [""]
    except Refused:
        return [""]


def _delimiter(lines: Sequence[str]) -> str:
    top = "".join(lines[:NEAR])
    return max(";\t,", key=top.count)


def _cells(line: str, delimiter: str) -> list[str]:
    """Part a line; a quotation mark that is not closed in it does not swallow the lines that follow."""
    try:
        return [cell.strip() for cells in csv.reader([line], delimiter=delimiter, strict=True) for cell in cells]
    except csv.Error:
        raise Refused(422, "bad_quotes") from None


def _row(cells: Sequence[str], columns: Sequence[Column]) -> Row:
    if any(cells[len(columns) :]):
        raise Refused(422, "many_columns" if columns is IN_ORDER else "surplus_cells")
    login = login_of(_held(cells, columns, Meaning.LOGIN))
    name = name_of(" ".join(filter(None, (_held(cells, columns, one) for one in (Meaning.SURNAME, Meaning.NAME)))))
    group = _held(cells, columns, Meaning.GROUP)
    if group and (len(group) > MOST_GROUP or not group.isprintable() or group[0] in "=+-@"):
        raise Refused(422, "bad_group")
    return Row(login, name, group)


def _held(cells: Sequence[str], columns: Sequence[Column], meaning: Meaning) -> str:
    held = (cells[one.number - 1] for one in columns if one.meaning is meaning and one.number <= len(cells))
    return " ".join(word for cell in held for word in cell.split())
