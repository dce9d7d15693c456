"""The store in a relational database: the same code on SQLite and on PostgreSQL."""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from typing import Any, TypeVar

from sqlalchemy import Connection, Row, Select, Table, bindparam, delete, insert, select, update
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.exc import SQLAlchemyError

from server.engine import READERS, engine
from server.storage import Dealt, Handed, KeyReused, Marked, Owner, StorageUnavailable, UnknownVariant
from server.tables import grades, owners, settings, submissions, variants
from server.writer import Writer

T = TypeVar("T")
SECRET_BYTES = 32
VARIANT = select(variants, owners.c.anonymous).join(owners).where(variants.c.id == bindparam("number"))
TOUCH = update(variants).where(variants.c.id == bindparam("number")).values(last_used=bindparam("time"))
ONCE = (settings, owners, submissions)
INSERT_ONCE = {
    **{("sqlite", table.name): sqlite.insert(table).on_conflict_do_nothing() for table in ONCE},
    **{("postgresql", table.name): postgresql.insert(table).on_conflict_do_nothing() for table in ONCE},
}


class Database:
    """A store in SQLite or PostgreSQL; the writer and the readers have connections of their own."""

    def __init__(self, url: str) -> None:
        self._writing = engine(url, connections=1, begin="BEGIN IMMEDIATE")
        self._reading = engine(url, connections=READERS)
        self._writer = Writer(self._writing)
        self._readers = ThreadPoolExecutor(READERS, "reader")

    async def keep_variant(self, variant: Dealt) -> None:
        """Store a new variant, and its owner if new."""
        await self._write(lambda connection: _keep_variant(connection, variant))

    async def variant(self, number: str) -> Dealt | None:
        """Give a variant."""
        row = await self._read(lambda connection: connection.execute(VARIANT, {"number": number}).first())
        return None if row is None else _dealt(row)

    async def touch(self, number: str, time: datetime) -> None:
        """Note that a variant was used."""
        await self._write(lambda connection: _touch(connection, number, time))

    async def keep_submission(self, marked: Marked) -> tuple[Marked, bool]:
        """Store a submission with its grade, once for each key."""
        return await self._write(lambda connection: _keep_submission(connection, marked))

    async def submission(self, receipt: str) -> Marked | None:
        """Give a submission with its newest grade."""
        query = _marked().where(submissions.c.receipt == receipt).order_by(grades.c.id.desc())
        return await self._read(lambda connection: _one(connection, query))

    async def latest(self, variant: str) -> Marked | None:
        """Give the last submission to a variant."""
        newest = submissions.c.time.desc(), submissions.c.receipt, grades.c.id.desc()
        query = _marked().where(submissions.c.variant == variant).order_by(*newest)
        return await self._read(lambda connection: _one(connection, query))

    async def counted(self, variant: str) -> bool:
        """Tell whether some submission to a variant counted."""
        mine = submissions.c.variant == variant, grades.c.counted
        query = select(grades.c.id).join(submissions).where(*mine).limit(1)
        return await self._read(lambda connection: connection.execute(query).first()) is not None

    async def purge(self, before: datetime) -> int:
        """Forget anonymous variants that were last used before a moment; gives how many."""
        return await self._write(lambda connection: _purge(connection, before))

    async def check(self) -> None:
        """Raise StorageUnavailable unless the store answers."""
        await self._read(lambda connection: connection.execute(select(settings.c.name).limit(1)).first())

    def close(self) -> None:
        """Finish what is under way and let go of the files."""
        self._writer.close()
        self._readers.shutdown()
        self._writing.dispose()
        self._reading.dispose()

    async def _write(self, write: Callable[[Connection], T]) -> T:
        return await asyncio.wrap_future(self._writer.write(write))

    async def _read(self, read: Callable[[Connection], T]) -> T:
        return await asyncio.get_running_loop().run_in_executor(self._readers, self._answer, read)

    def _answer(self, read: Callable[[Connection], T]) -> T:
        try:
            with self._reading.connect() as connection:
                return read(connection)
        except SQLAlchemyError as error:
            raise StorageUnavailable(str(error)) from error


def secret_of(url: str) -> bytes:
    """Give the server's secret; the first one to ask makes it."""
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        _insert_once(connection, settings, {"name": "secret", "value": secrets.token_hex(SECRET_BYTES)})
        value = connection.execute(select(settings.c.value).where(settings.c.name == "secret")).scalar_one()
    store.dispose()
    return bytes.fromhex(value)


def _insert_once(connection: Connection, table: Table, values: Mapping[str, Any]) -> bool:
    """Insert a row unless its key is taken; waits for another server that is just taking it."""
    statement = INSERT_ONCE[connection.dialect.name, table.name]
    return connection.execute(statement, values, execution_options={"preserve_rowcount": True}).rowcount == 1


def _keep_variant(connection: Connection, variant: Dealt) -> None:
    owner = {"id": variant.owner.id, "anonymous": variant.owner.anonymous, "created": variant.created}
    _insert_once(connection, owners, owner)
    values = {column.name: getattr(variant, column.name) for column in variants.columns}
    connection.execute(insert(variants), values | {"owner": variant.owner.id})


def _touch(connection: Connection, number: str, time: datetime) -> bool:
    return connection.execute(TOUCH, {"number": number, "time": time}).rowcount == 1


def _keep_submission(connection: Connection, marked: Marked) -> tuple[Marked, bool]:
    handed = marked.handed
    if not _touch(connection, handed.variant, handed.time):
        raise UnknownVariant(handed.variant)
    if not _insert_once(connection, submissions, _columns(handed)):
        return _first(connection, handed), True
    line = {"submission": handed.receipt, "grader_version": marked.grader_version, "grade": marked.grade}
    connection.execute(insert(grades), line | {"counted": marked.counted, "time": handed.time})
    return marked, False


def _columns(handed: Handed) -> dict[str, Any]:
    return {column.name: getattr(handed, column.name) for column in submissions.columns}


def _first(connection: Connection, handed: Handed) -> Marked:
    """What the key stands for already."""
    mine = submissions.c.owner == handed.owner, submissions.c.variant == handed.variant
    first = _one(connection, _marked().where(*mine, submissions.c.key == handed.key).order_by(grades.c.id))
    if first is None:
        raise StorageUnavailable("the receipt's number is taken")
    if first.handed.body != handed.body:
        raise KeyReused(handed.key)
    return first


def _purge(connection: Connection, before: datetime) -> int:
    idle = select(variants.c.id).join(owners).where(owners.c.anonymous, variants.c.last_used < before)
    handed_in = select(submissions.c.receipt).where(submissions.c.variant.in_(idle))
    connection.execute(delete(grades).where(grades.c.submission.in_(handed_in)))
    connection.execute(delete(submissions).where(submissions.c.variant.in_(idle)))
    gone = connection.execute(delete(variants).where(variants.c.id.in_(idle))).rowcount
    bare = owners.c.id.not_in(select(variants.c.owner))
    connection.execute(delete(owners).where(owners.c.anonymous, owners.c.created < before, bare))
    return gone


def _marked() -> Select[Any]:
    return select(submissions, grades.c.grade, grades.c.counted, grades.c.grader_version).join(grades)


def _one(connection: Connection, query: Select[Any]) -> Marked | None:
    row = connection.execute(query.limit(1)).first()
    if row is None:
        return None
    values = row._mapping
    handed = Handed(**{column.name: values[column.name] for column in submissions.columns})
    return Marked(handed, values["grade"], values["counted"], values["grader_version"])


def _dealt(row: Row[Any]) -> Dealt:
    values = dict(row._mapping)
    owner = Owner(values.pop("owner"), values.pop("anonymous"))
    return Dealt(owner=owner, **values)
