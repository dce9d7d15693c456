"""Power cuts while jobs are done: a worker is killed at random moments, and every batch must be done once in effect.

Run: ``uv run python benchmarks/jobs.py --kills 1000`` (embedded store), or with ``DATABASE_URL`` and an empty database
for Procrastinate. A batch leaves a row under a key of its own: one that is missing is lost, a second one cannot be.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = str(Path(__file__).resolve().parents[1])
sys.path[0] = ROOT  # else benchmarks/http.py would stand before the library's http

import argparse  # noqa: E402
import asyncio  # noqa: E402
import os  # noqa: E402
import random  # noqa: E402
import subprocess  # noqa: E402
import time  # noqa: E402
from tempfile import TemporaryDirectory  # noqa: E402

from server.database import Database  # noqa: E402
from server.migrate import migrate  # noqa: E402
from server.settings import Settings  # noqa: E402
from tests.server.jobs.counting import left, order  # noqa: E402

WORKER = """
import asyncio, sys
from server.database import Database
from server.jobs.engine import Engine
from server.jobs.working import Bureau
from tests.server.jobs.counting import KINDS, Here
if __name__ == "__main__":
    database = Database(sys.argv[1])
    database.jobs.lease = 2.0
    bureau = Bureau(database.jobs, Here(), b"s", KINDS)
    print("works", flush=True)
    if sys.argv[1].startswith("sqlite"):
        asyncio.run(Engine(bureau, "server", 2).run())
    else:
        from server.jobs import queue
        queue.TAKING_BACK, queue.SILENT, queue.HEARTBEAT = "* * * * * *", 3.0, 1.0
        asyncio.run(queue.run(queue.application(sys.argv[1], bureau, 2), 2, signals=True))
"""
PIECES = [[number, 0.02] for number in range(20)]
SUM = sum(number**2 for number, _ in PIECES)
LONGEST_LIFE = 0.6  # s of a worker from when it works
PATIENCE = 120.0  # s for what is left in the end


def killed(url: str, chance: random.Random) -> None:
    """Let a worker live for a moment, then end it as a power cut would."""
    process = start(url)
    time.sleep(chance.uniform(0, LONGEST_LIFE))
    process.kill()
    process.communicate()


def start(url: str) -> subprocess.Popen[bytes]:
    """Start a worker and wait until it works."""
    environ = os.environ | {"PYTHONPATH": ROOT}
    process = subprocess.Popen([sys.executable, "-c", WORKER, url], env=environ, stdout=subprocess.PIPE)
    assert process.stdout is not None
    process.stdout.readline()
    return process


async def live(database: Database, numbers: list[str]) -> int:
    """Count the jobs that have not ended."""
    found = [await database.jobs.job(number) for number in numbers]
    return sum(job is not None and job.live for job in found)


def main() -> None:
    """Kill, keep enough jobs waiting, let the last worker finish, and count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    chance, numbers = random.Random(given.seed), list[str]()
    with TemporaryDirectory() as folder:
        url = Settings(Path(folder), database_url=os.environ.get("DATABASE_URL")).store_url
        migrate(url)
        database = Database(url)
        for _ in range(given.kills):
            if asyncio.run(live(database, numbers)) < 2:
                made = order(PIECES, str(len(numbers)))
                asyncio.run(database.jobs.start(made))
                numbers.append(made.id)
            killed(url, chance)
        last, deadline = start(url), time.monotonic() + PATIENCE
        while asyncio.run(live(database, numbers)) and time.monotonic() < deadline:
            time.sleep(0.1)
        last.kill()
        last.communicate()
        jobs = [asyncio.run(database.jobs.job(number)) for number in numbers]
        rows = [asyncio.run(database.jobs.plan(lambda c, n=number: [left(c, n)]))[0] for number in numbers]
        database.close()
    right = sum(job is not None and (job.state, job.result) == ("done", {"sum": SUM}) for job in jobs)
    print(f"{given.kills} kills, {len(numbers)} jobs of {len(PIECES)} batches: {right} done with the right result")
    print(f"batches lost or doubled: {sum(abs(number - len(PIECES)) for number in rows)}")
    sys.exit(0 if right == len(numbers) and set(rows) <= {len(PIECES)} else 1)


if __name__ == "__main__":
    main()
