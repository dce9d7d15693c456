"""What somebody did, as the audit log keeps it, and what a store of it promises."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum
from typing import Protocol, TypeAlias

Detail: TypeAlias = str | int | float | bool | None


class Action(StrEnum):
    """What can be done that is written down; the locales word each."""

    LINK_MADE = "link_made"
    LINK_USED = "link_used"
    PLACE_CLAIMED = "place_claimed"
    CLAIM_UNDONE = "claim_undone"
    JOINING_CHANGED = "joining_changed"
    ROLE_CHANGED = "role_changed"
    MEMBER_CHANGED = "member_changed"
    MEMBER_REMOVED = "member_removed"
    ROSTER_IMPORTED = "roster_imported"
    COURSE_STARTED = "course_started"
    COURSE_COPIED = "course_copied"
    SET_PUBLISHED = "set_published"
    SET_COPIED = "set_copied"
    SET_REMOVED = "set_removed"
    DEADLINES_MOVED = "deadlines_moved"
    TIME_GIVEN = "time_given"
    MARK_GIVEN = "mark_given"
    REGRADED = "regraded"
    MARKS_EXPORTED = "marks_exported"
    PERSON_EXPORTED = "person_exported"
    PERSON_ERASED = "person_erased"
    PERSON_DISABLED = "person_disabled"
    PERSON_ENABLED = "person_enabled"
    SESSIONS_ENDED = "sessions_ended"
    TOKEN_MADE = "token_made"
    TOKEN_REVOKED = "token_revoked"


@dataclass(frozen=True, slots=True)
class Entry:
    """An act to be written down. It holds numbers and counts: no secret, no answer, no name.

    Attributes:
        actor: The number of the person, or `command line` or `server`.
        action: What was done.
        object: The number of what it was done to.
        course: The course it belongs to; its lecturers may read the line.
        details: A few short values more.
    """

    actor: str
    action: Action
    object: str
    course: str | None = None
    details: Mapping[str, Detail] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the log; `number` grows with time, `digest` binds it to the lines before."""

    number: int
    time: datetime
    entry: Entry
    digest: str


@dataclass(frozen=True, slots=True)
class End:
    """The last line of the log, by number and digest; kept elsewhere, it shows later that nothing was cut off."""

    number: int
    digest: str

    def __str__(self) -> str:
        return f"{self.number} {self.digest}"


@dataclass(frozen=True, slots=True)
class Checked:
    """What came of walking the log: its end, and the first line that is wrong or missing; none where all fit."""

    end: End
    broken: int | None


class Audit(Protocol):
    """A store of the audit log. Lines are only ever added."""

    async def note(self, entry: Entry) -> None:
        """Write down something that changes nothing else, such as an export."""
        ...

    async def lines(self, course: str | None, before: int | None, most: int) -> Sequence[Line]:
        """List the lines of a course, or all, before a line, the newest first."""
        ...

    async def names(self, numbers: Collection[str]) -> Mapping[str, str]:
        """Give the names of people and the titles of sets and courses that are there."""
        ...

    async def check(self, earlier: End | None = None) -> Checked:
        """Walk the log: each line must fit to the one before, and the last ones and an earlier end must be there."""
        ...
