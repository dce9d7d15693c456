"""Drafts and reported problems in the database."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import ColumnElement, Connection, and_, bindparam, func, insert, or_, select, update

from server.storage import Answers, Draft, Problem
from server.tables import deck, drafts, memberships, owners, problems, slots, task_sets, variants

CLOSE = update(drafts).where(drafts.c.variant == bindparam("of")).values(revision=drafts.c.revision + 1)


def draft(connection: Connection, variant: str) -> Draft | None:
    """Give the draft of a variant."""
    row = connection.execute(select(drafts).where(drafts.c.variant == variant)).first()
    return None if row is None else Draft(**row._mapping)


def keep_draft(connection: Connection, new: Draft) -> tuple[Draft, bool]:
    """Store a draft unless another one came first; gives what is stored, and whether it is this one."""
    old = draft(connection, new.variant)
    if (old.revision if old else 0) != new.revision - 1:
        return old or Draft(new.variant, {}, new.time, 0), False
    values = {"answers": dict(new.answers), "time": new.time, "revision": new.revision}
    if old is None:
        connection.execute(insert(drafts), values | {"variant": new.variant})
    else:
        connection.execute(update(drafts).where(drafts.c.variant == new.variant), values)
    return new, True


def close_draft(connection: Connection, variant: str, answers: Answers, time: datetime) -> None:
    """Let what is handed in be the draft from now on: one that was sent before and arrives later is typed over none."""
    values = {"answers": dict(answers), "time": time}
    if connection.execute(CLOSE, values | {"of": variant}).rowcount == 0:
        connection.execute(insert(drafts), values | {"variant": variant, "revision": 1})


def keep_problem(connection: Connection, problem: Problem, most: int) -> bool:
    """Store a reported problem unless so many of its variant are open already; tells whether it is stored."""
    mine = problems.c.variant == problem.variant, problems.c.settled.is_(None)
    if connection.execute(select(func.count()).select_from(problems).where(*mine)).scalar_one() >= most:
        return False
    connection.execute(insert(problems), {column.name: getattr(problem, column.name) for column in problems.columns})
    return True


def open_problems(connection: Connection, before: datetime, number: int, teacher: str | None) -> list[Problem]:
    """Give the open problems reported before a moment that concern a teacher, the newest first."""
    dealt = variants.c.exercise, variants.c.version, variants.c.seed, deck.c.code
    mine = problems.c.settled.is_(None), problems.c.time < before, *_concerning(teacher)
    tables = problems.join(variants).outerjoin(deck, deck.c.variant == variants.c.id)
    query = select(problems, *dealt).select_from(tables).where(*mine)
    rows = connection.execute(query.order_by(problems.c.time.desc()).limit(number))
    return [Problem(**row._mapping) for row in rows]


def settle_problem(connection: Connection, number: str, time: datetime, teacher: str | None) -> bool:
    """Note that a problem is settled; tells whether there was such an open one for this teacher."""
    mine = problems.c.id == number, problems.c.settled.is_(None), *_concerning(teacher)
    return connection.execute(update(problems).where(*mine), {"settled": time}).rowcount == 1


def _concerning(teacher: str | None) -> tuple[ColumnElement[bool], ...]:
    """Those of the cards of a teacher's courses, and of practice by a teacher's students or by nobody known; all where
    no teacher is named."""
    if teacher is None:
        return ()
    courses = select(memberships.c.course).where(memberships.c.person == teacher, memberships.c.role != "student")
    taught = select(memberships.c.person).where(memberships.c.course.in_(courses), memberships.c.role == "student")
    unknown = select(owners.c.id).where(owners.c.anonymous)
    card, sets = deck.alias(), select(task_sets.c.id).where(task_sets.c.course.in_(courses))
    dealt = select(card.c.id).where(card.c.variant == problems.c.variant)
    here = dealt.join(slots, slots.c.id == card.c.slot).where(slots.c.task_set.in_(sets))
    practice = ~dealt.exists(), or_(problems.c.owner.in_(taught), problems.c.owner.in_(unknown))
    return (or_(here.exists(), and_(*practice)),)
