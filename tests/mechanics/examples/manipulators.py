"""Manipulators by homogeneous matrices (domain DH): each example computed from its inputs."""

from __future__ import annotations

from math import radians

from mechanics import chain, link_frames, rod_groups, transform
from mechanics.chain import Chain
from mechanics.dh import Row
from mechanics.transform import acceleration_matrix, moved_point, velocity_matrix
from mechanics.vectors import Matrix
from tests.mechanics.examples.reading import Inputs, Outputs, Solve

WORDS = (*rod_groups.GROUPS,)  # in the order of the groups, 1 to 6


def _group(given: Inputs) -> tuple[str, dict[str, float]]:
    word = WORDS[given["group"] - 1]
    return word, {name: given[name] for name in rod_groups.GROUPS[word].lengths}


def _joints(given: Inputs) -> tuple[float, float, float]:
    return given["q1"], given["q2"], given["q3"]


def rigid_transform(given: Inputs) -> Outputs:
    assert given["R"] == "Rz(30deg)"
    x, y, z = given["p"]
    up, across = transform.trans_z(z), transform.product(transform.rot_z(radians(90)), transform.trans_x(y))
    T = transform.product(transform.trans_x(x), across, transform.rot_z(radians(30 - 90)), up)
    return {"r_out": moved_point(T, given["r"])}


def _pair(given: Inputs) -> Matrix:
    return chain.pair_matrix(radians(given["theta_deg"]), given["s"], given["a"], radians(given["alpha_deg"]))


def pair_matrix(given: Inputs) -> Outputs:
    return {"A": _pair(given)}


def point_transfer(given: Inputs) -> Outputs:
    A = _pair(given)
    return {"r_prev": moved_point(A, given["r_i"]), "A_inv": transform.rigid_inverse(A)}


def derivatives(given: Inputs) -> Outputs:
    theta, alpha = radians(given["theta_deg"]), radians(given["alpha_deg"])
    turn, slide = Row("R", 0.0, given["s"], given["a"], alpha), Row("P", theta, 0.0, given["a"], alpha)
    return {
        "dA_dtheta": velocity_matrix([turn], [theta], 1, 1),
        "dA_ds": velocity_matrix([slide], [given["s"]], 1, 1),
    }


def direct(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    assert word == given["pairs"]
    q = _joints(given)
    rows, _ = rod_groups.table(word, lengths)
    return {
        "M": rod_groups.direct(word, lengths, q),
        "T": chain.pose(Chain(rows), q),
        "det_J": rod_groups.determinant(word, lengths, q),
    }


def inverse(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    found = rod_groups.inverse(word, lengths, given["M"])
    return {"n_solutions": len(found), "solutions": found}


def velocity_matrices(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    rows, point = rod_groups.table(word, lengths)
    q, qd = _joints(given), given["q_dot"]
    _, v, _ = transform.point_motion(rows, q, qd, (0.0,) * 3, point)
    return {**{f"U3{j}": velocity_matrix(rows, q, 3, j) for j in (1, 2, 3)}, "v_M": v}


def acceleration_matrices(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    rows, point = rod_groups.table(word, lengths)
    q = _joints(given)
    _, _, a = transform.point_motion(rows, q, given["q_dot"], given["q_ddot"], point)
    pairs = ((1, 1), (1, 2), (2, 2), (3, 3))
    return {**{f"V3{j}{k}": acceleration_matrix(rows, q, 3, j, k) for j, k in pairs}, "a_M": a}


def recursion_in_base_axes(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    rows, point = rod_groups.table(word, lengths)
    state = _joints(given), given["q_dot"], given["q_ddot"]
    last, tool = chain.link_motions(Chain(rows), *state)[-1], chain.solve(Chain(rows), *state, point)
    return {
        "omega3": last.omega,
        "eps3": last.epsilon,
        "v_O3": last.v,
        "a_O3": last.a,
        "v_M": tool.v,
        "a_M": tool.a,
    }


def recursion_in_link_axes(given: Inputs) -> Outputs:
    word, lengths = _group(given)
    rows, _ = rod_groups.table(word, lengths)
    last = link_frames.motions(rows, _joints(given), given["q_dot"], given["q_ddot"])[-1]
    return {"omega3": last.omega, "eps3": last.epsilon, "v_O3": last.v, "a_O3": last.a}


SOLVED: dict[str, Solve] = {
    "DH-1": rigid_transform,
    "DH-2": pair_matrix,
    "DH-3": point_transfer,
    "DH-5": derivatives,
    "DH-6": velocity_matrices,
    "DH-7": acceleration_matrices,
    "DH-8": recursion_in_base_axes,
    "DH-9": recursion_in_link_axes,
    **{f"DH-1{group}": direct for group in range(1, 7)},
    **{f"DH-2{group}": inverse for group in range(1, 7)},
}
