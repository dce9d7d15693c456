"""What a comparison answers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from graders.equality import Finding
from graders.solutions.found import Found


class Verdict(StrEnum):
    """What two answers are to each other."""

    EQUAL = "equal"
    DIFFERENT = "different"
    UNDECIDED = "undecided"
    UNREADABLE = "unreadable"


class Why(StrEnum):
    """The code of a verdict; that of an unreadable text is its reason."""

    EQUAL = "equal"
    VALUE = "value"  # another value at the witness
    UNDEFINED = "undefined"  # no value there, on one side only
    LOST = "lost_solution"  # the witness solves a, not b
    SURPLUS = "surplus_solution"  # the witness solves b, not a
    SHAPE = "shape"  # of another kind or shape
    COUNT = "count"
    DIMENSION = "dimension"
    UNDECIDED = "undecided"
    NOWHERE = "nowhere"  # neither has a value anywhere


@dataclass(frozen=True, slots=True)
class Answer:
    """A verdict with its code, the place of what could not be read, and the point that proves a difference."""

    verdict: Verdict
    code: str
    position: int | None = None
    witness: tuple[tuple[str, float], ...] = ()

    def document(self) -> dict[str, Any]:
        """Give the answer as a JSON object."""
        found: dict[str, Any] = {"verdict": self.verdict.value, "code": str(self.code), "position": self.position}
        if self.verdict is Verdict.DIFFERENT:
            found["witness"] = dict(self.witness)
        return found


EQUAL = Answer(Verdict.EQUAL, Why.EQUAL)
UNDECIDED = Answer(Verdict.UNDECIDED, Why.UNDECIDED)
NOWHERE = Answer(Verdict.UNDECIDED, Why.NOWHERE)


def different(why: Why, witness: Iterable[tuple[str, float]] = ()) -> Answer:
    """Make the answer that two are different."""
    return Answer(Verdict.DIFFERENT, why, witness=tuple(witness))


def of_solutions(found: Found) -> Answer:
    """Turn what was found about sets of solutions into an answer."""
    if found.finding is Finding.EQUAL:
        return EQUAL
    if found.finding is Finding.UNDECIDED:
        return UNDECIDED
    return different(Why.LOST if found.lost else Why.SURPLUS, found.witness)
