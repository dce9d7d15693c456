"""Later answers are right from earlier right ones as they were rounded, and nothing else becomes right by that.

The typed numbers were computed with a calculator that shows three significant figures, line by line.
"""

from __future__ import annotations

from math import pi

import pytest

from exercises import variants
from exercises.exercise import Variant
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
    """M where x = 4 m: 11,1·4 - 7·2,5²/2 - 11·1 - 3 = 8,525, from 11,1389 kN it would be 8,681."""
    found = handed_in(BEAM, R_A="11,1 кН", R_B="24,4 кН", x_M="4 m", M_max="8,525 kNm").verdicts
    assert (found["x_M"].outcome, found["M_max"].code) == (Outcome.WRONG, Code.FOLLOWED)
    assert handed_in(BEAM, x_M="4 m", M_max="8,525 kNm").verdicts["M_max"].outcome is Outcome.WRONG


def test_another_near_number_is_not_precise() -> None:
    found = handed_in(BARS, **ANGLES, omega2="1,14", omega3="1,42").verdicts
    assert found["omega2"].code is found["omega3"].code is Code.NOT_PRECISE


def test_one_number_has_to_come_near() -> None:
    """However far the earlier ones lead: here from angles that no judge would have taken for right."""
    judges, symbols = solved(BARS).answers, solved(BARS).symbols
    angles = judges["assemblies"].parse("(30; 90); (-30; -90)", symbols("assemblies"))
    rows = ((pi / 6, pi / 2), (-pi / 6, -pi / 2))
    own = solved(BARS).again(fixed={"assemblies": rows})["omega2"]
    typed = judges["omega2"].parse(judges["omega2"].show(own), symbols("omega2"))
    verdict = judges["omega2"].check(typed, solved(BARS).values["omega2"])
    assert verdict.code is Code.WRONG
    assert Earlier(solved(BARS), right={"assemblies": angles}).seen("omega2", typed, verdict) is verdict
