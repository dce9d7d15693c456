"""The solvers are imported by others too: each stands where it has always stood, whatever room is made around it."""

from __future__ import annotations

from importlib import import_module

import pytest

SOLVERS = (
    "balancing", "bar", "beam", "chain", "class_iii", "four_bar", "frame", "gear_train", "manipulator",
    "newton_euler", "planar", "reduction", "rod_groups", "section", "shaft", "six_bar", "slider_crank", "structure",
    "vibration", "willis",
)  # fmt: skip


@pytest.mark.parametrize("name", SOLVERS)
def test_a_solver_is_a_module_of_mechanics(name: str) -> None:
    module = import_module(f"mechanics.{name}")
    assert module.__doc__ and module.__name__ == f"mechanics.{name}"
