"""Drafts and reported problems in the database."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import Connection, func, insert, select, update

from server.storage import Draft, Problem
from server.tables import drafts, problems, variants


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


def keep_problem(connection: Connection, problem: Problem, most: int) -> bool:
    """Store a reported problem unless so many of its variant are open already; tells whether it is stored."""
    mine = problems.c.variant == problem.variant, problems.c.settled.is_(None)
    if connection.execute(select(func.count()).select_from(problems).where(*mine)).scalar_one() >= most:
        return False
    connection.execute(insert(problems), {column.name: getattr(problem, column.name) for column in problems.columns})
    return True


def open_problems(connection: Connection, before: datetime, number: int) -> list[Problem]:
    """Give the open problems reported before a moment, the newest first."""
    dealt = variants.c.exercise, variants.c.version, variants.c.seed
    mine = problems.c.settled.is_(None), problems.c.time < before
    query = select(problems, *dealt).join(variants).where(*mine).order_by(problems.c.time.desc()).limit(number)
    return [Problem(**row._mapping) for row in connection.execute(query)]


def settle_problem(connection: Connection, number: str, time: datetime) -> bool:
    """Note that a problem is settled; tells whether there was such an open one."""
    mine = problems.c.id == number, problems.c.settled.is_(None)
    return connection.execute(update(problems).where(*mine), {"settled": time}).rowcount == 1
