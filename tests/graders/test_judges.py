"""The judges: every kind tests itself by its samples, and tells the slips apart that it promises to."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import (
    KINDS,
    AnswerSyntaxError,
    Choice,
    Choices,
    Code,
    DHTable,
    Expression,
    Formula,
    Grader,
    Integer,
    Matrix,
    Ordering,
    Outcome,
    Polygon,
    Quantity,
    Rates,
    Rational,
    Set,
    States,
    Symbols,
    Text,
)
from graders.language import Reason, parse, parse_line
from graders.verdict import OUTCOMES, Entries, Witness
from graders.words import LANGUAGES, locale, message, tolerance
from tests.graders.chain.truth import motion
from tests.graders.polygon.mechanisms import SLIDER

NOTHING = Symbols(())
NAMES = ("l1", "l2", "alpha1", "omega1")
POINTS = tuple((0.04 + 0.01 * (k % 7), 0.2 + 0.02 * (k % 11), 0.37 + 0.383 * k, 5 + 2.1 * (k % 13)) for k in range(16))
STATES = States(NAMES, POINTS, (("alpha2", parse_line("-asin(l1*sin(alpha1)/l2)")),))
OMEGA2 = Formula(parse_line("-l1*omega1*cos(alpha1)/(l2*cos(alpha2))"), STATES)
SYMBOLS = Symbols([*NAMES, "alpha2"], ["omega2"])
RIGHT: list[tuple[Grader, Any, Symbols]] = [
    (Quantity("MPa"), 12.5e6, NOTHING),
    (Quantity("deg"), -0.2159, NOTHING),
    (Quantity("mm", atol=1e-5), 0.0032, NOTHING),
    (Integer(), 45.0, NOTHING),
    (Choice(("strength", "stiffness")), "stiffness", NOTHING),
    (Choices(("crank", "rod", "rocker", "slider")), "crank; rocker", NOTHING),
    (Choices(("crank", "rod")), "", NOTHING),
    (Choices(("crank", "rod")), "rod; crank", NOTHING),
    (Ordering(("draw", "solve", "check")), "draw; solve; check", NOTHING),
    (Rational(), -8 / 3, NOTHING),
    (Rational(rtol=0.01), 4.0, NOTHING),
    (Rational(either=True), 0.25, NOTHING),
    (Set(("deg", "m")), ((0.3, 1.5), (-0.3, 2.5)), NOTHING),
    (DHTable("RRP"), motion("RRP"), Symbols(motion("RRP").names)),
    (Text(), "", NOTHING),
    (Matrix(2, 2), ((0.5, -0.25), (0.0, 1.0)), NOTHING),
    (Expression("omega2"), OMEGA2, SYMBOLS),
    (Polygon(SLIDER.nodes, "alpha2"), SLIDER, Symbols(SLIDER.states()[0].names)),
    (Rates("polygon", 1, "omega2"), SLIDER, Symbols(SLIDER.states()[0].names)),
    (Rates("polygon", 2, "omega2"), SLIDER, Symbols(SLIDER.states()[0].names)),
]


def judged(grader: Grader, text: str, reference: Any, symbols: Symbols = NOTHING) -> Code:
    return grader.check(grader.parse(text, symbols), reference).code


@pytest.mark.parametrize(("grader", "reference", "symbols"), RIGHT)
def test_a_judge_passes_its_own_samples(grader: Grader, reference: Any, symbols: Symbols) -> None:
    samples = grader.samples(reference)
    right = {Code.KEPT} if grader.kind == "text" else {Code.RIGHT}
    assert {judged(grader, text, reference, symbols) for text in (*samples.right, grader.show(reference))} == right
    assert all(judged(grader, text, reference, symbols) is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            grader.parse(text, symbols)


def test_every_kind_stands_in_the_registry_under_its_name() -> None:
    assert all(str(cls.kind) == kind for kind, cls in KINDS.items())


def test_every_kind_is_tested_by_its_samples_here_or_in_a_file_of_its_name() -> None:
    here = {grader.kind for grader, *_ in RIGHT}
    elsewhere = {kind for kind in KINDS if any(Path(__file__).parent.rglob(f"test_{kind}.py"))}
    assert here | elsewhere == set(KINDS)


@pytest.mark.parametrize(("grader", "reference", "symbols"), RIGHT)
def test_a_judge_echoes_what_it_read_and_describes_its_field(grader: Grader, reference: Any, symbols: Symbols) -> None:
    answer = grader.parse(grader.show(reference), symbols)
    assert grader.echo(answer).text
    assert grader.describe() == json.loads(json.dumps(grader.describe()))
    assert grader.carried(answer) is not None or grader.kind in ("text", "polygon", "rates")
    assert grader.apart(reference, reference) == 0


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("12,5", Code.RIGHT),
        ("12500 kPa", Code.RIGHT),
        ("1,25e7 Pa", Code.RIGHT),
        ("12,5 N/mm²", Code.RIGHT),
        ("25/2", Code.RIGHT),
        ("12.5 [MPa]", Code.RIGHT),
        ("σ = 12,5 МПа", Code.RIGHT),
        ("1.25·10^7 N/m^2", Code.RIGHT),
        ("12.5625", Code.RIGHT),
        ("12.4375", Code.RIGHT),
        ("12.56251", Code.NOT_PRECISE),
        ("１２.5", Code.RIGHT),
        ("12.5 kPa", Code.WRONG_UNIT),
        ("12.5 mm", Code.WRONG_DIMENSION),
        ("12.5 N", Code.WRONG_DIMENSION),
        ("12.5 N/m", Code.WRONG_DIMENSION),
        ("-12.5", Code.OPPOSITE_SIGN),
        ("13 mm", Code.WRONG_DIMENSION),
        ("125", Code.FACTOR_OF_TEN),
        ("0.0125", Code.FACTOR_OF_TEN),
        ("40", Code.WRONG),
        ("0", Code.WRONG),
    ],
)
def test_value_unit_sign_and_power_of_ten_are_told_apart(typed: str, code: Code) -> None:
    assert judged(Quantity("MPa"), typed, 12.5e6) is code


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        ("1..2", Reason.BAD_CHARACTER),
        ("5 qq", Reason.UNKNOWN_UNIT),
        ("NaN", Reason.NOT_A_NUMBER),
        ("inf", Reason.NOT_A_NUMBER),
        ("1e400", Reason.OUT_OF_RANGE),
        ("9^9^9^9", Reason.OUT_OF_RANGE),
        ("MPa", Reason.NOT_A_NUMBER),
        ("", Reason.EMPTY),
        ("[1; 2]", Reason.NOT_A_NUMBER),
        ("0*kN + 5 m", Reason.NEEDS_OPERAND),
        ("1e98 GPa", Reason.OUT_OF_RANGE),
        ("1/0", Reason.OUT_OF_RANGE),
        ("3 < 5", Reason.NOT_A_NUMBER),
        ("True", Reason.NOT_A_NUMBER),
    ],
)
def test_what_is_no_quantity_is_unreadable(typed: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Quantity("MPa").parse(typed, NOTHING)
    assert refused.value.reason is reason


@given(st.floats(-math.pi, math.pi), st.integers(-3, 3))
def test_an_angle_is_right_modulo_a_full_turn(angle: float, turns: int) -> None:
    typed = f"{math.degrees(angle) + 360 * turns:.9f}"
    assert judged(Quantity("deg", atol=1e-6), typed, angle) is Code.RIGHT


@given(st.floats(1e-3, 1e6), st.sampled_from(["", " ", "\u00a0"]))
def test_four_figures_are_enough(value: float, gap: str) -> None:
    assert judged(Quantity("kN"), f"{value / 1e3:.4g}{gap}kN".replace(".", ","), value) is Code.RIGHT


@pytest.mark.parametrize("typed", ["-12,37°", "-12°22'20\"", "347.63", "-0.21593 rad", "-12.37 deg", "347,63 stopni"])
def test_angles_are_read_in_degrees_minutes_and_radians(typed: str) -> None:
    assert judged(Quantity("deg"), typed, -0.2159367698) is Code.RIGHT


@pytest.mark.parametrize(
    "typed",
    [
        "-asin(45*sin(105°)/220)",
        "-arcsin(45/220·sin105°)",
        "-asin(0.197576)",
        "-arcsin 0,197576 rad",
        "-asin(45*sin(105°)/220)*180/pi",
        "-180/π·arcsin(45·sin(105°)/220)",
        "180 - 191,3952°",
        "-0,198884·180/π °",
        "asin(0.802424*sin(90°)) - 64.7582°",
        "-11,3952 stopnia",
        "-11.3952 degrees",
        "-0.198884 radians",
        "-11,3952 градуса",
    ],
)
def test_a_computed_angle_is_read_in_the_unit_it_speaks_of(typed: str) -> None:
    assert judged(Quantity("deg"), typed, -0.198884) is Code.RIGHT


@pytest.mark.parametrize(
    ("unit", "reference", "typed"),
    [
        ("mm", 0.2040164, "45*cos(105°) + 220*cos(-11,3952°)"),
        ("mm", 0.2040164, "45·cos105° + 220·cos 11,3952°"),
        ("m", 0.1047198, "0,2*30°"),
        ("m", 0.1047198, "0.4*asin(0.2588190)"),
        ("1", 1.0, "tg45°"),
    ],
)
def test_a_degree_sign_inside_a_function_does_not_make_an_angle(unit: str, reference: float, typed: str) -> None:
    assert judged(Quantity(unit), typed, reference) is Code.RIGHT


def test_an_angle_where_none_is_asked_for_is_of_another_dimension() -> None:
    assert judged(Quantity("mm"), "30°", 0.03) is Code.WRONG_DIMENSION


def test_credit_for_a_number_in_the_wrong_unit_is_declared_by_the_task() -> None:
    assert Quantity("MPa").check(Quantity("MPa").parse("12.5 kPa", NOTHING), 12.5e6).score == 0.5
    strict = Quantity("MPa", unit_credit=0.0)
    assert strict.check(strict.parse("12.5 kPa", NOTHING), 12.5e6).score == 0


@pytest.mark.parametrize(
    ("unit", "reference", "typed"),
    [
        ("N*m", 25.0, "25 J"),
        ("kN*m", 25e3, "25 kJ"),
        ("rad/s", 25.0, "25 Hz"),
        ("Hz", 25.0, "25 rad/s"),
        ("Hz", 25.0, "1500 rpm"),
        ("rad", 0.5, "0,5 m"),
        ("W", 100.0, "100 J"),
    ],
)
def test_a_right_number_of_another_quantity_earns_nothing(unit: str, reference: float, typed: str) -> None:
    judge = Quantity(unit)
    verdict = judge.check(judge.parse(typed, NOTHING), reference)
    assert (verdict.code, verdict.score) == (Code.WRONG_DIMENSION, 0)


@pytest.mark.parametrize(
    "typed",
    ["1500", "1500 rpm", "1500 obr/min", "1500 об/мин", "1500 rev/min", "1500 obr./min", "25 obr/s", "25 об/с",
     "1500 1/min", "1500 min^-1", "1500 мин⁻¹", "25 1/s", "157,08 rad/s", "9000 deg/s"],
)  # fmt: skip
def test_a_speed_of_rotation_is_read_in_turns_or_radians(typed: str) -> None:
    assert judged(Quantity("rpm"), typed, 1500 * math.pi / 30) is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "code"),
    [("25 1/s", Code.RIGHT), ("25 rad/s", Code.RIGHT), ("25 obr/s", Code.WRONG_UNIT), ("25 Hz", Code.WRONG_DIMENSION)],
)
def test_a_bare_second_below_the_line_means_radians_where_radians_are_asked(typed: str, code: Code) -> None:
    assert judged(Quantity("rad/s"), typed, 25.0) is code


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        ("-l1*ω1*cos(α1)/(l2*cos(α2))", Code.RIGHT),
        ("-l1*ω1*cos(α1)/sqrt(l2^2 - l1^2*sin(α1)^2)", Code.RIGHT),
        ("ω1 cos α1 (-l1)/(l2 cos α2)", Code.RIGHT),
        ("ω2 = -l1 ω1 cos(α1)/(l2 cos(α2))", Code.RIGHT),
        ("-l1*ω1*cos(α1)/(l2*cos(α2)) * (1 + 1e-9)", Code.WRONG),
        ("-l1*ω1*cos(α1)/(l2*cos(α2)) + 1e-12", Code.WRONG),
        ("-l1*ω1*sin(α1)/(l2*cos(α2))", Code.WRONG),
        ("sqrt(-1 - l1)", Code.UNDEFINED),
        ("1/(l1 - l1)", Code.UNDEFINED),
        ("2", Code.WRONG),
    ],
)
def test_formulas_are_equal_as_functions_or_proved_different(typed: str, code: Code) -> None:
    assert judged(Expression("omega2"), typed, OMEGA2, SYMBOLS) is code


def test_a_different_formula_comes_with_a_witness() -> None:
    judge = Expression("omega2")
    verdict = judge.check(judge.parse("l1", SYMBOLS), OMEGA2)
    assert isinstance(verdict.details, Witness)
    assert [name for name, _ in verdict.details.point] == list(NAMES)


@pytest.mark.parametrize(
    ("typed", "reason", "place"),
    [
        ("omega2", Reason.FORBIDDEN_NAME, 0),
        ("l1 + ω2", Reason.FORBIDDEN_NAME, 5),
        ("l1 = l2", Reason.NOT_AN_EXPRESSION, 0),
    ],
)
def test_the_unknown_itself_is_no_answer(typed: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Expression("omega2").parse(typed, SYMBOLS)
    assert (refused.value.reason, refused.value.position) == (reason, place)


def test_a_formula_that_cancels_to_zero_is_accepted_for_zero() -> None:
    zero = Formula(parse_line("sin(alpha1)^2 + cos(alpha1)^2 - 1"), STATES)
    assert judged(Expression("z"), "0", zero, SYMBOLS) is Code.RIGHT


def test_brackets_that_open_inside_the_domain_are_seen() -> None:
    states = States(("x", "a"), tuple((0.2 * k + 0.03, 1.5) for k in range(16)))
    reference = Formula(parse_line("macaulay(x - a; 1)"), states)
    names = Symbols(["x", "a"])
    assert judged(Expression("M"), "<x-a>", reference, names) is Code.RIGHT
    assert judged(Expression("M"), "x - a", reference, names) is Code.WRONG
    assert judged(Expression("M"), "(x - a + |x - a|)/2", reference, names) is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("[[0,5; -0,25], [0; 1]]", Code.RIGHT, 1),
        ("[0.5, -0.25; 0, 1]", Code.RIGHT, 1),
        ("A = [[1/2, -1/4], [0, 1]]", Code.RIGHT, 1),
        ("[[sin(30°); -0.25], [0; 1]]", Code.RIGHT, 1),
        ("[[0.5; 0.25], [0; 1]]", Code.SOME_ENTRIES, 0.5),
        ("[[0.5; 0.25], [3; 1]]", Code.WRONG, 0),
        ("[[0.5; -0.25]]", Code.WRONG_SHAPE, 0),
    ],
)
def test_a_matrix_is_judged_entry_by_entry(typed: str, code: Code, score: float) -> None:
    judge = Matrix(2, 2)
    names = Symbols((), ["A"])
    verdict = judge.check(judge.parse(typed, names), ((0.5, -0.25), (0.0, 1.0)))
    assert (verdict.code, verdict.score) == (code, score)
    assert not isinstance(verdict.details, Entries) or verdict.details.total == 4


@pytest.mark.parametrize("typed", ["[[a; 1], [0; 1]]", "[[1/0; 1], [0; 1]]", "3", "[[1e99*100; 0], [0; 1]]"])
def test_a_matrix_of_anything_but_numbers_is_unreadable(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Matrix(2, 2).parse(typed, Symbols(["a"]))


@pytest.mark.parametrize("typed", ["45", " z3 = 45 ", "+45", "45,0", "45.00"])
def test_a_whole_number_is_read_however_it_is_typed(typed: str) -> None:
    assert judged(Integer(), typed, 45.0) is Code.RIGHT


def test_a_whole_number_of_the_opposite_sign_is_named() -> None:
    assert judged(Integer(), "−45", 45.0) is Code.OPPOSITE_SIGN


@pytest.mark.parametrize("typed", ["b", "B)", "stiffness", "б"])
def test_an_option_is_chosen_by_letter_or_name(typed: str) -> None:
    judge = Choice(("strength", "stiffness"))
    if typed == "б":
        with pytest.raises(AnswerSyntaxError):
            judge.parse(typed, NOTHING)
    else:
        assert judged(judge, typed, "stiffness") is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("a; c", Code.RIGHT, 1),
        ("C,A", Code.RIGHT, 1),
        ("ca", Code.RIGHT, 1),
        ("links = crank; rocker", Code.RIGHT, 1),
        ("(a) c)", Code.RIGHT, 1),
        ("a", Code.SOME_ITEMS, 0.5),
        ("a; b; c", Code.SOME_ITEMS, 0.5),
        ("a; b", Code.WRONG, 0),
        ("abcd", Code.WRONG, 0),
        ("b; d", Code.WRONG, 0),
        ("-", Code.WRONG, 0),
    ],
)
def test_several_choices_earn_their_share_and_all_of_them_nothing(typed: str, code: Code, score: float) -> None:
    judge = Choices(("crank", "rod", "rocker", "slider"))
    verdict = judge.check(judge.parse(typed, NOTHING), "crank; rocker")
    assert (verdict.code, verdict.score) == (code, score)


@given(st.integers(2, 8).flatmap(lambda n: st.tuples(st.just(n), st.sets(st.integers(0, n - 1)))))
def test_ticking_at_random_earns_nothing_on_the_average(drawn: tuple[int, set[int]]) -> None:
    """The mean over all selections of one size of share of right less share of wrong ones is zero."""
    count, right = drawn
    options = tuple(f"option{k}" for k in range(count))
    judge, reference = Choices(options), "; ".join(options[k] for k in right)
    assert judge.check(frozenset(options), reference).score == (1 if len(right) == count else 0)
    assert judge.check(frozenset(), reference).score == (0 if right else 1)


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("a; b; c; d", Code.RIGHT, 1),
        ("a → b → c → d", Code.RIGHT, 1),
        ("abcd", Code.RIGHT, 1),
        ("b; a; c; d", Code.SOME_ITEMS, 2 / 3),
        ("a; c; d; b", Code.SOME_ITEMS, 1 / 3),
        ("b; a; d; c", Code.SOME_ITEMS, 1 / 3),
        ("d; a; b; c", Code.WRONG, 0),
        ("d; c; b; a", Code.WRONG, 0),
    ],
)
def test_an_order_earns_by_its_pairs(typed: str, code: Code, score: float) -> None:
    judge = Ordering(("one", "two", "three", "four"))
    verdict = judge.check(judge.parse(typed, NOTHING), "one; two; three; four")
    assert verdict.code is code
    assert verdict.score == pytest.approx(score)


@pytest.mark.parametrize(
    ("judge", "typed", "reason", "place"),
    [
        (Ordering(("one", "two", "three")), "a; c", Reason.MISSING_ITEM, 4),
        (Ordering(("one", "two", "three")), "a; c; a", Reason.REPEATED_ITEM, 6),
        (Ordering(("one", "two", "three")), "a; q; b", Reason.NOT_A_CHOICE, 3),
        (Choices(("one", "two", "three")), "a; a", Reason.REPEATED_ITEM, 3),
        (Choices(("one", "two", "three")), " ; ", Reason.EMPTY, 0),
        (Choices(("one", "two", "three")), "a;" * 300, Reason.TOO_LONG, 400),
        (Choice(("one", "two")), " " * 500 + "a", Reason.TOO_LONG, 400),
        (Choice(("one", "two")), " zz", Reason.NOT_A_CHOICE, 1),
        (Text(longest=5), "123456", Reason.TOO_LONG, 5),
        (Text(), "ab\u202e", Reason.BAD_CHARACTER, 2),
        (Rational(), "3" * 300, Reason.TOO_LONG, 200),
        (Rational(), "sin(1)", Reason.NOT_A_FRACTION, 0),
        (Rational(), "9^9^9", Reason.NOT_A_FRACTION, 0),
        (Rational(), "9^12", Reason.OUT_OF_RANGE, 0),
        (Rational(), "i = 1/(2-2)", Reason.OUT_OF_RANGE, 4),
        (Rational(), "2 1/2", Reason.MIXED_NUMBER, 2),
        (Rational(), r"\frac{8}{}", Reason.EMPTY_BOX, 8),
        (Integer(), r"\frac{8}{2}", Reason.NOT_AN_INTEGER, 0),
    ],
)
def test_what_no_small_judge_reads_is_refused_with_its_place(
    judge: Grader, typed: str, reason: Reason, place: int
) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        judge.parse(typed, NOTHING)
    assert (refused.value.reason, refused.value.position) == (reason, place)


@pytest.mark.parametrize(
    ("judge", "typed", "code"),
    [
        (Rational(), "-8/3", Code.RIGHT),
        (Rational(), "−8 : 3", Code.RIGHT),
        (Rational(), "i_14 = -8/3", Code.RIGHT),
        (Rational(), "8/(-3)", Code.RIGHT),
        (Rational(), "-(80/20)*(40/60)", Code.RIGHT),
        (Rational(), "-2 - 2/3", Code.RIGHT),
        (Rational(), r"-\frac{8}{3}", Code.RIGHT),
        (Rational(), r"i_{14}=-\frac83", Code.RIGHT),
        (Rational(), "8/3", Code.OPPOSITE_SIGN),
        (Rational(), "-3/8", Code.INVERTED_RATIO),
        (Rational(), "3/8", Code.WRONG),
        (Rational(), "-2,667", Code.NOT_EXACT),
        (Rational(), "-2.666666666666667", Code.NOT_EXACT),
        (Rational(), "0", Code.WRONG),
        (Rational(rtol=0.005), "-2,667", Code.RIGHT),
        (Rational(rtol=0.005), "-2,69", Code.NOT_PRECISE),
        (Rational(either=True), "-3:8", Code.RIGHT),
        (Rational(either=True), "3:8", Code.WRONG),
        (Rational(), "(2^3)/(-3)", Code.RIGHT),
    ],
)
def test_a_ratio_is_judged_by_its_declared_direction_and_exactly(judge: Rational, typed: str, code: Code) -> None:
    assert judged(judge, typed, -8 / 3) is code


@given(st.integers(-200_000, 200_000).filter(bool), st.integers(1, 200_000))
def test_a_product_of_teeth_is_recovered_from_its_double(over: int, under: int) -> None:
    assert judged(Rational(), f"{over}/{under}", over / under) is Code.RIGHT


@pytest.mark.parametrize(("one", "other", "apart"), [(2.0, 2.0, 0), (2.0, 2.02, 0.990099), (4.0, 0.25, 93.75)])
def test_ratios_with_a_tolerance_lie_apart_by_it(one: float, other: float, apart: float) -> None:
    assert Rational(rtol=0.01).apart(one, other) == pytest.approx(apart, rel=1e-5)
    assert Rational().apart(one, other) == (math.inf if apart else 0)
    assert Rational(either=True).apart(4.0, 0.25) == 0


def test_a_text_is_kept_and_is_no_right_answer() -> None:
    judge = Text()
    verdict = judge.check(judge.parse("Prędkość rośnie.\r\nТак и должно быть.", NOTHING), "")
    assert (verdict.outcome, verdict.score) == (Outcome.UNDECIDED, 0)
    assert judge.echo(judge.parse(" a\r\nb ", NOTHING)).text == "a\nb"
    assert judge.apart("a", "b") == 0
    assert judge.show("") == "…"


def test_every_code_has_an_outcome_and_words_in_every_language() -> None:
    assert set(OUTCOMES) == set(Code)
    for lang in LANGUAGES:
        assert set(locale(lang)["codes"]) == {code.value for code in Code}
        assert set(locale(lang)["reasons"]) == {reason.value for reason in Reason}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_an_unreadable_answer_is_worded_with_its_place_and_proposal(lang: str) -> None:
    from graders.verdict import unreadable

    with pytest.raises(AnswerSyntaxError) as refused:
        parse("1 + ax", Symbols(["a", "x"]))
    text = message(unreadable(refused.value), lang)
    assert "5" in text and "a·x" in text and "{" not in text


@pytest.mark.parametrize(("lang", "shown"), [("pl", "±0,5 %"), ("en", "±0.5 %"), ("ru", "±0,5 %")])
def test_the_tolerance_at_a_field_is_made_from_its_rule(lang: str, shown: str) -> None:
    assert tolerance(Quantity("mm").describe(), lang) == shown
    assert "0,01\u202fmm" in tolerance(Quantity("mm", atol=1e-5).describe(), "pl")
    assert tolerance(Integer().describe(), lang) == ""
    assert tolerance(Rational().describe(), lang) == locale(lang)["tolerance"]["exact"]
    assert "0" in tolerance(Matrix(4, 4).describe(), lang)


def test_a_language_that_is_not_spoken_is_refused() -> None:
    with pytest.raises(KeyError):
        locale("de")


def test_outcomes_cover_what_a_student_is_told() -> None:
    assert set(OUTCOMES.values()) == set(Outcome)


@given(st.sampled_from([g for g, *_ in RIGHT]), st.text(max_size=30))
def test_no_text_makes_a_judge_fail(grader: Grader, text: str) -> None:
    reference = next(reference for judge, reference, _ in RIGHT if judge is grader)
    try:
        answer = grader.parse(text, SYMBOLS)
    except AnswerSyntaxError as refused:
        assert refused.position >= 0
    else:
        assert 0 <= grader.check(answer, reference).score <= 1


def test_an_echo_has_the_decimal_mark_of_the_reader() -> None:
    judge = Quantity("mm")
    answer = judge.parse("12.5", NOTHING)
    assert "<mn>12,5</mn>" in judge.echo(answer, comma=True).mathml
    assert "<mn>12.5</mn>" in judge.echo(answer).mathml


@pytest.mark.parametrize(
    ("unit", "atol", "shown"),
    [
        ("°", 0.1, "±0,5 %, co najmniej ±0,1°"),
        ("", 0.001, "±0,5 %, co najmniej ±0,001"),
        ("kN", 2.0, "±0,5 %, co najmniej ±2\u202fkN"),
    ],
)
def test_a_tolerance_is_printed_with_its_unit_as_a_number_is(unit: str, atol: float, shown: str) -> None:
    assert tolerance({"rtol": 0.005, "atol": atol, "unit": unit}, "pl") == shown
