"""Serial chains and the reduced slider-crank on the wire: what the numbers must obey, and what is refused."""

from __future__ import annotations

from math import cos, pi, sin
from typing import Any

import pytest

from mechanics import rod_groups
from mechanics.wire import solvers
from tests.mechanics.examples.reading import EXAMPLES
from tests.mechanics.test_rod_groups import LENGTHS, PUBLISHED
from tests.mechanics.wire.test_solvers import answered

LIFT = {"rows": [{"type": "P"}], "q": [0.5], "qd": [2.0], "qdd": [1.19]}
HEAVY = {
    "mass": [3.0],
    "com_in_link_frame": [[0.2, 0, 0]],
    "inertia_about_com_link_axes": [[0.1, 0.1, 0.1]],
    "gravity_vector": [0, 0, -9.81],
}


def test_a_turning_slide_moves_as_its_polar_coordinates() -> None:
    arm = {"rows": [{"type": "R", "alpha": pi / 2}, {"type": "P", "a": 0.0}], "q": [0.7, 0.5], "qd": [2.0, 0.3]}
    found = answered("chain", arm)
    r, angle = 0.5, 0.7 - pi / 2  # the slide runs along -Y of the first link
    assert found["p"] == pytest.approx([r * cos(angle), r * sin(angle), 0], abs=1e-15)
    radial, across = [cos(angle), sin(angle)], [-sin(angle), cos(angle)]
    for axis in (0, 1):
        assert found["v"][axis] == pytest.approx(0.3 * radial[axis] + r * 2 * across[axis])
        assert found["a"][axis] == pytest.approx(-r * 4 * radial[axis] + 2 * 2 * 0.3 * across[axis])
    assert (found["omega"], "tau" in found) == ([0, 0, 2], False)


def test_a_lift_needs_weight_and_inertia() -> None:
    found = answered("chain", {**LIFT, **HEAVY})
    assert found["tau"] == pytest.approx([3 * 11])
    assert found["gravity_tau"] == pytest.approx([3 * 9.81])
    assert found["mass_matrix"] == [[pytest.approx(3)]]


def test_the_published_drives_without_friction_hold() -> None:
    given, printed = EXAMPLES["DY-7"]["inputs"], EXAMPLES["DY-7"]["outputs"]
    rows = [
        {"type": "R", "d": given["L1"], "alpha": pi / 2},
        {"type": "R", "a": given["L2"]},
        {"type": "R"},
    ]
    q, qd, qdd = [given["q1"], given["q2"], -given["q3"]], list(given["q_dot"]), list(given["q_ddot"])
    qd[2], qdd[2] = -qd[2], -qdd[2]  # the wire's third drive turns forward, the printed one backward
    request = {
        "rows": rows,
        "q": q,
        "qd": qd,
        "qdd": qdd,
        "mass": given["m"],
        "com_in_link_frame": given["s_cm"],
        "inertia_about_com_link_axes": given["I_diag"],
        "gravity_vector": given["g"],
    }
    one, two, three = answered("chain", request)["tau"]
    free = [tau - b * w for tau, b, w in zip(printed["tau"], given["b"], given["q_dot"], strict=True)]
    assert [one, two, -three] == pytest.approx(free, rel=1e-9)


def test_a_tensor_of_principal_moments_is_that_of_three_rows() -> None:
    rows = {**HEAVY, "inertia_about_com_link_axes": [[[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]]}
    assert answered("chain", {**LIFT, **HEAVY}) == answered("chain", {**LIFT, **rows})


@pytest.mark.parametrize("group", ["PPP", "RPP", "RRP", "PRR", "RRR", "PRP"])
def test_every_branch_of_a_group_comes_back_through_the_chain(group: str) -> None:
    M = next(point for word, _, point, _ in PUBLISHED if word == group)
    found = answered("chain_inverse", {"group": group, "lengths": dict(LENGTHS[group]), "M": M})
    table, point = rod_groups.table(group, LENGTHS[group])
    assert found["n_solutions"] == len(found["solutions"]) == len(found["determinants"])
    for q in found["solutions"]:
        rows = [{"type": r.type, "theta": r.theta, "d": r.d, "a": r.a, "alpha": r.alpha} for r in table]
        variables = [row.sign * x for row, x in zip(table, q, strict=True)]
        assert answered("chain", {"rows": rows, "q": variables, "tool_point": point})["p"] == pytest.approx(M, abs=1e-9)


ARM: dict[str, Any] = {"group": "RRR", "lengths": dict(LENGTHS["RRR"])}


@pytest.mark.parametrize(
    ("name", "request_", "wanted", "word"),
    [
        ("chain", {"rows": [{"type": "R"}], "q": [1, 2]}, "out_of_range", "q has 2 values for 1 joints"),
        ("chain", {"rows": [{"type": "R"}], "q": [1], "qd": [1, 2]}, "out_of_range", "qd has 2"),
        ("chain", {"rows": [{"type": "S"}], "q": [1]}, "out_of_range", "rows[0].type"),
        ("chain", {"rows": [{"type": "R", "theta": 1e300}], "q": [1]}, "out_of_range", "rows[0].theta"),
        ("chain", {"rows": [], "q": []}, "out_of_range", "rows must have 1 to 30 entries"),
        ("chain", {"rows": [{"type": "R"}], "q": [1], "tool_point": [1, 2]}, "out_of_range", "tool_point"),
        ("chain", {"rows": [{"type": "R", "sign": -1}], "q": [1]}, "unknown_field", "rows[0].sign"),
        ("chain", {**LIFT, "mass": [1]}, "missing_field", "com_in_link_frame"),
        ("chain", {**LIFT, "gravity_vector": [0, 0, 1]}, "missing_field", "mass"),
        ("chain", {**LIFT, **HEAVY, "mass": [1, 2]}, "out_of_range", "mass has 2 entries for 1 links"),
        ("chain", {**LIFT, **HEAVY, "mass": [-1]}, "out_of_range", "mass[0]"),
        (
            "chain",
            {**LIFT, **HEAVY, "inertia_about_com_link_axes": [[1, 1, -1]]},
            "out_of_range",
            "axes[0]: an inertia",
        ),
        ("chain", {**LIFT, **HEAVY, "inertia_about_com_link_axes": [1]}, "wrong_type", "axes[0]"),
        ("chain", {**LIFT, **HEAVY, "inertia_about_com_link_axes": [[[1, 0, 0], [0, 1]]]}, "out_of_range", "axes[0]"),
        ("chain_inverse", {**ARM, "M": [1, 1, 1]}, "cannot_assemble", "are missing"),
        ("chain_inverse", {**ARM, "M": [0, 0, 0.9]}, "singular", "joint 1 is arbitrary"),
        ("chain_inverse", {**ARM, "M": [0, 0]}, "out_of_range", "M must have 3 entries"),
        ("chain_inverse", {**ARM, "lengths": {"L1": 1}, "M": [0, 0, 0]}, "missing_field", "lengths.L2"),
        ("chain_inverse", {**ARM, "lengths": {**LENGTHS["RRR"], "d": 1}, "M": [0, 0, 0]}, "unknown_field", "lengths.d"),
        ("chain_inverse", {**ARM, "group": "RRH", "M": [0, 0, 0]}, "out_of_range", "RRH"),
        ("reduction", {"l1": 0.1, "l2": 0.3, "alpha1": 1}, "singular", "inertia is 0"),
        ("reduction", {"l1": 0.1, "l2": 0.05, "alpha1": 1, "J1": 1}, "cannot_assemble", "cannot reach"),
        ("reduction", {"l1": 0.1, "l2": 0.1, "alpha1": pi / 2, "J1": 1}, "singular", "perpendicular"),
        ("reduction", {"l1": 0.1, "l2": 0.3, "alpha1": 1, "J1": -1}, "out_of_range", "J1"),
    ],
)
def test_what_cannot_be_solved_says_why(name: str, request_: Any, wanted: str, word: str) -> None:
    error = answered(name, request_)["error"]
    assert error["code"] == wanted and word in error["message"], error


def test_the_reduced_crank_obeys_its_equation_of_motion() -> None:
    example = solvers.load("reduction").EXAMPLE
    found = answered("reduction", example)
    left = found["J_reduced"] * found["epsilon1"] + found["dJ_reduced"] * example["omega1"] ** 2 / 2
    assert left == pytest.approx(found["M_reduced"])
    h = 1e-6
    ahead, behind = (answered("reduction", {**example, "alpha1": example["alpha1"] + k * h}) for k in (1, -1))
    assert found["dJ_reduced"] == pytest.approx((ahead["J_reduced"] - behind["J_reduced"]) / (2 * h), rel=1e-6)
