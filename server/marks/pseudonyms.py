"""Marks for research: in the place of each person stands a pseudonym, the same in every export of one server."""

from __future__ import annotations

import hmac
from collections.abc import Sequence
from dataclasses import replace
from hashlib import sha256

from server.marks.gradebook import Gradebook, Row
from server.storage.people import Person

SIGNS = 12  # of a pseudonym: 48 bits


def hidden(books: Sequence[Gradebook], secret: bytes) -> list[Gradebook]:
    """Give gradebooks that name nobody; their order says nothing of names either.

    Args:
        books: Gradebooks of one course.
        secret: The server's; who has it can find the person of a pseudonym, nobody else.
    """
    return [replace(book, rows=_hidden(book.rows, secret)) for book in books]


def _hidden(rows: Sequence[Row], secret: bytes) -> tuple[Row, ...]:
    return tuple(sorted((_unnamed(row, secret) for row in rows), key=lambda row: row.member.person.name))


def _unnamed(row: Row, secret: bytes) -> Row:
    person = row.member.person
    return replace(row, member=replace(row.member, person=replace(person, login=None, name=pseudonym(person, secret))))


def pseudonym(person: Person, secret: bytes) -> str:
    """Name a person without saying who it is."""
    return hmac.new(secret, b"pseudonym " + person.id.encode(), sha256).hexdigest()[:SIGNS]
