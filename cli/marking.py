"""Marking one file of answers: against the tasks it names itself, or against a list of tasks."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from cli.problems import Unusable
from cli.reading import Item, Task, read_answers
from exercises import catalogue, grading
from exercises.exercise import Grade, Submission, Variant
from exercises.variants import deal
from graders import Outcome
from graders.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Mark:
    """What one task brought.

    Attributes:
        exercise: Id of the exercise.
        seed: Seed of the variant.
        version: Version of the exercise.
        variant: The variant, from which the hint is worded; None where nothing was graded.
        grade: The grade; None where the file does not answer the task.
        lack: Why nothing was graded: ``absent`` or ``disagrees``; empty otherwise.
    """

    exercise: str
    seed: int
    version: int
    variant: Variant | None = None
    grade: Grade | None = None
    lack: str = ""

    @property
    def score(self) -> float:
        """The score, 0 where nothing was graded."""
        return self.grade.score if self.grade else 0.0

    @property
    def verdicts(self) -> Mapping[str, Verdict]:
        """The verdicts by answer."""
        return self.grade.verdicts if self.grade else {}


@dataclass(frozen=True, slots=True)
class Sheet:
    """One marked file, or why it could not be marked."""

    file: str
    marks: tuple[Mark, ...] = ()
    problem: Unusable | None = None

    @property
    def score(self) -> float:
        """The mean of the items' scores."""
        return round(sum(mark.score for mark in self.marks) / len(self.marks), 6) if self.marks else 0.0

    @property
    def failed(self) -> bool:
        """Whether some answer could not be judged by our fault."""
        return any(verdict.outcome is Outcome.FAULT for mark in self.marks for verdict in mark.verdicts.values())


def mark_file(file: str, tasks: Sequence[Task] | None, secret: bytes) -> Sheet:
    """Mark a file.

    Args:
        file: Its name.
        tasks: What was asked; without it the file's own items are.
        secret: What the test points of formulas are drawn from.
    """
    try:
        items = read_answers(file)
        if tasks is None:
            return Sheet(file, tuple(_graded(file, item, secret) for item in items))
        return Sheet(file, tuple(_against(file, list(items), tasks, secret)))
    except Unusable as problem:
        return Sheet(file, problem=problem)


def _against(file: str, items: list[Item], tasks: Sequence[Task], secret: bytes) -> list[Mark]:
    """Mark each task by the first unused item that answers it; a task without one scores 0."""
    found = [_taken(items, task) for task in tasks]
    others = {item.exercise for item in items}
    marks = []
    for task, item in zip(tasks, found, strict=True):
        lack = "disagrees" if task.exercise in others else "absent"
        empty = Mark(task.exercise, task.seed, task.version, lack=lack)
        marks.append(_graded(file, item, secret) if item else empty)
    return marks


def _taken(items: list[Item], task: Task) -> Item | None:
    for at, item in enumerate(items):
        if (item.exercise, item.seed) == (task.exercise, task.seed):
            return items.pop(at)
    return None


def _graded(file: str, item: Item, secret: bytes) -> Mark:
    version = catalogue.load(item.exercise).exercise.version
    variant = deal(item.exercise, item.seed)
    submission = Submission(variant, item.answers)
    try:
        grade = grading.grade(submission, secret)
    except grading.UnknownAnswer as unknown:
        place = f"{item.place}.answers.{unknown}"
        raise Unusable("unknown_answer", file, place, names=", ".join(grading.failed(submission).verdicts)) from None
    except Exception as error:  # our fault, whatever it is: the other answers are graded all the same
        sys.excepthook(type(error), error, error.__traceback__)
        grade = grading.failed(submission)
    return Mark(item.exercise, item.seed, version, variant, grade)
