"""Migrations make exactly the tables that the program uses, once, and refuse a newer store."""

from __future__ import annotations

import ast
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

VERSIONS = Path(__file__).resolve().parents[2] / "server/migrations/versions"
LATER = [path for path in sorted(VERSIONS.glob("0*.py")) if path.stem > "0006"]  # nothing was released before
ADDING = {"add_column", "create_table", "create_index", "execute", "get_bind", "get_context"}


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


@pytest.mark.parametrize("path", LATER, ids=[path.stem for path in LATER])
def test_a_migration_only_adds_so_that_servers_of_the_version_before_go_on(path: Path) -> None:
    calls = [node for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.Call)]
    done = {ast.unparse(call.func) for call in calls}
    assert {name for name in done if name.startswith("op.")} <= {f"op.{name}" for name in ADDING}
    for call in calls:
        if ast.unparse(call.func) == "op.add_column":
            column = ast.unparse(call.args[1])
            assert "nullable=False" not in column or "server_default=" in column, column
