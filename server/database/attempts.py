"""What is handed in to a set: a submission and its attempt are stored together, or neither."""

from __future__ import annotations

from typing import Any

from sqlalchemy import Connection, Select, bindparam, func, insert, select

from server.database.hints import before, moments
from server.database.practice import keep_submission
from server.storage import Marked
from server.storage.sets import Line, NoAttemptLeft, Waiting
from server.tables import attempts, deck, drafts, grades, slots, submissions, task_sets

HANDED = deck.c.slot, deck.c.person, submissions.c.variant, submissions.c.receipt, submissions.c.time  # of a line
PLACE = select(deck.c.slot, deck.c.person).where(deck.c.variant == bindparam("variant"))
MINE = deck.c.slot == bindparam("slot"), deck.c.person == bindparam("person")
SHARING = select(deck.c.id).where(*MINE).order_by(deck.c.id).with_for_update()
TAKEN = select(func.count()).select_from(attempts).join(deck, deck.c.variant == attempts.c.variant).where(*MINE)


def keep(connection: Connection, marked: Marked, limit: int | None) -> tuple[Marked, bool]:
    """Store a submission to a set and its attempt.

    Raises:
        NoAttemptLeft: The attempts of the slot are used up.
    """
    variant = marked.handed.variant
    mine = _locked(connection, variant)
    stored, replayed = keep_submission(connection, marked)
    if replayed:
        return stored, True
    number = connection.execute(TAKEN, mine).scalar_one()
    if limit is not None and number >= limit:
        raise NoAttemptLeft(variant)
    if stored.counted:
        values = {"variant": variant, "number": number + 1, "submission": stored.handed.receipt}
        connection.execute(insert(attempts), values)
    return stored, False


def _locked(connection: Connection, variant: str) -> dict[str, str]:
    """Give the slot and the student of a card, and lock all cards that share its attempts: the replaced ones too."""
    mine = dict(connection.execute(PLACE, {"variant": variant}).mappings().one())
    connection.execute(SHARING, mine).all()
    return mine


def used_up(connection: Connection, number: str) -> list[str]:
    """List the students who have used up the attempts of some task of a set."""
    counted = select(deck.c.person).join(attempts, attempts.c.variant == deck.c.variant)
    tasks = within(counted, number, None).group_by(deck.c.slot, deck.c.person, slots.c.attempts)
    return sorted(set(connection.execute(tasks.having(func.count() >= slots.c.attempts)).scalars()))


def ledger(connection: Connection, number: str, person: str | None) -> list[Line]:
    """List the submissions to a set in the order received."""
    query = graded(select(*HANDED, grades.c.grade, grades.c.counted), number, person)
    opened = moments(connection, number)
    rows = connection.execute(query.order_by(submissions.c.time, submissions.c.receipt)).mappings()
    return [Line(**row, hints=before(opened, row["variant"], row["time"])) for row in rows]


def graded(query: Select[Any], number: str, person: str | None) -> Select[Any]:
    """Join the submissions to a set, of all students or one, with their cards and their newest grades."""
    given = grades.alias()
    newest = select(func.max(given.c.id)).where(given.c.submission == submissions.c.receipt).scalar_subquery()
    joined = query.select_from(submissions).join(deck, deck.c.variant == submissions.c.variant)
    return within(joined.join(grades, grades.c.id == newest), number, person)


def within(query: Select[Any], number: str, person: str | None) -> Select[Any]:
    """Keep what belongs to cards of a set, of all students or one."""
    found = query.join(slots, slots.c.id == deck.c.slot).where(slots.c.task_set == number)
    return found if person is None else found.where(deck.c.person == person)


def waiting(connection: Connection) -> list[Waiting]:
    """List the drafts in examinations that are newer than what was handed in, where an attempt is left for them."""
    last = select(func.max(submissions.c.time)).where(submissions.c.variant == drafts.c.variant).scalar_subquery()
    same = deck.alias()
    taken = (
        select(func.count())
        .select_from(attempts)
        .join(same, same.c.variant == attempts.c.variant)
        .where(same.c.slot == deck.c.slot, same.c.person == deck.c.person)
        .scalar_subquery()
    )
    query = (
        select(drafts.c.variant, deck.c.person, drafts.c.answers, drafts.c.time)
        .join_from(drafts, deck, deck.c.variant == drafts.c.variant)
        .join(slots, slots.c.id == deck.c.slot)
        .join(task_sets, task_sets.c.id == slots.c.task_set)
        .where(task_sets.c.rules["mode"].as_string() == "exam", (last.is_(None)) | (last < drafts.c.time))
        .where(slots.c.attempts.is_(None) | (taken < slots.c.attempts))
    )
    return [Waiting(**row) for row in connection.execute(query).mappings()]
