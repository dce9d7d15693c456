"""Connections to the store: SQLite that writes through to disk, or PostgreSQL."""

from __future__ import annotations

from sqlite3 import Connection as SQLiteConnection
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, make_url
from sqlalchemy.exc import OperationalError

from server.storage import StorageUnavailable

UNANSWERED = (OperationalError, StorageUnavailable)  # what is raised where a store does not answer
BUSY = 10_000  # ms to wait for another process's lock
READERS = 4  # threads and connections that read

NETWORK = {"connect_timeout": 5, "keepalives_idle": 10, "keepalives_interval": 5, "keepalives_count": 3}  # s; tries
PRAGMAS = (f"busy_timeout={BUSY}", "journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON")


def engine(url: str, *, connections: int, begin: str = "BEGIN") -> Engine:
    """Make an engine.

    Args:
        url: Address of the store as SQLAlchemy reads it.
        connections: Most connections that are kept open.
        begin: How a transaction begins on SQLite; a writer takes its lock at once with ``BEGIN IMMEDIATE``.
    """
    embedded = make_url(url).get_backend_name() == "sqlite"
    made = create_engine(
        url, pool_size=connections, max_overflow=0, pool_pre_ping=not embedded, hide_parameters=True,
        connect_args={} if embedded else NETWORK,
    )  # fmt: skip
    if embedded:
        event.listen(made, "connect", _prepare)
        event.listen(made, "begin", lambda connection: _begin(connection, begin))
    return made


def _prepare(connection: SQLiteConnection, record: Any) -> None:
    connection.isolation_level = None  # the driver must not begin transactions of its own
    for pragma in PRAGMAS:
        connection.execute(f"PRAGMA {pragma}").close()


def _begin(connection: Connection, begin: str) -> None:
    connection.exec_driver_sql(begin)
