"""What the judge of polygons weighs beside the defects it names: states, closures that are not there, shares.

Mutants of this judge that live on change nothing that can be seen:

* the words of an error of ours; `<` for `<=` where no number meets the border; how strictly rows are put side by side;
* how many other measures of an angle are tried in all, which bounds the work; letters `X` taken off the end of a name;
* the other axis where both are added up; the projection on the same axis, without which only a line at 45° is another;
* flaws begun anew where there are none yet; the first state for the names of all; a state more for the rank;
* second rates of slopes, their scale, and the place at which they are taken, none of which changes their rank.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from graders import Code
from graders.polygon.checking import states_of
from graders.polygon.mechanism import State
from graders.verdict import Flaw, Flaws
from tests.graders.polygon.judging import judged
from tests.graders.polygon.mechanisms import FOUR_BAR, SLIDER, TWO_LOOPS, slider_states


def test_sixteen_true_states_are_enough_and_fifteen_are_not() -> None:
    assert len(states_of(replace(SLIDER, states=lambda: slider_states()[:16]))) == 16
    with pytest.raises(ValueError, match="15 true states"):
        states_of(replace(SLIDER, states=lambda: slider_states()[:15]))


def test_projections_of_a_polygon_without_its_closure_are_judged_all_the_same() -> None:
    text = TWO_LOOPS.polygon.replace("closure 2: l4 + l3 + l5 - s6 - h6 = 0\n", "")
    found = judged(text, TWO_LOOPS)
    assert found.details == Flaws((Flaw(Code.MISSING_LOOP, "2"),))
    assert found.score == 0.9


def test_an_equation_that_says_nothing_takes_one_fifth() -> None:
    text = SLIDER.polygon.replace("l1*sin(alpha1) + l2*sin(alpha2) = 0", "l1 = l1")
    assert (judged(text).code, judged(text).score) == (Code.NOT_DETERMINED, 0.8)


def test_a_score_has_six_figures_and_nothing_right_is_told_with_its_flaws() -> None:
    interior = SLIDER.polygon.replace("alpha2", "psi").replace("cos(psi)", "cos(alpha1 - psi)")
    assert judged(interior.replace("sin(psi)", "sin(alpha1 - psi)")).score == 0.933333
    nothing = judged("l1: B > A, length l2, angle alpha1\ny: l1 = l2\nx: l1 = 2*l2")
    assert isinstance(nothing.details, Flaws) and Flaw(Code.NO_UNKNOWNS) in nothing.details.found


def test_a_name_that_follows_from_another_may_stand_for_it_in_projections_of_a_wrong_closure() -> None:
    states = tuple(State({**one.names, "phi": one.names["alpha1"]}, one.nodes) for one in slider_states())
    text = SLIDER.polygon.replace("closure: l1 + l2", "closure: l1 - l2").replace(" + l2*", " - l2*")
    mechanism = replace(SLIDER, states=lambda: states, derived=(("phi", "alpha1"),))
    found = judged(text.replace("l1*cos(alpha1)", "l1*cos(phi)"), mechanism)
    assert found.details == Flaws((Flaw(Code.CLOSURE_SIGN, "l2"),))


def test_an_angle_is_looked_for_behind_others_that_stand_in_no_false_projection() -> None:
    text = TWO_LOOPS.polygon.replace("+ l5*cos", "- l5*cos").replace("+ l5*sin", "- l5*sin")
    assert judged(text, TWO_LOOPS).details == Flaws((Flaw(Code.REVERSED_ANGLE, "l5"),))


def test_the_angle_of_the_rod_from_the_crank_is_told_under_its_usual_name() -> None:
    text = SLIDER.polygon.replace("cos(alpha2)", "cos(alpha1 + alpha2)").replace("sin(alpha2)", "sin(alpha1 + alpha2)")
    assert judged(text).details == Flaws((Flaw(Code.INTERIOR_ANGLE, "l2"),))


def test_a_slip_beside_two_wrong_signs_that_are_carried_through_is_named() -> None:
    text = FOUR_BAR.polygon.replace("closure: l1 + l2 - l3", "closure: l1 - l2 + l3")
    text = text.replace("l1*cos(alpha1) + l2*cos(alpha2) - l3", "l1*sin(alpha1) - l2*cos(alpha2) + l3")
    found = judged(text.replace("+ l2*sin(alpha2) - l3", "- l2*sin(alpha2) + l3"), FOUR_BAR)
    signs = (Flaw(Code.CLOSURE_SIGN, "l2"), Flaw(Code.CLOSURE_SIGN, "l3"))
    assert found.details == Flaws((*signs, Flaw(Code.SINE_COSINE, "l1", "x")))


def test_two_slips_in_one_projection_are_looked_for_until_two_are_named() -> None:
    text = TWO_LOOPS.polygon.replace("+ l2*cos", "- l2*cos").replace("+ l2*sin", "+ l2*cos")
    twice = text.replace("x2: l4 + l3*cos(alpha3) +", "x2:")
    assert isinstance(details := judged(twice, TWO_LOOPS).details, Flaws)
    assert details.found[2:] == (Flaw(Code.WRONG_PROJECTION, "", "x2"),)
    alone = TWO_LOOPS.polygon.replace("x2: l4 + l3*cos(alpha3) +", "x2:")
    assert isinstance(details := judged(alone, TWO_LOOPS).details, Flaws)
    assert details.found == (Flaw(Code.TERM_MISSING, "l4, l3", "x2"),)


def test_with_one_unknown_a_given_in_its_list_takes_the_whole_share_and_an_identity_determines_nothing() -> None:
    states = tuple(State({**one.names, "l3": one.nodes["C"][0]}, one.nodes) for one in slider_states())
    mechanism = replace(SLIDER, states=lambda: states)
    assert (found := judged(SLIDER.polygon, mechanism)).details == Flaws((Flaw(Code.UNKNOWN_EXTRA, "l3"),))
    assert found.score == 0.8
    head = SLIDER.polygon.partition("x:")[0]
    nothing = judged(head + "x: l1 = l1\ny: l2 = l2\nunknowns: alpha2", mechanism)
    assert nothing.details == Flaws((Flaw(Code.NOT_DETERMINED, "alpha2"),))
