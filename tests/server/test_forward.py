"""A store of an earlier version, with a row in every table, comes to this version with all that it held."""

from __future__ import annotations

import asyncio
from collections.abc import Collection, Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from alembic import command
from sqlalchemy import (
    JSON,
    Boolean,
    Column,
    Connection,
    DateTime,
    Float,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Table,
    insert,
    inspect,
    select,
)

from server import migrate as migrations
from server.database import Database
from server.database.engine import engine
from server.migrations import newest
from server.settings import Settings
from tests.server.stores import Postgres

FIRST = "0002"  # the first version with people and courses
BEFORE = f"{int(newest()) - 1:04}"
MADE_ANEW = {FIRST: ["jobs"]}  # nothing had been written there
NOW = datetime(2026, 11, 28, 9, 0, 0, 123456, UTC)


@pytest.fixture(params=["sqlite", "postgres"])
def url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """The address of a store without tables."""
    server: Postgres | None = request.getfixturevalue("postgres") if request.param == "postgres" else None
    yield Settings(tmp_path, database_url=server.empty() if server else None).store_url


def laid_at(url: str, version: str) -> None:
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        config = migrations._config(str(Path(migrations.__file__).parent / "migrations"))
        config.attributes["connection"] = connection
        command.upgrade(config, version)
    store.dispose()


def value(column: Column[Any]) -> Any:
    """Make a value that the column takes: the one it refers to, where it refers to one."""
    length = getattr(column.type, "length", None)
    kinds: tuple[tuple[type[Any], Any], ...] = (
        (JSON, {"l1": [0.1, "ż"]}), (Boolean, True), (DateTime, NOW), (Float, 0.5), (Integer, 1),
        (LargeBinary, b"%PDF"), (String, "a-1"[:length]),
    )  # fmt: skip
    return next(made for kind, made in kinds if isinstance(column.type, kind))


def filled(connection: Connection, but: Collection[str] = ()) -> dict[str, dict[str, Any]]:
    """Put a row into every table."""
    found = MetaData()
    found.reflect(connection)
    rows = {}
    for table in found.sorted_tables:
        if not table.name.startswith(("alembic_", "procrastinate_", *but)):  # the queue has versions of its own
            connection.execute(insert(table), {column.name: value(column) for column in table.columns})
            rows[table.name] = row(connection, table)
    return rows


def row(connection: Connection, table: Table) -> dict[str, Any]:
    return dict(connection.execute(select(table)).mappings().one())


@pytest.mark.parametrize("version", sorted({FIRST, BEFORE}))
def test_what_an_earlier_version_stored_is_there_after_the_upgrade(url: str, version: str) -> None:
    laid_at(url, version)
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        before = filled(connection, MADE_ANEW.get(version, ()))
    migrations.migrate(url)
    assert migrations.current(url) and len(before) > 10
    with store.connect() as connection:
        assert set(inspect(connection).get_table_names()) >= set(before)
        for name, old in before.items():
            now = row(connection, Table(name, MetaData(), autoload_with=connection))
            assert {column: now.get(column, value) for column, value in old.items()} == old, name
    store.dispose()


def test_what_an_earlier_version_stored_is_read_by_this_one(url: str) -> None:
    laid_at(url, FIRST)
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        filled(connection, MADE_ANEW[FIRST])
    store.dispose()
    migrations.migrate(url)
    database = Database(url)
    asyncio.run(database.practice.check())
    dealt, marked = asyncio.run(database.practice.variant("a-1")), asyncio.run(database.practice.submission("a-1"))
    database.close()
    assert dealt is not None and dealt.givens == {"l1": [0.1, "ż"]} and dealt.created == NOW
    assert marked is not None and marked.handed.answers == {"l1": [0.1, "ż"]} and marked.counted
