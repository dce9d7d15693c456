"""What is wrong is traced to own answers, to a given misread, to a line not asked for, to the other mode of angles.

Mutants of what explains an answer that live on change nothing that can be seen:

* another name of no answer, where a judge stands beside none;
* own values of a step for a number of that step: no two numbers ask for one step;
* no line replaced where a line that is not asked for is: no formula is judged against it;
* what is solved further than it is asked; no value in the other mode, which a line with an angle always has.
"""

from __future__ import annotations

import pytest

from exercises import variants
from exercises.exercise import Value, Variant
from exercises.grading import reference
from exercises.solving import evaluate, solved
from exercises.variants import modes, slipped
from graders import Code
from graders.common_slips import CommonSlip
from tests.exercises.handing import handed_in

CRANK = variants.deal("slider_crank", 1)
BEAM = variants.deal("simple_beam", 1)
BARS = variants.deal("four_bar", 1)
INVERSE = variants.deal("rrr_inverse", 1)
SHAFT = variants.deal("stepped_shaft", 1)
POLYGON = variants.deal("slider_crank_polygon", 1)


def shown(variant: Variant, values: dict[str, Value], *names: str) -> dict[str, str]:
    judges = solved(variant).answers
    return {name: judges[name].show(values[solved(variant).step_of(name)]) for name in names}


# own answers


def test_rates_are_judged_beside_the_own_polygon() -> None:
    right = reference(POLYGON)
    polygon = right["polygon"].replace("l1 + l2 - l3", "l1 - l2 - l3").replace("+ l2*", "- l2*")
    rates = right["velocities"].replace("- l2*", "+ l2*").replace("+ l2*omega2*cos", "- l2*omega2*cos")
    assert handed_in(POLYGON, polygon=polygon, velocities=rates).verdicts["velocities"].code is Code.FOLLOWED
    assert handed_in(POLYGON, velocities=rates).verdicts["velocities"].code not in (Code.FOLLOWED, Code.RIGHT)


def test_rates_beside_a_polygon_that_cannot_be_read_are_judged_by_themselves() -> None:
    found = handed_in(POLYGON, polygon="l1:").verdicts
    assert found["polygon"].code is Code.UNREADABLE and found["velocities"].code is Code.RIGHT


def test_nothing_follows_from_a_cosine_of_nothing_where_other_answers_are_counted() -> None:
    own = solved(INVERSE).again(fixed={"c3": 0.0})
    assert handed_in(INVERSE, c3="0", **shown(INVERSE, own, "q")).verdicts["q"].code is not Code.FOLLOWED


def test_nothing_follows_where_the_own_values_lead_to_none() -> None:
    rows = solved(INVERSE).values["q"]
    assert isinstance(rows, tuple)
    typed = solved(INVERSE).answers["q"].show(rows[:2])
    assert handed_in(INVERSE, c3="1.3", q=typed).verdicts["q"].code is Code.LOST_BRANCH


def test_no_slip_is_read_out_of_a_number_with_which_a_right_one_has_no_value() -> None:
    typed = max(value for slip, value in slipped(solved(INVERSE), "c3", None) if slip is CommonSlip.TERM_LOST)
    assert typed > 1 and handed_in(INVERSE, c3=f"{typed:.6f}", q="", n="").slip is CommonSlip.TERM_LOST  # type: ignore[operator]
    assert handed_in(INVERSE, c3=f"{typed:.6f}").slip is None


def test_what_cannot_be_read_beside_a_slip_hides_nothing() -> None:
    values = solved(CRANK).values
    assert isinstance(values["v3"], float)
    assert handed_in(CRANK, l3="((", v3=f"{2 * values['v3']:.6g}").slip is CommonSlip.FACTOR_TWO


# a known slip, and a common one


LOST_MINUS = {"alpha2": "asin(l1*sin(alpha1)/l2)"}


def test_what_does_not_follow_from_a_common_slip_beside_a_known_one_is_not_explained() -> None:
    values = solved(CRANK).again(replaced=LOST_MINUS)
    typed = shown(CRANK, values, "alpha2", "l3")
    found = handed_in(CRANK, **typed, omega2=f"{2 * values['omega2']}", v3="7.77")
    assert (found.mistake, found.slip) == (None, None)


@pytest.mark.parametrize(("off", "slip"), [(2.0, CommonSlip.FACTOR_TWO), (0.5, CommonSlip.FACTOR_TWO), (1.37, None)])
def test_what_follows_from_a_common_slip_beside_a_known_one_contradicts_neither(
    off: float, slip: CommonSlip | None
) -> None:
    values = solved(CRANK).again(replaced=LOST_MINUS)
    assert isinstance(values["omega2"], float)
    typed = shown(CRANK, values, "alpha2", "l3")
    own = solved(CRANK).again(replaced=LOST_MINUS, fixed={"omega2": off * values["omega2"]})
    found = handed_in(CRANK, **typed, omega2=f"{own['omega2']} rad/s", v3=f"{own['v3']} m/s")
    assert found.verdicts["v3"].code is Code.FOLLOWED
    assert (found.mistake, found.slip) == ("lost_minus" if slip else None, slip)


# a line, a given


@pytest.mark.parametrize(
    ("variant", "given", "factor", "slip"),
    [
        (BEAM, "x_K", "1e3", CommonSlip.KILO_PREFIX),
        (BEAM, "x_K", "1e-3", CommonSlip.KILO_PREFIX),
        (BEAM, "x_K", "2", None),
        (BEAM, "x_K", "0.5", None),
        (INVERSE, "L3", "2", CommonSlip.FACTOR_TWO),
        (INVERSE, "x", "0.5", CommonSlip.FACTOR_TWO),
    ],
)
def test_a_given_that_is_misread_is_told_by_two_answers_or_by_a_prefix(
    variant: Variant, given: str, factor: str, slip: CommonSlip | None
) -> None:
    values = solved(variant).again(replaced={given: f"{factor}*{given}"})
    names = [name for name, judge in solved(variant).answers.items() if judge.kind in ("quantity", "set")]
    found = handed_in(variant, **shown(variant, values, *names))
    assert (found.mistake, found.slip) == (None, slip)


def test_a_given_that_is_misread_leaves_a_right_formula_right() -> None:
    values = solved(BEAM).again(replaced={"F1": "2*F1"})
    numbers = [name for name, judge in solved(BEAM).answers.items() if judge.kind == "quantity"]
    found = handed_in(BEAM, **shown(BEAM, values, *numbers))
    assert found.verdicts["R_A_formula"].code is Code.RIGHT
    assert (found.mistake, found.slip) == (None, CommonSlip.FACTOR_TWO)


def test_a_given_that_is_misread_leads_to_every_answer() -> None:
    values = solved(INVERSE).again(replaced={"L3": "2*L3"})
    found = handed_in(INVERSE, **shown(INVERSE, values, "c3"), q="(1; 2; 3)")
    assert (found.mistake, found.slip) == (None, None)


def test_a_slip_in_a_line_that_is_not_asked_for_is_told_by_one_answer() -> None:
    line = str(solved(BEAM).steps["f_B"]).replace(" - F3", " + F3")
    values = solved(BEAM).again(replaced={"f_B": line})
    assert handed_in(BEAM, **shown(BEAM, values, "v_K")).slip is CommonSlip.TERM_SIGN


def test_a_line_on_which_a_right_number_stands_has_no_slip() -> None:
    line = str(solved(BARS).steps["gamma"]).replace("l4 - l1", "l4 + l1")
    values = solved(BARS).again(replaced={"gamma": line})
    numbers = ("omega2", "omega3", "epsilon2", "epsilon3")
    assert handed_in(BARS, **shown(BARS, values, "assemblies", *numbers)).slip is CommonSlip.TERM_SIGN
    assert handed_in(BARS, **shown(BARS, values, *numbers)).slip is None


# the other mode


@pytest.mark.parametrize("which", [0, 1])
def test_lines_in_the_other_mode_of_angles_are_told(which: int) -> None:
    lines, _ = list(modes(solved(CRANK)))[which]
    values = solved(CRANK).again(replaced=lines)
    found = handed_in(CRANK, **shown(CRANK, values, "l3", "omega2", "v3"))
    assert (found.mistake, found.slip) == (None, CommonSlip.DEGREES_RADIANS)


def test_a_line_in_the_other_mode_is_told_from_own_earlier_values() -> None:
    lines, _ = next(modes(solved(BARS)))
    omega2 = solved(BARS).again(replaced={"omega2": lines["omega2"]})["omega2"]
    own = solved(BARS).again(fixed={"omega2": omega2})
    typed = {"omega2": omega2, "epsilon2": evaluate(lines["epsilon2"], own)}
    found = handed_in(BARS, **shown(BARS, typed, "omega2", "epsilon2"))
    assert (found.mistake, found.slip) == (None, CommonSlip.DEGREES_RADIANS)


def test_a_wrong_answer_without_an_angle_in_its_line_is_not_of_the_other_mode() -> None:
    lines, _ = next(modes(solved(BARS)))
    values = solved(BARS).again(replaced={"omega2": lines["omega2"]})
    assert handed_in(BARS, **shown(BARS, values, "omega2")).slip is CommonSlip.DEGREES_RADIANS
    found = handed_in(BARS, assemblies="(11.5 deg; 77.7 deg), (-33.3 deg; 5 deg)", **shown(BARS, values, "omega2"))
    assert (found.mistake, found.slip) == (None, None)
