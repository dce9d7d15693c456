"""What the server asks of its judging, and grades that cost nobody anything when we fail."""

from __future__ import annotations

import logging
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from typing import Any, ParamSpec, Protocol, TypeVar

from exercises import catalogue, grading
from exercises.exercise import Grade, Submission
from graders.verdict import EMPTY, FAULT, KEPT

P = ParamSpec("P")
T = TypeVar("T")
log = logging.getLogger("grubler")


class JudgingEnded(Exception):
    """The judging has ended over a task more than once: it is ours to look at."""


class Judging(Protocol):
    """Where exercises are computed."""

    def begin(self) -> None:
        """Get ready; nothing waits for it."""
        ...

    async def run(self, compute: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Compute something of the exercise room."""
        ...

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Grade a submission; the rules are those of `grading.grade`."""
        ...

    async def apart(self, compute: Callable[..., T], tasks: Sequence[tuple[Any, ...]]) -> list[T]:
        """Compute long tasks without holding up the judging."""
        ...

    def close(self) -> None:
        """Finish what is under way."""
        ...


def graded(submission: Submission, secret: bytes, **rules: Any) -> Grade:
    try:
        return grading.grade(submission, secret, **rules)
    except grading.UnknownAnswer:
        raise
    except Exception:  # our fault, whatever it is: the student keeps the receipt and loses nothing
        log.exception("grading %s with seed %d failed", submission.variant.exercise, submission.variant.seed)
        return grading.failed(submission)


def graded_as_asked(submission: Submission, secret: bytes, asked: Collection[str], **rules: Any) -> Grade:
    """Grade answers to a task that was dealt before its exercise changed what it asks for.

    What the exercise no longer asks for has no judge: it is kept for the lecturer.

    Raises:
        UnknownAnswer: An answer that the task does not ask for.
    """
    unknown = sorted(set(submission.answers) - set(asked))
    if unknown:
        raise grading.UnknownAnswer(unknown[0])
    variant = submission.variant
    judged = catalogue.load(variant.exercise).exercise.answers_of(variant.givens)
    known = {name: text for name, text in submission.answers.items() if name in judged}
    grade = graded(replace(submission, answers=known), secret, **rules)
    if grade.verdicts.keys() != judged.keys() or FAULT in grade.verdicts.values():
        return grade
    gone = {name: submission.answers.get(name, "") for name in asked if name not in judged}
    kept = {name: KEPT if text.strip() else EMPTY for name, text in gone.items()}
    return replace(grade, verdicts={**grade.verdicts, **kept}, provisional=grade.provisional or KEPT in kept.values())
