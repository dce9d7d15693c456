"""What can be told of tasks before a card is dealt: limits on givens that are not there or that no card can keep, pools
of unequal length."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import combinations
from statistics import mode
from typing import Any

from exercises import catalogue
from exercises.draw import Draw, Rejected
from exercises.givens import domains
from graders import Domain
from graders.language.doubles import UndefinedError
from server.sets.dealing import DRAWS as DEALING_DRAWS
from server.sets.dealing import LEAST_ACCEPTED, Limits, kept
from server.web.errors import Refused

DRAWS = 500  # of an exercise; what none of them has, too few cards would have to be limited by it
Task = tuple[Sequence[str], Limits]  # the pool of a task, and its limits


@dataclass(frozen=True, slots=True)
class Traits:
    """What the variants of an exercise have: givens that are numbers, how many steps, and the least and greatest value
    that is declared of each given that all of them have."""

    givens: tuple[str, ...]
    steps: frozenset[int]
    always: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Scarce:
    """Limits that fewer draws of an exercise keep than publishing asks for."""

    slot: int
    exercise: str
    accepted: int
    draws: int


@dataclass(frozen=True, slots=True)
class Uneven:
    """A pool of exercises of which most draws differ in their number of steps, with these numbers."""

    slot: int
    counts: str


def refuse_unfit(tasks: Iterable[Task]) -> None:
    """Refuse tasks that can never be published, as far as that is known without dealing.

    Raises:
        Refused: 422, by the number of the task from 0 and the field in it.
    """
    for at, (pool, limits) in enumerate(tasks):
        known = {exercise: traits(exercise) for exercise in pool if exercise in catalogue.ids()}
        _refuse_unknown_givens(f"items.{at}.limits", known, limits)
        _refuse_values_that_never_come(f"items.{at}.limits", known, limits)
        _refuse_unequal_steps(f"items.{at}.pool", known)


def _refuse_unknown_givens(field: str, known: dict[str, Traits], limits: Limits) -> None:
    names = dict.fromkeys(name for found in known.values() for name in found.givens)
    unknown = next((name for name in limits if name not in names), None)
    if known and unknown is not None:
        raise Refused(422, "unknown_given", field=field, given=unknown, known=", ".join(names) or "—")


def _refuse_values_that_never_come(field: str, known: dict[str, Traits], limits: Limits) -> None:
    """Refuse limits outside the values that are declared of a given, which no draw can keep."""
    for exercise, found in known.items():
        for given, (low, high) in limits.items():
            least, greatest = found.always.get(given, (low, high))
            if high < least or greatest < low:
                raise Refused(422, "limit_outside", field=field, given=given, exercise=exercise)


def scarce(tasks: Iterable[Task]) -> tuple[Scarce, ...]:
    """Name the tasks whose limits keep under 1 % of the draws, as far as some draws tell."""
    found = []
    for slot, (pool, limits) in enumerate(tasks, 1):
        for exercise in pool if limits else ():
            drawn = _drawn(exercise) if exercise in catalogue.ids() else ()
            accepted = sum(kept(givens, limits) for givens in drawn)
            if accepted * DEALING_DRAWS < LEAST_ACCEPTED * len(drawn):
                found.append(Scarce(slot, exercise, accepted, len(drawn)))
    return tuple(found)


def uneven(tasks: Iterable[Task]) -> tuple[Uneven, ...]:
    """Name the tasks whose pools most likely cannot be published: most draws of their exercises differ in steps."""
    found = []
    for slot, (pool, limits) in enumerate(tasks, 1):
        known = [exercise for exercise in pool if exercise in catalogue.ids()]
        usual = {one: _usual(one, limits) for one in known} if len(known) > 1 else {}
        if len(set(usual.values()) - {None}) > 1:
            found.append(Uneven(slot, "; ".join(f"{one} ({count})" for one, count in usual.items() if count)))
    return tuple(found)


def _usual(exercise: str, limits: Limits) -> int | None:
    """Tell how many steps most draws within the limits have; None where no draw is within them."""
    both = zip(_drawn(exercise), _lengths(exercise), strict=True)
    counts = [length for givens, length in both if kept(givens, limits)]
    return mode(counts) if counts else None


def _refuse_unequal_steps(field: str, known: dict[str, Traits]) -> None:
    """Refuse a pool in which no variant of one exercise is as long as one of another."""
    if any(one.steps.isdisjoint(other.steps) for one, other in combinations(known.values(), 2)):
        said = "; ".join(f"{exercise} ({length(exercise)})" for exercise in known)
        raise Refused(422, "unequal_steps", field=field, counts=said)


def length(exercise_id: str) -> str:
    """Tell how many steps the solution of an exercise has, from the fewest to the most."""
    counts = traits(exercise_id).steps
    low, high = min(counts), max(counts)
    return f"{low}" if low == high else f"{low}–{high}"


@lru_cache(maxsize=1024)
def traits(exercise_id: str) -> Traits:
    """Look through draws of an exercise, whether or not they would be dealt."""
    bounds: dict[str, list[Domain]] = {}
    steps = _lengths(exercise_id)
    for givens in _drawn(exercise_id):
        for name, domain in domains(givens).items():
            bounds.setdefault(name, []).append(domain)
    always = {name: _span(found) for name, found in bounds.items() if len(found) == len(steps)}
    return Traits(tuple(bounds), frozenset(steps), always)


def _span(found: Sequence[Domain]) -> tuple[float, float]:
    return min(one.low for one in found), max(one.high for one in found)


@lru_cache(maxsize=64)
def _lengths(exercise_id: str) -> tuple[int, ...]:
    exercise = catalogue.load(exercise_id).exercise
    return tuple(len(exercise.steps_of(givens)) for givens in _drawn(exercise_id))


@lru_cache(maxsize=64)
def _drawn(exercise_id: str) -> tuple[Any, ...]:
    return tuple(_draws(exercise_id))


def _draws(exercise_id: str) -> Iterator[Any]:
    exercise = catalogue.load(exercise_id).exercise
    for seed in range(DRAWS):
        try:
            yield exercise.draw(Draw(exercise_id, seed, 0))
        except (Rejected, UndefinedError):
            continue
