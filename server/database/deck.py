"""The cards of a set: kept for a student at publishing, dealt when he first opens the task."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace as changed
from datetime import datetime
from typing import Any

from sqlalchemy import Connection, Select, case, func, insert, select, update

from server.database.once import insert_once
from server.storage.sets import Card, Slot
from server.tables import deck, owners, slots, task_sets, variants
from server.web.language import DEFAULT

# The weights of the answers of a card; what tells them is read on a card of an older version alone.
WEIGHTS = (deck.c.weights, case((deck.c.weights.is_(None), deck.c.shown[DEFAULT, "answers"])).label("asked"))


def weights_of(row: Mapping[Any, Any]) -> Mapping[str, float]:
    """Give the weights of the answers of a card of which `WEIGHTS` were read."""
    own: Mapping[str, float] | None = row["weights"]
    return own if own is not None else {name: field["weight"] for name, field in row["asked"].items()}


def slot_of(row: Mapping[Any, Any]) -> Slot:
    """Build a slot from its row."""
    limits = {name: (low, high) for name, (low, high) in row["limits"].items()}
    return Slot(**{**row, "pool": tuple(row["pool"]), "limits": limits})


def add(connection: Connection, cards: Sequence[Card]) -> None:
    """Store cards."""
    rows = [{column.name: getattr(card, column.name) for column in deck.columns} for card in cards]
    if rows:
        connection.execute(insert(deck), rows)


def append(connection: Connection, card: Card) -> None:
    """Store one more card, behind the others of its slot."""
    _lock(connection, card.slot)
    last = connection.execute(select(func.max(deck.c.number)).where(deck.c.slot == card.slot)).scalar_one() or 0
    add(connection, [changed(card, number=last + 1)])


def of_set(connection: Connection, number: str, slot: int | None) -> list[Card]:
    """List the cards of a set, or of one of its slots, by slot and number."""
    query = select(deck).join(slots).where(slots.c.task_set == number).order_by(slots.c.number, deck.c.number)
    query = query if slot is None else query.where(slots.c.number == slot)
    return [Card(**row) for row in connection.execute(query).mappings()]


def of_student(connection: Connection, number: str, person: str) -> list[Card]:
    """List the cards of a student in a set by slot and turn."""
    mine = slots.c.task_set == number, deck.c.person == person
    query = select(deck).join(slots).where(*mine).order_by(slots.c.number, deck.c.turn)
    return [Card(**row) for row in connection.execute(query).mappings()]


def titles(connection: Connection, number: str, person: str, language: str) -> dict[int, str]:
    """Give the titles of the cards that a student has opened in a set, by the number of the task; the last turn's."""
    opened = slots.c.task_set == number, deck.c.person == person, deck.c.variant.is_not(None)
    query = select(slots.c.number, deck.c.shown[language, "title"].as_string()).join_from(deck, slots).where(*opened)
    return {slot: title for slot, title in connection.execute(query.order_by(slots.c.number, deck.c.turn))}


def begun(connection: Connection, number: str, person: str) -> datetime | None:
    """Tell when a student first opened a set."""
    mine = slots.c.task_set == number, deck.c.person == person
    moment: datetime | None = connection.execute(select(func.min(deck.c.dealt)).join(slots).where(*mine)).scalar_one()
    return moment


def open_card(connection: Connection, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
    """Deal a student's card of a slot; the same one every time. None where no spare is left."""
    _lock(connection, slot.id)
    card = _newest(connection, slot, person)
    if card is None:
        _take_seat(connection, slot, person)
        card = _newest(connection, slot, person)
    if card is None or card.variant is not None:
        return card
    return _deal(connection, card, person, variant, now)


def replace(connection: Connection, slot: Slot, person: str, variant: str, now: datetime) -> Card | None:
    """Deal a student a spare card of a slot in place of the present one. None where no spare is left."""
    _lock(connection, slot.id)
    present = _newest(connection, slot, person)
    if present is None or present.variant is None:
        return open_card(connection, slot, person, variant, now)
    spare = _one(connection, _spares(slot.id).order_by(deck.c.number.desc()))
    if spare is None:
        return None
    taken = changed(spare, person=person, turn=present.turn + 1)
    connection.execute(update(deck).where(deck.c.id == spare.id).values(person=person, turn=taken.turn))
    return _deal(connection, taken, person, variant, now)


def _lock(connection: Connection, slot: str) -> None:
    """Let one server at a time deal from a set; on SQLite there is but one that writes."""
    number = select(slots.c.task_set).where(slots.c.id == slot).scalar_subquery()
    connection.execute(select(task_sets.c.id).where(task_sets.c.id == number).with_for_update()).one()


def _newest(connection: Connection, slot: Slot, person: str) -> Card | None:
    mine = deck.c.slot == slot.id, deck.c.person == person
    return _one(connection, select(deck).where(*mine).order_by(deck.c.turn.desc()))


def _spares(slot: str) -> Select[Any]:
    return select(deck).where(deck.c.slot == slot, deck.c.person.is_(None))


def _take_seat(connection: Connection, slot: Slot, person: str) -> None:
    """Keep the cards of one number in all slots for a student who was not in the class at publishing.

    Where no number is free in all of them, this slot's first spare is taken.
    """
    theirs = slots.c.task_set == slot.task_set
    total = select(func.count()).select_from(slots).where(theirs).scalar_subquery()
    free = select(deck.c.number).join(slots).where(theirs, deck.c.person.is_(None)).group_by(deck.c.number)
    number = connection.execute(free.having(func.count() == total).order_by(deck.c.number).limit(1)).scalar()
    if number is None:
        spare = _one(connection, _spares(slot.id).order_by(deck.c.number))
        mine = deck.c.id == (spare.id if spare else None)
    else:
        mine = deck.c.slot.in_(select(slots.c.id).where(theirs)) & (deck.c.number == number)
    connection.execute(update(deck).where(mine).values(person=person))


def _deal(connection: Connection, card: Card, person: str, variant: str, now: datetime) -> Card:
    insert_once(connection, owners, {"id": person, "anonymous": False, "created": now})
    values = {"id": variant, "owner": person, "exercise": card.exercise, "version": card.version, "seed": card.seed}
    connection.execute(insert(variants), values | {"givens": card.givens, "created": now, "last_used": now})
    connection.execute(update(deck).where(deck.c.id == card.id).values(variant=variant, dealt=now))
    return changed(card, variant=variant, dealt=now)


def _one(connection: Connection, query: Select[Any]) -> Card | None:
    row = connection.execute(query.limit(1)).mappings().first()
    return None if row is None else Card(**row)
