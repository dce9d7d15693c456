"""Owners, variants, submissions and their grades, and what a store of them promises."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Protocol, TypeAlias

Answers: TypeAlias = Mapping[str, str | list[str]]


@dataclass(frozen=True, slots=True)
class Owner:
    """Whose variants these are. Practice of an anonymous owner expires; that of a named one does not."""

    id: str
    anonymous: bool


@dataclass(frozen=True, slots=True)
class Dealt:
    """A variant as stored: seed, realised givens and the exercise's version stand side by side.

    One that is dealt from a set has a code, which its student sees instead of the seed.
    """

    id: str
    owner: Owner
    exercise: str
    version: int
    seed: int
    givens: Mapping[str, Any]
    created: datetime
    last_used: datetime
    code: str | None = None


@dataclass(frozen=True, slots=True)
class Handed:
    """A submission as stored; it never changes.

    Attributes:
        receipt: Number by which it is looked up.
        variant: Number of the variant it answers.
        owner: Who handed it in.
        answers: The raw answers, as typed.
        time: When the server received it.
        key: Idempotency key, if the client sent one.
        body: Digest of the raw request, by which a repeated key is told from a reused one.
        digest: Digest of what was handed in, printed on the receipt.
        language: Language of the first response.
    """

    receipt: str
    variant: str
    owner: str
    answers: Answers
    time: datetime
    key: str | None
    body: str
    digest: str
    language: str


@dataclass(frozen=True, slots=True)
class Marked:
    """A submission with a grade (JSON values), whether it counted, and the version of the judges that gave it.

    One to a set has the code of its variant.
    """

    handed: Handed
    grade: Mapping[str, Any]
    counted: bool
    grader_version: str
    code: str | None = None


@dataclass(frozen=True, slots=True)
class Draft:
    """Answers as typed so far; each keeping counts the revision up by one."""

    variant: str
    answers: Answers
    time: datetime
    revision: int


@dataclass(frozen=True, slots=True)
class Problem:
    """What somebody reports of an exercise, with all that is needed to see the same; a card of a set has a code."""

    id: str
    variant: str
    owner: str
    text: str
    time: datetime
    settled: datetime | None = None
    exercise: str = ""
    version: int = 0
    seed: int = 0
    code: str | None = None


class Storage(Protocol):
    """A store of practice. A write that has returned is on disk; one that raised left nothing behind."""

    async def keep_variant(self, variant: Dealt) -> None:
        """Store a new variant, and its owner if new."""
        ...

    async def variant(self, number: str) -> Dealt | None:
        """Give a variant."""
        ...

    async def touch(self, number: str, time: datetime) -> None:
        """Note that a variant was used."""
        ...

    async def keep_submission(self, marked: Marked) -> tuple[Marked, bool]:
        """Store a submission with its grade, once for each key.

        Returns:
            What is stored under this key, and whether it had been there before.

        Raises:
            KeyReused: The key was used with another body.
            UnknownVariant: The variant has gone.
            StorageUnavailable: Nothing was stored.
        """
        ...

    async def submission(self, receipt: str) -> Marked | None:
        """Give a submission with its newest grade."""
        ...

    async def keyed(self, owner: str, variant: str, key: str, body: str) -> Marked | None:
        """Give the submission that a key stands for.

        Raises:
            KeyReused: The key was used with another body.
        """
        ...

    async def latest(self, variant: str) -> Marked | None:
        """Give the last submission to a variant."""
        ...

    async def counted(self, variant: str) -> bool:
        """Tell whether some submission to a variant counted."""
        ...

    async def keep_draft(self, draft: Draft) -> tuple[Draft, bool]:
        """Store a draft over the revision before it.

        Returns:
            What is stored now, and whether it is this draft: it is not where another one came first.

        Raises:
            UnknownVariant: The variant has gone.
        """
        ...

    async def draft(self, variant: str) -> Draft | None:
        """Give the draft of a variant."""
        ...

    async def keep_problem(self, problem: Problem, most: int) -> bool:
        """Store a reported problem, unless so many of its variant are open already; tells whether it is stored."""
        ...

    async def problems(self, before: datetime, number: int, teacher: str | None) -> list[Problem]:
        """Give the open problems reported before a moment, the newest first.

        Args:
            before: The moment.
            number: How many at most.
            teacher: Whose students reported them, or nobody known; none for all problems.
        """
        ...

    async def settle_problem(self, number: str, time: datetime, teacher: str | None) -> bool:
        """Note that a problem is settled; tells whether there was such an open one for this teacher."""
        ...

    async def purge(self, before: datetime) -> int:
        """Forget anonymous variants that were last used before a moment and of which no problem is open."""
        ...

    async def check(self) -> None:
        """Raise StorageUnavailable unless the store answers and takes a write."""
        ...

    def failures(self) -> int:
        """Tell how many pieces the store could not write since it was opened."""
        ...

    async def practised(self, owner: str) -> int:
        """Tell how many variants an owner has."""
        ...

    async def take_over(self, anonymous: str, person: str) -> int:
        """Give the variants of an anonymous owner to a person; gives how many."""
        ...
