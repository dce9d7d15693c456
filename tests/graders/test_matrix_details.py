"""What is told of a matrix beside right and wrong: slips, borders, scores, distances, places of what cannot be read.

Mutants of this judge that live on change nothing that can be seen:

* `<` for `<=`, or the opposite, where no number meets the border: of right, of a slip, of the least entry that is told;
* letters beside `0` and `.` that are taken off an end;
* a greatest number of 1e99 and one; the name of the type variable.
"""

from __future__ import annotations

from math import inf, pi

import pytest

from graders import AnswerSyntaxError, Code, Matrix, Symbols
from graders.common_slips import CommonSlip
from graders.judge import Matrix as Rows
from graders.kinds.matrix import ALL
from graders.language import Reason
from graders.verdict import RIGHT, Entries, Verdict

NOTHING = Symbols(())
SQUARE = Matrix(2, 2)
ROWS = ((1.0, 2.0), (3.0, 4.0))
SIGN, KILO, DEGREES = CommonSlip.OPPOSITE_SIGN, CommonSlip.KILO_PREFIX, CommonSlip.DEGREES_RADIANS
TURNED, EXCHANGED = CommonSlip.ROWS_FOR_COLUMNS, CommonSlip.EXCHANGED
POSE = ((0.8, -0.6, 0.0, 1.5), (0.6, 0.8, 0.0, 2.5), (0.0, 0.0, 1.0, 3.5), (0.0, 0.0, 0.0, 1.0))


def slips(text: str, reference: Rows = ROWS, judge: Matrix = SQUARE) -> frozenset[CommonSlip]:
    return judge.slips(judge.parse(text, NOTHING), reference)


def judged(text: str, reference: Rows = ROWS, judge: Matrix = SQUARE) -> Verdict:
    return judge.check(judge.parse(text, NOTHING), reference)


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("[[1; 3], [2; 4]]", {TURNED}),
        ("[[3; 4], [1; 2]]", {EXCHANGED}),
        ("[[2; 1], [3; 4]]", {EXCHANGED}),
        ("[[1; 2], [4; 3]]", {EXCHANGED}),
        ("[[2; 1], [4; 3]]", set()),
        ("[[1; 2], [4,01; 3]]", set()),
        ("[[1; 2], [4,007; 3]]", {EXCHANGED}),
        ("[[1; 3], [2,01; 4]]", set()),
        ("[[-1; 2], [3; -4]]", {SIGN}),
        ("[[1; 2], [3; 4000]]", {KILO}),
        ("[[-1; 2], [3; 4000]]", set()),
        ("[[1; 2], [3; -4,03]]", set()),
        ("[[1; 2], [3; 400]]", set()),
        ("[[57,2958; 2], [3; 4]]", set()),
        ("[[0; 2], [3; 4]]", set()),
        ("[[-1; -2]]", set()),
        ("[[-1], [-3]]", set()),
    ],
)
def test_one_slip_is_told_that_explains_each_entry_that_is_off(typed: str, found: set[CommonSlip]) -> None:
    assert slips(typed) == found


def test_an_entry_near_the_border_of_right_explains_nothing() -> None:
    assert slips("[[1; 2], [3; 4,007]]") == ALL


def test_rows_and_entries_far_apart_are_exchanged_too() -> None:
    rows = ((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0))
    judge = Matrix(3, 3)
    assert slips("[[7; 8; 9], [4; 5; 6], [1; 2; 3]]", rows, judge) == {EXCHANGED}
    assert slips("[[1; 2; 3], [6; 5; 4], [7; 8; 9]]", rows, judge) == {EXCHANGED}
    assert slips("[[1; 2; 3], [4; 5; 6], [7; 9; 8]]", rows, judge) == {EXCHANGED}
    assert slips("[[1; 4; 7], [2; 5; 8], [3; 6; 9]]", rows, judge) == {TURNED}


def test_the_rotation_of_a_pose_may_stand_with_rows_for_columns_alone() -> None:
    judge = Matrix(4, 4)
    assert slips("0,8 0,6 0 1,5\n-0,6 0,8 0 2,5\n0 0 1 3,5\n0 0 0 1", POSE, judge) == {TURNED}
    assert slips("0,8 0,6 0 0\n-0,6 0,8 0 0\n0 0 1 0\n1,5 2,5 3,5 1", POSE, judge) == {TURNED}
    assert slips("0,8 0,6 0 1,5\n-0,6 0,8 0 2,5\n0 0 1 3,5\n0 0 0 2", POSE, judge) == set()


def test_degrees_for_radians_are_told_in_a_column_of_angles_alone() -> None:
    judge = Matrix(1, 2, units=("deg", "mm"))
    reference = ((pi / 6, 0.45),)
    assert slips("[pi/6, 450]", reference, judge) == ALL
    assert slips("[0.5236, 450]", reference, judge) == {DEGREES}
    assert slips("[30, 7.854]", reference, judge) == set()
    assert slips("[450, 30]", reference, judge) == set()


def test_a_small_entry_is_off_by_a_slip_to_a_hundredth_at_most() -> None:
    assert slips("[[-0,0201; 1], [1; 1]]", ((0.02, 1.0), (1.0, 1.0))) == {SIGN}
    assert slips("[[-0,0203; 1], [1; 1]]", ((0.02, 1.0), (1.0, 1.0))) == set()
    assert slips("[[-0,01; 1], [1; 1]]", ((0.01, 1.0), (1.0, 1.0))) == set()


@pytest.mark.parametrize(
    ("typed", "code"),
    [("[1.002, 0]", Code.RIGHT), ("[1.003, 0]", Code.WRONG), ("[1, 0.003]", Code.WRONG), ("[1, 0.001]", Code.RIGHT)],
)
def test_the_border_of_right_is_within_the_tolerance(typed: str, code: Code) -> None:
    assert judged(typed, ((1.0, 0.0),)).code is code


def test_entries_that_are_off_are_counted_and_named() -> None:
    assert judged("[[1; 2], [3; 5]]") == Verdict(0.5, Code.SOME_ENTRIES, Entries(((2, 2),), 4))
    assert judged("[[1; 0], [3; 5]]") == Verdict(0.0, Code.WRONG, Entries(((1, 2), (2, 2)), 4))
    assert judged("[1, 2, 4]", ((1.0, 2.0, 3.0),)).details == Entries(((1, 3),), 3)
    assert judged("[[1; 2]]").code is judged("[[1], [3]]").code is Code.WRONG_SHAPE


def test_a_matrix_agrees_where_each_entry_does_on_its_own_scale() -> None:
    judge, reference = Matrix(1, 2), ((1000.0, 1.0),)
    typed = judge.parse("[1000, 1.01]", NOTHING)
    assert judge.check(typed, reference) is RIGHT and not judge.agrees(typed, reference)
    assert judge.agrees(judge.parse("[1001.5, 1.0015]", NOTHING), reference)
    assert not judge.agrees(judge.parse("[1003, 1]", NOTHING), reference)
    assert judge.agrees(judge.parse("[1000, 0.0015]", NOTHING), ((1000.0, 0.0),))
    assert not judge.agrees(judge.parse("[1000, 0.003]", NOTHING), ((1000.0, 0.0),))
    assert not judge.agrees(typed, ((1000.0,),))
    assert not judge.agrees(typed, ((1000.0, 1.0), (1000.0, 1.0)))


def test_distance_is_the_largest_difference_in_tolerances() -> None:
    assert SQUARE.apart(ROWS, ((1.0, 2.0), (3.0, 5.0))) == pytest.approx(1 / (0.002 * 5))
    assert SQUARE.apart(((1.0, 2.0), (3.0, 5.0)), ROWS) == pytest.approx(1 / (0.002 * 5))
    assert Matrix(1, 2).apart(((0.1, 0.2),), ((0.1, 0.5),)) == pytest.approx(0.3 / 0.002)
    assert SQUARE.apart(ROWS, ROWS[:1]) == SQUARE.apart(ROWS, ((1.0,), (3.0,))) == inf


def test_a_matrix_of_the_shape_asked_for_is_carried_on() -> None:
    judge = Matrix(1, 2)
    assert judge.carried(judge.parse("[1, 2]", NOTHING)) == ((1.0, 2.0),)
    assert judge.carried(judge.parse("[1, 2, 3]", NOTHING)) is None
    assert judge.carried(judge.parse("[[1; 2], [3; 4]]", NOTHING)) is None


def test_a_matrix_is_written_in_the_units_of_its_columns() -> None:
    judge = Matrix(1, 3, units=("deg", "mm"))
    assert judge.show(((pi / 6, 0.45, -1 / 3),)) == "[[30; 450; -0.33333333]]"
    assert Matrix(1, 3).show(((10.0, 0.5, 120.25),)) == "[[10; 0.5; 120.25]]"
    assert Matrix(1, 4).show(((4e-9, 6e-9, 20.0, -4e-9),)) == "[[0; 0.00000001; 20; 0]]"
    assert judge.check(judge.parse("[30, 450, -1/3]", NOTHING), ((pi / 6, 0.45, -1 / 3),)) is RIGHT
    assert judge.describe() == {"rows": 1, "columns": 3, "rtol": 0.002, "units": ["deg", "mm"]}
    assert SQUARE.describe() == {"rows": 2, "columns": 2, "rtol": 0.002}


def test_a_matrix_is_echoed_as_it_was_read() -> None:
    answer = Matrix(1, 1).parse("[[0.5]]", NOTHING)
    assert Matrix(1, 1).echo(answer).text == "[[0.5]]"
    assert "<mn>0.5</mn>" in Matrix(1, 1).echo(answer).mathml
    assert "<mn>0,5</mn>" in Matrix(1, 1).echo(answer, comma=True).mathml


@pytest.mark.parametrize(
    ("typed", "reason", "place", "found"),
    [
        ("[[1; b + a], [0; 1]]", Reason.NOT_A_NUMBER, 9, "a"),
        ("[[1; a + a], [a; 1]]", Reason.NOT_A_NUMBER, 5, "a"),
        ("[[1; α], [0; 1]]", Reason.NOT_A_NUMBER, 0, "alpha"),
        ("[[1; 2*(1/0) + 100000000000000], [0; 1]]", Reason.OUT_OF_RANGE, 0, "2*(1/0) + 1000000000"),
        ("[[1; 1e99*10000000000000000], [0; 1]]", Reason.OUT_OF_RANGE, 0, "1e99*100000000000000"),
        ("[[1; -1e99*2], [0; 1]]", Reason.OUT_OF_RANGE, 0, "-1e99*2"),
        ("  12345678901234567890123  ", Reason.WRONG_SHAPE, 0, "12345678901234567890"),
        ("[1, 2; 3, 4; 5, ]", Reason.MISSING_ENTRY, 16, "(3, 2)"),
        ("[[1; 2], [3; 4], [5; ]]", Reason.MISSING_ENTRY, 21, "(3, 2)"),
        ("[[1, 2, 3], [3, ]]", Reason.MISSING_ENTRY, 16, "(2, 2)"),
        (r"[\frac{1}{2}; ]", Reason.NEEDS_OPERAND, 14, "]"),
        ("[[1; zz], [0; 1]]", Reason.UNKNOWN_NAME, 5, "zz"),
        ("[[1; 2; ]]", Reason.MISSING_ENTRY, 8, "(1, 3)"),
        ("[[1; 2], [3; 4 +]]", Reason.MISSING_ENTRY, 16, "(2, 2)"),
    ],
)
def test_what_cannot_be_read_is_named_with_its_place(typed: str, reason: Reason, place: int, found: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        SQUARE.parse(typed, Symbols(["a", "b", "alpha"]))
    error = refused.value
    assert (error.reason, error.position, error.proposal.found) == (reason, place, found)


def test_the_greatest_number_may_be_an_entry() -> None:
    assert Matrix(1, 1).parse("[[1e99]]", NOTHING).rows == ((1e99,),)
