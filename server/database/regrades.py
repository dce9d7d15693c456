"""What a regrade reads and writes: cards with what was handed in to them; new grades beside the old ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from itertools import groupby
from typing import Any

from sqlalchemy import Connection, Select, func, insert, select, update

from server.database.audit import note
from server.database.deck import WEIGHTS, weights_of
from server.regrading.replay import Dealt, Lot, Replayed, Work
from server.storage.audit import Action, Entry
from server.storage.jobs import DONE, Batch, Ending, Job, Json, Kept
from server.tables import batches, deck, grades, persons, slots, submissions, task_sets

BATCH = 400  # submissions, about
TIMED_OUT = "time-out "  # begins the body of a collected draft; that of what was sent is a digest
STORED = (deck.c.exercise, deck.c.version, deck.c.seed, deck.c.givens)


def pieces(connection: Connection, task_set: str, whole: bool) -> list[Json]:
    """Cut what was handed in to a set, or its whole deck, into batches: first and last card of each."""
    number = func.count().label("number")
    handed = submissions.c.variant == deck.c.variant
    query = _of_set(select(deck.c.id, number).join(submissions, handed, isouter=whole), task_set)
    made, size = list[Json](), BATCH
    for card, submitted in connection.execute(query.group_by(deck.c.id).order_by(deck.c.id)):
        if size >= BATCH:
            made.append([card, card])
            size = 0
        made[-1][1] = card
        size += submitted
    return made or [["", ""]]  # nothing was handed in: one batch says so


def _of_set(query: Select[Any], task_set: str) -> Select[Any]:
    return query.join(slots, slots.c.id == deck.c.slot).where(slots.c.task_set == task_set)


def _of_batch(query: Select[Any], batch: Batch) -> Select[Any]:
    first, last = batch.piece
    return _of_set(query, batch.payload["task_set"]).where(deck.c.id.between(first, last))


def read(connection: Connection, batch: Batch) -> Lot:
    """Read the cards of a batch, and what was handed in to them."""
    of_set = task_sets.c.id == batch.payload["task_set"]
    rules = connection.execute(select(task_sets.c.rules).where(of_set)).scalar_one()
    columns = (
        deck.c.id, deck.c.code, deck.c.variant, *STORED, deck.c.reference, *WEIGHTS, deck.c.person,
        slots.c.number, slots.c.attempts,
    )  # fmt: skip
    cards = connection.execute(_of_batch(select(*columns), batch)).mappings().all()
    works = _works(connection, batch)
    dealt, recompute = (_dealt(card, works.get(card["variant"], ())) for card in cards), _recompute(batch.payload)
    cards_read = tuple(one for one in dealt if one.works or recompute)
    return Lot(rules, batch.payload["allow_lower"], recompute, cards_read, _erased(connection, batch))


def _erased(connection: Connection, batch: Batch, *, hold: bool = False) -> frozenset[str]:
    """Name the people of a batch who are erased; `hold`: nobody else is, until what is written here is on disk."""
    query = _of_batch(select(persons.c.id, persons.c.erased).join(deck, deck.c.person == persons.c.id), batch)
    query = query.with_for_update(read=True, of=persons) if hold else query
    return frozenset(number for number, erased in connection.execute(query) if erased is not None)


def _recompute(payload: Mapping[str, Any]) -> bool:
    """Whether the references are computed anew; an older order does not speak of it."""
    return bool(payload.get("recompute_references"))


def _dealt(card: Any, works: Sequence[Work]) -> Dealt:
    stored = {column.name: card[column.name] for column in STORED}
    limited = card["attempts"] is not None
    own = card["id"], card["code"], stored, card["reference"], weights_of(card), card["person"]
    return Dealt(*own, card["number"], limited, tuple(works))


def _works(connection: Connection, batch: Batch) -> dict[str, list[Work]]:
    """Give what was handed in, by variant, each with its newest grade."""
    given = grades.alias()
    newest = select(func.max(given.c.id)).where(given.c.submission == submissions.c.receipt).scalar_subquery()
    columns = submissions.c.variant, submissions.c.receipt, submissions.c.answers, submissions.c.body
    judged = grades.c.grade, grades.c.grader_version, grades.c.counted
    query = _of_batch(select(*columns, *judged).join(deck, deck.c.variant == submissions.c.variant), batch)
    query = query.join(grades, grades.c.id == newest)
    rows = connection.execute(query.order_by(submissions.c.variant, submissions.c.time, submissions.c.receipt)).all()
    return {variant: [_work(row) for row in mine] for variant, mine in groupby(rows, lambda row: str(row.variant))}


def _work(row: Any) -> Work:
    return Work(
        row.receipt, row.answers, row.grade, row.grader_version, row.counted, row.body.startswith(TIMED_OUT)
    )  # fmt: skip


def write(connection: Connection, batch: Batch, outcome: Replayed) -> Kept:
    """Keep the grades and the references that are in force from now on; a dry run keeps none.

    What a reference was before stays in the result of the batch. What was read of somebody who has been erased since is
    written nowhere.
    """
    outcome, now = outcome.without(_erased(connection, batch, hold=True) - outcome.erased), datetime.now(UTC)
    if outcome.grades and not batch.payload["dry_run"]:
        given = [
            {"submission": one.receipt, "grader_version": one.version, "grade": one.grade, "counted": one.counted,
             "time": now, "reason": batch.payload["reason"] or one.effect, "job": batch.job}
            for one in outcome.grades
        ]  # fmt: skip
        connection.execute(insert(grades), given)
    for repair in () if batch.payload["dry_run"] else outcome.repairs:
        connection.execute(update(deck).where(deck.c.id == repair.card).values(reference=repair.reference))
    told = [repair.told for repair in outcome.repairs]
    return Kept({"counts": outcome.counts, "changes": list(outcome.changes), "references": told})


def finish(connection: Connection, job: Job) -> Ending:
    """Add up what the batches have found; a regrade that was not dry is written down in the audit log."""
    found = batches.c.job == job.id, batches.c.state == DONE
    total: dict[str, int] = {}
    for counts in connection.execute(select(batches.c.result["counts"]).where(*found)).scalars():
        total = {name: total.get(name, 0) + number for name, number in counts.items()}
    if not job.payload["dry_run"]:
        details = {name: total[name] for name in ("raised", "lowered", "withheld", "reworded", "recomputed")}
        note(connection, Entry(job.payload["actor"], Action.REGRADED, job.subject, job.course, details))
    return Ending(total)


def undo(connection: Connection, job: Job) -> None:
    """Leave the grades that were given: each is right by itself, and says which job gave it."""
