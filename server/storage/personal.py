"""All that is kept of one person: to be handed out, and to be erased."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

from server.storage.audit import Entry, Line
from server.storage.practice import Answers, Marked

Row: TypeAlias = Mapping[str, Any]
Prune: TypeAlias = Callable[[Answers, Mapping[str, Any]], tuple[Answers, Mapping[str, Any]]]


@dataclass(frozen=True, slots=True)
class Kept:
    """What is kept of a person, row by row; no password, no cookie, no token stands in it.

    Attributes:
        person: The account.
        courses: Courses with role and group.
        sessions: Where the person is signed in.
        tokens: Tokens of programs, without the tokens.
        variants: Variants with exercise, version, and seed or code.
        submissions: What was handed in, with its newest grade.
        drafts: What was typed and not handed in.
        problems: What was reported.
        hints: Hints that were opened at a price.
        marks: What lecturers wrote beside submissions.
        extra: Extra time in sets.
        acts: What the audit log says the person did, or was done to the person.
    """

    person: Row
    courses: Sequence[Row]
    sessions: Sequence[Row]
    tokens: Sequence[Row]
    variants: Sequence[Row]
    submissions: Sequence[Marked]
    drafts: Sequence[Row]
    problems: Sequence[Row]
    hints: Sequence[Row]
    marks: Sequence[Row]
    extra: Sequence[Row]
    acts: Sequence[Line]


class Personal(Protocol):
    """A store of what is kept of people."""

    async def kept(self, number: str) -> Kept | None:
        """Give all that is kept of a person."""
        ...

    async def erase(self, number: str, prune: Prune, entry: Entry) -> bool:
        """Erase a person; False where there is none. The work in sets stays under a number that is nobody's name.

        Args:
            number: The person.
            prune: Gives what stays of answers and their grade.
            entry: What the audit log says of it.
        """
        ...
