"""A small part of `benchmarks/linkages.py` in every run: linkages near dead positions are solved or refused by name."""

from __future__ import annotations

from random import Random

import pytest

from tests.depth import amount
from tests.mechanics.hostile_linkages import KINDS, attack


@pytest.mark.parametrize("kind", KINDS)
def test_hostile_linkages_are_solved_or_refused(kind: str) -> None:
    count = amount(9, 25) if kind in ("class_iii", "bodies") else amount(100, 300)
    found = attack(7, count, kind)
    assert found.solved > count / 3 and found.worst < 1e-9, found
    assert kind in ("manipulator", "class_iii", "bodies") or found.refused["SingularError"] > 0


def test_two_assemblies_that_meet_are_found_behind_a_long_lever() -> None:
    assert KINDS["class_iii"](Random("1/class_iii/5842")) < 1e-9  # CE is eighteen times as long as BE
