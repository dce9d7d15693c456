"""Verdicts: a code and its small details, never a sentence; `graders/locales/` words each code."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TypeAlias

from graders.language.errors import AnswerSyntaxError, Proposal, Reason


class Outcome(StrEnum):
    """What a student is told at a glance."""

    RIGHT = "right"
    PARTLY = "partly"
    WRONG = "wrong"
    UNREADABLE = "unreadable"
    UNDECIDED = "undecided"
    FAULT = "fault"


class Code(StrEnum):
    """What was found; each code has one outcome. Reading errors carry a `Reason` in their details."""

    RIGHT = "right"
    FOLLOWED = "followed"
    WRONG = "wrong"
    OPPOSITE_SIGN = "opposite_sign"
    FACTOR_OF_TEN = "factor_of_ten"
    WRONG_UNIT = "wrong_unit"
    WRONG_DIMENSION = "wrong_dimension"
    NOT_PRECISE = "not_precise"
    NOT_EXACT = "not_exact"
    INVERTED_RATIO = "inverted_ratio"
    UNDEFINED = "undefined"
    SOME_ENTRIES = "some_entries"
    SOME_ITEMS = "some_items"
    SOME_BRANCHES = "some_branches"
    LOST_BRANCH = "lost_branch"
    SURPLUS_BRANCH = "surplus_branch"
    DOUBLED_BRANCH = "doubled_branch"
    WRONG_SHAPE = "wrong_shape"
    EMPTY = "empty"
    UNREADABLE = "unreadable"
    UNDECIDED = "undecided"
    KEPT = "kept"
    FAULT = "fault"


OUTCOMES = {
    Code.RIGHT: Outcome.RIGHT,
    Code.FOLLOWED: Outcome.RIGHT,
    Code.WRONG: Outcome.WRONG,
    Code.OPPOSITE_SIGN: Outcome.WRONG,
    Code.FACTOR_OF_TEN: Outcome.WRONG,
    Code.WRONG_UNIT: Outcome.PARTLY,
    Code.WRONG_DIMENSION: Outcome.WRONG,
    Code.NOT_PRECISE: Outcome.WRONG,
    Code.NOT_EXACT: Outcome.WRONG,
    Code.INVERTED_RATIO: Outcome.WRONG,
    Code.UNDEFINED: Outcome.WRONG,
    Code.SOME_ENTRIES: Outcome.PARTLY,
    Code.SOME_ITEMS: Outcome.PARTLY,
    Code.SOME_BRANCHES: Outcome.PARTLY,
    Code.LOST_BRANCH: Outcome.PARTLY,
    Code.SURPLUS_BRANCH: Outcome.PARTLY,
    Code.DOUBLED_BRANCH: Outcome.PARTLY,
    Code.WRONG_SHAPE: Outcome.WRONG,
    Code.EMPTY: Outcome.UNREADABLE,
    Code.UNREADABLE: Outcome.UNREADABLE,
    Code.UNDECIDED: Outcome.UNDECIDED,
    Code.KEPT: Outcome.UNDECIDED,
    Code.FAULT: Outcome.FAULT,
}


@dataclass(frozen=True, slots=True)
class Reading:
    """Details of an unreadable answer: the reason, its 0-based place, what stood there and what may be meant."""

    reason: Reason
    position: int
    proposal: Proposal


@dataclass(frozen=True, slots=True)
class Entries:
    """Details of a matrix that is right in part: rows and columns (from 1) of the entries that are not."""

    wrong: tuple[tuple[int, int], ...]
    total: int


@dataclass(frozen=True, slots=True)
class Witness:
    """A point at which the answer is proved to differ from the reference (names with exact decimals)."""

    point: tuple[tuple[str, float], ...]


@dataclass(frozen=True, slots=True)
class Branches:
    """Details of a set that is right in part: how many branches are right, and how many are given."""

    right: int
    given: int


Details: TypeAlias = Reading | Entries | Witness | Branches | None


@dataclass(frozen=True, slots=True)
class Verdict:
    """The judgement of one answer: a score from 0 to 1, a code and its details."""

    score: float
    code: Code
    details: Details = None

    @property
    def outcome(self) -> Outcome:
        """Give the outcome that belongs to the code."""
        return OUTCOMES[self.code]


RIGHT = Verdict(1.0, Code.RIGHT)
FOLLOWED = Verdict(1.0, Code.FOLLOWED)
EMPTY = Verdict(0.0, Code.EMPTY)
UNDECIDED = Verdict(0.0, Code.UNDECIDED)
FAULT = Verdict(0.0, Code.FAULT)


def wrong(code: Code = Code.WRONG, details: Details = None) -> Verdict:
    """Make a verdict without credit."""
    return Verdict(0.0, code, details)


def unreadable(error: AnswerSyntaxError) -> Verdict:
    """Turn a reading error into a verdict: the one place that does."""
    return Verdict(0.0, Code.UNREADABLE, Reading(error.reason, error.position, error.proposal))
