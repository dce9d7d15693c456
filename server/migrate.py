"""Bring a store to the tables of this version. Imports Alembic, so only commands that migrate import it."""

from __future__ import annotations

from importlib.resources import as_file, files

from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory
from alembic.util.exc import CommandError
from sqlalchemy import Connection, text

from server.database.engine import engine

LOCK = 0x6772  # any number, the same on all hosts: one migrates, the others wait


class MigrationError(RuntimeError):
    """The store cannot be brought to this version; the message says why."""


def migrate(url: str) -> None:
    """Run all migrations that the store lacks, in one transaction.

    Args:
        url: Address of the store as SQLAlchemy reads it.

    Raises:
        MigrationError: A newer version of the program has written this store.
    """
    store = engine(url, connections=1, begin="BEGIN IMMEDIATE")
    try:
        with store.begin() as connection:
            if store.dialect.name == "postgresql":
                connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": LOCK})
            _upgrade(connection)
    except CommandError as error:
        raise MigrationError(f"the store was written by a newer version of Grübler: {error}") from error
    finally:
        store.dispose()


def _upgrade(connection: Connection) -> None:
    with as_file(files("server") / "migrations") as folder:
        config = _config(str(folder))
        config.attributes["connection"] = connection
        command.upgrade(config, "head")


def current(url: str) -> bool:
    """Whether the store has exactly the tables of this version."""
    store = engine(url, connections=1)
    try:
        with store.connect() as connection, as_file(files("server") / "migrations") as folder:
            head = ScriptDirectory.from_config(_config(str(folder))).get_current_head()
            return MigrationContext.configure(connection).get_current_revision() == head
    finally:
        store.dispose()


def _config(folder: str) -> Config:
    config = Config()
    config.set_main_option("script_location", folder.replace("%", "%%"))
    config.set_main_option("path_separator", "os")
    return config
