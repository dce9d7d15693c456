"""A roster against a course: what each line changes, and changing it in one transaction."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from datetime import datetime

from sqlalchemy import Connection, delete, insert, select, update

from server.database.audit import note
from server.database.once import insert_once
from server.database.people import add_person
from server.storage.audit import Action, Entry
from server.storage.courses import Change, Row
from server.storage.people import Person
from server.tables import groups, links, memberships, persons
from server.web import ids


def plan(connection: Connection, course: str, rows: Sequence[Row]) -> list[Change]:
    """Tell what each line changes: new, joins, moves (to another group) or same."""
    people, groups_of = _people(connection, rows), _groups_of(connection, course)
    names = _names(connection, people.values())
    return [
        Change(row, _what(row, people, groups_of), _other(row, names.get(people.get(row.login, "")))) for row in rows
    ]


def apply_roster(connection: Connection, course: str, rows: Sequence[Row], now: datetime, actor: str) -> list[Change]:
    """Add who is not there yet, as a student, and put everybody into the group of the line; nobody is taken out."""
    changes = plan(connection, course, rows)
    named = _groups(connection, course, rows)
    for change in changes:
        if change.what == "new":
            person = Person(ids.new(), change.row.login, change.row.name, "student", now)
            add_person(connection, person)
    people = _people(connection, rows)
    for change in changes:
        _place(connection, course, people[change.row.login], named.get(change.row.group), change.what, now)
    counts = Counter(change.what for change in changes)
    note(connection, Entry(actor, Action.ROSTER_IMPORTED, course, course, dict(counts)))
    return changes


def add_member(connection: Connection, values: Mapping[str, object]) -> bool:
    """Add a member; links that other courses made to replace a password end. False for one who is there."""
    if not insert_once(connection, memberships, values):
        return False
    foreign = links.c.person == values["person"], links.c.course != values["course"], links.c.used.is_(None)
    connection.execute(delete(links).where(*foreign, links.c.purpose == "reset"))
    return True


def _place(connection: Connection, course: str, person: str, group: str | None, what: str, now: datetime) -> None:
    if what in ("new", "joins"):
        values = {"course": course, "person": person, "role": "student", "group": group, "joined": now}
        add_member(connection, values | {"vouched": what == "new"})
    if what == "moves":
        mine = memberships.c.course == course, memberships.c.person == person
        connection.execute(update(memberships).where(*mine).values(group=group))


def _what(row: Row, people: Mapping[str, str], groups_of: Mapping[str, str | None]) -> str:
    person = people.get(row.login)
    if person is None:
        return "new"
    if person not in groups_of:
        return "joins"
    return "moves" if row.group and groups_of[person] != row.group else "same"


def _people(connection: Connection, rows: Sequence[Row]) -> dict[str, str]:
    query = select(persons.c.login, persons.c.id).where(persons.c.login.in_([row.login for row in rows]))
    return {login: number for login, number in connection.execute(query)}


def _names(connection: Connection, numbers: Collection[str]) -> dict[str, str]:
    query = select(persons.c.id, persons.c.name).where(persons.c.id.in_(numbers))
    return {number: name for number, name in connection.execute(query)}


def _other(row: Row, name: str | None) -> str | None:
    return name if name is not None and name.casefold() != row.name.casefold() else None


def _groups_of(connection: Connection, course: str) -> dict[str, str | None]:
    query = select(memberships.c.person, groups.c.name).outerjoin(groups, memberships.c.group == groups.c.id)
    return {person: name for person, name in connection.execute(query.where(memberships.c.course == course))}


def _groups(connection: Connection, course: str, rows: Sequence[Row]) -> dict[str, str]:
    """Give the groups of a course by name, those of the roster among them."""
    query = select(groups.c.name, groups.c.id).where(groups.c.course == course)
    found: dict[str, str] = {name: number for name, number in connection.execute(query)}
    fresh = {row.group: ids.new() for row in rows if row.group and row.group not in found}
    if fresh:
        lines = [{"id": number, "course": course, "name": name} for name, number in fresh.items()]
        connection.execute(insert(groups), lines)
    return found | fresh
