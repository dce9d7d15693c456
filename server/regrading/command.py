"""Regrading a set from the command line, beside the servers of its store or without any."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager
from typing import Any

from server.audit.acts import COMMAND_LINE
from server.database import Database, secret_of
from server.jobs.engine import Engine
from server.jobs.kinds import KINDS
from server.jobs.working import Bureau
from server.judging.thread import JudgingThread
from server.regrading import job as regrade
from server.settings import Settings, SettingsError
from server.storage.jobs import Busy, Job
from server.web import ids

LOOK = 0.2  # s


def run(settings: Settings, task_set: str, tell: Callable[[Mapping[str, Any]], None], **wish: bool) -> Job:
    """Regrade a set and wait for the end; a regrade that is under way is gone on with.

    Args:
        settings: The settings of the store.
        task_set: Number of the set.
        tell: Is given every change, of a submission or of a reference.
        wish: `dry_run`, `allow_lower`, `recompute_references`, as `job.order` takes them.

    Raises:
        SettingsError: There is no such published set.
    """
    return asyncio.run(_run(settings, task_set, tell, wish))


async def _run(
    settings: Settings, task_set: str, tell: Callable[[Mapping[str, Any]], None], wish: Mapping[str, Any]
) -> Job:
    database, judging = Database(settings.store_url), JudgingThread(settings.workers or 1)
    try:
        found = await database.sets.task_set(task_set) if ids.known(task_set) else None
        if found is None or found.published is None:
            raise SettingsError(f"there is no published task set {task_set}")
        bureau = Bureau(database.jobs, judging, settings.secret or secret_of(settings.store_url), KINDS)
        who = COMMAND_LINE, None
        try:
            number = await regrade.order(database.jobs, found, *who, **wish)
        except Busy as other:
            number = str(other)
        async with _at_work(bureau, settings.workers or 1):
            job = await _ended(database, number)
        await _tell(database, job, tell)
        return job
    finally:
        judging.close()
        database.close()


@asynccontextmanager
async def _at_work(bureau: Bureau, most: int) -> AsyncIterator[None]:
    working = asyncio.create_task(Engine(bureau, f"command {ids.new()}", most).run())
    try:
        yield
    finally:
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)


async def _ended(database: Database, number: str) -> Job:
    while True:
        job = await database.jobs.job(number)
        assert job is not None
        if not job.live:
            return job
        await asyncio.sleep(LOOK)


async def _tell(database: Database, job: Job, tell: Callable[[Mapping[str, Any]], None]) -> None:
    after = 0
    while batch := next(iter(await database.jobs.results(job.id, after, 1)), None):
        after, result = batch
        for change in (*result.get("references", ()), *result["changes"]):
            tell(change)
