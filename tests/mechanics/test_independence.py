"""An oracle must not lean on the module it checks, and nothing heavy is imported with the room."""

from __future__ import annotations

import subprocess
import sys

import pytest

POISONED = "import sys; sys.modules[{poison!r}] = None; import {module}; "


@pytest.mark.parametrize(
    ("module", "poison"),
    [
        ("mechanics.planar", "mechanics.slider_crank"),
        ("mechanics.slider_crank", "mechanics.planar"),
        ("mechanics.newton_linkages", "mechanics.four_bar"),
        ("mechanics.four_bar", "mechanics.planar"),
        ("mechanics.newton_linkages", "mechanics.dyad"),
        ("mechanics.newton_linkages", "mechanics.slider_crank"),
        ("mechanics.newton_linkages", "mechanics.manipulator"),
        ("mechanics.cycle", "mechanics.dyad"),
        ("mechanics.six_bar", "mechanics.planar"),
        ("mechanics.two_loop", "mechanics.planar"),
        ("mechanics.inverted_slider", "mechanics.planar"),
        ("mechanics.variable_length_link", "mechanics.planar"),
        ("mechanics.manipulator", "mechanics.planar"),
        ("mechanics.class_iii", "mechanics.planar"),
        ("mechanics.transform", "mechanics.chain"),
        ("mechanics.chain", "mechanics.transform"),
        ("mechanics.transform", "mechanics.rod_groups"),
        ("mechanics.lagrange", "mechanics.newton_euler"),
        ("mechanics.lagrange", "mechanics.chain"),
        ("mechanics.newton_euler", "mechanics.lagrange"),
        ("mechanics.newton_euler", "mechanics.transform"),
        ("mechanics.link_frames", "mechanics.newton_euler"),
        ("mechanics.kinetostatics", "mechanics.force_equations"),
        ("mechanics.frame", "mechanics.sweep"),
        ("mechanics.beam", "mechanics.stiffness"),
        ("mechanics.torsion_frame", "mechanics.shaft"),
        ("mechanics.willis", "mechanics.gear_train"),
        ("mechanics.gear_train", "mechanics.willis"),
    ],
)
def test_the_independent_way_imports_without_the_other(module: str, poison: str) -> None:
    code = POISONED.format(module=module, poison=poison)
    code += "assert not {'numpy', 'sympy'} & set(sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
