"""Jobs in the database: taken under a fence, written once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import UTC, datetime, timedelta
from typing import Any

from sqlalchemy import ColumnElement, Connection, and_, func, insert, or_, select, update

from server.database.connections import Connections
from server.storage.jobs import (
    CANCELLED,
    DONE,
    FAILED,
    LIVE,
    RUNNING,
    WAITING,
    Batch,
    Busy,
    Fenced,
    Job,
    Json,
    Kind,
    Order,
    Progress,
)
from server.tables import batches, jobs

LEASE = 30.0  # s
MOST_FAILURES = 3  # of one batch
LONGEST_ERROR = 500
JOB = [column for column in jobs.columns if column.name != "live"]


class Jobs:
    """The jobs of one store."""

    def __init__(self, connections: Connections, lease: float = LEASE) -> None:
        self._connections = connections
        self.lease = lease

    async def start(self, order: Order, record: Callable[[Connection], None] | None = None) -> None:
        """Store a job with its batches, and the record that needs it, together."""
        await self._connections.write(lambda connection: start(connection, order, record))

    async def plan(self, plan: Callable[[Connection], Sequence[Json]]) -> Sequence[Json]:
        """Read the pieces of a job to be."""
        return await self._connections.read(plan)

    async def job(self, number: str) -> Job | None:
        """Give a job."""
        return await self._connections.read(lambda connection: _job(connection, number))

    async def latest(self, kind: str, subject: str) -> Job | None:
        """Give the last job of a kind on a subject."""
        mine = jobs.c.kind == kind, jobs.c.subject == subject
        query = select(*JOB).where(*mine).order_by(jobs.c.created.desc()).limit(1)
        row = await self._connections.read(lambda connection: connection.execute(query).mappings().first())
        return None if row is None else Job(**row)

    async def progress(self, number: str) -> Sequence[Progress]:
        """Tell how far each batch of a job is."""
        refused = and_(batches.c.state == DONE, batches.c.reached < batches.c.parts)
        columns = batches.c.piece, batches.c.reached, batches.c.parts, refused
        query = select(*columns).where(batches.c.job == number).order_by(batches.c.number)
        rows = await self._connections.read(lambda connection: connection.execute(query).all())
        return [Progress(*row) for row in rows]

    async def results(self, number: str, after: int, most: int) -> Sequence[tuple[int, Json]]:
        """List number and result of the batches that are done, behind a number."""
        done = batches.c.job == number, batches.c.number > after, batches.c.state == DONE
        query = select(batches.c.number, batches.c.result).where(*done).order_by(batches.c.number).limit(most)
        rows = await self._connections.read(lambda connection: connection.execute(query).all())
        return [(row.number, row.result) for row in rows]

    async def content(self, number: str, batch: int) -> bytes | None:
        """Give the document that a batch has made."""
        query = select(batches.c.content).where(batches.c.job == number, batches.c.number == batch)
        return await self._connections.read(lambda connection: connection.execute(query).scalar_one_or_none())

    async def take(self, worker: str) -> Batch | None:
        """Take the next batch that waits or whose worker is gone; shorter jobs go first."""
        if not await self._connections.read(_something_waits):
            return None
        return await self._connections.write(lambda connection: _take_next(connection, worker, self.lease))

    async def take_one(self, worker: str, number: str, batch: int) -> Batch | None:
        """Take a certain batch, unless it is done or in other hands."""
        return await self._connections.write(lambda connection: _take(connection, worker, number, batch, self.lease))

    async def renew(self, batch: Batch, reached: int = 0) -> bool:
        """Keep a batch for longer, and how many of its parts are done; tells whether it is still this worker's."""
        return await self._connections.write(lambda connection: _renew(connection, batch, reached, self.lease))

    async def read(self, kind: Kind, batch: Batch) -> Any:
        """Read what a batch works on."""
        return await self._connections.read(lambda connection: kind.read(connection, batch))

    async def keep(self, kind: Kind, batch: Batch, outcome: Any) -> None:
        """Write what came of a batch and mark it done, together, once."""
        await self._connections.write(lambda connection: _keep(connection, kind, batch, outcome))

    async def give_back(self, batch: Batch) -> None:
        """Let others take a batch."""
        await self._connections.write(lambda connection: _give_back(connection, batch, 0))

    async def fail(self, kind: Kind, batch: Batch, error: str) -> None:
        """Note that a batch failed; it is tried some times, then the job has failed."""
        await self._connections.write(lambda connection: _fail(connection, kind, batch, error))

    async def take_back(self, worker: str | None = None) -> int:
        """Take batches back whose lease is over, or all of a worker that was started anew; gives how many."""
        return await self._connections.write(lambda connection: _take_back(connection, worker))

    async def cancel(self, kind: Kind, number: str) -> bool:
        """End a job; tells whether it was under way."""
        return await self._connections.write(lambda connection: _end(connection, kind, number, CANCELLED))

    async def forget(self, before: datetime) -> int:
        """Forget the documents of jobs that ended before a moment; gives how many."""
        old = select(jobs.c.id).where(jobs.c.finished < before)
        made = batches.c.content.is_not(None), batches.c.job.in_(old)
        gone = update(batches).where(*made).values(content=None)
        return await self._connections.write(lambda connection: connection.execute(gone).rowcount)


def start(connection: Connection, order: Order, record: Callable[[Connection], None] | None) -> None:
    """Store a job with its batches, hand them to the queue, and write the record that needs it.

    Raises:
        Busy: One of this kind is under way on the same subject.
    """
    live = f"{order.kind} {order.subject}"
    other = connection.execute(select(jobs.c.id).where(jobs.c.live == live)).scalar_one_or_none()
    if other is not None:
        raise Busy(other)
    values = {
        "id": order.id, "kind": order.kind, "subject": order.subject, "course": order.course, "live": live,
        "payload": dict(order.payload), "state": WAITING, "done": 0, "total": len(order.pieces),
        "person": order.person, "created": order.created,
    }  # fmt: skip
    connection.execute(insert(jobs), values)
    fresh = {"job": order.id, "state": WAITING, "fence": 0, "failures": 0, "parts": order.parts, "reached": 0}
    rows = [fresh | {"number": number, "piece": piece} for number, piece in enumerate(order.pieces, 1)]
    connection.execute(insert(batches), rows)
    _hand_out(connection, [(order.id, number) for number in range(1, len(rows) + 1)])
    if record is not None:
        record(connection)


def _hand_out(connection: Connection, waiting: Sequence[tuple[str, int]]) -> None:
    """Put batches into the queue; the embedded store has none: there the table is looked at."""
    if connection.dialect.name != "postgresql":
        return
    from server.database import queue

    for job in {job for job, _ in waiting}:
        total = connection.execute(select(jobs.c.total).where(jobs.c.id == job)).scalar_one()
        queue.defer(connection, job, [number for name, number in waiting if name == job], total)


def _now(connection: Connection) -> datetime:
    """Give the time by the clock of the store, which all its workers share."""
    if connection.dialect.name != "postgresql":
        return datetime.now(UTC)
    now: datetime = connection.execute(select(func.clock_timestamp())).scalar_one()
    return now


def _job(connection: Connection, number: str) -> Job | None:
    row = connection.execute(select(*JOB).where(jobs.c.id == number)).mappings().first()
    return None if row is None else Job(**row)


def _free(now: datetime) -> ColumnElement[bool]:
    """Whether a batch may be taken: it waits, or its worker has been silent for too long."""
    silent = and_(batches.c.state == RUNNING, batches.c.lease < now)
    return and_(jobs.c.state.in_(LIVE), or_(batches.c.state == WAITING, silent))


def _something_waits(connection: Connection) -> bool:
    query = select(batches.c.job).join(jobs).where(_free(_now(connection))).limit(1)
    return connection.execute(query).first() is not None


def _take_next(connection: Connection, worker: str, lease: float) -> Batch | None:
    shortest = jobs.c.total - jobs.c.done, jobs.c.created, batches.c.job, batches.c.number
    query = select(batches.c.job, batches.c.number).join(jobs).where(_free(_now(connection))).order_by(*shortest)
    found = connection.execute(query.limit(1).with_for_update(skip_locked=True, of=batches)).first()
    return None if found is None else _take(connection, worker, found.job, found.number, lease)


def _take(connection: Connection, worker: str, number: str, batch: int, lease: float) -> Batch | None:
    now = _now(connection)
    mine = batches.c.job == number, batches.c.number == batch
    found = select(batches, jobs.c.kind, jobs.c.payload).join(jobs).where(*mine, _free(now))
    row = connection.execute(found.with_for_update(of=batches)).first()
    if row is None:
        return None
    held = {"state": RUNNING, "fence": row.fence + 1, "lease": now + timedelta(seconds=lease), "worker": worker}
    held["reached"] = 0  # whoever had it before has left nothing
    connection.execute(update(batches).where(*mine), held)
    connection.execute(update(jobs).where(jobs.c.id == number, jobs.c.state == WAITING).values(state=RUNNING))
    return Batch(number, row.kind, batch, row.fence + 1, row.payload, row.piece)


def _held(batch: Batch) -> tuple[ColumnElement[bool], ...]:
    """Whether a batch is still in the hands that took it."""
    mine = batches.c.job == batch.job, batches.c.number == batch.number
    return *mine, batches.c.fence == batch.fence, batches.c.state == RUNNING


def _renew(connection: Connection, batch: Batch, reached: int, lease: float) -> bool:
    kept = {"lease": _now(connection) + timedelta(seconds=lease), "reached": reached}
    live = batches.c.job.in_(select(jobs.c.id).where(jobs.c.state.in_(LIVE)))
    return connection.execute(update(batches).where(*_held(batch), live).values(kept)).rowcount == 1


def _keep(connection: Connection, kind: Kind, batch: Batch, outcome: Any) -> None:
    done = update(batches).where(*_held(batch)).values(state=DONE, lease=None)
    if connection.execute(done).rowcount != 1:
        raise Fenced(f"batch {batch.number} of job {batch.job}")
    kept = kind.write(connection, batch, outcome)
    mine = batches.c.job == batch.job, batches.c.number == batch.number
    left = {"result": kept.result, "content": kept.content, "reached": 0 if kept.refused else batches.c.parts}
    connection.execute(update(batches).where(*mine).values(**left))
    counted = update(jobs).where(jobs.c.id == batch.job, jobs.c.state == RUNNING).values(done=jobs.c.done + 1)
    if connection.execute(counted).rowcount != 1:
        raise Fenced(f"job {batch.job} has ended")
    job = _job(connection, batch.job)
    assert job is not None
    if job.done == job.total:
        ending = kind.finish(connection, job)
        _end(connection, kind, job.id, FAILED if ending.failed else DONE, result=ending.result)


def _give_back(connection: Connection, batch: Batch, failures: int) -> bool:
    free = {"state": WAITING, "lease": None, "worker": None, "failures": batches.c.failures + failures}
    if connection.execute(update(batches).where(*_held(batch)).values(**free)).rowcount != 1:
        return False
    _hand_out(connection, [(batch.job, batch.number)])
    return True


def _fail(connection: Connection, kind: Kind, batch: Batch, error: str) -> None:
    if not _give_back(connection, batch, 1):
        return
    mine = batches.c.job == batch.job, batches.c.number == batch.number
    if connection.execute(select(batches.c.failures).where(*mine)).scalar_one() >= MOST_FAILURES:
        _end(connection, kind, batch.job, FAILED, error=error[:LONGEST_ERROR])


def _take_back(connection: Connection, worker: str | None) -> int:
    left = batches.c.worker == worker if worker else batches.c.lease < _now(connection)
    query = select(batches.c.job, batches.c.number).where(batches.c.state == RUNNING, left)
    found = connection.execute(query.with_for_update(skip_locked=True)).all()
    for job, number in found:
        mine = batches.c.job == job, batches.c.number == number
        free = {"state": WAITING, "lease": None, "worker": None}
        connection.execute(update(batches).where(*mine).values(**free))
    _hand_out(connection, [(job, number) for job, number in found])
    return len(found)


def _end(
    connection: Connection, kind: Kind, number: str, state: str, *, result: Json = None, error: str | None = None
) -> bool:
    """End a live job; what its batches have written is taken back unless it is done."""
    ended = {"state": state, "live": None, "result": result, "error": error, "finished": _now(connection)}
    live = update(jobs).where(jobs.c.id == number, jobs.c.state.in_(LIVE))
    if connection.execute(live.values(**ended)).rowcount != 1:
        return False
    job = _job(connection, number)
    assert job is not None
    if state != DONE:
        kind.undo(connection, job)
    return True
