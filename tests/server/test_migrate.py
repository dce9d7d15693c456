"""Migrations make exactly the tables that the program uses, once, and refuse a newer store."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import text

from server.database.engine import engine
from server.migrate import MigrationError, current, migrate
from server.settings import Settings
from server.tables import metadata


def ours(name: str | None, kind: str, parents: object) -> bool:
    """Tell our tables from those of the queue, which come with it."""
    return kind != "table" or not str(name).startswith("procrastinate_")


def test_the_migrations_make_the_tables_of_the_program(store_url: str) -> None:
    store = engine(store_url, connections=1)
    with store.connect() as connection:
        context = MigrationContext.configure(connection, opts={"include_name": ours})
        difference = compare_metadata(context, metadata)
    store.dispose()
    assert difference == []
    assert current(store_url)


def test_migrating_twice_changes_nothing(store_url: str) -> None:
    migrate(store_url)
    assert current(store_url)


def test_a_store_without_tables_is_not_current(tmp_path: Path) -> None:
    assert not current(Settings(tmp_path).store_url)


def test_two_processes_may_migrate_at_once(tmp_path: Path) -> None:
    url = Settings(tmp_path).store_url
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(migrate, [url, url]))
    assert current(url)


def test_a_newer_store_is_refused(store_url: str) -> None:
    store = engine(store_url, connections=1)
    with store.begin() as connection:
        connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
    store.dispose()
    with pytest.raises(MigrationError, match="newer version"):
        migrate(store_url)
