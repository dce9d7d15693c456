"""What explains a wrong submission: a slip of the exercise, a common one, one of each; and what is followed.

Mutants of the grading up to what explains an answer that live on change nothing that can be seen:

* no values, where the right ones are taken; own values begun anew by a free answer, which stands first;
* a number solved again from itself; right answers that are not free beside those that are: they lead to what is right;
* wrong formulas not behind wrong numbers: no line explains both; no bound of the lines that are tried.
"""

from __future__ import annotations

import re

import pytest

from exercises import catalogue, variants
from exercises.exercise import Submission, Variant
from exercises.grading import grade, reference
from exercises.presenting import hints, hints_text
from exercises.solving import solved
from graders import Code, Outcome
from graders.common_slips import CommonSlip, likeliest, off_by
from graders.language import parse_line
from graders.language.text import text_of
from graders.line_slips import slips_in
from graders.plausible import plausible
from graders.units import read_unit
from graders.words import LANGUAGES, common_hint, locale
from tests.exercises.handing import handed_in

CRANK = variants.deal("slider_crank", 1)
BEAM = variants.deal("simple_beam", 2)
ARM = variants.deal("rrr_matrices", 1)
PAIRS = variants.deal("mobility", 3)
BARS = variants.deal("four_bar", 1)


def value(variant: Variant, name: str) -> float:
    found = solved(variant).values[name]
    assert isinstance(found, float)
    return found


def test_one_common_slip_explains_all_wrong_answers() -> None:
    omega2, v3 = value(CRANK, "omega2"), value(CRANK, "v3")
    found = handed_in(CRANK, omega2=f"{1000 * omega2:.6g}", v3=f"{1000 * v3:.6g}")
    assert (found.mistake, found.slip) == (None, CommonSlip.KILO_PREFIX)


def test_two_different_common_slips_are_not_named_as_one() -> None:
    found = handed_in(CRANK, l3=f"{100 * value(CRANK, 'l3'):.6g} m", v3=f"{-value(CRANK, 'v3'):.6g}")
    assert found.slip is None


def test_a_known_slip_and_a_common_one_are_named_together() -> None:
    values = solved(CRANK).again(replaced={"alpha2": "asin(l1*sin(alpha1)/l2)"})
    found = handed_in(
        CRANK,
        alpha2=f"{values['alpha2']} rad",
        l3=f"{values['l3']:.6f} mm",
        v3=f"{values['v3']:.6f}",
        omega2=f"{values['omega2']:.6f}",
    )
    assert (found.mistake, found.slip) == ("lost_minus", CommonSlip.KILO_PREFIX)
    assert len(hints(CRANK, found, "pl")) == 2


@pytest.mark.parametrize(
    ("line", "slip"),
    [
        ("-l1*omega1*cos(alpha1) - l2*omega2*sin(alpha2)", CommonSlip.SINE_COSINE),
        ("-l1*omega1*sin(alpha1) + l2*omega2*sin(alpha2)", CommonSlip.TERM_SIGN),
        ("-l2*omega2*sin(alpha2)", CommonSlip.TERM_LOST),
        ("-l1*omega1*sin(alpha1) - omega2*sin(alpha2)", CommonSlip.FACTOR_LOST),
        ("-l1*omega1*sin(alpha1*180/pi) - l2*omega2*sin(alpha2*180/pi)", CommonSlip.DEGREES_RADIANS),
    ],
)
def test_a_slip_in_one_place_of_a_line_is_named(line: str, slip: CommonSlip) -> None:
    typed = solved(CRANK).again(replaced={"v3": line})["v3"]
    found = handed_in(CRANK, v3=f"{typed:.5g}")
    assert (found.mistake, found.slip) == (None, slip)


def test_no_slip_is_read_out_of_a_number_on_which_a_right_one_stands() -> None:
    arm = variants.deal("tmm2_oop", 57)
    line = str(solved(arm).steps["a_y"]).replace(" + ", " - ", 1)
    values = solved(arm).again(replaced={"a_y": line})
    alone = handed_in(arm, a_y=f"{values['a_y']:.5g}")
    assert (alone.mistake, alone.slip, alone.verdicts["a_D"].code) == (None, None, Code.RIGHT)
    followed = handed_in(arm, a_y=f"{values['a_y']:.5g}", a_D=f"{values['a_D']:.5g}")
    assert (followed.mistake, followed.slip) == (None, CommonSlip.TERM_SIGN)


def test_a_slip_in_a_line_that_is_not_asked_for_is_named() -> None:
    typed = solved(BEAM).again(replaced={"W": "b*h^2/3"})["sigma_max"]
    assert handed_in(BEAM, sigma_max=f"{typed} Pa").slip is CommonSlip.FACTOR_TWO


def test_a_number_is_told_by_the_figures_typed() -> None:
    """Within the tolerance of the field, but not within what is typed: nothing is named."""
    wrong = value(CRANK, "v3") / 2
    assert handed_in(CRANK, v3=f"{wrong:.5g}").slip is CommonSlip.FACTOR_TWO
    assert handed_in(CRANK, v3=f"{wrong * 1.003:.5g}").slip is None


def test_answers_in_each_others_fields_are_named() -> None:
    answers = reference(BEAM)
    assert handed_in(BEAM, R_A=answers["R_B"], R_B=answers["R_A"]).slip is CommonSlip.FIELDS_EXCHANGED


def test_matrices_in_each_others_fields_are_named() -> None:
    answers = reference(ARM)
    assert handed_in(ARM, A1=answers["A2"], A2=answers["A1"]).slip is CommonSlip.FIELDS_EXCHANGED


def test_one_answer_in_the_field_of_another_is_no_exchange() -> None:
    answers = reference(BEAM)
    assert handed_in(BEAM, R_A=answers["R_B"], R_B="0,777 kN").slip is None
    assert handed_in(BEAM, R_B=answers["R_A"], R_A="0,777 kN").slip is None


def test_counts_that_are_off_are_not_taken_for_exchanged() -> None:
    answers = reference(PAIRS)
    assert handed_in(PAIRS, n=answers["p5"], p5=answers["n"]).slip is None


def test_a_slip_is_told_by_the_right_value_and_by_what_follows_from_own_ones() -> None:
    alpha2 = -value(CRANK, "alpha2")
    followed = solved(CRANK).again(fixed={"alpha2": alpha2})["v3"]
    assert isinstance(followed, float) and abs(followed - value(CRANK, "v3")) > 0.01 * abs(followed)
    for v3 in (-followed, -value(CRANK, "v3")):
        found = handed_in(CRANK, alpha2=f"{alpha2} rad", v3=f"{v3}")
        assert (found.mistake, found.slip) == (None, CommonSlip.OPPOSITE_SIGN)


def test_a_slip_in_a_line_is_told_from_own_earlier_values() -> None:
    omega2 = solved(CRANK).again(replaced={"omega2": "-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"})["omega2"]
    line = "-l1*omega1*cos(alpha1) - l2*omega2*sin(alpha2)"
    v3 = solved(CRANK).again(replaced={"v3": line}, fixed={"omega2": omega2})["v3"]
    found = handed_in(CRANK, omega2=f"{omega2}", v3=f"{v3}")
    assert (found.mistake, found.slip) == (None, CommonSlip.SINE_COSINE)


def test_a_slip_never_changes_the_score() -> None:
    named, unnamed = (handed_in(CRANK, v3=f"{value(CRANK, 'v3') * factor:.6g}") for factor in (2.0, 2.345))
    assert named.slip is CommonSlip.FACTOR_TWO and unnamed.slip is None
    assert named.score == unnamed.score


def test_a_right_submission_and_an_empty_one_have_no_slip() -> None:
    for answers in (reference(CRANK), {}):
        found = grade(Submission(CRANK, answers))
        assert (found.mistake, found.slip) == (None, None)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_common_slip_has_a_hint_that_holds_no_number_of_the_task(lang: str) -> None:
    assert set(locale(lang)["common_slips"]) == {slip.value for slip in CommonSlip}
    for slip in CommonSlip:
        assert not re.findall(r"\d+[.,]\d", common_hint(slip, lang))
    found = handed_in(CRANK, v3=f"{2 * value(CRANK, 'v3'):.6g}")
    assert hints_text(CRANK, found, lang) == common_hint(CommonSlip.FACTOR_TWO, lang)


def test_the_likeliest_slip_is_the_one_that_all_answers_share() -> None:
    one, other = frozenset({CommonSlip.KILO_PREFIX, CommonSlip.POWER_OF_TEN}), frozenset({CommonSlip.POWER_OF_TEN})
    assert likeliest([one]) is CommonSlip.KILO_PREFIX
    assert likeliest([one, other]) is CommonSlip.POWER_OF_TEN
    assert likeliest([one, frozenset()]) is None and likeliest([]) is None


@pytest.mark.parametrize(
    ("ratio", "unit", "slip"),
    [
        (-1.0, "N", CommonSlip.OPPOSITE_SIGN),
        (1e6, "Pa", CommonSlip.KILO_PREFIX),
        (0.1, "mm", CommonSlip.POWER_OF_TEN),
        (57.29578, "deg", CommonSlip.DEGREES_RADIANS),
        (9.549297, "rad/s", CommonSlip.TURNS_RADIANS),
        (16.0, "MPa", CommonSlip.DIAMETER_RADIUS),
        (0.5, "N", CommonSlip.FACTOR_TWO),
        (3.141593, "mm", CommonSlip.PI_LOST),
    ],
)
def test_what_a_number_is_off_by_is_told_by_its_unit(ratio: float, unit: str, slip: CommonSlip) -> None:
    assert slip in off_by(ratio, 1e-4, read_unit(unit).dimension)
    assert not off_by(ratio * 1.01, 1e-4, read_unit(unit).dimension)


def test_slips_in_a_line_are_different_lines() -> None:
    line = parse_line("(l1*cos(alpha1) - sqrt(l2^2 - a^2))/l2")
    found = slips_in(line)
    written = {text_of(tree) for _, tree in found}
    assert len(written) == len(found) and text_of(line) not in written
    assert {"(l1*sin(alpha1) - sqrt(l2^2 - a^2))/l2", "(l1*cos(alpha1) + sqrt(l2^2 - a^2))/l2"} <= written
    assert {"(l1*cos(alpha1) - sqrt(l2 - a^2))/l2", "(l2*cos(alpha1) - sqrt(l1^2 - a^2))/l1"} <= written


@pytest.mark.parametrize(
    ("slip", "line"),
    [
        (CommonSlip.FACTOR_LOST, "-l1*omega1/l2"),
        (CommonSlip.UPSIDE_DOWN, "-l2*omega1*cos(alpha2)/(l1*cos(alpha1))"),
    ],
)
def test_projections_are_forgotten_together_and_a_quotient_is_turned_over_beside_a_factor(
    slip: CommonSlip, line: str
) -> None:
    assert handed_in(CRANK, omega2_formula=line).slip is slip


def test_a_root_drawn_from_each_term_of_a_sum_is_a_slip_in_the_root() -> None:
    found = slips_in(parse_line("sqrt(v_x^2 + v_y^2)"))
    assert {(CommonSlip.POWER, "v_x + v_y"), (CommonSlip.POWER, "abs(v_x + v_y)")} <= {
        (slip, text_of(tree)) for slip, tree in found
    }


@pytest.mark.parametrize(("unit", "factor"), [("deg", 4.0), ("s", 4.0), ("s", 16.0), ("rad/s", 16.0)])
def test_what_has_no_length_in_its_unit_is_not_put_down_to_a_radius(unit: str, factor: float) -> None:
    assert CommonSlip.DIAMETER_RADIUS not in off_by(factor, 1e-4, read_unit(unit).dimension)


def test_a_twist_may_be_put_down_to_a_radius_in_the_polar_second_moment() -> None:
    assert CommonSlip.DIAMETER_RADIUS in off_by(16.0, 1e-4, read_unit("deg").dimension)


def test_a_quotient_of_numbers_alone_is_not_turned_over() -> None:
    """An angle of 2 pi is one of zero, so that it would explain a right angle that was left out."""
    assert CommonSlip.UPSIDE_DOWN not in {slip for slip, _ in slips_in(parse_line("pi/2"))}


def test_a_given_that_is_misread_is_told_by_a_set_and_what_follows() -> None:
    judges, values = solved(BARS).answers, solved(BARS).again(replaced={"alpha1": "-alpha1"})
    typed = {name: judges[name].show(values[name]) for name in judges}
    assert handed_in(BARS, **typed).slip is CommonSlip.OPPOSITE_SIGN


# follow-through


@pytest.mark.parametrize("trivial", ["0", "0*l1", "omega1*1e-9", "1e9*omega1"])
def test_nothing_follows_from_a_trivial_formula(trivial: str) -> None:
    own = solved(CRANK).again(replaced={"omega2": trivial})
    found = handed_in(CRANK, omega2_formula=trivial, omega2=f"{own['omega2']}", v3=f"{own['v3']}")
    assert found.verdicts["omega2"].outcome is Outcome.WRONG
    assert found.verdicts["v3"].code is not Code.FOLLOWED


def test_a_formula_with_the_opposite_sign_is_followed() -> None:
    own = solved(CRANK).again(replaced={"omega2": "l1*omega1*cos(alpha1)/l2"})
    found = handed_in(CRANK, omega2_formula="l1*omega1*cos(alpha1)/l2", omega2=f"{own['omega2']}", v3=f"{own['v3']}")
    assert found.verdicts["omega2"].code is found.verdicts["v3"].code is Code.FOLLOWED


IDENTITY = "[[1; 0; 0; 0], [0; 1; 0; 0], [0; 0; 1; 0], [0; 0; 0; 1]]"


@pytest.mark.parametrize("trivial", [IDENTITY, IDENTITY.replace("1", "0"), IDENTITY.replace("1", "1e8")])
def test_no_product_follows_from_a_trivial_matrix(trivial: str) -> None:
    rows = tuple(tuple(float(e) for e in row.split(";")) for row in re.findall(r"\[([^\[\]]+)\]", trivial))
    own = solved(ARM).again(fixed={"A1": rows})["T"]
    grader = solved(ARM).answers["T"]
    found = handed_in(ARM, A1=trivial, T=grader.show(own))
    assert found.verdicts["A1"].outcome is not Outcome.RIGHT
    assert found.verdicts["T"].code is not Code.FOLLOWED


def test_a_product_follows_from_a_matrix_with_a_wrong_sign() -> None:
    true = solved(ARM).values["A2"]
    assert isinstance(true, tuple)
    rows = ((true[0][0], -true[0][1], *true[0][2:]), *true[1:])
    own = solved(ARM).again(fixed={"A2": rows})["T"]
    judges = solved(ARM).answers
    found = handed_in(ARM, A2=judges["A2"].show(rows), T=judges["T"].show(own))
    assert found.verdicts["T"].code is Code.FOLLOWED and found.slip is CommonSlip.OPPOSITE_SIGN


def test_a_number_of_pairs_may_be_none_and_few_for_none() -> None:
    own = solved(PAIRS).again(fixed={"p4": 2.0 if value(PAIRS, "p4") == 0 else 0.0})
    found = handed_in(PAIRS, p4=f"{own['p4']:.0f}", F=f"{own['F']:.0f}")
    assert found.verdicts["p4"].outcome is Outcome.WRONG
    assert found.verdicts["F"].code is Code.FOLLOWED


@pytest.mark.parametrize(
    ("own", "right", "counts", "is_plausible"),
    [
        (-5.0, 5.0, False, True),
        (0.0, 5.0, False, False),
        (5e3, 5.0, False, False),
        (5e-3, 5.0, False, False),
        (0.0, 2.0, True, True),
        (0.0, 45.0, True, False),
        (2.0, 0.0, True, True),
        ("same", "opposite", False, True),
        (1.0, ((1.0,),), False, False),
        (((1.0, 2.0), (0.0, 0.0)), ((1.0, 2.0), (3.0, 4.0)), False, False),
        (((1.0, -2.0), (3.0, 0.0)), ((1.0, 2.0), (3.0, 4.0)), False, True),
        (((1e9, 1.0), (1.0, 1.0)), ((1.0, 2.0), (3.0, 4.0)), False, False),
    ],
)
def test_only_values_of_the_right_size_are_carried_on(
    own: object, right: object, counts: bool, is_plausible: bool
) -> None:
    assert plausible(own, right, counts) is is_plausible  # type: ignore[arg-type]


def test_a_choice_follows_from_ones_own_ratio() -> None:
    variant = variants.deal("gear_train", 1)
    u = value(variant, "u")
    other = "opposite" if u > 0 else "same"
    found = handed_in(variant, u=f"{-u:.6g}", sense=other)
    assert found.verdicts["sense"].code is Code.FOLLOWED


def test_a_reciprocal_of_an_exact_ratio_is_followed() -> None:
    variant = variants.deal("planetary", 1)
    own = solved(variant).again(fixed={"u0": 1 / value(variant, "u0")})
    texts = {name: solved(variant).answers[name].show(own[name]) for name in ("u0", "u", "n_out")}
    found = handed_in(variant, **texts)
    assert found.verdicts["u0"].code is Code.INVERTED_RATIO
    assert found.verdicts["u"].code is found.verdicts["n_out"].code is Code.FOLLOWED


def test_nothing_follows_from_no_angle_however_small_the_right_one_is() -> None:
    """Only where things are counted may none stand for a few."""
    values = solved(CRANK).again(fixed={"alpha2": 0.0})
    found = handed_in(CRANK, alpha2="0", omega2=f"{values['omega2']} rad/s")
    assert abs(value(CRANK, "alpha2")) < 3
    assert found.verdicts["omega2"].outcome is Outcome.WRONG


def test_a_wrong_formula_behind_a_wrong_number_does_not_follow_from_it() -> None:
    found = handed_in(CRANK, alpha2="0.3 rad", omega2_formula="l1*omega1*cos(alpha1)/l2")
    assert found.verdicts["omega2_formula"].code not in (Code.FOLLOWED, Code.RIGHT)
    assert found.verdicts["omega2_formula"].outcome is Outcome.WRONG


def test_numbers_follow_from_a_lost_branch() -> None:
    variant = variants.deal("rrr_inverse", 1)
    rows = solved(variant).values["q"]
    assert isinstance(rows, tuple)
    text = solved(variant).answers["q"].show(rows[:2])
    found = handed_in(variant, q=text, n="2")
    assert found.verdicts["q"].code is Code.LOST_BRANCH and found.verdicts["n"].code is Code.FOLLOWED


def test_diagrams_follow_from_a_wrong_reaction() -> None:
    variant = next(
        v for v in (variants.deal("beam_diagrams", seed) for seed in range(20)) if len(v.givens.supports) == 2
    )
    own = solved(variant).again(fixed={"R_A": 1.3 * value(variant, "R_A")})
    judges = solved(variant).answers
    found = handed_in(variant, **{name: judges[name].show(own[name]) for name in ("R_A", "R_B", "V", "M")})
    codes = [found.verdicts[name].code for name in ("R_B", "V", "M")]
    assert codes == [Code.FOLLOWED] * 3 and found.verdicts["R_A"].code is Code.WRONG


def test_a_cycle_follows_from_a_wrong_speed() -> None:
    variant = variants.deal("slider_crank_cycle", 1)
    own = solved(variant).again(fixed={"omega1": 1.3 * value(variant, "omega1")})
    judges = solved(variant).answers
    found = handed_in(variant, **{name: judges[name].show(own[name]) for name in ("omega1", "T", "cycle")})
    assert found.verdicts["T"].code is found.verdicts["cycle"].code is Code.FOLLOWED


def test_functions_are_judged_in_symbols_so_a_wrong_reaction_does_not_touch_them() -> None:
    variant = variants.deal("beam_deflection", 1)
    found = handed_in(variant, R_A=f"{1.3 * value(variant, 'R_A')} N")
    assert found.verdicts["M"].code is found.verdicts["v"].code is Code.RIGHT


def test_every_exercise_follows_from_a_wrong_first_number() -> None:
    """Wherever a number stands on an earlier one: solved again from a third more, all later numbers follow."""
    for exercise_id in catalogue.ids():
        variant = variants.deal(exercise_id, 4)
        made = solved(variant)
        numbers = [n for n, judge in made.answers.items() if judge.kind == "quantity" and made.step_of(n) == n]
        if not numbers:
            continue
        own = made.again(fixed={numbers[0]: 1.3 * value(variant, numbers[0])})
        texts = {name: made.answers[name].show(own[name]) for name in numbers}
        found = handed_in(variant, **texts)
        for name in numbers[1:]:
            changed = abs(own[name] - value(variant, name)) > 0.1 * abs(value(variant, name))  # type: ignore[operator]
            assert found.verdicts[name].code in ((Code.FOLLOWED,) if changed else (Code.FOLLOWED, Code.RIGHT))
