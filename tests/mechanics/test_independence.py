"""An oracle must not lean on the module it checks, and nothing heavy is imported with the room."""

from __future__ import annotations

import subprocess
import sys

import pytest

POISONED = "import sys; sys.modules[{poison!r}] = None; import {module}; "


@pytest.mark.parametrize(
    ("module", "poison"),
    [
        ("mechanics.linkages.planar", "mechanics.linkages.slider_crank"),
        ("mechanics.linkages.slider_crank", "mechanics.linkages.planar"),
        ("mechanics.linkages.newton_linkages", "mechanics.linkages.four_bar"),
        ("mechanics.linkages.four_bar", "mechanics.linkages.planar"),
        ("mechanics.linkages.newton_linkages", "mechanics.linkages.dyad"),
        ("mechanics.linkages.newton_linkages", "mechanics.linkages.slider_crank"),
        ("mechanics.linkages.newton_linkages", "mechanics.linkages.manipulator"),
        ("mechanics.linkages.cycle", "mechanics.linkages.dyad"),
        ("mechanics.linkages.six_bar", "mechanics.linkages.planar"),
        ("mechanics.linkages.two_loop", "mechanics.linkages.planar"),
        ("mechanics.linkages.inverted_slider", "mechanics.linkages.planar"),
        ("mechanics.linkages.variable_length_link", "mechanics.linkages.planar"),
        ("mechanics.linkages.manipulator", "mechanics.linkages.planar"),
        ("mechanics.linkages.class_iii", "mechanics.linkages.planar"),
        ("mechanics.chains.transform", "mechanics.chains.chain"),
        ("mechanics.chains.chain", "mechanics.chains.transform"),
        ("mechanics.chains.transform", "mechanics.chains.rod_groups"),
        ("mechanics.chains.lagrange", "mechanics.chains.newton_euler"),
        ("mechanics.chains.lagrange", "mechanics.chains.chain"),
        ("mechanics.chains.newton_euler", "mechanics.chains.lagrange"),
        ("mechanics.chains.newton_euler", "mechanics.chains.transform"),
        ("mechanics.chains.link_frames", "mechanics.chains.newton_euler"),
        ("mechanics.dynamics.kinetostatics", "mechanics.dynamics.force_equations"),
        ("mechanics.strength.frame", "mechanics.strength.sweep"),
        ("mechanics.strength.beam", "mechanics.strength.stiffness"),
        ("mechanics.strength.torsion_frame", "mechanics.strength.shaft"),
        ("mechanics.transmissions.willis", "mechanics.transmissions.gear_train"),
        ("mechanics.transmissions.gear_train", "mechanics.transmissions.willis"),
    ],
)
def test_the_independent_way_imports_without_the_other(module: str, poison: str) -> None:
    code = POISONED.format(module=module, poison=poison)
    code += "assert not {'numpy', 'sympy'} & set(sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
