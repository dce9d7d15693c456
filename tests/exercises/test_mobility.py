"""What explains a count and a formula at the mobility of a drawn mechanism."""

from __future__ import annotations

import pytest

from exercises import variants
from exercises.exercise import Grade, Variant
from exercises.grading import reference
from exercises.solving import solved
from exercises.structure.mobility import Givens
from exercises.structure.mobility.parts import Dyad, Start, Strut
from graders import Code
from tests.exercises.handing import handed_in

DYADS = Dyad("rocker_down", "link"), Dyad("slider_level", "joint")
CRANK, GEARS = (Variant("mobility", 2, 1, Givens((Start(kind), *DYADS), "left")) for kind in ("crank", "gears"))


def made(variant: Variant, **lines: str) -> Grade:
    """Grade all answers as they follow from other lines."""
    again = solved(variant).again(replaced=lines)
    numbers = {name: str(round(float(again[name]))) for name in ("n", "p5", "p4", "F", "k")}  # type: ignore[arg-type]
    formulas = {f"{name}_formula": line for name, line in lines.items() if name in ("F", "k")}
    return handed_in(variant, **numbers, **formulas, drives=str(again["drives"]))


def test_a_formula_has_to_hold_for_all_counts_and_not_for_those_of_the_drawing() -> None:
    for text in ("3n - 2p_5 - p_4", "W = 3n - 2p5 - p4"):
        assert handed_in(GEARS, F_formula=text).score == 1
    assert handed_in(GEARS, F_formula="1").verdicts["F_formula"].code is Code.NO_SYMBOLS
    for text in ("n - 5 + 0*p5", "3*n - 2*p5"):
        assert handed_in(GEARS, F_formula=text).verdicts["F_formula"].code is Code.WRONG


def test_a_pair_that_the_drawing_has_not_may_be_left_out_of_the_formulas() -> None:
    found = handed_in(CRANK, F_formula="3*n - 2*p5", k_formula="p5 - n")
    assert (found.score, found.mistake) == (1, None)


def test_a_number_off_by_one_beside_the_right_formula_is_put_down_to_no_formula() -> None:
    loops = int(reference(GEARS)["k"])
    for number in (loops - 1, loops + 1):
        assert handed_in(GEARS, k=str(number)).mistake is None
    assert made(GEARS, k="p5 + p4 - n + 1").mistake == "loops_without_frame"


def test_what_follows_from_the_freedoms_of_one_link_too_many_is_followed() -> None:
    """Also where the right mobility is none."""
    rigid = Variant("mobility", 2, 1, Givens((Start("cam"), *DYADS, Strut("link")), "left"))
    found = made(rigid, F="3*(n + 1) - 2*p5 - p4")
    assert (reference(rigid)["F"], found.mistake) == ("0", "frame_moves")
    assert found.verdicts["F"].code is found.verdicts["drives"].code is Code.FOLLOWED


@pytest.mark.parametrize(
    ("line", "mistake"),
    [
        ("3*n - 2*p5", "contact_left_out"),
        ("3*n - 2*p5 - p4 + 1", "one_added"),
        ("3*n - 2*p5 + p4", "contact_added"),
        ("3*n - p5 - 2*p4", "classes_exchanged"),
        ("2*n - 2*p5 - p4", "two_freedoms"),
        ("3*n - 3*p5 - p4", "three_for_joint"),
    ],
)
def test_formulas_that_give_the_same_number_are_told_apart(line: str, mistake: str) -> None:
    assert made(GEARS, F=line).mistake == mistake


@pytest.mark.parametrize(
    ("variant", "step", "by", "mistake"),
    [
        (GEARS, "n", -1, "slider_forgotten"),
        (GEARS, "n", -2, "two_links_less"),
        (GEARS, "n", 2, "rods_counted_twice"),
        (GEARS, "p5", 1, "contact_as_both"),
        (CRANK, "p5", 1, "joint_thrice"),
        (GEARS, "p4", 1, "contact_twice"),
    ],
)
def test_what_was_counted_is_told_by_all_that_follows(variant: Variant, step: str, by: int, mistake: str) -> None:
    assert made(variant, **{step: f"{reference(variant)[step]} + {by}"}).mistake == mistake


def test_an_n_that_counts_the_frame_is_told_where_the_formulas_allow_for_it() -> None:
    n = f"{reference(GEARS)['n']} + 1"
    found = made(GEARS, n=n, F="3*(n - 1) - 2*p5 - p4", k="p5 + p4 - n + 1")
    assert (found.mistake, found.verdicts["F"].code, found.verdicts["k"].code) == ("frame_in_n", Code.RIGHT, Code.RIGHT)


def test_guides_put_into_the_other_class_are_told() -> None:
    pairs = f"{reference(GEARS)['p5']} - 1"
    assert made(GEARS, p5=pairs, p4="2").mistake == "guide_as_higher"


def test_each_reading_of_a_pair_too_many_has_one_name() -> None:
    """Where a contact or a joint of three links explains it, the hint of that slip names the other reading too."""
    named = [set(variants.predictions(solved(variants.deal("mobility", seed)))) for seed in range(20)]
    several = [names & {"one_pair_more", "contact_as_both", "joint_thrice"} for names in named]
    assert all(several) and all(not names >= {"one_pair_more", "contact_as_both"} for names in several)
