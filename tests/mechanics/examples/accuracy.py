"""Accuracy (domain AC): each example computed from its inputs."""

from __future__ import annotations

from math import hypot, radians

from mechanics import accuracy, rod_groups
from mechanics.chain import Chain
from tests.mechanics.examples.reading import Inputs, Outputs, Solve


def _lengths(given: Inputs) -> dict[str, float]:
    return {name: given[name] for name in ("L1", "L2", "L3")}


def _joints(given: Inputs) -> tuple[float, float, float]:
    return given["q1"], given["q2"], given["q3"]


def by_partial_derivatives(given: Inputs) -> Outputs:
    lengths, q = _lengths(given), _joints(given)
    found = accuracy.linear(rod_groups.partials("RRR", lengths, q), given["dq"])
    there = rod_groups.direct("RRR", lengths, [x + e for x, e in zip(q, given["dq"], strict=True)])
    here = rod_groups.direct("RRR", lengths, q)
    dx, dy, dz = found.dr
    return {
        "dx": dx,
        "dy": dy,
        "dz": dz,
        "dr": hypot(dx, dy, dz),
        "exact": [b - a for a, b in zip(here, there, strict=True)],
        "worst_case_dr_bound": found.worst,
    }


def by_matrices(given: Inputs) -> Outputs:
    rows, point = rod_groups.table("RRR", _lengths(given))
    q, dq = _joints(given), given["dq"]
    return {"dT": accuracy.pose_error(rows, q, dq), "dr": accuracy.by_matrices(rows, q, dq, point)}


def by_vectors(given: Inputs) -> Outputs:
    rows, point = rod_groups.table("RRR", _lengths(given))
    found = accuracy.by_vectors(Chain(rows), _joints(given), given["dq"], point)
    one, two, three = found.terms
    return {"term1": one, "term2": two, "term3": three, "dr": found.dr}


def angular(given: Inputs) -> Outputs:
    rows, _ = rod_groups.table("RRR", _lengths(given))
    found = accuracy.angular(Chain(rows), _joints(given), given["dq"])
    return {"dphi_base": found.base, "dphi_gripper": found.gripper, "angle": found.angle}


def slider(given: Inputs) -> Outputs:
    errors = given["dl1"], given["dl2"], given["dalpha1"]
    found = accuracy.slider(given["l1"], given["l2"], radians(given["alpha1_deg"]), *errors)
    return {name: getattr(found, name) for name in ("c_l1", "c_l2", "c_alpha", "dl3", "worst", "rms")}


SOLVED: dict[str, Solve] = {
    "AC-1": by_partial_derivatives,
    "AC-2": by_matrices,
    "AC-3": by_vectors,
    "AC-4": angular,
    "AC-5": slider,
}
