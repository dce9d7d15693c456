"""Mechanisms of a higher class (domain HC): each example computed from its inputs."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from math import degrees, pi, radians
from typing import Any

from mechanics.class_iii import Unit, assemblies, constraint, critical, newton
from tests.mechanics.examples.reading import Inputs, Outputs, Solve, inputs

PIVOTS = ("A", "D", "G", "K")


def unit(**changed: complex) -> Unit:
    """Give the unit of HC-1; all HC examples have its geometry."""
    given = dict(inputs("HC-1"))
    geometry: dict[str, Any] = {name: complex(*given.pop(name)) for name in PIVOTS} | given
    return Unit(**(geometry | changed))


def all_assemblies(given: Inputs) -> Outputs:
    one = unit()
    found = assemblies(one)
    first = found[0]
    return {
        "chi_2E_deg": degrees(phase(one.arm_C)),
        "chi_4F_deg": degrees(phase(one.arm_E)),
        "n_real": len(found),
        "alpha5_deg": [degrees(one.alpha5) for one in found],
        "first_alpha4_deg": degrees(first.alpha4),
        "first_alpha2_deg": degrees(first.alpha2),
        "first_E": _point(first.E),
        "first_C": _point(first.C),
        "first_F": _point(first.F),
    }


def _point(place: complex) -> Sequence[float]:
    return [place.real, place.imag]


def constraint_functions(given: Inputs) -> Outputs:
    names = {"Phi_pp": "++", "Phi_pm": "+-", "Phi_mp": "-+", "Phi_mm": "--"}
    return {name: constraint(unit(), radians(given["alpha5_deg"]), branch) for name, branch in names.items()}


def singular_positions(given: Inputs) -> Outputs:
    height = unit().K.imag
    found = critical(lambda x_K: unit(K=complex(x_K, height)), given["x_K_from"], given["x_K_to"])
    places = {f"x_K_{i}": one.parameter for i, one in enumerate(found, 1)}
    angles = {f"alpha5_{i}_deg": degrees(one.angles[0]) for i, one in enumerate(found, 1)}
    return {**places, **angles, "counts": [found[0].below, *(one.above for one in found)]}


def newton_steps(given: Inputs) -> Outputs:
    steps = newton(unit(), tuple(given["start_rad"]))
    return {"step1": steps[1], "step2": steps[2], "root": [angle % (2 * pi) for angle in steps[-1]]}


SOLVED: dict[str, Solve] = {
    "HC-1": all_assemblies,
    "HC-2": constraint_functions,
    "HC-3": singular_positions,
    "HC-4": newton_steps,
}
