"""A kind of job for tests: each batch squares its piece; what it writes would be seen twice if it were done twice."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import Any

from sqlalchemy import Connection, insert, select

from server.judging.thread import JudgingThread
from server.storage.jobs import Batch, Ending, Job, Kept, Kind, Order
from server.tables import batches, settings
from server.web import ids

KIND = "counting"
PART = 0.02  # s


class Here(JudgingThread):
    """Computes apart on the thread of the judge: no process has to be started."""

    async def apart(self, compute: Callable[..., Any], tasks: Sequence[tuple[Any, ...]]) -> list[Any]:
        """Compute long tasks here."""
        return [await self.run(compute, *task) for task in tasks]


def order(pieces: Sequence[Any], subject: str = "S", kind: str = KIND, parts: int = 1) -> Order:
    return Order(ids.new(), kind, subject, None, {"by": "tests"}, pieces, None, datetime.now(UTC), parts)


def read(connection: Connection, batch: Batch) -> Any:
    return batch.piece


def compute(secret: bytes, piece: Any) -> int:
    """Square a number; a list is a number and the seconds it takes, a text cannot be squared."""
    number, seconds = piece if isinstance(piece, list) else (piece, 0)
    time.sleep(seconds)
    return int(number) ** 2


def compute_in_parts(secret: bytes, piece: Any, tell: Callable[[int], None]) -> int:
    """Square a number in as many parts as it says, each of which takes a moment."""
    for reached in range(1, int(piece) + 1):
        time.sleep(PART)
        tell(reached)
    return int(piece) ** 2


def write(connection: Connection, batch: Batch, outcome: Any) -> Kept:
    """Leave a row that nobody may leave twice."""
    connection.execute(insert(settings), {"name": f"{batch.job} {batch.number}", "value": str(outcome)})
    return Kept(outcome, b"document")


def finish(connection: Connection, job: Job) -> Ending:
    done = connection.execute(select(batches.c.result).where(batches.c.job == job.id)).scalars()
    total = sum(done)
    return Ending({"sum": total}, failed=total > 10_000)


def undo(connection: Connection, job: Job) -> None:
    connection.execute(settings.delete().where(settings.c.name.startswith(f"{job.id} ")))


COUNTING = Kind(KIND, read, compute, write, finish, undo)
TELLING = replace(COUNTING, name="telling", compute=compute_in_parts, tells=True)
KINDS = {KIND: COUNTING, TELLING.name: TELLING}


def left(connection: Connection, job: str) -> int:
    """Count the rows that the batches of a job have left."""
    rows = connection.execute(select(settings.c.name).where(settings.c.name.startswith(f"{job} ")))
    return len(rows.all())
