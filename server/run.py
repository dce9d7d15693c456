"""Starting the server, and the commands that need its store."""

from __future__ import annotations

import asyncio
import gc
from collections.abc import Callable, Mapping
from contextlib import suppress
from socket import socket
from typing import Any

import uvicorn
from sqlalchemy.exc import SQLAlchemyError

from server import migrate as migrations
from server.app import create_app
from server.database import Database, secret_of
from server.jobs.kinds import KINDS
from server.jobs.working import Bureau
from server.judging.process import JudgingProcess
from server.judging.thread import JudgingThread
from server.people import accounts, tokens
from server.regrading import command
from server.settings import Settings, SettingsError, check
from server.storage.audit import Checked, End
from server.storage.jobs import Job
from server.web import logs

GRACE = 30  # s that requests under way have when the process is told to end


def serve(settings: Settings) -> None:
    """Serve until the process is told to end. The embedded store is brought up to date first.

    Raises:
        SettingsError: The bind is not safe, or the PostgreSQL store does not answer or lacks migrations.
        MigrationError: A newer version of the program has written the store.
    """
    check(settings)
    logs.install(settings.log)
    if settings.embedded:
        migrate(settings)
    elif not _current(settings):
        raise SettingsError("the database lacks migrations: run `grubler migrate` first")
    app = create_app(settings, judging=JudgingProcess(log=settings.log))
    config = uvicorn.Config(
        app, host=settings.host, port=settings.port, log_level="warning", access_log=False, server_header=False,
        proxy_headers=False, log_config=None, timeout_graceful_shutdown=GRACE,
    )  # fmt: skip
    server = Announced(config)
    server.address = settings.address
    server.first = accounts.first_link(settings)
    with suppress(KeyboardInterrupt):
        server.run()
    if not server.started:
        raise SystemExit(3)


def _current(settings: Settings) -> bool:
    try:
        return migrations.current(settings.store_url)
    except SQLAlchemyError as error:
        raise SettingsError(f"the database does not answer: {error}") from error


class Announced(uvicorn.Server):
    """A server that says where it listens once it does."""

    address = ""
    first: str | None = None  # the link for the first administrator, until there is one

    async def startup(self, sockets: list[socket] | None = None) -> None:
        """Listen, then say so."""
        await super().startup(sockets)
        gc.collect()
        gc.freeze()  # what is loaded stays: no later collection need walk through it
        if self.started:
            print(f"Grübler listens at {self.address}", flush=True)
        if self.started and self.first:
            print(f"Nobody administers it yet. This link works once: {self.first}", flush=True)


def work(settings: Settings, processes: int | None = None) -> None:
    """Do the batches of jobs until the process is told to end; any number of hosts may do so beside the servers.

    Args:
        settings: The settings of the servers.
        processes: Batches at a time; as many as there are processors by default.

    Raises:
        SettingsError: The store is an embedded one, or lacks migrations.
    """
    if settings.embedded:
        raise SettingsError("workers need DATABASE_URL; the server of an embedded store does its jobs itself")
    if not migrations.current(settings.store_url):
        raise SettingsError("the database lacks migrations: run `grubler migrate` first")
    logs.install(settings.log)
    asyncio.run(_work(settings, processes or settings.workers or 1))


async def _work(settings: Settings, most: int) -> None:
    from server.jobs import queue  # Procrastinate is imported where it is needed

    database, judging = Database(settings.store_url), JudgingThread(most)
    secret = settings.secret or secret_of(settings.store_url)
    try:
        print(f"Grübler works, {most} batches at a time", flush=True)
        await queue.run_until_told(settings.store_url, Bureau(database.jobs, judging, secret, KINDS), most)
    finally:
        judging.close()
        database.close()


def check_log(settings: Settings, earlier: End | None) -> Checked:
    """Check the audit log, which an earlier end must still be part of."""
    migrate(settings)
    database = Database(settings.store_url)
    try:
        return asyncio.run(database.audit.check(earlier))
    finally:
        database.close()


def regrade(settings: Settings, task_set: str, tell: Callable[[Mapping[str, Any]], None], **wish: bool) -> Job:
    """Judge again what was handed in to a set, and tell every change; gives the job once it has ended.

    Raises:
        SettingsError: There is no such published set, or the store lacks migrations.
    """
    if settings.embedded:
        migrate(settings)
    elif not migrations.current(settings.store_url):
        raise SettingsError("the database lacks migrations: run `grubler migrate` first")
    return command.run(settings, task_set, tell, **wish)


def migrate(settings: Settings) -> None:
    """Bring the store to the tables of this version; makes the embedded one where there is none.

    Raises:
        SettingsError: The folder cannot be made, or the address is not one of PostgreSQL.
        MigrationError: A newer version of the program has written the store.
    """
    if settings.embedded:
        try:
            settings.data_dir.mkdir(mode=0o700, parents=True, exist_ok=True)
        except OSError as error:
            raise SettingsError(f"the data folder {settings.data_dir} cannot be made: {error.strerror}") from error
    migrations.migrate(settings.store_url)


def token(settings: Settings, role: str, *, hours: float = tokens.HOURS) -> str:
    """Make a bearer token that this server accepts.

    Raises:
        ValueError: There is no such role.
        SettingsError: The store cannot be made.
        MigrationError: A newer version of the program has written the store.
    """
    if settings.secret is None:
        migrate(settings)
    return tokens.issue(role, settings.secret or secret_of(settings.store_url), hours=hours)
