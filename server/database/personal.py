"""All that is kept of one person, and erasing it in one transaction."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Any

from sqlalchemy import Column, ColumnElement, Connection, Select, Table, delete, or_, select, update

from server.database.audit import line_of, noting
from server.database.connections import Connections
from server.database.practice import MARKED, marked_of
from server.storage.audit import Entry
from server.storage.personal import Kept, Prune, Row
from server.storage.practice import Marked
from server.tables import (
    accommodations,
    api_tokens,
    audit,
    courses,
    deck,
    drafts,
    grades,
    groups,
    hints,
    links,
    marks,
    memberships,
    persons,
    problems,
    sessions,
    submissions,
    task_sets,
    variants,
)

TOLD = ("id", "login", "name", "role", "language", "theme", "active", "issuer", "subject", "created", "erased")


class Personal:
    """What one store keeps of people."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections

    async def kept(self, number: str) -> Kept | None:
        """Give all that is kept of a person."""
        return await self._connections.read(lambda connection: _kept(connection, number))

    async def erase(self, number: str, prune: Prune, entry: Entry) -> bool:
        """Erase a person; False where there is none. The work in sets stays under a number that is nobody's name."""
        return await self._connections.write(noting(lambda connection: _erase(connection, number, prune), entry))


def _kept(connection: Connection, number: str) -> Kept | None:
    person = _rows(connection, select(*_named(persons, *TOLD)).where(persons.c.id == number))
    if not person:
        return None
    mine, own = variants.c.owner == number, memberships.c
    named = select(courses.c.title, own.role, groups.c.name.label("group"), own.joined, own.claimed)
    placed = memberships.join(courses, own.course == courses.c.id).outerjoin(groups, own.group == groups.c.id)
    dealt = select(*_named(variants, "id", "exercise", "version", "seed", "created", "last_used"), deck.c.code)
    about = select(*_named(marks, "submission", "answer", "share", "comment", "time"))
    extra = select(task_sets.c.title.label("set"), *_named(accommodations, "minutes", "reason")).join(accommodations)
    typed = select(*_named(drafts, "variant", "answers", "time")).join(variants)
    opened = select(*_named(hints, "variant", "answer", "rung", "time")).join(variants)
    reported = select(*_named(problems, "variant", "text", "time"))
    return Kept(
        person=person[0],
        courses=_rows(connection, named.select_from(placed).where(own.person == number)),
        sessions=_rows(connection, _of(sessions, number, "created", "last_used", "expires", "agent")),
        tokens=_rows(connection, _of(api_tokens, number, "name", "role", "created", "expires", "revoked")),
        variants=_rows(connection, dealt.outerjoin(deck, deck.c.variant == variants.c.id).where(mine)),
        submissions=_submissions(connection, mine),
        drafts=_rows(connection, typed.where(mine)),
        problems=_rows(connection, reported.where(problems.c.owner == number)),
        hints=_rows(connection, opened.where(mine).order_by(hints.c.time)),
        marks=_rows(connection, about.where(marks.c.submission.in_(_receipts(mine))).order_by(marks.c.id)),
        extra=_rows(connection, extra.where(accommodations.c.person == number)),
        acts=[line_of(row) for row in connection.execute(_acts(number)).mappings()],
    )


def _rows(connection: Connection, query: Select[Any]) -> Sequence[Row]:
    return [dict(row) for row in connection.execute(query).mappings()]


def _named(table: Table, *names: str) -> list[Column[Any]]:
    return [table.c[name] for name in names]


def _of(table: Table, person: str, *names: str) -> Select[Any]:
    return select(*_named(table, *names)).where(table.c.person == person).order_by(table.c.created)


def _receipts(which: ColumnElement[bool]) -> Select[Any]:
    return select(submissions.c.receipt).join(variants, submissions.c.variant == variants.c.id).where(which)


def _submissions(connection: Connection, which: ColumnElement[bool]) -> list[Marked]:
    """Give submissions in the order received, each with its newest grade."""
    query = MARKED.where(submissions.c.receipt.in_(_receipts(which))).order_by(submissions.c.time, grades.c.id)
    newest = {row.receipt: marked_of(row) for row in connection.execute(query)}
    return list(newest.values())


def _acts(number: str) -> Select[Any]:
    return select(audit).where(or_(audit.c.actor == number, audit.c.object == number)).order_by(audit.c.id)


def _erase(connection: Connection, number: str, prune: Prune) -> bool:
    if connection.execute(select(persons.c.id).where(persons.c.id == number)).first() is None:
        return False
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("PRAGMA secure_delete=ON")  # what is deleted is overwritten in the file too
    bare = dict.fromkeys(("login", "password", "language", "theme", "issuer", "subject"))
    gone = {"name": number, "active": False, "erased": datetime.now(UTC), **bare}
    connection.execute(update(persons).where(persons.c.id == number).values(gone))
    own = variants.c.owner == number
    _forget_practice(connection, own & ~variants.c.id.in_(select(deck.c.variant).where(deck.c.variant.is_not(None))))
    _prune(connection, own, prune)
    kept = select(variants.c.id).where(own)
    connection.execute(delete(drafts).where(drafts.c.variant.in_(kept)))
    connection.execute(delete(problems).where(or_(problems.c.owner == number, problems.c.variant.in_(kept))))
    mine = _receipts(own)
    connection.execute(update(marks).where(marks.c.submission.in_(mine)).values(comment=""))
    connection.execute(update(grades).where(grades.c.submission.in_(mine)).values(reason=None))
    connection.execute(update(accommodations).where(accommodations.c.person == number).values(reason=""))
    connection.execute(update(task_sets).where(task_sets.c.changed_by == number).values(changed_by=None))
    for table in (memberships, sessions, api_tokens, links):
        connection.execute(delete(table).where(table.c.person == number))
    return True


def _forget_practice(connection: Connection, which: ColumnElement[bool]) -> None:
    """Delete practice that stands in no set, with all that hangs on it."""
    receipts, gone = _receipts(which), select(variants.c.id).where(which)
    for table in (marks, grades):
        connection.execute(delete(table).where(table.c.submission.in_(receipts)))
    connection.execute(delete(submissions).where(submissions.c.variant.in_(gone)))
    for table in (drafts, problems):
        connection.execute(delete(table).where(table.c.variant.in_(gone)))
    connection.execute(delete(variants).where(which))


def _prune(connection: Connection, which: ColumnElement[bool], prune: Prune) -> None:
    query = select(grades.c.id, grades.c.grade, *_named(submissions, "receipt", "answers")).join(submissions)
    rows = connection.execute(query.where(submissions.c.receipt.in_(_receipts(which))).order_by(grades.c.id)).all()
    for row in rows:  # the newest grade of a submission comes last and decides which answers stay
        answers, grade = prune(row.answers, row.grade)
        connection.execute(update(grades).where(grades.c.id == row.id).values(grade=grade))
        mine = submissions.c.receipt == row.receipt
        connection.execute(update(submissions).where(mine).values(answers=answers, key=None))
