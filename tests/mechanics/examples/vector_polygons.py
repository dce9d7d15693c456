"""Vector polygons (domain VP): each example computed from its inputs."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees, hypot, pi, radians
from typing import Any

from mechanics import (
    four_bar,
    inverted_slider,
    manipulator,
    slider_crank,
    two_loop,
    variable_length_link,
)
from mechanics.linkage import LinkageMotion
from tests.mechanics.examples.reading import Inputs, Outputs, Solve

Names = Mapping[str, str]


def _named(motion: LinkageMotion, pos: Names, vel: Names, acc: Names) -> dict[str, Any]:
    """Give the values of a motion under the names of the example, angles in degrees where the name says so."""
    found: dict[str, Any] = {}
    for values, names in ((motion.pos, pos), (motion.vel, vel), (motion.acc, acc)):
        for name, ours in names.items():
            found[name] = degrees(values[ours]) if name.endswith("_deg") else values[ours]
    return found


def rocking_slide(given: Inputs) -> Outputs:
    motion = inverted_slider.solve(
        given["l1"], radians(given["alpha1_deg"]), given["omega1"], given["eps1"], (0.0, -given["l0"])
    )
    return _named(motion, {"l2": "s", "alpha2_deg": "phi"}, {"v2": "s", "omega2": "phi"}, {"p2": "s", "eps2": "phi"})


def slider(given: Inputs) -> Outputs:
    offset = given.get("h", 0.0)
    motion = slider_crank.solve(
        given["l1"], given["l2"], radians(given["alpha1_deg"]), given["omega1"], given["eps1"], offset
    )
    pos = {"alpha2_deg": "alpha2", "l3": "slider_x"}
    found = _named(motion, pos, {"omega2": "alpha2", "v3": "slider_x"}, {"eps2": "alpha2", "p3": "slider_x"})
    if "h" in given:
        return found | {"stroke": slider_crank.stroke(given["l1"], given["l2"], offset)}
    return found | {"alpha2_rad": motion.pos["alpha2"]}


def four_bars(given: Inputs) -> Outputs:
    bars = (given["l1"], given["l2"], given["l3"], given["l4"])
    alpha1 = radians(given["alpha1_deg"])
    motion = four_bar.solve(*bars, alpha1, given["omega1"], given["eps1"])
    other = four_bar.position(*bars, alpha1, "C_right_of_BD")
    pos = {"alpha2_deg": "alpha2", "alpha3_deg": "alpha3"}
    vel, acc = {"omega2": "alpha2", "omega3": "alpha3"}, {"eps2": "alpha2", "eps3": "alpha3"}
    others = {"alpha2_deg_other": degrees(other.coupler_angle), "alpha3_deg_other": degrees(other.rocker_angle)}
    return _named(motion, pos, vel, acc) | others


def two_loops(given: Inputs) -> Outputs:
    lengths = (given["l1"], given["l2"], given["l3"], given["l4"], given["l5"], given["h6"])
    motion = two_loop.solve(*lengths, radians(given["alpha1_deg"]), given["omega1"], given["eps1"])
    pos = {"alpha5_deg": "alpha5", "s6": "s6"}
    return _named(motion, pos, {"omega5": "alpha5", "v6": "s6"}, {"eps5": "alpha5", "p6": "s6"})


def arm(word: str) -> Solve:
    """Solve an example of a manipulator; its variables are Theta and h with the number of the joint."""

    def solve(given: Inputs) -> Outputs:
        names = [f"Theta{i}" if joint == "R" else f"h{i}" for i, joint in enumerate(word, 1)]
        motion = manipulator.solve(
            word,
            [radians(given[f"{name}_deg"]) if name[0] == "T" else given[name] for name in names],
            [given["l_AB"], given["l_BC"]],
            [given[f"{name}_dot"] for name in names],
            [given[f"{name}_ddot"] for name in names],
            radians(given["delta_deg"]),
        )
        parts = (("", "", motion.pos), ("v", "v", motion.vel), ("a", "a", motion.acc))
        found = {f"{prefix}{axis}": values[f"p_{axis}"] for _, prefix, values in parts for axis in "xy"}
        return found | {total: hypot(values["p_x"], values["p_y"]) for total, _, values in parts if total}

    return solve


def linear_drive(given: Inputs) -> Outputs:
    lengths = (given["AC"], given["BC"], given["AB"], given["AB_dot"], given["AB_ddot"])
    motion = variable_length_link.solve(*lengths, mirrored=True)
    beta, omega = motion.pos["beta"], motion.vel["beta"]
    return {
        "beta_deg": degrees(beta),
        "alpha_deg": degrees(motion.pos["alpha"]),
        "phi_deg": degrees(pi / 2 - beta),
        "xB": given["xC"] + motion.pos["B_x"],
        "yB": given["yC"] + motion.pos["B_y"],
        "v_Bx": motion.vel["B_x"],
        "v_BC": hypot(motion.vel["B_x"], motion.vel["B_y"]),
        "omega_BC": omega,
        "eps_BC": motion.acc["beta"],
        "omega_AB": -motion.vel["alpha"],  # AB points at pi - alpha
    }


SOLVED: dict[str, Solve] = {
    "VP-1": rocking_slide,
    "VP-2": slider,
    "VP-3": slider,
    "VP-4": four_bars,
    "VP-5": two_loops,
    "VP-6": arm("RRP"),
    "VP-6b": arm("RRP"),
    "VP-7": arm("RPR"),
    "VP-7b": arm("RPR"),
    "VP-8": arm("PRR"),
    "VP-9": linear_drive,
}
