"""What the publishing of a set writes: cards slot by slot; the set may be used once all of them are dealt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from datetime import UTC, datetime

from sqlalchemy import Connection, delete, select, update

from server.database import deck
from server.database.audit import note
from server.database.sets import task_set
from server.sets.dealing import Drawn, Plan, Trouble
from server.sets.planning import planned
from server.sets.planning import stored as card_of
from server.storage.audit import Action, Entry
from server.storage.jobs import DONE, Batch, Ending, Job, Kept
from server.storage.sets import DRAFT, PUBLISHED, PUBLISHING, NotADraft
from server.tables import batches, slots, task_sets
from server.tables import deck as cards


def begin(connection: Connection, number: str, revision: int) -> None:
    """Freeze a draft while its deck is dealt.

    Raises:
        NotADraft: It is published already, or has changed meanwhile.
    """
    draft = task_sets.c.id == number, task_sets.c.state == DRAFT, task_sets.c.revision == revision
    if connection.execute(update(task_sets).where(*draft).values(state=PUBLISHING)).rowcount != 1:
        raise NotADraft(number)


def read(connection: Connection, batch: Batch) -> Plan:
    """Plan one slot of a set."""
    found = task_set(connection, batch.payload["task_set"])
    assert found is not None  # it is frozen while the job is under way
    return next(plan for plan in planned(found, tuple(batch.payload["seats"])) if plan.number == batch.piece)


def write(connection: Connection, batch: Batch, outcome: tuple[Sequence[Drawn], Trouble | None]) -> Kept:
    """Store the cards of a slot, or why there are none."""
    drawn, trouble = outcome
    if trouble is not None:
        return Kept({"cards": 0, "trouble": asdict(trouble)}, refused=True)
    theirs = slots.c.task_set == batch.payload["task_set"], slots.c.number == batch.piece
    slot = connection.execute(select(slots.c.id).where(*theirs)).scalar_one()
    members = set(batch.payload["roster"])
    deck.add(
        connection,
        [card_of(slot, n, one, one.seat if one.seat in members else None) for n, one in enumerate(drawn, 1)],
    )
    return Kept({"cards": len(drawn)})


def finish(connection: Connection, job: Job) -> Ending:
    """Publish the set, and write that down; or tell what stands against it."""
    mine = batches.c.job == job.id, batches.c.state == DONE
    told = connection.execute(select(batches.c.result).where(*mine).order_by(batches.c.number)).scalars().all()
    troubles = [one["trouble"] for one in told if "trouble" in one]
    if troubles:
        return Ending({"troubles": troubles}, failed=True)
    made = {"cards": sum(one["cards"] for one in told)}
    here = task_sets.c.id == job.subject, task_sets.c.state == PUBLISHING
    connection.execute(update(task_sets).where(*here).values(state=PUBLISHED, published=datetime.now(UTC)))
    note(connection, Entry(job.payload["actor"], Action.SET_PUBLISHED, job.subject, job.course, made))
    return Ending(made)


def undo(connection: Connection, job: Job) -> None:
    """Make the set a draft again, without cards."""
    here = task_sets.c.id == job.subject, task_sets.c.state == PUBLISHING
    if connection.execute(update(task_sets).where(*here).values(state=DRAFT)).rowcount == 1:
        theirs = select(slots.c.id).where(slots.c.task_set == job.subject)
        connection.execute(delete(cards).where(cards.c.slot.in_(theirs)))
