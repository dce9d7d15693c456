"""Dealing a variant: drawing until no known mistake lands on a right answer; its stored form."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

from exercises import catalogue
from exercises.draw import Draw, Rejected
from exercises.exercise import AnyExercise, Steps, Variant
from exercises.givens import Json
from exercises.givens import dump as dump_givens
from exercises.givens import restore as restore_givens
from exercises.solving import Solved
from graders import Value
from graders.language import Tree
from graders.language.doubles import UndefinedError

MAX_SEED = 2**53 - 1
REDRAWS = 100
NOTHING_CHOSEN: Mapping[str, Value | Tree] = {}
APART = 3.0  # tolerances between a mistake's prediction and the reference, in some answer


class Predictions(Mapping[str, Any]):
    """The answers that a set of steps leads to, each reference made when it is first looked at."""

    def __init__(self, solved: Solved, values: Mapping[str, Value], lines: Steps) -> None:
        self._solved, self._values, self._lines = solved, values, lines
        self._made: dict[str, Any] = {}

    def __getitem__(self, answer: str) -> Any:
        if answer not in self._made:
            self._made[answer] = self._solved.reference(answer, self._values, self._lines)
        return self._made[answer]

    def __iter__(self) -> Iterator[str]:
        return iter(self._solved.answers)

    def __len__(self) -> int:
        return len(self._solved.answers)


class DrawError(RuntimeError):
    """An exercise refused a hundred draws in a row: its author must widen the draw."""


def deal(exercise_id: str, seed: int) -> Variant:
    """Deal the variant of a seed.

    Raises:
        UnknownExercise: No exercise has this id.
        ValueError: The seed is not a whole number from 0 to 2^53 - 1.
        DrawError: A hundred draws in a row were refused.
    """
    if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed <= MAX_SEED:
        raise ValueError(f"seed {seed!r} is not a whole number from 0 to {MAX_SEED}")
    exercise = catalogue.load(exercise_id).exercise
    for turn in range(REDRAWS):
        try:
            givens = exercise.draw(Draw(exercise_id, seed, turn))
            variant = Variant(exercise_id, exercise.version, seed, givens)
            if told_apart(Solved(exercise, variant)):
                return variant
        except (Rejected, UndefinedError):
            continue
    raise DrawError(f"{exercise_id}: seed {seed} was refused {REDRAWS} times")


def predictions(solved: Solved) -> dict[str, Predictions]:
    """Give the answers each mistake leads to; a mistake without occasion or without a value is left out."""
    return dict(slips(solved))


def slips(solved: Solved, chosen: Mapping[str, Value | Tree] = NOTHING_CHOSEN) -> Iterator[tuple[str, Predictions]]:
    """Solve one mistake after the other, so that who has found his need not solve the rest.

    Args:
        solved: The variant.
        chosen: Right answers of the student in which he chose freely (frames of a chain), by their step.
    """
    for name, mistake in solved.exercise.mistakes.items():
        lines = mistake.lines(solved.variant.givens)
        if not lines:
            continue
        try:
            yield name, Predictions(solved, solved.again(replaced=lines, fixed=chosen), lines)
        except UndefinedError:
            continue


def told_apart(solved: Solved) -> bool:
    """Tell whether every mistake differs from the reference and from the others in at least one answer."""
    right = Predictions(solved, solved.values, {})
    return all(differ(solved, one, other) for one, other in combinations([right, *predictions(solved).values()], 2))


def differ(solved: Solved, one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    """Tell whether two sets of answers are at least three tolerances apart somewhere; numbers are compared first."""
    for name in sorted(solved.answers, key=lambda answer: solved.answers[answer].symbolic):
        expected, other_one = one[name], other[name]
        if expected is not other_one and solved.answers[name].apart(expected, other_one) >= APART:
            return True
    return False


def dump(variant: Variant) -> dict[str, Json]:
    """Write a variant as JSON values."""
    return {
        "exercise": variant.exercise,
        "version": variant.version,
        "seed": variant.seed,
        "givens": dump_givens(variant.givens),
    }


def restore(stored: Mapping[str, Json]) -> Variant:
    """Build a variant from its stored form; the realised givens rule, not the seed."""
    exercise: AnyExercise = catalogue.load(stored["exercise"]).exercise
    givens = restore_givens(exercise.givens, stored["givens"])
    return Variant(stored["exercise"], stored["version"], stored["seed"], givens)
