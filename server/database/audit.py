"""The audit log: each line carries the digest of the one before, so that a changed or missing line is seen.

The last line is noted among the settings, and a new line is bound to what is noted: if the last lines are cut off,
neither the end nor the next line fits.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping, Sequence
from datetime import UTC, datetime
from typing import TypeVar

from sqlalchemy import Connection, RowMapping, func, insert, select, union_all, update

from server.database.connections import Connections
from server.storage.audit import Action, Checked, End, Entry, Line
from server.tables import audit, courses, persons, settings, task_sets
from server.web import ids

T = TypeVar("T")
LOCK = 0x6C6F  # any number, the same on all hosts: lines are added one after the other
NOTHING = End(0, "0" * 64)  # what stands before the first line
NOTED = settings.c.name == "audit_end"
AT_ONCE = 1000  # lines read together when the chain is walked


class Audit:
    """The audit log of one store."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections

    async def note(self, entry: Entry) -> None:
        """Write down something that changes nothing else, such as an export."""
        await self._connections.write(lambda connection: note(connection, entry))

    async def lines(self, course: str | None, before: int | None, most: int) -> Sequence[Line]:
        """List the lines of a course, or all, before a line, the newest first."""
        query = select(audit).order_by(audit.c.id.desc()).limit(most)
        query = query if course is None else query.where(audit.c.course == course)
        query = query if before is None else query.where(audit.c.id < before)
        rows = await self._connections.read(lambda connection: connection.execute(query).mappings().all())
        return [line_of(row) for row in rows]

    async def names(self, numbers: Collection[str]) -> Mapping[str, str]:
        """Give the names of people and the titles of sets and courses that are there."""
        named = (persons.c.id, persons.c.name), (task_sets.c.id, task_sets.c.title), (courses.c.id, courses.c.title)
        query = union_all(*(select(number, name).where(number.in_(numbers)) for number, name in named))
        rows = await self._connections.read(lambda connection: connection.execute(query).all())
        return {number: name for number, name in rows}

    async def check(self, earlier: End | None = None) -> Checked:
        """Walk the log: each line must fit to the one before, and the last ones and an earlier end must be there."""
        return await self._connections.read(lambda connection: _checked(connection, earlier or NOTHING))


def note(connection: Connection, entry: Entry) -> None:
    """Add a line, in the transaction of what it tells about."""
    if connection.dialect.name == "postgresql":
        connection.execute(select(func.pg_advisory_xact_lock(LOCK)))
    previous = _end(connection).digest
    now = datetime.now(UTC)
    values = {
        "time": now, "actor": entry.actor, "action": entry.action.value, "object": entry.object,
        "course": entry.course, "details": dict(entry.details),
    }  # fmt: skip
    digest = _digest(previous, now, entry)
    added = insert(audit).values(values | {"previous": previous, "digest": digest}).returning(audit.c.id)
    _note_end(connection, End(connection.execute(added).scalar_one(), digest))


def _end(connection: Connection) -> End:
    """Give the end that was noted; a store from before it was noted gives its last line."""
    noted = connection.execute(select(settings.c.value).where(NOTED)).scalar_one_or_none()
    if noted is not None:
        number, _, digest = noted.partition(" ")
        return End(int(number), digest)
    last = connection.execute(select(audit.c.id, audit.c.digest).order_by(audit.c.id.desc()).limit(1)).first()
    return End(*last) if last else NOTHING


def _note_end(connection: Connection, end: End) -> None:
    if connection.execute(update(settings).where(NOTED).values(value=str(end))).rowcount == 0:
        connection.execute(insert(settings), {"name": "audit_end", "value": str(end)})


def noting(write: Callable[[Connection], T], entry: Entry | None) -> Callable[[Connection], T]:
    """Make a piece of writing that writes down what it does; where it gives False it did nothing."""

    def written(connection: Connection) -> T:
        result = write(connection)
        if entry is not None and result is not False:
            note(connection, entry)
        return result

    return written


def _digest(previous: str, time: datetime, entry: Entry) -> str:
    told = [
        time.astimezone(UTC).isoformat(),
        entry.actor,
        entry.action,
        entry.object,
        entry.course,
        dict(entry.details),
    ]
    whole = json.dumps(told, sort_keys=True, ensure_ascii=True, allow_nan=False)
    return ids.digest(b"audit", previous.encode(), whole.encode())


def line_of(row: RowMapping) -> Line:
    """Make a line of a row of `audit`."""
    entry = Entry(row["actor"], Action(row["action"]), row["object"], row["course"], row["details"])
    return Line(row["id"], row["time"], entry, row["digest"])


def _checked(connection: Connection, earlier: End) -> Checked:
    due = [end for end in (earlier, _end(connection)) if end.number]  # lines may be added while the log is walked
    last = NOTHING
    while rows := _following(connection, last.number):
        for row in rows:
            line = line_of(row)
            told = End(line.number, line.digest)
            fits = row["previous"] == last.digest and line.digest == _digest(last.digest, line.time, line.entry)
            if not fits or any(end.number == told.number and end != told for end in due):
                return Checked(last, line.number)
            due, last = [end for end in due if end != told], told
    return Checked(last, min((end.number for end in due), default=None))


def _following(connection: Connection, after: int) -> Sequence[RowMapping]:
    query = select(audit).where(audit.c.id > after).order_by(audit.c.id).limit(AT_ONCE)
    return connection.execute(query).mappings().all()
