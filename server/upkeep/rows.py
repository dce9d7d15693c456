"""All rows of one store written into another, empty one: so a PostgreSQL store becomes a file, and a file one of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sqlalchemy import Connection, func, insert, literal, select
from sqlalchemy.exc import SQLAlchemyError

from server.database.engine import engine
from server.tables import metadata

AT_ONCE = 500  # rows read and written together
TABLES = metadata.sorted_tables  # those that others refer to come first


class NotEmpty(ValueError):
    """The store that is written into holds something."""


def transfer(source: str, target: str) -> None:
    """Copy all rows as they stand at one moment, in one transaction; both stores have the tables of this version.

    Args:
        source: Address of the store that is read, while others may go on writing.
        target: Address of the store that is written.

    Raises:
        NotEmpty: The target has rows.
        ConnectionError: A store does not answer.
    """
    with _asked(), _reading(source) as reading, _writing(target) as writing:
        if any(writing.execute(select(literal(1)).select_from(table).limit(1)).first() for table in TABLES):
            raise NotEmpty
        for table in TABLES:
            rows = reading.execute(select(table).order_by(*table.primary_key), execution_options={"yield_per": AT_ONCE})
            for some in rows.mappings().partitions():
                writing.execute(insert(table), [dict(row) for row in some])
        if writing.dialect.name == "postgresql":
            _count_on(writing)


@contextmanager
def _asked() -> Iterator[None]:
    try:
        yield
    except SQLAlchemyError as error:
        raise ConnectionError(str(error)) from error


@contextmanager
def _reading(url: str) -> Iterator[Connection]:
    store = engine(url, connections=1)
    isolation = "REPEATABLE READ" if store.dialect.name == "postgresql" else "SERIALIZABLE"
    try:
        with store.connect().execution_options(isolation_level=isolation) as connection:
            yield connection
    finally:
        store.dispose()


@contextmanager
def _writing(url: str) -> Iterator[Connection]:
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    try:
        with store.begin() as connection:
            yield connection
    finally:
        store.dispose()


def _count_on(connection: Connection) -> None:
    """Let the numbers that the database counts go on after those that were written."""
    for table in TABLES:
        column = table.autoincrement_column
        if column is not None:
            sequence = func.pg_get_serial_sequence(table.name, column.name)
            after = select(func.coalesce(func.max(column), 0) + 1).scalar_subquery()
            connection.execute(select(func.setval(sequence, after, False)))
