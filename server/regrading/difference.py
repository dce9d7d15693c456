"""What changes when a submission is judged again. Pure: two grades in, the difference out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, TypeAlias

from graders.verdict import OUTCOMES

Json: TypeAlias = Any
OUTCOME = {code.value: outcome.value for code, outcome in OUTCOMES.items()}
GONE = "undecided"  # the outcome of a code that the judges do not give any more
Grade: TypeAlias = Mapping[str, Json]  # as it is stored


class Effect(StrEnum):
    """What a new grade does."""

    SAME = "same"
    RAISED = "raised"
    LOWERED = "lowered"
    WITHHELD = "withheld"  # it would be lower, and that was not asked for: the old one stays in force
    REWORDED = "reworded"  # the same score, found in another way


@dataclass(frozen=True, slots=True)
class Said:
    """What a grade says of one answer."""

    outcome: str
    code: str
    score: float


@dataclass(frozen=True, slots=True)
class Answer:
    """An answer of which two grades do not say the same; one of them may not speak of it at all."""

    name: str
    old: Said | None
    new: Said | None


@dataclass(frozen=True, slots=True)
class Difference:
    """What two grades of a submission have apart."""

    effect: Effect
    old: float
    new: float
    answers: tuple[Answer, ...]

    def told(self) -> dict[str, Json]:
        """Give all of it as JSON values."""
        answers: list[Json] = [
            {"name": one.name, "old": _plain(one.old), "new": _plain(one.new)} for one in self.answers
        ]
        return {"effect": self.effect.value, "old": self.old, "new": self.new, "answers": answers}

    @property
    def in_force(self) -> bool:
        """Whether the new grade is to take the place of the old one."""
        return self.effect in (Effect.RAISED, Effect.LOWERED, Effect.REWORDED)


def difference(old: Grade, new: Grade, allow_lower: bool) -> Difference:
    """Compare two grades of a submission.

    Args:
        old: The grade in force.
        new: What the installed judges give.
        allow_lower: Whether a lower score may take the place of a higher one.
    """
    names = [*old["verdicts"], *(name for name in new["verdicts"] if name not in old["verdicts"])]
    both = ((name, old["verdicts"].get(name), new["verdicts"].get(name)) for name in names)
    answers = tuple(Answer(name, _said(one), _said(other)) for name, one, other in both if one != other)
    return Difference(_effect(old, new, allow_lower), old["score"], new["score"], answers)


def _plain(said: Said | None) -> Json:
    return None if said is None else {"outcome": said.outcome, "code": said.code, "score": said.score}


def _effect(old: Grade, new: Grade, allow_lower: bool) -> Effect:
    if new["score"] > old["score"]:
        return Effect.RAISED
    if new["score"] < old["score"]:
        return Effect.LOWERED if allow_lower else Effect.WITHHELD
    return Effect.SAME if _judgement(old) == _judgement(new) else Effect.REWORDED


def _judgement(grade: Grade) -> dict[str, Json]:
    """A grade without the version that gave it: a new version that finds the same changes nothing."""
    return {name: value for name, value in grade.items() if name != "grader_version"}


def _said(verdict: Mapping[str, Json] | None) -> Said | None:
    return None if verdict is None else Said(OUTCOME.get(verdict["code"], GONE), verdict["code"], verdict["score"])
