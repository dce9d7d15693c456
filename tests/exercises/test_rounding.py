"""Later answers are right from earlier right ones as they were rounded, and nothing else becomes right by that.

The typed numbers were computed with a calculator that shows three significant figures, line by line.
"""

from __future__ import annotations

import pytest

from exercises import variants
from exercises.exercise import Variant
from exercises.grading import reference
from exercises.solving import Earlier, solved
from graders import Code, Outcome
from tests.exercises.handing import handed_in

Typed = dict[str, str]
BARS = variants.deal("four_bar", 7)
TRAIN = variants.deal("gear_train", 90)
ARM = variants.deal("tmm2_oop", 4)
BEAM = variants.deal("simple_beam", 2)
INVERSE = variants.deal("rrr_inverse", 13)
DIAGRAM = variants.deal("beam_diagrams", 17)
MOMENTS = """0; 0; 0; 2,36
0,4; 4,72; 4,72; 11,6
2; 13,4; 13,4; 12,4
4; 11,4; 11,4; 11,8
4,4; 12,2; 12,2; 12,2
4,8; 12,2; 0,192; 0,2
5,2; 0,208; 0"""
BRANCHES = "(-30°; 5°; 30,1°); (-30°; -33,8°; -30,1°); (150°; 214°; 30,1°); (150°; 175°; -30,1°)"
ANGLES: Typed = {"assemblies": "(37,6°; 141°); (-39,2°; -143°)"}
CASES: list[tuple[Variant, Typed, Typed]] = [
    (BARS, ANGLES, {"omega2": "1,17"}),
    (TRAIN, {"u": "-15,6"}, {"M_out": "-101 Н·м"}),
    (ARM, {"a_x": "0,733", "a_y": "1,02"}, {"a_D": "1,26"}),
    (BEAM, {"R_A": "11,1 кН", "R_B": "24,4 кН"}, {"M_max": "25,4 кНм"}),
    (DIAGRAM, {"R_A": "11,8", "R_B": "3,04"}, {"M": MOMENTS}),
    (INVERSE, {"c3": "0,865"}, {"q": BRANCHES}),
]  # fmt: skip


@pytest.mark.parametrize(("variant", "before", "late"), CASES)
def test_what_follows_from_rounded_right_answers_is_right(variant: Variant, before: Typed, late: Typed) -> None:
    found = handed_in(variant, **before, **late).verdicts
    assert {found[name].code for name in (*before, *late)} == {Code.RIGHT}


@pytest.mark.parametrize(("variant", "before", "late"), CASES)
def test_the_same_answer_misses_behind_exact_ones(variant: Variant, before: Typed, late: Typed) -> None:
    found = handed_in(variant, **late).verdicts
    assert {found[name].outcome for name in late} <= {Outcome.WRONG, Outcome.PARTLY}


def test_rounded_right_answers_stand_beside_wrong_ones() -> None:
    angles = {"assemblies": "(37,6°; 141°); (-39,2°; -143°)"}
    wrong = {"omega2": "2,34", "omega3": "1,39"}
    line, values = "epsilon3", solved(BARS).again
    own = values(fixed={"assemblies": ((0.656244, 2.460914), (-0.684169, -2.495821)), "omega2": 2.34, "omega3": 1.39})
    found = handed_in(BARS, **angles, **wrong, epsilon3=f"{own[line]}").verdicts
    assert (found["omega2"].outcome, found["epsilon3"].code) == (Outcome.WRONG, Code.FOLLOWED)


def test_another_near_number_is_not_precise() -> None:
    found = handed_in(BARS, **ANGLES, omega2="1,14", omega3="1,42").verdicts
    assert found["omega2"].code is found["omega3"].code is Code.NOT_PRECISE


def test_one_number_has_to_come_near() -> None:
    """However far the earlier ones lead: here from an angle that no judge would have taken for right."""
    judge, value = solved(BARS).answers["omega2"], solved(BARS).values["omega2"]
    earlier = Earlier(solved(BARS), free={"alpha2": 0.5, "alpha3": 1.5}, right={"assemblies": ()})
    own = solved(BARS).again(fixed=earlier.free)["omega2"]
    typed = judge.parse(judge.show(own), solved(BARS).symbols("omega2"))
    verdict = judge.check(typed, value)
    assert verdict.code is Code.WRONG
    assert earlier.seen("omega2", typed, verdict) is verdict


def test_the_reference_of_another_table_is_not_taken_for_the_own_one() -> None:
    variant = variants.deal("rrp_table", 11)
    right = reference(variant)
    own = "[[q1; L1; 0; -pi/2], [-q2; 0; 0; -pi/2], [0; q3; 0; -pi/2]]"
    found = handed_in(variant, **{**right, "P": own}).verdicts
    assert found["P"].code is Code.RIGHT and found["A1"].outcome is not Outcome.RIGHT
