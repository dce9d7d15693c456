"""What is told of a diagram beside right and wrong: scores, powers of ten, echoes, tables, what is written.

Mutants of this judge that live on change nothing that can be seen:

* `None` for the empty table beside pieces; another span for a curve that names its own;
* another tolerance, or none, for a comparison of which only the pairs of stretches are used;
* pairs in which nothing is drawn, which no reference has.
"""

from __future__ import annotations

import pytest

from graders import Code, Diagram, Symbols
from graders.profile.stretches import Rows
from graders.remarks import Remark, Remarks, Slip
from graders.verdict import Verdict

NOTHING = Symbols(())
V: Rows = ((0, 1.5, 7500.0, -2000.0), (1.5, 4, -1500.0, -2000.0))
SHEAR, MILLIMETRES = Diagram("kN", "V"), Diagram("kN", "V", x_unit="mm")
FIRST, SECOND = "0..1,5: 7,5 - 2x", "1,5..4: -1,5 - 2*(x - 1,5)"


def judged(text: str, judge: Diagram = SHEAR, rows: Rows = V) -> Verdict:
    return judge.check(judge.parse(text, NOTHING), rows)


def test_marks_are_counted_and_the_score_is_that_beyond_a_diagram_left_at_zero() -> None:
    verdict = judged(f"{FIRST}; 1,5..4: -1,5 - 1,9*(x - 1,5)")
    assert verdict.code is Code.SOME_MARKS and isinstance(verdict.details, Remarks)
    assert (verdict.details.right, verdict.details.total) == (4, 8)
    assert verdict.score == round(verdict.score, 6) and 0.5 < verdict.score < 1
    whole = judged("0..4: 0")
    assert whole.code is Code.NO_MARKS and isinstance(whole.details, Remarks)
    assert (whole.score, whole.details.total) == (0, 8)


@pytest.mark.parametrize(
    ("factor", "code"),
    [
        ("10", Code.FACTOR_OF_TEN),
        ("1000", Code.FACTOR_OF_TEN),
        ("0,001", Code.FACTOR_OF_TEN),
        ("1e12", Code.FACTOR_OF_TEN),
        ("1e13", Code.SOME_MARKS),
        ("11", Code.SOME_MARKS),
        ("-1", Code.OPPOSITE_CONVENTION),
        ("-10", Code.SOME_MARKS),
    ],
)
def test_a_power_of_ten_is_told_up_to_the_twelfth(factor: str, code: Code) -> None:
    found = judged(f"0..1,5: {factor}*(7,5 - 2x); 1,5..4: {factor}*(-1,5 - 2*(x - 1,5))")
    assert found.code is code
    assert code is Code.SOME_MARKS or found.details is None


def test_a_diagram_is_written_in_the_units_of_places_and_ordinates() -> None:
    assert SHEAR.show(V) == "0 .. 1.5: 7.5 - 2*x\n1.5 .. 4: -1.5 - 2*(x - 1.5)"
    assert MILLIMETRES.show(V) == "0 .. 1500: 7.5 - 0.002*x\n1500 .. 4000: -1.5 - 0.002*(x - 1500)"
    assert SHEAR.show(((0, 3, 1000 / 3, 0.0, 2000.0),)) == "0 .. 3: 0.3333333333 + 2*x^2"
    assert SHEAR.show(((-1.5, 0, 0.0, 1000.0),)) == "-1.5 .. 0: 1*(x + 1.5)"
    assert SHEAR.show(((0, 3, 0.0, 0.0),)) == "0 .. 3: 0"


def test_what_stays_below_rounding_all_along_a_stretch_is_not_written() -> None:
    """A coefficient counts by its ordinate at the end of the stretch."""
    assert SHEAR.show(((0, 0.1, 7500.0, 0.0, 1e-8),)) == "0 .. 0.1: 7.5"
    assert SHEAR.show(((0, 10.0, 7500.0, 0.0, 1e-9),)) == "0 .. 10: 7.5 + 1e-12*x^2"


def test_pieces_are_echoed_with_their_ranges_in_the_printed_unit() -> None:
    answer = MILLIMETRES.parse("0..1500: 7,5; 1500..4000: 2", NOTHING)
    assert MILLIMETRES.echo(answer).text == "0 .. 1500: 7.5; 1500 .. 4000: 2"
    assert "<mn>7.5</mn>" in MILLIMETRES.echo(answer).mathml
    assert "<mn>7,5</mn>" in MILLIMETRES.echo(answer, comma=True).mathml
    assert SHEAR.echo(SHEAR.parse("7,5 - 6*<x - 2>^0", NOTHING)).text == "7.5 - 6*<x - 2>^0"


def test_a_curve_is_laid_out_as_a_table_in_the_printed_units() -> None:
    typed = MILLIMETRES.parse("0..1500: 7,5; 1500..4000: 2", NOTHING)
    rows = [[0.0, 7.5, None, None], [1500.0, 7.5, 2.0, None], [4000.0, 2.0, None, None]]
    assert MILLIMETRES.rows(typed, None) == rows
    assert SHEAR.rows(SHEAR.parse("7 - x", NOTHING), None) is None
    assert SHEAR.rows(SHEAR.parse("7 - x", NOTHING), 2.0) == [[0.0, 7.0, None, None], [2.0, 5.0, None, None]]


def test_a_table_names_its_own_span() -> None:
    table = SHEAR.parse("0; 7; 7\n2; 5; 3\n3; 3; 3", NOTHING)
    assert SHEAR.carried(table) == ((0.0, 2.0, 7000.0, -1000.0, 0.0), (2.0, 3.0, 3000.0, 0.0, 0.0))
    assert SHEAR.rows(table, None) == [[0.0, 7.0, None, None], [2.0, 5.0, 3.0, None], [3.0, 3.0, None, None]]


def test_distance_is_the_largest_difference_over_the_larger_diagram() -> None:
    one, other = ((0.0, 2.0, 100.0),), ((0.0, 2.0, 100.0, 50.0),)
    assert SHEAR.apart(one, other) == SHEAR.apart(other, one) == pytest.approx(100 / (0.01 * 200))
    assert SHEAR.apart(one, ((0.0, 1.0, 100.0), (1.0, 2.0, 100.0))) == 0


def test_a_place_is_told_in_the_printed_unit() -> None:
    details = judged("0..1500: 7,5 - 0,002x", MILLIMETRES).details
    assert isinstance(details, Remarks)
    assert details.found[0] == Remark(Slip.GAP, 1500.0, 4000.0, unit="mm")


STRETCHES = (FIRST, "1,5..3: -1,5 - 2*(x - 1,5)", "3..4: -4,5 - 2*(x - 3)")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("; ".join(STRETCHES[:2]), Remark(Slip.GAP, 3.0, 4.0)),
        ("; ".join(STRETCHES[1:]), Remark(Slip.GAP, 0.0, 1.5)),
        ("; ".join(STRETCHES[::2]), Remark(Slip.GAP, 1.5, 3.0)),
        ("; ".join((*STRETCHES, "3,5..4: 1")), Remark(Slip.OVERLAP, 3.5, 4.0)),
        ("; ".join((*STRETCHES[:2], "3..5: -4,5 - 2*(x - 3)")), Remark(Slip.BEYOND, 4.0, 5.0)),
        ("; ".join(("-1..0: 3", *STRETCHES)), Remark(Slip.BEYOND, -1.0, 0.0)),
        (f"{FIRST}; 1,5..4: 4,5 - 2*(x - 1,5)", Remark(Slip.LOST_JUMP, 1.5)),
        (f"{FIRST}; 1,5..4: 10,5 - 2*(x - 1,5)", Remark(Slip.OPPOSITE_JUMP, 1.5)),
        (f"{FIRST}; 1,5..4: -2,5 - 2*(x - 1,5)", Remark(Slip.JUMP, 1.5)),
        ("; ".join((*STRETCHES[:2], "3..4: -6 - 2*(x - 3)")), Remark(Slip.EXTRA_JUMP, 3.0)),
        (f"{FIRST}; 1,5..4: -1,5 - (x - 1,5)", Remark(Slip.SLOPE, 1.5, 4.0)),
        (f"{FIRST}; 1,5..4: -1,5 + 2*(x - 1,5)", Remark(Slip.OPPOSITE_SLOPE, 1.5, 4.0)),
        (f"{FIRST}; 1,5..4: -1,5", Remark(Slip.DEGREE, 1.5, 4.0)),
        (f"{FIRST}; 1,5..4: -1,5 - 2*(x - 1,5) - (x - 1,5)^2", Remark(Slip.BENT, 1.5, 4.0)),
    ],
)
def test_what_is_off_is_told_with_its_place(text: str, found: Remark) -> None:
    details = judged(text).details
    assert isinstance(details, Remarks)
    told = {remark.slip: remark for remark in details.found}
    assert told[found.slip] == Remark(found.slip, found.place, found.until, unit="m")


def test_every_mark_tells_of_a_stretch_that_is_not_drawn() -> None:
    details = judged(FIRST).details
    assert isinstance(details, Remarks)
    gap = [Remark(slip, 1.5, 4.0, unit="m") for slip in (Slip.GAP, Slip.SLOPE, Slip.DEGREE, Slip.GAP)]
    assert [remark for remark in details.found if remark.until == 4.0] == gap
    first = judged("; ".join(STRETCHES[::2])).details
    assert isinstance(first, Remarks) and first.found[0] == Remark(Slip.GAP, 1.5, 3.0, unit="m")


def test_a_slope_that_is_right_at_one_end_alone_is_off() -> None:
    bent: Rows = ((0.0, 2.0, 0.0, 4000.0, -1000.0),)
    details = judged("2,5*x - 0,25*x^2", SHEAR, bent).details
    assert isinstance(details, Remarks)
    assert Remark(Slip.SLOPE, 0.0, 2.0, unit="m") in details.found
    turned = judged("4*x - 2*x^2", SHEAR, bent).details
    assert isinstance(turned, Remarks)
    assert Remark(Slip.SLOPE, 0.0, 2.0, unit="m") in turned.found


def test_the_field_says_what_is_drawn() -> None:
    assert MILLIMETRES.describe() == {"unit": "kN", "x_unit": "mm", "quantity": "V", "largest": 0.01}
