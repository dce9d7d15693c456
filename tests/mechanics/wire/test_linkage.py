"""Every kind of linkage on the wire: answered under the contract's names, refused with the reason."""

from __future__ import annotations

import json
from typing import Any

import pytest

from mechanics.wire import solvers

BARS = {"l1": 0.1, "l2": 0.26, "l3": 0.22, "l4": 0.3, "alpha1": 1.0, "omega1": 12.0, "epsilon1": -8.0}
HC_1: dict[str, Any] = {
    "kind": "class_iii", "A": [458, 458], "D": [1925, 955], "G": [700, 750], "K": [2096, 1300],
    "l_AB": 1200, "l_BC": 1000, "l_BE": 1000, "l_CE": 1000, "l_CD": 1100, "l_EF": 1100, "l_EH": 821, "l_FH": 1039,
    "l_FG": 1110, "l_HK": 1230, "sigma2": 1, "sigma4": 1,
}  # fmt: skip
REQUESTS: dict[str, dict[str, Any]] = {
    "slider_crank": {"l1": 0.1, "l2": 0.3, "offset": 0.02, "branch": "slider_left", "alpha1": 0.7, "omega1": 20.0,
                     "point_S_fraction_of_l2": 0.4},
    "four_bar": BARS,
    "inverted_slider": {"l1": 0.15, "guide_pivot": [0.0, -0.4], "guide_point_distance": 0.6, "alpha1": 0.5,
                        "omega1": 10.0, "epsilon1": 4.0},
    "variable_length_link": {"AC": 0.8, "BC": 0.5, "l_AB": 0.6, "dl_AB": 0.05, "ddl_AB": 0.01},
    "manipulator": {"type": "RPR", "q": [0.5, 0.2, 0.8], "qd": [0.8, 0.1, -0.5], "qdd": [0.3, -0.2, 0.4],
                    "lengths": [0.5, 0.4], "delta": 0.3, "angles": "absolute"},
    "six_bar": {**BARS, "coupler_point": {"u": 0.1, "v": 0.05}, "dyad": {"pivot": [0.5, 0.3], "l5": 0.3, "l6": 0.3},
                "dyad_mode": "Q_right_of_PG"},
    "two_loop": {**BARS, "l5": 0.35, "h6": 0.05},
    "hooke_joint": {"shaft_angle_beta": 0.4, "gamma1": 0.3, "omega1": 5.0},
    "geneva": {"slots": 4, "centre_distance": 0.1, "alpha1": 0.2, "omega1": 5.0},
}  # fmt: skip
NAMES = {
    "slider_crank": {"alpha2", "slider_x", "S_x", "S_y"},
    "four_bar": {"alpha2", "alpha3", "P_x", "P_y"},
    "inverted_slider": {"phi", "s", "P_x", "P_y"},
    "variable_length_link": {"beta", "alpha", "B_x", "B_y"},
    "manipulator": {"p_x", "p_y"},
    "six_bar": {"alpha2", "alpha3", "P_x", "P_y", "alpha5", "alpha6", "Q_x", "Q_y"},
    "two_loop": {"alpha2", "alpha3", "alpha5", "s6"},
    "hooke_joint": {"gamma2"},
    "geneva": {"phi"},
}


def answered(request: dict[str, Any]) -> dict[str, Any]:
    wire: dict[str, Any] = json.loads(json.dumps(solvers.answer("linkage", json.dumps(request).encode())))
    return wire


@pytest.mark.parametrize("kind", REQUESTS)
def test_a_kind_answers_under_the_names_of_the_contract(kind: str) -> None:
    found = answered({"kind": kind, **REQUESTS[kind]})
    assert found.keys() == {"pos", "vel", "acc", "singular"}
    for part in ("pos", "vel", "acc"):
        assert found[part].keys() == NAMES[kind]
    assert 0 < found["singular"]["measure"] <= 1 and found["singular"]["name"]


@pytest.mark.parametrize("kind", [*REQUESTS, "class_iii"])
def test_extreme_values_of_every_kind_are_answered_or_refused(kind: str) -> None:
    request = HC_1 if kind == "class_iii" else {"kind": kind, **REQUESTS[kind]}
    numbers = [name for name, value in request.items() if isinstance(value, int | float)]
    for name in numbers[:6] if kind == "class_iii" else numbers:
        for extreme in (0, -1, 1e-300, 1e300):
            found = answered({**request, name: extreme})
            assert "error" in found or found.keys() <= {"pos", "vel", "acc", "singular", "assemblies"}


def test_the_class_iii_unit_answers_all_sixteen_assemblies_in_order() -> None:
    found = answered(HC_1)
    angles = [one["alpha5"] for one in found["assemblies"]]
    assert len(angles) == 16 and angles == sorted(angles)
    assert found["assemblies"][0]["branch"] == "++"
    assert found["assemblies"][0]["C"] == pytest.approx([1424.449475, 1934.514764])
    assert found["singular"]["measure"] == min(one["measure"] for one in found["assemblies"])


def test_the_class_iii_unit_answers_phi_of_each_branch_and_none_where_there_is_no_branch() -> None:
    assert answered({**HC_1, "alpha5": 0.6981317007977318})["phi"] == pytest.approx(
        {"++": 121541.9449, "+-": -521319.5341, "-+": 1024371.954, "--": 72909.50005}
    )
    assert set(answered({**HC_1, "alpha5": 3.3})["phi"].values()) == {None}


def test_the_class_iii_unit_answers_the_steps_of_newton_s_method() -> None:
    found = answered({**HC_1, "x0": [0.4, 2.23, 5.89]})
    assert found["steps"][0] == pytest.approx([0.4004496649, 2.22576397, 5.891141147])
    assert [one["alpha5"] for one in found["assemblies"]] == pytest.approx([0.400464548])


@pytest.mark.parametrize(
    ("request_", "code", "word"),
    [
        ({"kind": "four_bar", **BARS, "l4": 5.0}, "cannot_assemble", "are missing"),
        ({"kind": "slider_crank", "l1": 0.3, "l2": 0.1, "alpha1": 1.5}, "cannot_assemble", "0.1992 m are missing"),
        ({"kind": "slider_crank", "l1": 0.1, "l2": 0.1, "alpha1": 1.5707963267948966}, "singular", "perpendicular"),
        ({"kind": "variable_length_link", "AC": 1, "BC": 0.2, "l_AB": 3}, "cannot_assemble", "1.8 m do not fit"),
        ({"kind": "variable_length_link", "AC": 1, "BC": 0.2, "l_AB": 1.2}, "singular", "in line"),
        ({"kind": "inverted_slider", "l1": 0.1, "alpha1": 0, "guide_pivot": [0.1, 0]}, "singular", "guide pivot"),
        ({"kind": "manipulator", "type": "ROR", "q": [1, 1, 1]}, "out_of_range", "word over R and P"),
        ({"kind": "manipulator", "type": "RR", "q": [1], "lengths": [1, 1]}, "out_of_range", "q has 1 values"),
        ({"kind": "manipulator", "type": "RR", "q": [1, 2], "lengths": [1]}, "out_of_range", "lengths has 1 values"),
        ({"kind": "hooke_joint", "shaft_angle_beta": 1.5707963267948966, "gamma1": 0}, "singular", "Cardan"),
        ({**HC_1, "l_BC": 3000}, "cannot_assemble", "ternary link B-C-E"),
        ({**HC_1, "sigma2": 0}, "out_of_range", "sigma2"),
        ({**HC_1, "x0": [0.4, 2.23, 5.89], "alpha5": 1.0}, "contradictory", "x0"),
        ({"kind": "inverted_slider", "l1": 0.1, "alpha1": 0, "guide_pivot": [0.1]}, "out_of_range", "guide_pivot"),
        ({"kind": "four_bar", **BARS, "offset": 0.1}, "unknown_field", "offset"),
        ({"l1": 0.1}, "missing_field", "kind"),
    ],
)
def test_what_cannot_be_solved_says_why(request_: dict[str, Any], code: str, word: str) -> None:
    error = answered(request_)["error"]
    assert error["code"] == code and word in error["message"], error
