"""Slips that students make are named, and numbers that no slip made are not."""

from __future__ import annotations

from importlib import import_module
from itertools import islice

import pytest

from exercises import catalogue
from tests.depth import amount
from tests.slips.random_answers import attributed
from tests.slips.slip import S, named_rightly, occasions

LEAST = 50  # slips an exercise
SHARE, CHANCE = 0.90, 0.01


def table(exercise: str) -> tuple[S, ...]:
    """Give the slips written for an exercise, apart from its list of mistakes."""
    slips: tuple[S, ...] = import_module(f"tests.slips.{exercise}").SLIPS
    return slips


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_every_exercise_has_fifty_different_slips(exercise: str) -> None:
    names = [slip.name for slip in table(exercise)]
    assert len(set(names)) == len(names) >= LEAST


def test_nine_slips_of_ten_are_named_rightly() -> None:
    """Each slip in the first variant where it shows; a slip without occasion counts as not named.

    Of all exercises together, and of each one where all its slips are tried.
    """
    named = {
        exercise: [
            any(named_rightly(slip, g) for _, g in islice(occasions(exercise, slip), 1))
            for slip in table(exercise)[:: amount(3, 1)]
        ]
        for exercise in catalogue.ids()
    }
    every = [one for found in named.values() for one in found]
    shares = {exercise: round(sum(found) / len(found), 2) for exercise, found in named.items()}
    print(f"{sum(every)} of {len(every)} slips named rightly: {shares}")
    assert sum(every) >= SHARE * len(every), shares
    assert min(sum(found) / len(found) for found in named.values()) >= amount(0.75, SHARE), shares


@pytest.mark.parametrize("whole", [False, True], ids=["one answer", "all answers"])
def test_random_wrong_answers_are_attributed_to_no_slip(whole: bool) -> None:
    explained, count, names = 0, 0, dict[str, dict[str, int]]()
    for exercise in catalogue.ids():
        more, all_, names[exercise] = attributed(exercise, range(1, 6 if whole else 11), whole)
        explained, count = explained + more, count + all_
    print(f"{explained} of {count} random submissions attributed: {names}")
    assert explained <= CHANCE * count, names
