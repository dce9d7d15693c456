"""The engine on PostgreSQL: Procrastinate hands the batches out to workers on any number of hosts."""

from __future__ import annotations

import asyncio
import logging
import os
import platform
import signal
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

from procrastinate import App, PsycopgConnector, RetryStrategy
from procrastinate.exceptions import ConnectorException
from procrastinate.jobs import Job, Status
from psycopg import OperationalError

from server.database.queue import QUEUE, TASK
from server.jobs.working import Bureau, work

AGAIN = 5  # s until a batch is tried again whose store did not answer
GRACE = 20.0  # s that a batch may still take when the worker ends
TAKING_BACK = "* * * * * */10"  # every ten seconds
HEARTBEAT, SILENT = 5.0, 30.0  # s
log = logging.getLogger("grubler")


def application(url: str, bureau: Bureau, most: int) -> App:
    """Make a worker's side of the queue.

    Args:
        url: Address of the store.
        bureau: What the worker needs.
        most: Batches at a time.
    """
    name = f"{platform.node()[:40]} {os.getpid()}"
    address = url.replace("postgresql+psycopg://", "postgresql://", 1)
    app = App(connector=PsycopgConnector(conninfo=address, min_size=1, max_size=most + 2))

    @app.task(name=TASK, queue=QUEUE, retry=RetryStrategy(wait=AGAIN))
    async def batch(job: str, number: int) -> None:
        taken = await bureau.jobs.take_one(name, job, number)
        if taken is not None:
            await work(bureau, taken)

    @app.periodic(cron=TAKING_BACK)
    @app.task(name="take_back", queue=QUEUE, queueing_lock="take_back", priority=1)
    async def take_back(timestamp: int) -> None:
        await bureau.jobs.take_back()
        for job in await app.job_manager.get_stalled_jobs(queue=QUEUE, seconds_since_heartbeat=SILENT):
            with suppress(ConnectorException):  # another worker has taken it back meanwhile
                await _taken_back(app, job)

    return app


async def _taken_back(app: App, job: Job) -> None:
    """Let a batch be tried again; what takes back comes by itself every time."""
    if job.task_name == TASK:
        await app.job_manager.retry_job(job)
    else:
        await app.job_manager.finish_job(job, Status.FAILED, delete_job=True)


async def run(app: App, most: int) -> None:
    """Work until told to stop; batches under way may end, or are given back."""
    async with _opened(app):
        await app.run_worker_async(
            queues=[QUEUE], concurrency=most, delete_jobs="always", shutdown_graceful_timeout=GRACE,
            install_signal_handlers=False, update_heartbeat_interval=HEARTBEAT, stalled_worker_timeout=SILENT,
        )  # fmt: skip


@asynccontextmanager
async def _opened(app: App) -> AsyncIterator[None]:
    """Open the connections, and close them in any case. Who is stopped while they open lets them open to the end:
    a pool that is cut off in the middle leaves a task that does not end."""
    opening = asyncio.ensure_future(app.open_async())
    try:
        await asyncio.shield(opening)
        yield
    finally:
        await asyncio.gather(opening, return_exceptions=True)
        await app.close_async()


async def run_on(url: str, bureau: Bureau, most: int) -> None:
    """Work until cancelled, also over times in which the database is away: Procrastinate ends its worker then."""
    while True:
        try:
            await run(application(url, bureau, most), most)
            log.warning("the queue was left without being told to, and is begun again")
        except (ConnectorException, OperationalError) as error:  # the second where connections cannot be opened
            log.warning("the queue waits for the database: %s", error)
        await asyncio.sleep(AGAIN)


async def run_until_told(url: str, bureau: Bureau, most: int) -> None:
    """Work as `run_on` does until a signal tells the process to end; a second one changes nothing."""
    working = asyncio.ensure_future(run_on(url, bureau, most))
    for told in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(told, lambda: working.cancelling() or working.cancel())
    with suppress(asyncio.CancelledError):
        await working
