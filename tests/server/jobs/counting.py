"""A kind of job for tests: each batch squares its piece; what it writes would be seen twice if it were done twice."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from typing import Any

from sqlalchemy import Connection, insert, select

from server import ids
from server.judging import JudgingThread
from server.storage.jobs import Batch, Ending, Job, Kept, Kind, Order
from server.tables import batches, settings

KIND = "counting"


class Here(JudgingThread):
    """Computes apart on the thread of the judge: no process has to be started."""

    async def apart(self, compute: Callable[..., Any], tasks: Sequence[tuple[Any, ...]]) -> list[Any]:
        """Compute long tasks here."""
        return [await self.run(compute, *task) for task in tasks]


def order(pieces: Sequence[Any], subject: str = "S") -> Order:
    return Order(ids.new(), KIND, subject, None, {"by": "tests"}, pieces, None, datetime.now(UTC))


def read(connection: Connection, batch: Batch) -> Any:
    return batch.piece


def compute(secret: bytes, piece: Any) -> int:
    """Square a number; a list is a number and the seconds it takes, a text cannot be squared."""
    number, seconds = piece if isinstance(piece, list) else (piece, 0)
    time.sleep(seconds)
    return int(number) ** 2


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
KINDS = {KIND: COUNTING}


def left(connection: Connection, job: str) -> int:
    """Count the rows that the batches of a job have left."""
    rows = connection.execute(select(settings.c.name).where(settings.c.name.startswith(f"{job} ")))
    return len(rows.all())
