"""The arms of laboratory TMM-2: any valid polygon is right, defects are named, sections follow from one another."""

from __future__ import annotations

from importlib import import_module
from math import hypot

import pytest

from exercises import variants
from exercises.exercise import Submission
from exercises.givens import numbers
from exercises.grading import grade, reference
from exercises.manipulators import _arm
from exercises.manipulators._arm import Side, Sides, motion
from exercises.manipulators._arm.motion import Arm
from exercises.solving import evaluate, solved
from figures.machine import Pair
from graders import Code, Outcome, Verdict
from tests.depth import amount

ARMS = ("tmm2_oop", "tmm2_opo", "tmm2_poo")
RELATIVE = next(seed for seed in range(50) if variants.deal("tmm2_oop", seed).givens.measured == "relative")
BY_DISTANCE = """a: AB, l_AB, Theta1
b: BC, l_BC, Theta1 + Theta2
c: DC, h3, alpha3 + pi
r: A > D, length r, angle phi
closure: a + b - c = r
x: l_AB*cos(Theta1) + l_BC*cos(Theta1 + Theta2) + h3*cos(alpha3) = r*cos(phi)
y: l_AB*sin(Theta1) + l_BC*sin(Theta1 + Theta2) + h3*sin(alpha3) = r*sin(phi)
unknowns: r; phi"""


def judged(exercise: str, seed: int, **answers: str) -> dict[str, Verdict]:
    return dict(grade(Submission(variants.deal(exercise, seed), answers)).verdicts)


def test_a_polygon_closed_by_one_vector_is_right() -> None:
    assert judged("tmm2_oop", RELATIVE, polygon=BY_DISTANCE)["polygon"].code is Code.RIGHT


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("closure: a + b - c = r", "closure: a + b + c = r", Code.CLOSURE_SIGN),
        ("+ h3*cos(alpha3)", "- h3*cos(alpha3)", Code.PROJECTION_SIGN),
        ("l_AB*sin(Theta1)", "l_AB*cos(Theta1)", Code.SINE_COSINE),
        ("\nunknowns: r; phi", "", Code.NO_UNKNOWNS),
        ("b: BC, l_BC, Theta1 + Theta2", "b: BC, l_BC, Theta2", Code.INTERIOR_ANGLE),
    ],
)
def test_a_defect_of_a_polygon_is_named(old: str, new: str, code: Code) -> None:
    found = judged("tmm2_oop", RELATIVE, polygon=BY_DISTANCE.replace(old, new))["polygon"]
    assert (found.outcome, found.code) == (Outcome.PARTLY, code)


def closed_by_one_vector(arm: str, seed: int) -> dict[str, str]:
    """The reference of an arm, its polygon closed by one vector of unknown length and angle."""
    typed = reference(variants.deal(arm, seed))
    lines = [line for line in typed["polygon"].split("\n") if not line.startswith(("r_", "closure", "unknowns"))]
    lines = [line.replace("- x_D = 0", "= r*cos(phi)").replace("- y_D = 0", "= r*sin(phi)") for line in lines]
    more = ["r: A > D, length r, angle phi", "closure: l1 + l2 + l3 = r", "unknowns: r; phi"]
    return typed | {"polygon": "\n".join([*lines[:3], *more[:2], *lines[3:], more[2]])}


@pytest.mark.parametrize("arm", ARMS)
def test_the_velocity_of_the_gripper_is_its_own_beside_a_polygon_closed_by_one_vector(arm: str) -> None:
    typed = closed_by_one_vector(arm, 3)
    found = judged(arm, 3, **typed)
    assert {found[name].code for name in ("polygon", "velocities", "accelerations")} == {Code.RIGHT}
    wrong = typed | {"velocities": typed["velocities"].replace("- v_x", "+ v_x")}
    assert judged(arm, 3, **wrong)["velocities"].outcome is Outcome.PARTLY


def test_the_rates_of_the_closing_vector_are_right_too() -> None:
    typed = closed_by_one_vector("tmm2_oop", 3)
    x, y = (line.partition(" - v_")[0] for line in typed["velocities"].split("\n"))
    own = f"{x} = r_d*cos(phi) - r*phi_d*sin(phi)\n{y} = r_d*sin(phi) + r*phi_d*cos(phi)"
    assert judged("tmm2_oop", 3, **typed | {"velocities": own})["velocities"].code is Code.RIGHT


@pytest.mark.parametrize("arm", ARMS)
@pytest.mark.parametrize(
    ("unknowns", "code"),
    [
        ("x_D; y_D", Code.RIGHT),
        ("r; phi; x_D; y_D", Code.RIGHT),
        ("r; phi", Code.UNKNOWN_MISSING),
        ("x_D; y_D; Theta1", Code.UNKNOWN_EXTRA),
    ],
)
def test_coordinates_in_the_projections_are_the_unknowns(arm: str, unknowns: str, code: Code) -> None:
    """A vector from A to D may be projected as x_D and y_D: these are sought then, its length and angle follow."""
    typed = closed_by_one_vector(arm, 3)["polygon"]
    mixed = typed.replace("r*cos(phi)", "x_D").replace("r*sin(phi)", "y_D").replace("r; phi", unknowns)
    assert judged(arm, 3, polygon=mixed)["polygon"].code is code


def test_one_coordinate_beside_a_length_and_an_angle_is_not_determined() -> None:
    typed = closed_by_one_vector("tmm2_oop", 3)["polygon"]
    mixed = typed.replace("r*cos(phi)", "x_D").replace("r; phi", "r; phi; x_D")
    assert judged("tmm2_oop", 3, polygon=mixed)["polygon"].code is Code.NOT_DETERMINED


@pytest.mark.parametrize("arm", ARMS)
@pytest.mark.parametrize(("speeds", "pushes"), [
    ("v_{}", "a_{}"), ("v_D{}", "a_D{}"), ("{}_D_d", "{}_D_dd"), ("V_{}", "A_{}"), ("V{}", "A{}"), ("VD{}", "aD{}"),
])  # fmt: skip
def test_rates_of_the_gripper_have_many_names(arm: str, speeds: str, pushes: str) -> None:
    typed = reference(variants.deal(arm, 3))
    for axis in "xy":
        typed["velocities"] = typed["velocities"].replace(f"v_{axis}", speeds.format(axis))
        typed["accelerations"] = typed["accelerations"].replace(f"a_{axis}", pushes.format(axis))
    found = judged(arm, 3, **typed)
    assert {found[name].code for name in ("velocities", "accelerations")} == {Code.RIGHT}


def test_a_lost_coriolis_term_is_named() -> None:
    typed = reference(variants.deal("tmm2_opo", 4))
    first = next(part for part in typed["accelerations"].replace(" - ", " + ").split(" + ") if part.startswith("2*"))
    lost = typed["accelerations"].replace(f" - {first}", "").replace(f" + {first}", "")
    found = judged("tmm2_opo", 4, polygon=typed["polygon"], accelerations=lost)["accelerations"]
    assert found.code is Code.CORIOLIS_MISSING


@pytest.mark.parametrize("arm", ARMS)
def test_a_wrong_component_is_carried_into_the_speed(arm: str) -> None:
    variant = variants.deal(arm, 5)
    typed = reference(variant)
    v_x, v_y = (float(typed[name].split()[0]) for name in ("v_x", "v_y"))
    found = judged(
        arm, 5, v_x=f"{1.3 * v_x:.6f} m/s", v_y=typed["v_y"], v_D=f"{((1.3 * v_x) ** 2 + v_y**2) ** 0.5:.6f}"
    )
    assert (found["v_x"].outcome, found["v_D"].code) == (Outcome.WRONG, Code.FOLLOWED)


@pytest.mark.parametrize("arm", ARMS)
def test_texts_wait_for_the_lecturer_and_do_not_lower_the_score(arm: str) -> None:
    variant = variants.deal(arm, 6)
    found = grade(Submission(variant, reference(variant) | {"conclusions": "Prędkość rośnie liniowo."}))
    assert (found.score, found.provisional, found.verdicts["conclusions"].code) == (1, True, Code.KEPT)


def test_bodies_and_formulas_agree_on_an_arm_of_another_word() -> None:
    """A slide behind a slide is no laboratory arm, yet the same two ways must meet."""
    sides: Sides = (
        Side("h1", "pi/2", slides=True), Side("h2", "0", slides=True), Side("l_CD", "Theta3", "Theta3_d", "Theta3_dd"),
    )  # fmt: skip
    arm = Arm((Pair("slide", "h1", turn=1.5707963267948966), Pair("slide", "h2", turn=-1.5707963267948966),
               Pair("turn", "Theta3")), tip="l_CD")  # fmt: skip
    numbers = {"h1": 0.2, "h2": 0.3, "l_CD": 0.4, "Theta3": 0.7, "h1_d": 0.1, "h2_d": -0.2, "Theta3_d": 0.9}
    numbers |= {"h1_dd": 0.3, "h2_dd": 0.4, "Theta3_dd": -0.5}
    found = motion.oracle(arm, numbers, doubled="l_CD")
    for name, line in _arm.gripper(sides).items():
        assert evaluate(line, numbers) == pytest.approx(found[name], abs=1e-12)


@pytest.mark.parametrize("arm", ARMS)
def test_the_judges_of_an_arm_share_its_true_motion(arm: str) -> None:
    found = solved(variants.deal(arm, 3))
    polygon, *rates = [found.reference(name).alone() for name in ("polygon", "velocities", "accelerations")]
    assert rates == [polygon, polygon]


@pytest.mark.parametrize("arm", ARMS)
def test_no_speed_of_the_node_c_is_the_small_difference_of_large_terms(arm: str) -> None:
    """Four significant figures of the terms leave three of the result."""
    sides = import_module(f"exercises.manipulators.{arm}").SIDES
    for seed in range(amount(100, 500)):
        known = solved(variants.deal(arm, seed))
        names = {**known.values, **numbers(known.variant.givens)}
        near = (sides[known.variant.givens.slide] if isinstance(sides, dict) else sides)[:2]
        _, _, v_x, a_x, v_y, a_y = _arm.terms(near)
        for name, along, up in (("v_C", v_x, v_y), ("a_C", a_x, a_y)):
            values = ([evaluate(term, names) for term in found] for found in (along, up))
            size = hypot(*(sum(abs(one) for one in found if isinstance(one, float)) for found in values))
            assert names[name] >= 0.19 * size, (seed, name)  # type: ignore[operator]
