"""Regrading a set of many submissions: how fast, with how much memory, and what a second worker brings.

Half of the submissions are right; of the others each has a wrong answer of its own, for which slips are tried. The
first regrade finds another grade for every submission and writes it; the second one finds the same to the last sign and
writes nothing. Run: ``uv run python benchmarks/regrade.py --submissions 100000``.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import asyncio
import os
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from datetime import UTC, datetime, timedelta
from multiprocessing import get_context
from tempfile import TemporaryDirectory
from typing import Any

from sqlalchemy import insert

from exercises import catalogue, verifying
from exercises.variants import deal, dump
from server.database import Database, regrades
from server.database.engine import engine
from server.jobs.engine import Engine
from server.jobs.kinds import KINDS
from server.jobs.working import Bureau
from server.judging.thread import JudgingThread
from server.migrate import migrate
from server.regrading import job as regrade
from server.regrading.replay import Lot, replay
from server.sets.rules import Rules
from server.settings import Settings
from server.storage.jobs import Batch
from server.tables import courses, deck, grades, owners, persons, slots, submissions, task_sets, variants

EXERCISE, SET, SECRET = "slider_crank", "SSSS-SSSS-SSSS", b"a secret of the benchmark"
PER_VARIANT = 20
NOW = datetime(2026, 12, 1, 12, tzinfo=UTC)
AT_ONCE = 100  # variants that are written together
UNGRADED = {"verdicts": {}, "score": 0.0, "mistake": None, "counted": True, "provisional": False,
            "grader_version": "0", "slip": None}  # fmt: skip
PAGE = os.sysconf("SC_PAGESIZE")  # bytes
COMPARED = 24  # batches with which one worker is compared with two


def lay(url: str, number: int) -> None:
    """Write a published set with so many submissions."""
    migrate(url)
    store = engine(url, connections=1)
    with store.begin() as connection:
        connection.execute(insert(courses), {"id": "C", "title": "C", "language": "pl", "time_zone": "UTC",
                                             "archived": False, "created": NOW})  # fmt: skip
        rules = Rules().model_dump(mode="json")
        made = {"id": SET, "course": "C", "title": "S", "rules": rules, "revision": 1, "created": NOW}
        connection.execute(insert(task_sets), made | {"state": "published", "published": NOW})
        connection.execute(insert(slots), {"id": "T", "task_set": SET, "number": 1, "pool": [EXERCISE], "points": 1.0,
                                           "limits": {}})  # fmt: skip
    for first in range(0, number // PER_VARIANT, AT_ONCE):
        with store.begin() as connection:
            for seed in range(first, min(first + AT_ONCE, number // PER_VARIANT)):
                hand_in(connection, seed)
    store.dispose()


def hand_in(connection: Any, seed: int) -> None:
    """Write a card of a student, and what that student has handed in to it."""
    who, variant = f"person {seed:06}", deal(EXERCISE, seed)
    stored, reference = dump(variant), verifying.record(variant)
    asked = catalogue.load(EXERCISE).exercise.answers_of(variant.givens)
    weights = {name: grader.weight for name, grader in asked.items()}
    connection.execute(insert(owners), {"id": who, "anonymous": False, "created": NOW})
    connection.execute(insert(persons), {"id": who, "name": who, "role": "student", "active": True, "created": NOW})
    connection.execute(insert(variants), stored | {"id": who, "owner": who, "created": NOW, "last_used": NOW})
    card = {"id": who, "slot": "T", "number": seed + 1, "code": str(seed), "shown": {}, "reference": reference,
            "weights": weights, "person": who, "turn": 1, "variant": who, "dealt": NOW}  # fmt: skip
    connection.execute(insert(deck), stored | card)
    wrong = [reference["texts"] | {"l3": f"{turn + 1}00,5 mm"} for turn in range(PER_VARIANT // 2)]
    handed = [
        {"receipt": f"{seed:06} {turn}", "variant": who, "owner": who, "answers": answers,
         "time": NOW + timedelta(seconds=turn), "body": "b", "digest": "d", "language": "pl"}
        for turn, answers in enumerate(wrong + [reference["texts"]] * (PER_VARIANT - len(wrong)))
    ]  # fmt: skip
    connection.execute(insert(submissions), handed)
    first = {"grader_version": "0", "grade": UNGRADED, "counted": True, "time": NOW}
    connection.execute(insert(grades), [first | {"submission": one["receipt"]} for one in handed])


async def regraded(url: str, workers: int, memory: list[tuple[int, int]]) -> tuple[float, dict[str, int]]:
    """Regrade the set once; gives the seconds and the counts, and notes meanwhile what is in memory."""
    database, judging = Database(url), JudgingThread(workers)
    worker = Engine(Bureau(database.jobs, judging, SECRET, KINDS), "benchmark", workers)
    await judging.apart(pow, [(2, 2)] * workers)  # the processes are there
    working = asyncio.create_task(worker.run())
    found = await database.sets.task_set(SET)
    assert found is not None
    start = time.perf_counter()
    number = await regrade.order(database.jobs, found, "command line", None, dry_run=False)
    worker.wake()
    while (job := await database.jobs.job(number)) is None or job.live:
        memory.append((resident(os.getpid()), max(map(resident, computing(judging)), default=0)))
        await asyncio.sleep(0.05)
    seconds = time.perf_counter() - start
    working.cancel()
    await asyncio.gather(working, return_exceptions=True)
    judging.close()
    database.close()
    assert job.state == "done", job
    return seconds, dict(job.result)


def computing(judging: JudgingThread) -> list[int]:
    """Give the numbers of the processes that compute apart."""
    pool = judging._apart._pool
    return list((pool._processes or {}) if pool else {})


def resident(process: int) -> int:
    """Give the bytes of a process that are in memory; none of one that has ended."""
    try:
        return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * PAGE
    except OSError:
        return 0


def lots(url: str) -> Iterator[Lot]:
    """Read some batches, as a regrade does."""
    store = engine(url, connections=1)
    with store.connect() as connection:
        payload = {"task_set": SET, "allow_lower": False}
        for number, piece in enumerate(regrades.pieces(connection, SET, whole=False)[:COMPARED], 1):
            yield regrades.read(connection, Batch("J", "regrade", number, 1, payload, piece))
    store.dispose()


def timed(lot: Lot) -> tuple[int, float]:
    """Judge a batch; gives how many submissions, and the seconds that a processor has worked for it."""
    start = time.process_time()
    return replay(SECRET, lot).counts["judged"], time.process_time() - start


def grading(found: list[Lot], workers: int) -> tuple[float, float]:
    """Judge batches in so many processes, which have been started before; gives submissions a second, by the clock and
    by the work of one processor."""
    with ProcessPoolExecutor(workers, get_context("spawn")) as pool:
        list(pool.map(timed, [found[0]] * workers))
        start = time.perf_counter()
        done = list(pool.map(timed, found))
        judged = sum(number for number, _ in done)
        return judged / (time.perf_counter() - start), judged / sum(seconds for _, seconds in done)


def main() -> None:
    """Lay the set, regrade it twice, and compare one worker with two."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--submissions", type=int, default=10_000)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    with TemporaryDirectory() as folder:
        url = Settings(Path(folder)).store_url
        with ProcessPoolExecutor(1, get_context("spawn")) as apart:  # what it remembers is not the server's
            apart.submit(lay, url, given.submissions).result()
        memory: list[tuple[int, int]] = []
        for what in ("every grade changes", "no grade changes"):
            seconds, counts = asyncio.run(regraded(url, given.workers, memory))
            print(f"{what}: {counts['judged'] / seconds:.0f} submissions/s end to end, {counts}", flush=True)
        found = list(lots(url))
        (one, work), (two, _) = (grading(found, workers) for workers in (1, 2))
        print(f"grading part: {one:.0f}/s with 1 worker, {two:.0f}/s with 2, {two / one:.2f}x")
        print(f"grading part by the work of one processor: {work:.0f}/s")
    print(f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors at the end")
    for who, seen in zip(("server", "largest worker"), zip(*memory, strict=True), strict=True):
        parts = [max(seen[len(seen) * tenth // 10 : len(seen) * (tenth + 1) // 10]) / 1e6 for tenth in range(10)]
        print(f"memory of the {who}, the most in each tenth of the time: {', '.join(f'{p:.0f}' for p in parts)} MB")


if __name__ == "__main__":
    main()
