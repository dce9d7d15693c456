"""The polygon of the slider-crank and the four-bar as whole submissions: following, naming, true states."""

from __future__ import annotations

from math import cos, pi, sin

import pytest

from exercises import variants
from exercises.exercise import Submission
from exercises.grading import grade, preview, reference
from exercises.linkages.four_bar import coupler_angle, rocker_angle
from exercises.linkages.slider_crank_polygon.motion import true_states
from graders import Code, Echo, Outcome
from graders.verdict import Branches, Flaws
from graders.words import LANGUAGES, message
from mechanics import planar
from mechanics.planar import Marker
from tests.depth import amount

POLYGON = "slider_crank_polygon"
REVERSED = {
    "polygon": """crank: B > A, length l1, angle alpha1 + pi
rod: C > B, length l2, angle psi
slide: A > C, length s, angle 0
closure: slide + rod + crank = 0
x: s + l2*cos(psi) + l1*cos(alpha1 + pi) = 0
y: l2*sin(psi) = l1*sin(alpha1)
unknowns: s, psi""",
    "velocities": "x: s_d - l2*psi_d*sin(psi) + l1*omega1*sin(alpha1) = 0\n"
    "y: l2*psi_d*cos(psi) = l1*omega1*cos(alpha1)",
    "accelerations": "x: s_dd = l2*psi_dd*sin(psi) + l2*psi_d^2*cos(psi)"
    " - l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1)\n"
    "y: l2*psi_dd*cos(psi) - l2*psi_d^2*sin(psi) = l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1)",
}  # fmt: skip


@pytest.mark.parametrize("seed", range(3))
def test_an_own_choice_of_vectors_is_graded_right_with_its_derivatives(seed: int) -> None:
    variant = variants.deal(POLYGON, seed)
    graded = grade(Submission(variant, {**reference(variant), **REVERSED}))
    assert graded.score == 1, {name: v.details for name, v in graded.verdicts.items()}


def test_derivatives_are_read_beside_the_polygon_of_the_same_submission() -> None:
    variant = variants.deal(POLYGON, 1)
    alone = grade(Submission(variant, {"velocities": REVERSED["velocities"]})).verdicts["velocities"]
    assert alone.code is Code.UNKNOWN_RATE or alone.code is Code.WRONG
    unread = grade(Submission(variant, {**REVERSED, "polygon": "l1: A >"})).verdicts
    assert unread["polygon"].outcome is Outcome.UNREADABLE
    assert unread["velocities"].code is not Code.RIGHT


def test_a_wrong_sign_is_named_once_and_followed() -> None:
    variant = variants.deal(POLYGON, 4)
    typed = reference(variant)
    typed["polygon"] = typed["polygon"].replace("closure: l1 + l2", "closure: l1 - l2").replace(" + l2*", " - l2*")
    typed["velocities"] = typed["velocities"].replace("- l2*", "+ l2*").replace(" + l2*omega2*cos", " - l2*omega2*cos")
    graded = grade(Submission(variant, typed))
    assert graded.verdicts["polygon"].code is Code.CLOSURE_SIGN
    assert graded.verdicts["velocities"].code is Code.FOLLOWED
    assert graded.verdicts["accelerations"].code is Code.RIGHT
    assert graded.counted and not graded.provisional


@pytest.mark.parametrize("lang", LANGUAGES)
def test_flaws_are_worded_with_their_vector(lang: str) -> None:
    variant = variants.deal(POLYGON, 2)
    typed = reference(variant)["polygon"].replace("+ l2*cos(alpha2)", "+ l2*sin(alpha2)").replace("; l3", "")
    verdict = grade(Submission(variant, {"polygon": typed})).verdicts["polygon"]
    assert isinstance(verdict.details, Flaws)
    words = message(verdict, lang)
    assert "l2" in words and "l3" in words and "{" not in words


def test_the_preview_shows_every_line_in_its_spelling() -> None:
    found = preview(variants.deal(POLYGON, 0), "polygon", REVERSED["polygon"])
    assert isinstance(found, Echo)
    assert found.text.splitlines()[1] == "rod: C > B, length l2, angle psi"


def test_true_states_are_those_of_newton() -> None:
    given = {"l1": 0.08, "l2": 0.3, "alpha1": 0.9, "omega1": 12.0, "epsilon1": -40.0}
    (state,) = true_states([given])
    motion = planar.slider_crank_motion(0.08, 0.3, 0.9, 12.0, -40.0)
    for node, marker in (("B", Marker(1, 0.08)), ("C", Marker(3))):
        for axis in (0, 1):
            found = [motion.point(marker)[k][axis] for k in range(3)]
            assert state.nodes[node][axis] == pytest.approx(found, rel=1e-9, abs=1e-9)
    assert state.names["alpha1"] == (0.9, 12.0, -40.0)


FOUR_BAR = "four_bar"


def test_assemblies_are_found_in_any_order_and_one_has_half_the_credit() -> None:
    variant = variants.deal(FOUR_BAR, 5)
    first, second = reference(variant)["assemblies"].split("); (")
    turned = f"({second}; {first})"
    assert grade(Submission(variant, {"assemblies": turned})).verdicts["assemblies"].code is Code.RIGHT
    lost = grade(Submission(variant, {"assemblies": first + ")"})).verdicts["assemblies"]
    assert lost.code is Code.LOST_BRANCH and lost.details == Branches(1, 1) and lost.score == 0.5


def test_rates_follow_from_the_student_s_own_angles() -> None:
    variant = variants.deal(FOUR_BAR, 6)
    g = variant.givens
    alpha2, alpha3 = 0.3, 1.4
    omega2 = -g.l1 * g.omega1 * sin(alpha3 - g.alpha1) / (g.l2 * sin(alpha3 - alpha2))
    typed = {"assemblies": f"({alpha2 * 180 / pi}; {alpha3 * 180 / pi}); (10; 20)", "omega2": repr(omega2)}
    verdicts = grade(Submission(variant, typed)).verdicts
    assert verdicts["assemblies"].outcome is Outcome.WRONG
    assert verdicts["omega2"].code is Code.FOLLOWED


def test_the_assembly_drawn_is_chosen_by_its_side() -> None:
    rows = ((0.2, -0.9), (0.4, 1.3))
    assert (coupler_angle(rows), rocker_angle(rows)) == (0.4, 1.3)
    assert (coupler_angle(rows[:1]), rocker_angle(rows[:1])) == (0.2, -0.9)


@pytest.mark.parametrize("seed", range(amount(6, 20)))
def test_a_draw_stays_away_from_dead_positions_and_turns_fully(seed: int) -> None:
    g = variants.deal(FOUR_BAR, seed).givens
    lengths = sorted((g.l1, g.l2, g.l3, g.l4))
    assert lengths[0] == g.l1 and lengths[0] + lengths[3] < lengths[1] + lengths[2]
    reach = ((g.l4 - g.l1 * cos(g.alpha1)) ** 2 + (g.l1 * sin(g.alpha1)) ** 2) ** 0.5
    transmission = (g.l2**2 + g.l3**2 - reach**2) / (2 * g.l2 * g.l3)
    assert abs(transmission) < 0.9
