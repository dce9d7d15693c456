"""What can be told of tasks before a card is dealt: limits on givens that are not there, pools of unequal length."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from typing import Any

from exercises import catalogue
from exercises.draw import Draw, Rejected
from exercises.givens import numbers
from graders.language.doubles import UndefinedError
from server.sets.dealing import Limits
from server.web.errors import Refused

DRAWS = 500  # of an exercise; what none of them has, too few cards would have to be limited by it
Task = tuple[Sequence[str], Limits]  # the pool of a task, and its limits


@dataclass(frozen=True, slots=True)
class Traits:
    """What the variants of an exercise have: givens that are numbers, and how many steps."""

    givens: tuple[str, ...]
    steps: frozenset[int]


def refuse_unfit(tasks: Iterable[Task]) -> None:
    """Refuse tasks that can never be published, as far as that is known without dealing.

    Raises:
        Refused: 422, by the number of the task from 0 and the field in it.
    """
    for at, (pool, limits) in enumerate(tasks):
        known = {exercise: traits(exercise) for exercise in pool if exercise in catalogue.ids()}
        _refuse_unknown_givens(f"items.{at}.limits", known, limits)
        _refuse_unequal_steps(f"items.{at}.pool", known)


def _refuse_unknown_givens(field: str, known: dict[str, Traits], limits: Limits) -> None:
    names = dict.fromkeys(name for found in known.values() for name in found.givens)
    unknown = next((name for name in limits if name not in names), None)
    if known and unknown is not None:
        raise Refused(422, "unknown_given", field=field, given=unknown, known=", ".join(names) or "—")


def _refuse_unequal_steps(field: str, known: dict[str, Traits]) -> None:
    """Refuse a pool in which no variant of one exercise is as long as one of another."""
    if any(one.steps.isdisjoint(other.steps) for one, other in combinations(known.values(), 2)):
        said = ", ".join(f"{exercise} {_between(found.steps)}" for exercise, found in known.items())
        raise Refused(422, "unequal_steps", field=field, counts=said)


def _between(counts: frozenset[int]) -> str:
    low, high = min(counts), max(counts)
    return f"{low}" if low == high else f"{low}–{high}"


@lru_cache(maxsize=1024)
def traits(exercise_id: str) -> Traits:
    """Look through draws of an exercise, whether or not they would be dealt."""
    exercise = catalogue.load(exercise_id).exercise
    names: dict[str, None] = {}
    steps: set[int] = set()
    for givens in _draws(exercise_id):
        names |= dict.fromkeys(numbers(givens))
        steps.add(len(exercise.steps_of(givens)))
    return Traits(tuple(names), frozenset(steps))


def _draws(exercise_id: str) -> Iterator[Any]:
    exercise = catalogue.load(exercise_id).exercise
    for seed in range(DRAWS):
        try:
            yield exercise.draw(Draw(exercise_id, seed, 0))
        except (Rejected, UndefinedError):
            continue
