"""The headings of a roster as universities export it, in three languages: which column holds what."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from server.web.errors import printable

INDEX = {
    "index", "index no", "index number", "student id", "student no", "student number", "id number",
    "matriculation number", "registration number", "indeks", "nr indeksu", "numer indeksu", "nr albumu", "numer albumu",
    "album", "номер", "номер студента", "номер зачетки", "зачетка", "номер зачетной книжки", "зачетная книжка",
    "зачетки", "зачетной книжки", "студенческого билета", "nr albumu studenta", "numer albumu studenta",
    "студенческий билет", "номер студенческого билета", "номер студенческого", "шифр",
}  # fmt: skip
LOGIN = {"login", "user", "username", "user name", "id", "identyfikator", "użytkownik", "логин"}
EMAIL = {
    "email", "e mail", "mail", "email address", "e mail address", "adres email", "adres e mail", "почта",
    "электронная почта", "эл почта",
}  # fmt: skip
LAST = {"last name", "lastname", "surname", "family name", "nazwisko", "фамилия"}
FIRST = {"first name", "firstname", "given name", "given names", "forename", "name", "imię", "imiona", "имя"}
FURTHER = {"middle name", "second name", "drugie imię", "imię 2", "имя отчество", "отчество"}
FULL = {
    "full name", "student name", "name and surname", "imię i nazwisko", "imiona i nazwisko", "nazwisko i imię",
    "nazwisko i imiona", "nazwisko imię", "фио", "ф и о", "имя и фамилия", "фамилия и имя", "фамилия имя",
    "фамилия имя отчество",
}  # fmt: skip
ALONE = FULL | FIRST | {"student", "студент", "osoba"}
GROUP = re.compile(r"(group|grupa|nr grupy|numer grupy|группа|подгруппа|номер группы)\b")


class Meaning(StrEnum):
    """What a column holds for us."""

    LOGIN = "login"
    SURNAME = "surname"
    NAME = "name"
    GROUP = "group"
    UNUSED = "unused"


@dataclass(frozen=True, slots=True)
class Column:
    """A column, counted from 1, its heading (empty where there is none) and what it holds."""

    number: int
    heading: str
    meaning: Meaning


IN_ORDER = tuple(Column(n, "", Meaning(one)) for n, one in enumerate(("login", "name", "group"), 1))


def understood(cells: Sequence[str]) -> tuple[Column, ...] | None:
    """Tell what the columns under some headings hold; None where the headings do not lead to students."""
    names = [_plain(cell) for cell in cells]
    login = next((found for known in (INDEX, LOGIN, EMAIL) for found in _among(names, known)), None)
    parts = _name(names)
    if login is None or not parts:
        return None
    group = next((at for at, name in enumerate(names) if GROUP.match(name)), None)
    meant = {**parts, login: Meaning.LOGIN}
    if group is not None:
        meant.setdefault(group, Meaning.GROUP)
    return tuple(Column(at + 1, printable(cell), meant.get(at, Meaning.UNUSED)) for at, cell in enumerate(cells))


def is_login(heading: str) -> bool:
    """Tell whether a cell is the heading of index numbers."""
    return _plain(heading) in INDEX | LOGIN | EMAIL


def _name(names: Sequence[str]) -> dict[int, Meaning]:
    """Find the columns that make up a name; a surname in a column of its own comes first in it, wherever it stands."""
    last, whole = _among(names, LAST), _among(names, FULL)
    if whole or not last:
        return dict.fromkeys((whole or _among(names, ALONE))[:1], Meaning.NAME)
    given = (*_among(names, FIRST)[:1], *_among(names, FURTHER)[:1])
    return {last[0]: Meaning.SURNAME, **dict.fromkeys(given, Meaning.NAME)}


def _among(names: Iterable[str], known: Collection[str]) -> list[int]:
    return [at for at, name in enumerate(names) if name in known]


def _plain(heading: str) -> str:
    """Give a heading without what is written in one way here and in another there: signs, brackets, letter case."""
    text = re.sub(r"\([^()]*\)", " ", heading[:200]).casefold().replace("ё", "е")
    return " ".join(re.sub(r"[^\w]|_", " ", text).split())
