"""Courses, their groups and members, and what a store of them promises."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Protocol

from server.storage.audit import Entry
from server.storage.people import Person

LEFT = "left"


@dataclass(frozen=True, slots=True)
class Course:
    """A course; who knows its join code may become one of its students.

    With `claims` the code also gives away a place of the roster to whom names its index number first.
    """

    id: str
    title: str
    language: str
    time_zone: str
    created: datetime
    join_code: str | None = None
    archived: bool = False
    keep_until: datetime | None = None
    claims: bool = False


@dataclass(frozen=True, slots=True)
class Group:
    """A group of a course."""

    id: str
    course: str
    name: str


@dataclass(frozen=True, slots=True)
class Member:
    """A person in a course: student, assistant or lecturer; `claimed` when by code from the roster.

    One who has handed in and then left, or now teaches, is no student; where such people are listed as students, their
    role is `LEFT`, and they joined when they handed in first.
    """

    person: Person
    role: str
    group: str | None
    joined: datetime
    claimed: datetime | None = None


@dataclass(frozen=True, slots=True)
class Row:
    """A line of a roster; an empty group leaves the group as it is."""

    login: str
    name: str
    group: str = ""


@dataclass(frozen=True, slots=True)
class Change:
    """What a line of a roster changes: new, joins, moves or same; `known` is another name the person has here."""

    row: Row
    what: str
    known: str | None = None


class Courses(Protocol):
    """A store of courses."""

    async def add(self, course: Course, lecturer: str, entry: Entry | None = None) -> None:
        """Store a new course with its lecturer."""
        ...

    async def course(self, number: str) -> Course | None:
        """Give a course."""
        ...

    async def by_code(self, code: str) -> Course | None:
        """Give the course that is joined by a code."""
        ...

    async def of(self, person: str) -> Sequence[tuple[Course, str]]:
        """List the courses of a person with the role in each, newest first."""
        ...

    async def role(self, course: str, person: str) -> str | None:
        """Give the role of a person in a course."""
        ...

    async def elsewhere(self, lecturer: str, person: str) -> bool:
        """Tell whether a person is in a course that a lecturer does not lecture, or came to none of the lecturer's."""
        ...

    async def is_staff(self, person: str) -> bool:
        """Tell whether a person assists or lectures anywhere."""
        ...

    async def teaches(self, lecturer: str, person: str) -> bool:
        """Tell whether one person lectures or assists in a course of the other."""
        ...

    async def members(self, course: str) -> Sequence[Member]:
        """List the members of a course by role and name."""
        ...

    async def left(self, course: str) -> Sequence[Member]:
        """List who has handed in to a set of a course and is no student of it any more."""
        ...

    async def join(self, course: str, person: str, role: str, now: datetime) -> bool:
        """Make a person a member; False where that is so already."""
        ...

    async def change(self, course: str, person: str, role: str, group: str | None, entry: Entry | None = None) -> bool:
        """Change role and group of a member; False where there is no such member or group."""
        ...

    async def leave(self, course: str, person: str, entry: Entry | None = None) -> bool:
        """Take a member out of a course; what was handed in stays."""
        ...

    async def groups(self, course: str) -> Sequence[Group]:
        """List the groups of a course by name."""
        ...

    async def add_group(self, group: Group) -> bool:
        """Store a group; False where the name is taken."""
        ...

    async def set_code(self, course: str, code: str | None, entry: Entry | None = None) -> bool:
        """Change the join code, or close joining; False where another course has this code."""
        ...

    async def let_claim(self, course: str, wanted: bool, entry: Entry | None = None) -> None:
        """Let the code of a course give away places of its roster, or not."""
        ...

    async def roster(
        self, course: str, rows: Sequence[Row], now: datetime, apply: bool, actor: str = ""
    ) -> Sequence[Change]:
        """Tell what a roster changes, and change it if that is wished."""
        ...
