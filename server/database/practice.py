"""Owners, variants, submissions and their grades."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from typing import Any

from sqlalchemy import Connection, Row, Select, bindparam, delete, exists, func, insert, select, text, update

from server.database import work
from server.database.connections import Connections
from server.database.once import insert_once
from server.migrations import newest
from server.sets.rules import same
from server.storage import (
    Answers,
    Dealt,
    Draft,
    Handed,
    KeyReused,
    Marked,
    Owner,
    Problem,
    StorageUnavailable,
    UnknownVariant,
)
from server.tables import deck, drafts, grades, owners, problems, submissions, variants

EARLIER = 20  # submissions with which a new one is compared
VARIANT = (
    select(variants, owners.c.anonymous, deck.c.code)
    .join(owners)
    .outerjoin(deck, deck.c.variant == variants.c.id)
    .where(variants.c.id == bindparam("number"))
)
MARKED: Select[Any] = (
    select(submissions, grades.c.grade, grades.c.counted, grades.c.grader_version, deck.c.code)
    .join(grades)
    .outerjoin(deck, deck.c.variant == submissions.c.variant)
)
COUNTED = (
    select(submissions.c.answers)
    .join(grades)
    .where(submissions.c.variant == bindparam("variant"), grades.c.counted)
    .order_by(submissions.c.time.desc())
    .limit(EARLIER)
)
TOUCH = update(variants).where(variants.c.id == bindparam("number")).values(last_used=bindparam("time"))


class Practice:
    """What is practised, in SQLite or PostgreSQL."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections

    async def keep_variant(self, variant: Dealt) -> None:
        """Store a new variant, and its owner if new."""
        await self._connections.write(lambda connection: _keep_variant(connection, variant))

    async def variant(self, number: str) -> Dealt | None:
        """Give a variant."""
        row = await self._connections.read(lambda connection: connection.execute(VARIANT, {"number": number}).first())
        return None if row is None else _dealt(row)

    async def touch(self, number: str, time: datetime) -> None:
        """Note that a variant was used."""
        await self._connections.write(lambda connection: _touch(connection, number, time))

    async def keep_submission(self, marked: Marked) -> tuple[Marked, bool]:
        """Store a submission with its grade, once for each key."""
        return await self._connections.write(lambda connection: keep_submission(connection, marked))

    async def submission(self, receipt: str) -> Marked | None:
        """Give a submission with its newest grade."""
        query = MARKED.where(submissions.c.receipt == receipt).order_by(grades.c.id.desc())
        return await self._connections.read(lambda connection: _one(connection, query))

    async def keyed(self, owner: str, variant: str, key: str, body: str) -> Marked | None:
        """Give the submission that a key stands for."""
        return await self._connections.read(lambda connection: _keyed(connection, owner, variant, key, body))

    async def latest(self, variant: str) -> Marked | None:
        """Give the last submission to a variant."""
        newest = submissions.c.time.desc(), submissions.c.receipt, grades.c.id.desc()
        query = MARKED.where(submissions.c.variant == variant).order_by(*newest)
        return await self._connections.read(lambda connection: _one(connection, query))

    async def counted(self, variant: str) -> bool:
        """Tell whether some submission to a variant counted."""
        mine = submissions.c.variant == variant, grades.c.counted
        query = select(grades.c.id).join(submissions).where(*mine).limit(1)
        return await self._connections.read(lambda connection: connection.execute(query).first()) is not None

    async def keep_draft(self, draft: Draft) -> tuple[Draft, bool]:
        """Store a draft over the revision before it."""
        return await self._connections.write(lambda connection: _keep_draft(connection, draft))

    async def draft(self, variant: str) -> Draft | None:
        """Give the draft of a variant."""
        return await self._connections.read(lambda connection: work.draft(connection, variant))

    async def keep_problem(self, problem: Problem, most: int) -> bool:
        """Store a reported problem, unless so many of its variant are open already; tells whether it is stored."""
        return await self._connections.write(lambda connection: work.keep_problem(connection, problem, most))

    async def problems(self, before: datetime, number: int, teacher: str | None) -> list[Problem]:
        """Give the open problems reported before a moment, the newest first."""
        return await self._connections.read(lambda connection: work.open_problems(connection, before, number, teacher))

    async def settle_problem(self, number: str, time: datetime, teacher: str | None) -> bool:
        """Note that a problem is settled; tells whether there was such an open one for this teacher."""
        return await self._connections.write(lambda connection: work.settle_problem(connection, number, time, teacher))

    async def purge(self, before: datetime) -> int:
        """Forget anonymous variants that were last used before a moment and of which no problem is open."""
        return await self._connections.write(lambda connection: _purge(connection, before))

    async def practised(self, owner: str) -> int:
        """Tell how many variants an owner has."""
        query = select(func.count()).select_from(variants).where(variants.c.owner == owner)
        return await self._connections.read(lambda connection: connection.execute(query).scalar_one())

    async def take_over(self, anonymous: str, person: str) -> int:
        """Give the variants of an anonymous owner to a person; gives how many."""
        nobody = select(owners.c.id).where(owners.c.id == anonymous, owners.c.anonymous)
        change = update(variants).where(variants.c.owner.in_(nobody)).values(owner=person)
        return await self._connections.write(lambda connection: connection.execute(change).rowcount)

    async def check(self) -> None:
        """Raise StorageUnavailable unless the store answers, has the tables of this version or of a later one, and
        takes a write."""
        if (await self._connections.read(_version)) < newest():
            raise StorageUnavailable("the store lacks migrations")
        await self._connections.prove()

    def failures(self) -> int:
        """Tell how many pieces the store could not write since it was opened."""
        return self._connections.failures()


def _version(connection: Connection) -> str:
    return str(connection.execute(text("SELECT version_num FROM alembic_version")).scalar_one())


def _keep_variant(connection: Connection, variant: Dealt) -> None:
    owner = {"id": variant.owner.id, "anonymous": variant.owner.anonymous, "created": variant.created}
    insert_once(connection, owners, owner)
    values = {column.name: getattr(variant, column.name) for column in variants.columns}
    connection.execute(insert(variants), values | {"owner": variant.owner.id})


def _touch(connection: Connection, number: str, time: datetime) -> bool:
    return connection.execute(TOUCH, {"number": number, "time": time}).rowcount == 1


def _keep_draft(connection: Connection, draft: Draft) -> tuple[Draft, bool]:
    if not _touch(connection, draft.variant, draft.time):
        raise UnknownVariant(draft.variant)
    return work.keep_draft(connection, draft)


def keep_submission(connection: Connection, marked: Marked) -> tuple[Marked, bool]:
    """Store a submission with its grade, once for each key; the same answers again are stored, but do not count."""
    handed = marked.handed
    if not _touch(connection, handed.variant, handed.time):
        raise UnknownVariant(handed.variant)
    earlier = _counted(connection, handed.variant) if marked.counted else []
    if not insert_once(connection, submissions, _columns(handed)):
        return _first(connection, handed), True
    if any(same(handed.answers, one) for one in earlier):
        marked = replace(marked, counted=False)
    line = {"submission": handed.receipt, "grader_version": marked.grader_version, "grade": marked.grade}
    connection.execute(insert(grades), line | {"counted": marked.counted, "time": handed.time})
    work.close_draft(connection, handed.variant, handed.answers, handed.time)
    return marked, False


def _counted(connection: Connection, variant: str) -> list[Answers]:
    """Give the newest answers to a variant that counted."""
    return list(connection.execute(COUNTED, {"variant": variant}).scalars())


def _columns(handed: Handed) -> dict[str, Any]:
    return {column.name: getattr(handed, column.name) for column in submissions.columns}


def _first(connection: Connection, handed: Handed) -> Marked:
    """What the key stands for already."""
    first = _keyed(connection, handed.owner, handed.variant, handed.key, handed.body)
    if first is None:
        raise StorageUnavailable("the receipt's number is taken")
    return first


def _keyed(connection: Connection, owner: str, variant: str, key: str | None, body: str) -> Marked | None:
    mine = submissions.c.owner == owner, submissions.c.variant == variant, submissions.c.key == key
    found = _one(connection, MARKED.where(*mine).order_by(grades.c.id))
    if found is not None and found.handed.body != body:
        raise KeyReused(key)
    return found


def _purge(connection: Connection, before: datetime) -> int:
    reported = select(problems.c.variant).where(problems.c.settled.is_(None))
    left = variants.c.last_used < before, variants.c.id.not_in(reported)
    idle = select(variants.c.id).join(owners).where(owners.c.anonymous, *left)
    handed_in = select(submissions.c.receipt).where(submissions.c.variant.in_(idle))
    connection.execute(delete(grades).where(grades.c.submission.in_(handed_in)))
    connection.execute(delete(submissions).where(submissions.c.variant.in_(idle)))
    for table in (drafts, problems):
        connection.execute(delete(table).where(table.c.variant.in_(idle)))
    gone = connection.execute(delete(variants).where(variants.c.id.in_(idle))).rowcount
    bare = (~exists().where(table.c.owner == owners.c.id) for table in (variants, submissions, problems))
    connection.execute(delete(owners).where(owners.c.anonymous, owners.c.created < before, *bare))
    return gone


def _one(connection: Connection, query: Select[Any]) -> Marked | None:
    row = connection.execute(query.limit(1)).first()
    return None if row is None else marked_of(row)


def marked_of(row: Row[Any]) -> Marked:
    """Make a submission with its grade of a row of `MARKED`."""
    values = row._mapping
    handed = Handed(**{column.name: values[column.name] for column in submissions.columns})
    return Marked(handed, values["grade"], values["counted"], values["grader_version"], values["code"])


def _dealt(row: Row[Any]) -> Dealt:
    values = dict(row._mapping)
    owner = Owner(values.pop("owner"), values.pop("anonymous"))
    return Dealt(owner=owner, **values)
