"""The audit log: written with the act, bound line to line, read page by page."""

from __future__ import annotations

import asyncio
from functools import partial

import pytest
from sqlalchemy import Connection, delete, update

from server.database import Database
from server.database.audit import note, noting
from server.storage.audit import Action, Entry
from server.tables import audit, settings

ENTRY = Entry("AAAA-AAAA-AAAA", Action.ROLE_CHANGED, "BBBB-BBBB-BBBB", "CCCC-CCCC-CCCC", {"role": "lecturer", "n": 1.5})


def write(database: Database, *pieces: object) -> None:
    async def all_of_them() -> None:
        for piece in pieces:
            await database._connections.write(piece)  # type: ignore[arg-type]

    asyncio.run(all_of_them())


def fill(database: Database, number: int) -> None:
    write(
        database,
        *(partial(note, entry=ENTRY if at % 2 else Entry("server", Action.REGRADED, "x")) for at in range(number)),
    )


def test_a_line_comes_back_as_it_was_written(database: Database) -> None:
    asyncio.run(database.audit.note(ENTRY))
    (line,) = asyncio.run(database.audit.lines(None, None, 9))
    assert line.entry == ENTRY
    assert asyncio.run(database.audit.check()).broken is None


def test_lines_are_paged_from_the_newest_by_course(database: Database) -> None:
    fill(database, 6)
    first = asyncio.run(database.audit.lines(None, None, 4))
    rest = asyncio.run(database.audit.lines(None, first[-1].number, 4))
    assert [line.number for line in (*first, *rest)] == [6, 5, 4, 3, 2, 1]
    mine = asyncio.run(database.audit.lines(ENTRY.course, None, 9))
    assert [line.number for line in mine] == [6, 4, 2]
    assert asyncio.run(database.audit.lines("DDDD-DDDD-DDDD", None, 9)) == []


def test_an_act_that_fails_or_does_nothing_leaves_no_line(database: Database) -> None:
    def fails(connection: Connection) -> bool:
        note(connection, ENTRY)
        raise ValueError("the act fails")

    with pytest.raises(ValueError, match="the act fails"):
        write(database, fails)
    write(database, noting(lambda connection: False, ENTRY))
    assert asyncio.run(database.audit.lines(None, None, 9)) == []
    write(database, noting(lambda connection: None, ENTRY))
    assert len(asyncio.run(database.audit.lines(None, None, 9))) == 1


def test_a_changed_or_missing_line_is_seen(database: Database) -> None:
    fill(database, 5)
    changed = update(audit).where(audit.c.id == 4).values(object="DDDD-DDDD-DDDD")
    write(database, lambda connection: connection.execute(changed))
    assert asyncio.run(database.audit.check()).broken == 4
    write(database, lambda connection: connection.execute(delete(audit).where(audit.c.id == 2)))
    assert asyncio.run(database.audit.check()).broken == 3


def test_lines_that_were_cut_off_at_the_end_are_missed_then_and_later(database: Database) -> None:
    fill(database, 5)
    whole = asyncio.run(database.audit.check())
    assert (whole.end.number, whole.broken) == (5, None)
    write(database, lambda connection: connection.execute(delete(audit).where(audit.c.id >= 4)))
    assert asyncio.run(database.audit.check()).broken == 5
    fill(database, 2)  # what comes after does not hide it
    after = asyncio.run(database.audit.lines(None, None, 2))[-1].number
    assert asyncio.run(database.audit.check()).broken == after


def test_an_end_that_was_kept_elsewhere_shows_a_log_that_was_written_anew(database: Database) -> None:
    fill(database, 3)
    kept = asyncio.run(database.audit.check()).end
    fill(database, 2)
    assert asyncio.run(database.audit.check(kept)).broken is None
    write(database, lambda connection: (connection.execute(delete(audit)), connection.execute(delete(settings))))
    assert asyncio.run(database.audit.check(kept)).broken == 3
    fill(database, 4)
    assert asyncio.run(database.audit.check()).broken is None and asyncio.run(database.audit.check(kept)).broken


def test_a_log_from_before_its_end_was_noted_goes_on(database: Database) -> None:
    fill(database, 3)
    write(database, lambda connection: connection.execute(delete(settings)))
    assert asyncio.run(database.audit.check()).broken is None
    fill(database, 1)
    assert asyncio.run(database.audit.check()).broken is None
    write(database, lambda connection: connection.execute(delete(audit).where(audit.c.id == 4)))
    assert asyncio.run(database.audit.check()).broken == 4
