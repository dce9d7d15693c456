"""The engine of an embedded store: all batches once, whatever fails, whenever it is stopped."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import select

from server.database import Database
from server.jobs import engine as engines
from server.jobs import working
from server.jobs.engine import Engine
from server.jobs.working import Bureau, work
from server.settings import Settings
from server.storage.jobs import Job
from server.tables import batches
from tests.server.jobs.counting import KINDS, TELLING, Here, left, order
from tests.server.stores import lay

WORKER = """
import asyncio, sys
from server.database import Database
from server.jobs.engine import Engine
from server.jobs.working import Bureau
from tests.server.jobs.counting import KINDS, Here
database = Database(sys.argv[1])
if __name__ == "__main__":
    asyncio.run(Engine(Bureau(database.jobs, Here(), b"s", KINDS), "server", 1).run())
"""


@pytest.fixture
def url(tmp_path: Path) -> str:
    return lay(Settings(tmp_path))


@pytest.fixture
def bureau(url: str) -> Iterator[Bureau]:
    database, judging = Database(url), Here()
    yield Bureau(database.jobs, judging, b"secret", KINDS)
    judging.close()
    database.close()


async def ended(bureau: Bureau, number: str) -> Job:
    """Wait until a job has ended."""
    while True:
        found = await bureau.jobs.job(number)
        assert found is not None
        if not found.live:
            return found
        await asyncio.sleep(0.005)


def run(bureau: Bureau, *pieces: Any) -> Job:
    """Run a job from its start to its end."""

    async def ran() -> Job:
        made, engine = order(pieces), Engine(bureau, "server", 2)
        working = asyncio.create_task(engine.run())
        await bureau.jobs.start(made)
        engine.wake()
        async with asyncio.timeout(20):
            found = await ended(bureau, made.id)
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)
        return found

    return asyncio.run(ran())


def rows(bureau: Bureau, number: str) -> Any:
    return asyncio.run(bureau.jobs.plan(lambda connection: [left(connection, number)]))[0]


def test_all_batches_are_done_once(bureau: Bureau) -> None:
    found = run(bureau, *range(9))
    assert (found.state, found.result, rows(bureau, found.id)) == ("done", {"sum": 204}, 9)


def test_a_batch_that_cannot_be_computed_fails_its_job_and_no_other(
    bureau: Bureau, caplog: pytest.LogCaptureFixture
) -> None:
    bad, good = run(bureau, 1, "x"), run(bureau, 2)
    assert (bad.state, good.state) == ("failed", "done")
    assert bad.error is not None and "invalid literal" in bad.error
    assert rows(bureau, bad.id) == 0 and "failed" in caplog.text


def test_an_engine_that_is_stopped_lets_its_batch_end(bureau: Bureau) -> None:
    async def stopped() -> tuple[str, int]:
        made, engine = order([[3, 0.3], 4]), Engine(bureau, "server", 1)
        await bureau.jobs.start(made)
        working = asyncio.create_task(engine.run())
        await _taken(bureau, made.id)
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)
        found = await bureau.jobs.job(made.id)
        assert found is not None
        return found.state, found.done

    assert asyncio.run(stopped()) == ("running", 1)


def test_a_batch_that_takes_too_long_to_end_is_given_back(bureau: Bureau, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engines, "GRACE", 0.01)

    async def stopped() -> int:
        made, engine = order([[3, 0.5]]), Engine(bureau, "server", 1)
        await bureau.jobs.start(made)
        working = asyncio.create_task(engine.run())
        await _taken(bureau, made.id)
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)
        again = await bureau.jobs.take("other")
        assert again is not None and again.job == made.id
        return again.fence

    assert asyncio.run(stopped()) == 2


async def _taken(bureau: Bureau, number: str) -> None:
    found = None
    while found is None or found.state == "waiting":
        found = await bureau.jobs.job(number)
        await asyncio.sleep(0.002)


def test_a_batch_that_only_workers_of_another_version_can_do_is_left_to_them(
    bureau: Bureau, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(working, "LEFT_TO_OTHERS", 0.0)

    async def worked() -> Any:
        made = order([3])
        await bureau.jobs.start(made)
        old, new = replace(bureau, kinds={}), bureau
        for worker in (old, new):
            batch = await bureau.jobs.take_one("worker", made.id, 1)
            assert batch is not None
            await work(worker, batch)
        return await bureau.jobs.job(made.id)

    job = asyncio.run(worked())
    assert (job.state, job.result) == ("done", {"sum": 9})
    assert "of the kind counting" in caplog.text


def test_a_batch_that_takes_longer_than_its_lease_is_renewed(bureau: Bureau) -> None:
    bureau.jobs.lease = 0.3

    async def worked() -> Any:
        await bureau.jobs.start(order([[3, 0.7]]))
        batch = await bureau.jobs.take("slow")
        assert batch is not None
        working = asyncio.create_task(work(bureau, batch))
        while not working.done():
            assert await bureau.jobs.take("greedy") is None
            await asyncio.sleep(0.05)
        return await bureau.jobs.job(batch.job)

    assert asyncio.run(worked()).state == "done"


def test_a_batch_tells_how_far_it_is_while_it_is_worked_on(bureau: Bureau, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(working, "LOOK", 0.01)

    async def worked() -> tuple[list[int], Any]:
        await bureau.jobs.start(order([20], kind=TELLING.name, parts=20))
        batch = await bureau.jobs.take("one")
        assert batch is not None
        working, seen = asyncio.create_task(work(bureau, batch)), []
        while not working.done():
            seen += [one.reached for one in await bureau.jobs.progress(batch.job)]
            await asyncio.sleep(0.01)
        return seen, (await bureau.jobs.progress(batch.job))[0]

    seen, last = asyncio.run(worked())
    assert seen == sorted(seen) and len(set(seen) - {0, 20}) > 3
    assert (last.piece, last.reached, last.parts) == (20, 20, 20)


def test_the_computing_of_a_job_that_was_cancelled_is_given_up(
    bureau: Bureau, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(working, "LOOK", 0.01)

    async def worked() -> None:
        await bureau.jobs.start(order([10**6], kind=TELLING.name, parts=10**6))
        batch = await bureau.jobs.take("one")
        assert batch is not None
        computing = asyncio.create_task(work(bureau, batch))
        await asyncio.sleep(0.05)
        await bureau.jobs.cancel(TELLING, batch.job)
        async with asyncio.timeout(10):
            await computing

    asyncio.run(worked())
    assert "nobody waits" in caplog.text


def test_a_killed_server_goes_on_where_it_stood(url: str, bureau: Bureau) -> None:
    made = order([1, 2, [3, 1], 4])
    asyncio.run(bureau.jobs.start(made))
    killed_in(url, bureau, made.id, 3)
    assert (rows(bureau, made.id), fence(bureau, made.id, 3)) == (2, 1)
    assert asyncio.run(bureau.jobs.take_one("other", made.id, 3)) is None  # its lease is not over

    async def started_anew() -> Job:
        working = asyncio.create_task(Engine(bureau, "server", 2).run())
        async with asyncio.timeout(20):
            found = await ended(bureau, made.id)
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)
        return found

    found = asyncio.run(started_anew())
    assert (found.state, found.result) == ("done", {"sum": 30})
    assert (rows(bureau, made.id), fence(bureau, made.id, 3)) == (4, 2)


def killed_in(url: str, bureau: Bureau, number: str, batch: int) -> None:
    """Let a server in a process of its own work until it is in a batch, and end it there as a power cut would."""
    environ = os.environ | {"PYTHONPATH": str(Path(__file__).parents[3])}
    process = subprocess.Popen([sys.executable, "-c", WORKER, url], env=environ)
    deadline = time.monotonic() + 60
    while fence(bureau, number, batch) == 0:
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.02)
    process.kill()
    process.wait()


def fence(bureau: Bureau, number: str, batch: int) -> Any:
    query = select(batches.c.fence).where(batches.c.job == number, batches.c.number == batch)
    return asyncio.run(bureau.jobs.plan(lambda connection: connection.execute(query).scalars().all()))[0]
