"""Courses, groups, memberships and rosters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from functools import partial

from sqlalchemy import Connection, Select, bindparam, delete, exists, func, insert, or_, select, update
from sqlalchemy.exc import IntegrityError

from server.alphabet import alphabetical
from server.database.audit import noting
from server.database.connections import Connections
from server.database.once import insert_once
from server.database.people import person_of
from server.database.rosters import add_member, apply_roster, plan
from server.storage.audit import Entry
from server.storage.courses import LEFT, Change, Course, Group, Member, Row
from server.tables import courses, deck, groups, memberships, persons, slots, submissions, task_sets

STAFF = ("assistant", "lecturer")
COURSE = select(courses).where(courses.c.id == bindparam("number"))
MINE = memberships.c.course == bindparam("course"), memberships.c.person == bindparam("person")
ROLE = select(memberships.c.role).where(*MINE)


class Courses:
    """The courses of one store."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections

    async def add(self, course: Course, lecturer: str, entry: Entry | None = None) -> None:
        """Store a new course with its lecturer."""
        await self._connections.write(noting(lambda connection: _add(connection, course, lecturer), entry))

    async def course(self, number: str) -> Course | None:
        """Give a course."""
        return await self._one(COURSE, {"number": number})

    async def by_code(self, code: str) -> Course | None:
        """Give the course that is joined by a code."""
        return await self._one(select(courses).where(courses.c.join_code == code, ~courses.c.archived))

    async def of(self, person: str) -> Sequence[tuple[Course, str]]:
        """List the courses of a person with the role in each, newest first."""
        query = select(courses, memberships.c.role).join(memberships).where(memberships.c.person == person)
        query = query.order_by(courses.c.created.desc())
        rows = await self._connections.read(lambda connection: connection.execute(query).mappings().all())
        return [(Course(**{c.name: row[c] for c in courses.columns}), row[memberships.c.role]) for row in rows]

    async def role(self, course: str, person: str) -> str | None:
        """Give the role of a person in a course."""
        mine = {"course": course, "person": person}
        return await self._connections.read(lambda connection: connection.execute(ROLE, mine).scalar_one_or_none())

    async def elsewhere(self, lecturer: str, person: str) -> bool:
        """Tell whether a person is in a course that a lecturer does not lecture, or came to none of the lecturer's."""
        lectured = memberships.c.person == lecturer, memberships.c.role == "lecturer"
        own, theirs = (
            memberships.c.course.in_(select(memberships.c.course).where(*lectured)),
            memberships.c.person == person,
        )
        query = select(or_(exists().where(theirs, ~own), ~exists().where(theirs, own, memberships.c.vouched)))
        return await self._connections.read(lambda connection: bool(connection.execute(query).scalar_one()))

    async def is_staff(self, person: str) -> bool:
        """Tell whether a person assists or lectures anywhere."""
        query = select(exists().where(memberships.c.person == person, memberships.c.role.in_(STAFF)))
        return await self._connections.read(lambda connection: bool(connection.execute(query).scalar_one()))

    async def teaches(self, lecturer: str, person: str) -> bool:
        """Tell whether one person lectures or assists in a course of the other."""
        theirs = select(memberships.c.course).where(memberships.c.person == person, memberships.c.role == "student")
        mine = memberships.c.person == lecturer, memberships.c.role.in_(STAFF), memberships.c.course.in_(theirs)
        query = select(exists().where(*mine))
        return await self._connections.read(lambda connection: bool(connection.execute(query).scalar_one()))

    async def members(self, course: str) -> Sequence[Member]:
        """List the members of a course by role and name."""
        return await self._connections.read(lambda connection: _members(connection, course))

    async def left(self, course: str) -> Sequence[Member]:
        """List who has handed in to a set of a course and is no student of it any more."""
        return await self._connections.read(lambda connection: _left(connection, course))

    async def join(self, course: str, person: str, role: str, now: datetime) -> bool:
        """Make a person a member; False where that is so already."""
        return await self._connections.write(lambda connection: _join(connection, course, person, role, now))

    async def change(self, course: str, person: str, role: str, group: str | None, entry: Entry | None = None) -> bool:
        """Change role and group of a member; False where there is no such member or group."""
        change = partial(_change, course=course, person=person, role=role, group=group)
        return await self._connections.write(noting(change, entry))

    async def leave(self, course: str, person: str, entry: Entry | None = None) -> bool:
        """Take a member out of a course; what was handed in stays."""
        gone = delete(memberships).where(memberships.c.course == course, memberships.c.person == person)
        return await self._connections.write(noting(lambda connection: connection.execute(gone).rowcount == 1, entry))

    async def groups(self, course: str) -> Sequence[Group]:
        """List the groups of a course by name."""
        query = select(groups).where(groups.c.course == course)
        rows = await self._connections.read(lambda connection: connection.execute(query).mappings().all())
        return sorted((Group(**row) for row in rows), key=lambda group: alphabetical(group.name))

    async def add_group(self, group: Group) -> bool:
        """Store a group; False where the name is taken."""
        values = {"id": group.id, "course": group.course, "name": group.name}
        return await self._connections.write(lambda connection: insert_once(connection, groups, values))

    async def set_code(self, course: str, code: str | None, entry: Entry | None = None) -> bool:
        """Change the join code, or close joining; False where another course has this code."""
        change = update(courses).where(courses.c.id == course).values(join_code=code)
        try:
            changed = noting(lambda connection: connection.execute(change).rowcount == 1, entry)
            return await self._connections.write(changed)
        except IntegrityError:
            return False

    async def let_claim(self, course: str, wanted: bool, entry: Entry | None = None) -> None:
        """Let the code of a course give away places of its roster, or not."""
        change = update(courses).where(courses.c.id == course).values(claims=wanted)
        await self._connections.write(noting(lambda connection: connection.execute(change).rowcount, entry))

    async def roster(
        self, course: str, rows: Sequence[Row], now: datetime, apply: bool, actor: str = ""
    ) -> Sequence[Change]:
        """Tell what a roster changes, and change it if that is wished."""
        if not apply:
            return await self._connections.read(lambda connection: plan(connection, course, rows))
        return await self._connections.write(lambda connection: apply_roster(connection, course, rows, now, actor))

    async def _one(self, query: Select[tuple[object, ...]], values: Mapping[str, str] | None = None) -> Course | None:
        row = await self._connections.read(lambda connection: connection.execute(query, values).mappings().first())
        return Course(**row) if row else None


def _add(connection: Connection, course: Course, lecturer: str) -> None:
    connection.execute(insert(courses), {column.name: getattr(course, column.name) for column in courses.columns})
    member = {"course": course.id, "person": lecturer, "role": "lecturer", "group": None, "joined": course.created}
    connection.execute(insert(memberships), member)


def _join(connection: Connection, course: str, person: str, role: str, now: datetime) -> bool:
    values = {"course": course, "person": person, "role": role, "group": None, "joined": now, "vouched": True}
    if add_member(connection, values):
        return True
    mine = memberships.c.course == course, memberships.c.person == person
    connection.execute(update(memberships).where(*mine).values(vouched=True))
    return False


def _members(connection: Connection, course: str) -> list[Member]:
    query = select(memberships, persons).join(persons).where(memberships.c.course == course)
    rows = connection.execute(query.order_by(persons.c.id)).mappings().all()
    own, place = memberships.c, {"lecturer": 0, "assistant": 1}
    found = [Member(person_of(row), row[own.role], row[own.group], row[own.joined], row[own.claimed]) for row in rows]
    return sorted(found, key=lambda one: (place.get(one.role, 2), alphabetical(one.person.name)))


def _left(connection: Connection, course: str) -> list[Member]:
    here = select(memberships.c.person).where(memberships.c.course == course, memberships.c.role == "student")
    first = func.min(submissions.c.time).label("first")
    handed = select(persons, first).join(deck, deck.c.person == persons.c.id).join(slots).join(task_sets)
    handed = handed.join(submissions, submissions.c.variant == deck.c.variant).group_by(persons.c.id)
    gone = task_sets.c.course == course, persons.c.id.not_in(here)
    rows = connection.execute(handed.where(*gone).order_by(persons.c.id)).mappings().all()
    found = [Member(person_of(row), LEFT, None, row["first"]) for row in rows]
    return sorted(found, key=lambda one: alphabetical(one.person.name))


def _change(connection: Connection, course: str, person: str, role: str, group: str | None) -> bool:
    here = select(groups.c.id).where(groups.c.id == group, groups.c.course == course)
    if group is not None and connection.execute(here).first() is None:
        return False
    mine = memberships.c.course == course, memberships.c.person == person
    return connection.execute(update(memberships).where(*mine).values(role=role, group=group)).rowcount == 1
