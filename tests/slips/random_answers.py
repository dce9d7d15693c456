"""Wrong answers that no slip made: plausible numbers, whole numbers, choices and entries at random."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from typing import Any

from exercises import solving
from exercises.exercise import Submission
from exercises.grading import grade
from tests.slips.slip import dealt

RANGE = 10.0  # of a random number to the right one, either way
FIGURES = 4
NEAR = 6  # of a random whole number to the right one


def _number(chance: random.Random, value: float) -> float:
    factor = RANGE ** chance.uniform(-1, 1) * chance.choice((-1, 1))
    return float(f"{(abs(value) or 1.0) * factor:.{FIGURES}g}")


def _rows(chance: random.Random, rows: Any) -> tuple[tuple[float, ...], ...]:
    """Entries of the size of the largest, in about half of the places."""
    size = max(abs(entry) for row in rows for entry in row)
    return tuple(tuple(_number(chance, size / 2) if chance.random() < 0.5 else entry for entry in row) for row in rows)


WRITTEN: dict[str, Callable[[random.Random, Any, Any], str]] = {
    "quantity": lambda chance, judge, value: judge.show(_number(chance, value)),
    "matrix": lambda chance, judge, value: judge.show(_rows(chance, value)),
    "set": lambda chance, judge, value: judge.show(tuple(tuple(_number(chance, e) for e in row) for row in value)),
    "integer": lambda chance, judge, value: str(
        chance.choice([round(value) + by for by in range(-NEAR, NEAR + 1) if by])
    ),
    "rational": lambda chance, judge, value: f"{chance.randint(-99, 99)}/{chance.randint(1, 60)}",
    "choice": lambda chance, judge, value: chance.choice([one for one in judge.options if one != value]),
}


def random_submissions(exercise: str, seeds: range, whole: bool) -> Iterator[Submission]:
    """Give submissions in which one answer is random and all others right, or all that can be are random."""
    for seed in seeds:
        chance = random.Random(f"{exercise} {seed} {whole}")
        variant = dealt(exercise, seed)
        solved = solving.solved(variant)
        right = {name: judge.show(solved.reference(name)) for name, judge in solved.answers.items()}
        guessed = {
            name: WRITTEN[judge.kind](chance, judge, solved.reference(name))
            for name, judge in solved.answers.items()
            if judge.kind in WRITTEN and len(getattr(judge, "options", "abc")) > 2  # of two options one is wrong
        }
        if whole:
            yield Submission(variant, guessed)
        else:
            name = chance.choice([*guessed])
            yield Submission(variant, {**right, name: guessed[name]})


def attributed(exercise: str, seeds: range, whole: bool) -> tuple[int, int, dict[str, int]]:
    """Count the submissions that are explained by some slip, all of them, and by which."""
    names: dict[str, int] = {}
    explained = count = 0
    for submission in random_submissions(exercise, seeds, whole):
        found = grade(submission)
        if found.score == 1:
            continue
        count += 1
        if found.mistake or found.slip:
            explained += 1
            name = "+".join(filter(None, (found.mistake, found.slip and found.slip.value)))
            names[name] = names.get(name, 0) + 1
    return explained, count, names
