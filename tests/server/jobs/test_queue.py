"""Workers on PostgreSQL: Procrastinate hands out, stalled jobs come back, what is written late is refused."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from psycopg_pool import PoolTimeout
from sqlalchemy import text

from server.database import Database
from server.database.queue import QUEUE
from server.jobs import queue
from server.jobs.working import Bureau, work
from server.settings import Settings
from server.storage.jobs import Job
from tests.server.jobs.counting import COUNTING, KINDS, Here, left, order
from tests.server.jobs.relay import Relay
from tests.server.jobs.test_engine import ended, fence
from tests.server.stores import lay

WORKER = """
import asyncio, sys
from server.database import Database
from server.database.queue import QUEUE
from server.jobs import queue
from server.jobs.working import Bureau
from tests.server.jobs.counting import KINDS, Here
if __name__ == "__main__":
    database = Database(sys.argv[1])
    queue.AGAIN = 0.2
    asyncio.run(queue.run_until_told(sys.argv[1], Bureau(database.jobs, Here(), b"s", KINDS), 1))
"""
ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def url(shared_database_url: str, tmp_path_factory: pytest.TempPathFactory) -> str:
    return lay(Settings(tmp_path_factory.mktemp("queue"), database_url=shared_database_url))


@pytest.fixture
def bureau(url: str) -> Iterator[Bureau]:
    """A worker's tools; nothing of an earlier test is in the queue."""
    database, judging = Database(url), Here()
    yield Bureau(database.jobs, judging, b"secret", KINDS)
    judging.close()
    database.close()


def asked(bureau: Bureau, query: str) -> Any:
    return asyncio.run(bureau.jobs.plan(lambda connection: connection.execute(text(query)).scalars().all()))


@asynccontextmanager
async def at_work(url: str, bureau: Bureau) -> AsyncIterator[None]:
    """Let a worker of this process do what comes."""
    working = asyncio.create_task(queue.run(queue.application(url, bureau, 2), 2))
    yield
    working.cancel()
    await asyncio.gather(working, return_exceptions=True)


def finished(url: str, bureau: Bureau, number: str) -> Job:
    async def waited() -> Job:
        async with at_work(url, bureau), asyncio.timeout(40):
            return await ended(bureau, number)

    return asyncio.run(waited())


def rows(bureau: Bureau, number: str) -> Any:
    return asyncio.run(bureau.jobs.plan(lambda connection: [left(connection, number)]))[0]


def test_a_worker_does_all_batches_once(url: str, bureau: Bureau) -> None:
    made = order(range(9))
    asyncio.run(bureau.jobs.start(made))
    assert len(asked(bureau, "SELECT id FROM procrastinate_jobs WHERE task_name = 'batch'")) == 9
    found = finished(url, bureau, made.id)
    assert (found.state, found.result, rows(bureau, made.id)) == ("done", {"sum": 204}, 9)
    assert asked(bureau, "SELECT id FROM procrastinate_jobs WHERE task_name = 'batch' AND status = 'todo'") == []


def test_what_is_rolled_back_is_not_in_the_queue(bureau: Bureau) -> None:
    def refuse(connection: Any) -> None:
        raise ValueError("no")

    made = order([1], "refused")
    with pytest.raises(ValueError, match="no"):
        asyncio.run(bureau.jobs.start(made, refuse))
    query = f"SELECT id FROM procrastinate_jobs WHERE args->>'job' = '{made.id}'"
    assert asked(bureau, query) == []


def test_a_killed_worker_s_batch_is_done_by_another(url: str, bureau: Bureau, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(queue, "TAKING_BACK", "* * * * * *")  # every second
    made = order([1, [2, 1], 3], "killed")
    asyncio.run(bureau.jobs.start(made))
    process = subprocess.Popen([sys.executable, "-c", WORKER, url], env=os.environ | {"PYTHONPATH": str(ROOT)})
    deadline = time.monotonic() + 60
    while fence(bureau, made.id, 2) == 0:
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.02)
    process.kill()
    process.wait()
    _end_leases(bureau)
    found = finished(url, bureau, made.id)
    assert (found.state, found.result, rows(bureau, made.id)) == ("done", {"sum": 14}, 3)


def test_what_killed_workers_left_is_taken_back_without_a_word_by_whoever_comes(
    url: str, bureau: Bureau, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(queue, "TAKING_BACK", "* * * * * *")
    made = order([1, 2], "left")
    asyncio.run(bureau.jobs.start(made))
    asyncio.run(bureau.jobs.plan(_killed_twice))
    assert finished(url, bureau, made.id).state == "done"
    assert asked(bureau, "SELECT id FROM procrastinate_jobs WHERE status = 'doing' AND task_name = 'take_back'") == []
    assert "Traceback" not in caplog.text


def _killed_twice(connection: Any) -> list[Any]:
    """Leave what two workers leave that were killed while they took back and did a batch."""
    taking = text(
        "INSERT INTO procrastinate_jobs (queue_name, task_name, args, status, queueing_lock)"
        " VALUES (:queue, 'take_back', jsonb_build_object('timestamp', 1), 'doing', 'take_back')"
    )
    connection.execute(taking, [{"queue": QUEUE}] * 2)
    connection.execute(text("UPDATE procrastinate_jobs SET status = 'doing' WHERE task_name = 'batch'"))
    connection.commit()
    return []


def _end_leases(bureau: Bureau) -> None:
    """Let the time pass that nobody may wait for in a test."""

    def end(connection: Any) -> list[Any]:
        connection.execute(text("UPDATE batches SET lease = now() - interval '1 second' WHERE state = 'running'"))
        connection.execute(text("UPDATE procrastinate_workers SET last_heartbeat = now() - interval '1 hour'"))
        connection.commit()
        return []

    asyncio.run(bureau.jobs.plan(end))


def test_a_worker_that_was_cut_off_past_its_lease_writes_nothing(
    url: str, bureau: Bureau, caplog: pytest.LogCaptureFixture
) -> None:
    port = int(url.rsplit(":", 1)[1].split("/")[0])
    relay = Relay(port)
    cut_off = Database(url.replace(f":{port}/", f":{relay.port}/"))
    slow = Bureau(cut_off.jobs, Here(), b"secret", KINDS)
    made = order([5, 6], "cut off")
    asyncio.run(bureau.jobs.start(made))

    async def both() -> Job:
        batch = await slow.jobs.take_one("slow", made.id, 1)
        assert batch is not None
        given = await slow.jobs.read(COUNTING, batch)
        relay.cut()
        late = asyncio.create_task(slow.jobs.keep(COUNTING, batch, given**2))
        await asyncio.to_thread(_end_leases, bureau)
        for number in (1, 2):
            other = await bureau.jobs.take_one("other", made.id, number)
            assert other is not None
            await work(bureau, other)
        assert not late.done()
        relay.mend()
        with pytest.raises(RuntimeError, match=f"batch 1 of job {made.id}"):
            await late
        found = await bureau.jobs.job(made.id)
        assert found is not None
        return found

    found = asyncio.run(both())
    assert (found.state, found.done, found.result) == ("done", 2, {"sum": 61})
    assert (rows(bureau, made.id), fence(bureau, made.id, 1)) == (2, 2)
    slow.judging.close()
    cut_off.close()
    relay.close()


def test_a_worker_that_is_stopped_while_it_starts_leaves_nothing_running(url: str, bureau: Bureau) -> None:
    async def stopped(moment: float) -> list[str]:
        before = asyncio.all_tasks()
        working = asyncio.create_task(queue.run(queue.application(url, bureau, 1), 1))
        await asyncio.sleep(moment)
        working.cancel()
        await asyncio.wait([working])
        return [one.get_name() for one in asyncio.all_tasks() - before]

    assert [asyncio.run(stopped(0.002 * step)) for step in range(12)] == [[]] * 12


class Away:
    """The side of a worker whose database is away at first, so long that no connection could be opened."""

    def __init__(self) -> None:
        self.opened, self.works = 0, asyncio.Event()

    async def open_async(self) -> None:
        self.opened += 1
        if self.opened == 1:
            raise PoolTimeout("pool initialization incomplete after 30.0 sec")

    async def close_async(self) -> None:
        pass

    async def run_worker_async(self, **rules: Any) -> None:
        self.works.set()
        await asyncio.Event().wait()


def test_an_outage_in_which_no_connection_can_be_opened_does_not_end_the_work(
    bureau: Bureau, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(queue, "AGAIN", 0)

    async def worked() -> int:
        away = Away()
        monkeypatch.setattr(queue, "application", lambda *tools: away)
        working = asyncio.create_task(queue.run_on("postgresql://", bureau, 1))
        async with asyncio.timeout(10):
            await away.works.wait()
        working.cancel()
        await asyncio.gather(working, return_exceptions=True)
        return away.opened

    assert asyncio.run(worked()) == 2
