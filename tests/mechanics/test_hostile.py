"""A small part of `benchmarks/structures.py` in every run: nearly singular structures are solved or refused by name."""

from __future__ import annotations

from random import Random

import pytest

from mechanics.errors import UnstableError
from tests.depth import amount
from tests.mechanics.hostile import KINDS, attack, exact_error, random_beam


@pytest.mark.parametrize("kind", KINDS)
def test_hostile_structures_are_solved_or_refused(kind: str) -> None:
    found = attack(7, amount(100, 300), kind)
    assert found.solved > amount(33, 100) and found.worst < 1e-9, found
    assert set(found.refused) <= {"ValueError", "UnstableError", "UnbalancedError"}


def test_a_hostile_beam_is_the_same_in_fractions() -> None:
    compared = 0
    for number in range(amount(14, 40)):
        try:
            made = random_beam(Random(f"exact/{number}"))
            assert exact_error(made) < 1e-9, made
        except (UnstableError, ValueError):
            continue
        compared += 1
    assert compared >= amount(4, 12)
