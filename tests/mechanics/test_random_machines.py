"""Any train or structure is solved, and then obeys what it was made of, or is refused by name."""

from __future__ import annotations

from random import Random

import pytest

from tests.depth import amount
from tests.mechanics import judged_machines


@pytest.mark.parametrize("judge", [judged_machines.train, judged_machines.structure])
def test_random_machines_are_solved_or_refused_by_name(judge: judged_machines.Judge) -> None:
    chance = Random(7)
    outcomes = {judge(chance) for _ in range(amount(12, 40))}
    assert "solved" in outcomes


@pytest.mark.parametrize("number", [6272, 9749])
def test_motions_that_bend_at_once_are_no_further_motions(number: int) -> None:
    assert judged_machines.structure(Random(f"1:{number}")) == "passive constraints"
