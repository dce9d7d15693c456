"""Velocity methods (domain VM): each example computed from its inputs."""

from __future__ import annotations

from math import degrees, dist, hypot, radians

from mechanics import acceleration, instant_centre, rotated_velocities, velocity, velocity_plan
from mechanics.drawing import Point
from tests.mechanics.examples.reading import Inputs, Outputs, Solve


def _points(given: Inputs, *names: str) -> tuple[Point, ...]:
    return tuple((given[name][0], given[name][1]) for name in names)


def projection(given: Inputs) -> Outputs:
    A, B, v_A = _points(given, "A", "B", "vA")
    found = velocity.project(A, B, v_A, radians(given["dirB_deg"]))
    return {"vB": found.speed, "vBx": found.v_B[0], "vBy": found.v_B[1], "omega": found.omega}


def centre(given: Inputs) -> Outputs:
    A, B, C, v_A, v_B = _points(given, "A", "B", "C", "vA", "vB")
    found = instant_centre.of_velocities(A, B, v_A, v_B)
    assert found.S is not None
    v_C = found.velocity(C)
    return {
        "omega": found.omega,
        "Sx": found.S[0],
        "Sy": found.S[1],
        "vCx": v_C[0],
        "vCy": v_C[1],
        "vC": hypot(*v_C),
        "check_vA_over_SA": hypot(*v_A) / dist(found.S, A),
        "check_vB_over_SB": hypot(*v_B) / dist(found.S, B),
    }


def decomposition(given: Inputs) -> Outputs:
    A, B, v_A = _points(given, "rA", "rB", "vA")
    found = velocity.decompose(A, B, v_A, given["omega"])
    return {"vBx": found.v_B[0], "vBy": found.v_B[1], "vBA": hypot(*found.v_BA)}


def plan(given: Inputs) -> Outputs:
    A, B, C, v_A, v_B = _points(given, "A", "B", "C", "vA", "vB")
    found = velocity_plan.of_link({"A": A, "B": B, "C": C}, "A", "B", (v_A, v_B))
    ratio = velocity_plan.similarity(A, B, C)
    return {
        "vCx": found.vectors["C"][0],
        "vCy": found.vectors["C"][1],
        "ratio_re": ratio.real,
        "ratio_im": ratio.imag,
        "scale_ab_over_AB": found.drawn("B", "A", 1.0) / dist(A, B),
    }


def centre_of_accelerations(given: Inputs) -> Outputs:
    A, B, a_A = _points(given, "A", "B", "aA")
    found = acceleration.decompose(A, B, a_A, given["omega"], given["eps"])
    centre = acceleration.centre(A, a_A, given["omega"], given["eps"])
    return {
        "aBx": found.a_B[0],
        "aBy": found.a_B[1],
        "Qx": centre.Q[0],
        "Qy": centre.Q[1],
        "angle_deg": degrees(centre.angle),
    }


def rotated(given: Inputs) -> Outputs:
    A, B, v_A, v_B = _points(given, "A", "B", "vA", "vB")
    found = rotated_velocities.rotate(A, B, v_A, v_B, float(given["scale"].split()[0]))
    return {
        "endA": found.ends["A"],
        "endB": found.ends["B"],
        "ratio_endAendB_over_AB": dist(found.ends["A"], found.ends["B"]) / dist(A, B),
    }


SOLVED: dict[str, Solve] = {
    "VM-1": projection,
    "VM-2": centre,
    "VM-3": decomposition,
    "VM-4": plan,
    "VM-5": centre_of_accelerations,
    "VM-6": rotated,
}
