"""Hints that were opened at a price: each step once, however many posts race for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from datetime import datetime

from sqlalchemy import Connection, select

from server.database.once import insert_once
from server.storage.sets import Hint
from server.tables import deck, hints, slots


def keep(connection: Connection, hint: Hint) -> None:
    """Store a step that was opened; one that is open stays as it is."""
    insert_once(connection, hints, asdict(hint))


def of(connection: Connection, variant: str) -> list[Hint]:
    """List the steps that are open under the answers of a variant."""
    query = select(hints).where(hints.c.variant == variant).order_by(hints.c.time, hints.c.answer, hints.c.rung)
    return [Hint(**row) for row in connection.execute(query).mappings()]


def moments(connection: Connection, task_set: str) -> Mapping[str, list[datetime]]:
    """Give when hints were opened in a set, by variant."""
    query = select(hints.c.variant, hints.c.time).join(deck, deck.c.variant == hints.c.variant).join(slots)
    found: dict[str, list[datetime]] = {}
    for variant, time in connection.execute(query.where(slots.c.task_set == task_set)):
        found.setdefault(variant, []).append(time)
    return found


def before(opened: Mapping[str, list[datetime]], variant: str, time: datetime) -> int:
    """Count the hints that were opened under a variant before something was handed in."""
    return sum(one <= time for one in opened.get(variant, ()))
