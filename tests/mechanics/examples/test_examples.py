"""Every worked example of the domain, reproduced to its printed digits by the solvers."""

from __future__ import annotations

import pytest

from tests.mechanics.examples import (
    accuracy,
    balancing,
    dynamics,
    higher_class,
    manipulators,
    motion_laws,
    strength,
    structure,
    transmissions,
    vector_polygons,
    velocity_methods,
)
from tests.mechanics.examples.reading import EXAMPLES, Solve, inputs, unlike

CHAPTERS = (
    vector_polygons, structure, velocity_methods, higher_class, manipulators, motion_laws, transmissions, accuracy,
    dynamics, balancing, strength,
)  # fmt: skip
SOLVED: dict[str, Solve] = {name: solve for chapter in CHAPTERS for name, solve in chapter.SOLVED.items()}


@pytest.mark.parametrize("name", SOLVED)
def test_a_worked_example_is_reproduced_to_its_printed_digits(name: str) -> None:
    assert unlike(name, SOLVED[name](inputs(name))) == []


def test_no_example_is_forgotten() -> None:
    assert SOLVED.keys() == EXAMPLES.keys() and len(EXAMPLES) == 103
