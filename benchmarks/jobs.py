"""Power cuts while jobs are done: a worker is killed at random moments, and every batch must be done once in effect.

Run: ``uv run python benchmarks/jobs.py --kills 1000 [--store postgres]``, where Procrastinate hands out the batches. A
batch leaves a row under a key of its own: one that is missing is lost, a second one cannot be.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import asyncio
import random
import time
from functools import partial
from multiprocessing import get_context
from multiprocessing.process import BaseProcess
from multiprocessing.synchronize import Event

from sqlalchemy import Connection

from benchmarks.stores import KINDS as STORES
from benchmarks.stores import settings, stores
from server.database import Database
from server.jobs import queue
from server.jobs.engine import Engine
from server.jobs.working import Bureau
from tests.server.jobs.counting import KINDS, Here, left, order

PROCESSES = get_context("forkserver")  # what a worker imports is imported once, so a life costs no more than a start
PROCESSES.set_forkserver_preload(["benchmarks.jobs"])
PIECES = [[number, 0.02] for number in range(20)]
SUM = sum(number**2 for number, _ in PIECES)
START = 120.0  # s to wait for a worker
LONGEST_LIFE = 0.6  # s of a worker from when it works
PATIENCE = 120.0  # s for what is left in the end


def work(url: str, working: Event) -> None:
    """Be a worker, two batches at a time, whose lease and silence are short."""
    database = Database(url)
    database.jobs.lease = 2.0
    bureau = Bureau(database.jobs, Here(), b"s", KINDS)
    working.set()
    if url.startswith("sqlite"):
        asyncio.run(Engine(bureau, "server", 2).run())
    else:
        queue.TAKING_BACK, queue.SILENT, queue.HEARTBEAT = "* * * * * *", 3.0, 1.0
        asyncio.run(queue.run_until_told(url, bureau, 2))


def killed(url: str, chance: random.Random) -> None:
    """Let a worker live for a moment, then end it as a power cut would."""
    process = start(url)
    time.sleep(chance.uniform(0, LONGEST_LIFE))
    process.kill()
    process.join()


def start(url: str) -> BaseProcess:
    """Start a worker and wait until it works."""
    working = PROCESSES.Event()
    process = PROCESSES.Process(target=work, args=(url, working))
    process.start()
    assert working.wait(START), "the worker does not start"
    return process


def rows_of(connection: Connection, job: str) -> list[int]:
    """Count the rows that the batches of a job have left."""
    return [left(connection, job)]


async def live(database: Database, numbers: list[str]) -> list[str]:
    """Give those of the jobs that have not ended."""
    found = [await database.jobs.job(number) for number in numbers]
    return [job.id for job in found if job is not None and job.live]


def kill(database: Database, url: str, kills: int, chance: random.Random) -> list[str]:
    """Kill one worker after another while two jobs wait; gives the numbers of all jobs."""
    numbers, waiting = list[str](), list[str]()
    for _ in range(kills):
        waiting = asyncio.run(live(database, waiting))
        if len(waiting) < 2:
            made = order(PIECES, str(len(numbers)))
            asyncio.run(database.jobs.start(made))
            numbers.append(made.id)
            waiting.append(made.id)
        killed(url, chance)
    return numbers


def finish(database: Database, url: str, numbers: list[str]) -> None:
    """Let one more worker finish what is left."""
    last, deadline = start(url), time.monotonic() + PATIENCE
    while asyncio.run(live(database, numbers)) and time.monotonic() < deadline:
        time.sleep(0.1)
    last.kill()
    last.join()


def main() -> None:
    """Kill, let the last worker finish, and count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--store", choices=STORES, default="sqlite")
    given = parser.parse_args()
    with stores(given.store) as (environment,):
        url = settings(environment).store_url
        database = Database(url)
        numbers = kill(database, url, given.kills, random.Random(given.seed))
        finish(database, url, numbers)
        jobs = [asyncio.run(database.jobs.job(number)) for number in numbers]
        rows = [asyncio.run(database.jobs.plan(partial(rows_of, job=number)))[0] for number in numbers]
        database.close()
    right = sum(job is not None and (job.state, job.result) == ("done", {"sum": SUM}) for job in jobs)
    print(f"store {given.store}: {given.kills} kills, {len(numbers)} jobs of {len(PIECES)} batches")
    print(f"done with the right result: {right}")
    print(f"batches lost or doubled: {sum(abs(number - len(PIECES)) for number in rows)}")
    sys.exit(0 if right == len(numbers) and set(rows) <= {len(PIECES)} else 1)


if __name__ == "__main__":
    main()
