"""Diagrams: what is read, what each mark finds, what earns nothing."""

from __future__ import annotations

import json
from functools import partial
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Code, Diagram, Symbols
from graders.language import Reason
from graders.profile.polynomial import crossings, derivative, shifted, value
from graders.profile.stretches import Rows, Stretch, highest, profile_of, rows_of
from graders.remarks import Remarks, Slip
from graders.verdict import Verdict
from graders.words import LANGUAGES, message, tolerance
from tests.depth import amount
from tests.graders.effort import effort

NOTHING = Symbols(())
# L = 4 m, q = 2 kN/m all over, 6 kN at 1.5 m, 1 kN m clockwise at 3 m: R_A = 7.5 kN (domain SM-11)
M: Rows = ((0, 1.5, 0.0, 7500.0, -1000.0), (1.5, 3, 9000.0, -1500.0, -1000.0), (3, 4, 5500.0, -4500.0, -1000.0))
V: Rows = ((0, 1.5, 7500.0, -2000.0), (1.5, 4, -1500.0, -2000.0))
MOMENT, SHEAR = Diagram("kN*m", "M"), Diagram("kN", "V")
FIRST, SECOND, THIRD = "0..1,5: 7,5*x - x^2", "1,5..3: 9 - 1,5*(x-1,5) - (x-1,5)^2", "3..4: 5,5 - 4,5*(x-3) - (x-3)^2"


def judged(text: str, judge: Diagram = MOMENT, rows: Rows = M) -> Verdict:
    return judge.check(judge.parse(text, NOTHING), rows)


def slips(text: str, judge: Diagram = MOMENT, rows: Rows = M) -> set[Slip]:
    details = judged(text, judge, rows).details
    assert isinstance(details, Remarks)
    return {remark.slip for remark in details.found}


@pytest.mark.parametrize(("judge", "rows"), [(MOMENT, M), (SHEAR, V)])
def test_a_diagram_passes_its_own_samples(judge: Diagram, rows: Rows) -> None:
    samples = judge.samples(rows)
    assert {judged(text, judge, rows).code for text in (*samples.right, judge.show(rows))} == {Code.RIGHT}
    assert all(judged(text, judge, rows).code is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            judge.parse(text, NOTHING)


@pytest.mark.parametrize(
    "text",
    [
        f"{FIRST}; {SECOND}; {THIRD}",
        f"{THIRD}\n{SECOND}\n{FIRST}",
        f"M =\n{FIRST}\n{SECOND}\n{THIRD}",
        f"- {FIRST}\n- {SECOND}\n- {THIRD}.",
        f"• {FIRST}\n• {SECOND}\n• {THIRD}",
        "7,5*x - x^2 - 6<x-1,5> + <x-3>^0",
        "M(x) = 7.5x - x² - 6<x - 1.5>^1 + 1*<x-3>^0",
        "7500*x - 1000*x^2 - 6000<x-1.5> + 1000<x-3>^0 N*m",
        f"0 .. 0,7: 7,5*x - x^2; 0,7 .. 1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0 <= x <= 1,5: 7,5x - x^2\n3 >= x >= 1,5: 9 - 1,5*(x-1,5) - (x-1,5)^2\n{THIRD}",
        f"<0; 1,5>: 7,5x - x^2; x ∈ (1,5; 3): 9 - 1,5*(x-1,5) - (x-1,5)^2; {THIRD}",
        f"0 – 1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0 ÷ 1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0÷1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"x = 0 ÷ 1,5 m: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0-1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0-1,5 m: 7,5x - x^2; {SECOND}; {THIRD}",
        f"0 do 1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"od 0 do 1,5 m: 7,5x - x^2; {SECOND}; {THIRD}",
        f"для x от 0 до 1,5: 7,5x - x^2; {SECOND}; {THIRD}",
        f"From 0 to 1.5: 7.5x - x^2; {SECOND}; {THIRD}",
        f"0 to 1500 mm: 7.5e-3*x - 1e-6*x^2 kN*m; {SECOND}; {THIRD}",
        f"0 .. 1500 mm: 7.5e-3*x - 1e-6*x^2 kN*m; {SECOND}; {THIRD}",
        f"0..1,501: 7,5x - x^2; 1,501..3: 9 - 1,5*(x-1,5) - (x-1,5)^2; {THIRD}",
        f"0 .. 1,5: 7500*x - 1000*x^2 [N·m]; {SECOND}; {THIRD}",
        f"{FIRST}; {SECOND}; 3..4: 5,53 - 4,5*(x-3) - (x-3)^2",
        "x; left; right; middle\n0; -; 0; 5,0625\n1,5; 9; 9; 7,3125\n3; 4,5; 5,5; 3\n4; 0; -",
        "| 0 | 0 | 0 | 5.0625 |\n| 1.5 | 9 | 9 | 7.3125 |\n| 3 | 4.5 | 5.5 | 3 |\n| 4 | 0 | 0 |",
    ],
)
def test_a_diagram_is_read_however_it_is_written(text: str) -> None:
    assert judged(text).code is Code.RIGHT


@pytest.mark.parametrize(
    "text",
    [
        "0..1,5: 7,5 - 2x; 1,5..4: -1,5 - 2*(x - 1,5)",
        "0; 0; 7,5\n1,5; 4,5; -1,5\n4; -6,5",
        "0\t0\t7.5\n1.5\t4.5\t-1.5\n4\t-6.5\t0",
    ],
)
def test_straight_lines_may_be_given_as_a_table(text: str) -> None:
    assert judged(text, SHEAR, V).code is Code.RIGHT


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (f"{FIRST}; {SECOND}", {Slip.GAP, Slip.LOST_JUMP}),
        (f"{FIRST}; {SECOND}; {THIRD}; 3,5..4: 1", {Slip.OVERLAP}),
        (f"{FIRST}; {SECOND}; 3..5: 5,5 - 4,5*(x-3) - (x-3)^2", {Slip.BEYOND}),
        (f"-1..0: 3; {FIRST}; {SECOND}; {THIRD}", {Slip.BEYOND}),
        (f"{FIRST}; {SECOND}; 3..4: 4,5 - 4,5*(x-3) - (x-3)^2", {Slip.LOST_JUMP, Slip.ORDINATE, Slip.OPEN_END}),
        (f"{FIRST}; {SECOND}; 3..4: 3,5 - 3,5*(x-3)", {Slip.OPPOSITE_JUMP, Slip.STRAIGHT}),
        (f"{FIRST}; {SECOND}; 3..4: 7 - 6*(x-3) - (x-3)^2", {Slip.JUMP}),
        (f"{FIRST}; 1,5..3: 8 - (x-1,5)^2; {THIRD}", {Slip.EXTRA_JUMP}),
        (f"0..1,5: 6*x; {SECOND}; {THIRD}", {Slip.STRAIGHT, Slip.SLOPE}),
        (f"{FIRST}; {SECOND}; 3..4: 5,5 - 4,5*(x-3) - (x-3)^2 + 9*(x-3)^3", {Slip.BENT}),
    ],
)
def test_what_is_off_in_a_moment_diagram_is_named(text: str, found: set[Slip]) -> None:
    assert found <= slips(text)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("0..1,5: 7,5 + 2x; 1,5..4: -1,5 - 2*(x - 1,5)", Slip.OPPOSITE_SLOPE),
        ("0..1,5: 6; 1,5..4: -1,5 - 2*(x - 1,5)", Slip.DEGREE),
        ("0..4: 7,5 - 3,5x", Slip.ZERO),
        ("0..1,5: 7,5 - 2x; 1,5..4: -1,5 - (x - 1,5)", Slip.EXTREME),
    ],
)
def test_what_is_off_in_a_shear_diagram_is_named(text: str, found: Slip) -> None:
    assert found in slips(text, SHEAR, V)


@pytest.mark.parametrize(
    "text",
    [
        f"{FIRST}; {SECOND}; 3..4: 5,5 - 9*(x-3)^2",
        f"{FIRST}; {SECOND}; 3..4: 5,5 + (x-3)^2",
        f"0..1,5: 6*x - 3*x^2; {SECOND}; {THIRD}",
    ],
)
def test_a_curve_bent_too_much_or_the_other_way_is_not_said_to_be_of_another_degree(text: str) -> None:
    assert not slips(text) & {Slip.DEGREE, Slip.BENT, Slip.STRAIGHT} and Slip.ORDINATE in slips(text)


@pytest.mark.parametrize("slope", ["-2,2", "+2", "-9"])
def test_a_straight_line_of_a_wrong_slope_is_not_said_to_be_of_another_degree(slope: str) -> None:
    found = slips(f"0..1,5: 7,5 - 2x; 1,5..4: -1,5 {slope}*(x - 1,5)", SHEAR, V)
    assert Slip.DEGREE not in found and Slip.ORDINATE in found


def test_places_are_named_in_the_printed_unit_and_in_every_language() -> None:
    verdict = judged(f"{FIRST}; {SECOND}; 3..4: 4,5 - 4,5*(x-3) - (x-3)^2")
    assert verdict.code is Code.SOME_MARKS and 0.3 < verdict.score < 0.7
    assert "3\u202fm" in message(verdict, "pl") and "skoku" in message(verdict, "pl")
    assert all("{" not in message(verdict, lang) for lang in LANGUAGES)
    inches = Diagram("kN*m", x_unit="mm")
    details = inches.check(inches.parse("0..4000: 1", NOTHING), M).details
    assert isinstance(details, Remarks) and details.found[0].place == pytest.approx(3000)


def test_a_diagram_of_the_opposite_convention_is_recognised() -> None:
    verdict = judged("-(7,5*x - x^2 - 6<x-1,5> + <x-3>^0)")
    assert (verdict.code, verdict.score) == (Code.OPPOSITE_CONVENTION, 0.5)
    strict = Diagram("kN*m", opposite_credit=0.0)
    assert judged("-(7,5*x - x^2 - 6<x-1,5> + <x-3>^0)", strict).score == 0


@pytest.mark.parametrize("text", ["1/<-pi>^1", "x + 1/<-2>^1", "ctg(<-3>^1)", "0 .. 4: ln(<-1>^2)"])
def test_a_formula_without_a_value_where_its_bracket_is_closed_is_wrong_and_not_carried(text: str) -> None:
    assert judged(text).code is Code.UNDEFINED
    assert MOMENT.carried(MOMENT.parse(text, NOTHING)) is None


def test_newtons_for_kilonewtons_are_recognised() -> None:
    assert judged("7500*x - 1000*x^2 - 6000<x-1.5> + 1000<x-3>^0").code is Code.FACTOR_OF_TEN


@pytest.mark.parametrize("text", ["0", "5", "x", "0..4: 0", "0..2: 5; 2..4: -5", "0..1: 7,5x"])
def test_what_says_nothing_earns_nothing(text: str) -> None:
    assert judged(text).score == 0


@pytest.mark.parametrize(
    ("text", "reason", "place"),
    [
        ("", Reason.EMPTY, 0),
        ("0 .. 2", Reason.NEEDS_RANGE, 0),
        ("0..1: x; 5", Reason.NEEDS_RANGE, 9),
        ("2..1: x", Reason.NEEDS_RANGE, 0),
        ("0..1: x +", Reason.NEEDS_OPERAND, 9),
        ("0..1:", Reason.NEEDS_OPERAND, 5),
        ("0..1: sin(x)", Reason.NOT_A_POLYNOMIAL, 6),
        ("1/x", Reason.NOT_A_POLYNOMIAL, 0),
        ("x^0.5", Reason.NOT_A_POLYNOMIAL, 0),
        ("x^7", Reason.NOT_A_POLYNOMIAL, 0),
        ("x^4*x^4", Reason.NOT_A_POLYNOMIAL, 0),
        ("<x^2 - 1>^1", Reason.NOT_A_POLYNOMIAL, 0),
        ("<x-1>^-1", Reason.NOT_A_POLYNOMIAL, 0),
        ("2^x", Reason.NOT_A_POLYNOMIAL, 0),
        ("x = 1 = 2", Reason.NOT_AN_EXPRESSION, 4),
        ("+".join(f"<x-{k}>^1" for k in range(41)), Reason.TOO_LONG, 0),
        ("+".join(["1"] * 900), Reason.TOO_LONG, 402),
        ("M .. =", Reason.NEEDS_RANGE, 0),
        ("0..1e300: x", Reason.OUT_OF_RANGE, 3),
        ("2 .. : x; 1", Reason.NEEDS_RANGE, 0),
        ("0 <= x: 5; 3", Reason.NEEDS_RANGE, 0),
        ("(1; ): 5; 3", Reason.NEEDS_RANGE, 0),
        ("from to 1: 5; 3", Reason.NEEDS_RANGE, 0),
        ("0 do 1 do 2: 5; 3", Reason.NEEDS_RANGE, 0),
        ("0..1: x kN kN", Reason.UNKNOWN_NAME, 8),
        ("0..1: 0*1e999*x", Reason.NOT_A_POLYNOMIAL, 6),
        ("1e98*x*1e98", Reason.NOT_A_POLYNOMIAL, 0),
        ("0; 1; 2\n1e-200; 1; 2", Reason.NEEDS_RANGE, 8),
        ("0; 1; 2\n1; 1e40; 2", Reason.OUT_OF_RANGE, 0),
        ("\n".join(f"{k}; 1; 2" for k in range(50)), Reason.TOO_LONG, 0),
        ("0; 1\n" + "1" * 6000, Reason.TOO_LONG, 6000),
        ("pi + F1", Reason.UNKNOWN_NAME, 5),
        ("1/0", Reason.OUT_OF_RANGE, 0),
        ("9^9^9", Reason.OUT_OF_RANGE, 0),
        ("[[1; 2]]", Reason.NOT_A_POLYNOMIAL, 0),
        ("0..3 kN: x", Reason.UNKNOWN_UNIT, 3),
        ("0..1: " + "1" * 6000, Reason.TOO_LONG, 6000),
        ("; ".join(f"{k}..{k + 1}: x" for k in range(41)), Reason.TOO_LONG, 430),
        ("0; 1; 2\n0; 1; 2", Reason.NEEDS_RANGE, 8),
        ("0; 1; 2; 3; 4\n1; 1; 2", Reason.RAGGED_MATRIX, 0),
        ("0; 1; a\n1; 1; 2", Reason.NOT_A_NUMBER, 6),
        ("x; y\n0; 1", Reason.NEEDS_RANGE, 0),
    ],
)
def test_what_is_no_diagram_is_refused_with_its_place(text: str, reason: Reason, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        MOMENT.parse(text, NOTHING)
    assert refused.value.reason is reason
    assert reason in (Reason.UNKNOWN_UNIT, Reason.TOO_LONG) or refused.value.position == place


def test_a_diagram_is_echoed_piece_by_piece_and_described() -> None:
    answer = MOMENT.parse(f"{FIRST}; {SECOND}", NOTHING)
    echo = MOMENT.echo(answer, comma=True)
    assert echo.text.startswith("0 .. 1.5: 7.5*x - x^2; 1.5 .. 3: ")
    assert echo.mathml.count("<mtr>") == 2 and "0 … 1,5" in echo.mathml and echo.unit == "kN*m"
    assert MOMENT.echo(MOMENT.parse("7*x", NOTHING)).mathml == "<math>" + echo_inner("7*x") + "</math>"
    table = MOMENT.echo(MOMENT.parse("0; 0; 7\n1,5; 2", NOTHING), comma=True)
    assert table.text == "0 .. 1.5: 7 - 3.33333*x"
    assert table.mathml == MOMENT.echo(MOMENT.parse("0 .. 1.5: 7 - 3.33333*x", NOTHING), comma=True).mathml
    assert "3,33333" in table.mathml and "0 … 1,5" in table.mathml
    assert json.loads(json.dumps(MOMENT.describe())) == MOMENT.describe()
    assert tolerance(MOMENT.describe(), "pl") == "±1 % największej wartości"


def test_what_is_left_over_from_adding_up_loads_is_not_written() -> None:
    rows = ((0, 2, 7500.0, 0.0), (2, 3, -1.8e-12, 9.1e-13))
    assert SHEAR.show(rows) == "0 .. 2: 7.5\n2 .. 3: 0"
    assert SHEAR.show(((0, 2, 7500.0, 0.0), (2, 3, 0.0, 0.001))) == "0 .. 2: 7.5\n2 .. 3: 1e-06*(x - 2)"


def echo_inner(text: str) -> str:
    whole = MOMENT.echo(MOMENT.parse(text, NOTHING)).mathml
    return whole.removeprefix("<math>").removesuffix("</math>")


def test_a_diagram_with_ranges_can_be_carried_and_one_without_cannot() -> None:
    carried = MOMENT.carried(MOMENT.parse(f"{FIRST}; {SECOND}; {THIRD}", NOTHING))
    assert carried is not None and MOMENT.apart(carried, M) < 1e-9
    assert MOMENT.carried(MOMENT.parse("7*x", NOTHING)) is None


def test_diagrams_lie_apart_by_their_largest_difference_in_tolerances() -> None:
    off = rows_of(one.scaled(1.05) for one in profile_of(M))
    assert MOMENT.apart(M, M) == 0
    assert MOMENT.apart(M, off) == pytest.approx(0.05 / 1.05 / 0.01, rel=1e-6)
    assert MOMENT.apart(M, ((0, 3, 1.0),)) == float("inf")
    assert MOMENT.apart(((0, 3, 0.0),), ((0, 3, 0.0),)) == 0


def as_table(text: str, judge: Diagram = MOMENT, span: float | None = None) -> str | None:
    rows = judge.rows(judge.parse(text, NOTHING), span)
    return (
        None
        if rows is None
        else "\n".join("; ".join("" if cell is None else f"{cell:.10g}" for cell in row) for row in rows)
    )


@pytest.mark.parametrize(("judge", "rows"), [(MOMENT, M), (SHEAR, V)])
def test_a_diagram_typed_in_pieces_is_the_same_as_its_table(judge: Diagram, rows: Rows) -> None:
    table = as_table(judge.show(rows), judge)
    assert table is not None and judged(table, judge, rows).code is Code.RIGHT
    assert as_table(table, judge) == table


def test_a_table_says_only_where_the_curve_jumps_and_bends() -> None:
    assert as_table("0 .. 1500 mm: 2 kN*m; 1500 mm .. 4000 mm: 1") == "0; 2; ; \n1.5; 2; 1; \n4; 1; ; "
    assert as_table("0 .. 2: x^2; 2 .. 4: 4") == "0; 0; ; 1\n2; 4; ; \n4; 4; ; "
    assert as_table("7.5*x - 6*<x - 1.5>^1", span=4.0) == "0; 0; ; \n1.5; 11.25; ; \n4; 15; ; "


@pytest.mark.parametrize("text", ["0 .. 1: 4; 2 .. 3: 1", "0 .. 2: x^3", "7*x", "0 .. 2: 1/<x - 3>^0"])
def test_a_curve_that_no_table_holds_has_none(text: str) -> None:
    assert as_table(text) is None


numbers = st.floats(-9, 9).map(lambda x: round(x, 3))


@settings(max_examples=amount(13, 40), deadline=None)
@given(st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=5))
def test_every_diagram_is_right_as_it_is_shown_and_not_right_when_moved(found: list[tuple[float, ...]]) -> None:
    rows = tuple((float(k), float(k + 1), *(1e3 * c for c in curve)) for k, curve in enumerate(found))
    if highest(profile_of(rows)) < 1:
        return
    assert judged(MOMENT.show(rows), MOMENT, rows).code is Code.RIGHT
    by = 0.02 * highest(profile_of(rows))
    moved = rows_of(Stretch(one.start, one.end, (one.curve[0] + by, *one.curve[1:])) for one in profile_of(rows))
    assert judged(MOMENT.show(moved), MOMENT, rows).code is not Code.RIGHT


@given(st.lists(numbers, min_size=1, max_size=5), numbers, numbers)
def test_a_shifted_polynomial_has_the_same_values(p: list[float], by: float, t: float) -> None:
    assert value(shifted(tuple(p), by), t) == pytest.approx(value(tuple(p), t + by), rel=1e-9, abs=1e-6)


@given(st.lists(st.floats(-5, 5), min_size=1, max_size=3, unique=True))
def test_changes_of_sign_are_found_where_the_factors_vanish(roots: list[float]) -> None:
    roots = sorted(roots)
    if any(b - a < 1e-2 for a, b in pairwise(roots)):
        return
    p: tuple[float, ...] = (1.0,)
    for root in roots:
        p = tuple(a - root * b for a, b in zip((0.0, *p), (*p, 0.0), strict=True))
    assert crossings(p, -6, 6) == pytest.approx(roots, abs=1e-6)
    assert derivative((3.0,)) == (0.0,)


def test_constants_of_the_language_are_numbers_here() -> None:
    first, second = "0..1,5: (3*2,5)*x - x^(2)", "1,5..3: 9 - 2*sin(30°)*1,5*(x-1,5)^1 - (x-1,5)^2/1"
    third = "3..4: 11/2 - 4,5*(x-3) + -(x-3)^2*2^0"
    assert judged(f"{first}; {second}; {third}").code is Code.RIGHT


def test_a_reference_of_zero_knows_only_zero() -> None:
    flat: Rows = ((0.0, 4.0, 0.0),)
    assert judged("0", MOMENT, flat).code is Code.RIGHT
    assert judged("1", MOMENT, flat).score == 0


def test_the_longest_diagram_is_judged_in_time() -> None:
    texts = [
        "; ".join(f"{k}/10 .. {k + 1}/10: " + "+".join(["<x-1>^3"] * 12) for k in range(40)),
        "+".join(f"<x - {k}/12>^6" for k in range(1, 41)),
        "((((x+1)^2+1)^1+1)^3)" + "*(x-1)^0" * 100,
    ]
    for text in texts:
        assert judged(text).score < 0.05  # some pieces are curved where they should be
        assert effort(partial(judged, text), enough=1.0) < 1.0  # tens of milliseconds on a free core
