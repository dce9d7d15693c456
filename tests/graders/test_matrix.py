"""A matrix whose columns have units, such as a Denavit-Hartenberg table."""

from __future__ import annotations

from math import pi

import pytest

from graders import AnswerSyntaxError, Code, Matrix, Quantity, Symbols
from graders.language import Reason
from graders.verdict import Entries

NOTHING = Symbols(())
TABLE = Matrix(2, 2, units=("deg", "mm"))
ROWS = ((pi / 6, 0.45), (-pi / 4, 0.0))


def judged(text: str) -> Code:
    return TABLE.check(TABLE.parse(text, NOTHING), ROWS).code


@pytest.mark.parametrize(
    "typed",
    [
        "[[30; 450], [-45; 0]]",
        "[[30°; 450], [-45°; 0]]",
        "[[390; 9*50], [315°; 0]]",
        "[[asin(0,5)*180/pi; 450], [-45; 0]]",
        "[[pi/6; 450], [-pi/4; 0]]",
    ],
)
def test_a_bare_number_is_read_in_the_unit_of_its_column(typed: str) -> None:
    assert judged(typed) is Code.RIGHT


@pytest.mark.parametrize("typed", ["[[30*pi; 450], [-45; 0]]", "[[30; 0.45], [-45; 0]]", "[[30; 450], [45; 0]]"])
def test_a_number_in_another_unit_or_of_another_sign_is_not_right(typed: str) -> None:
    assert judged(typed) is not Code.RIGHT


@pytest.mark.parametrize(
    "typed",
    [
        "30 450\n-45 0",
        "30\t450\n-45\t0\n",
        "30; 450\n-45; 0",
        "30, 450\n-45, 0",
        "| 30 | 450 |\n| -45 | 0 |",
        "[30 450; -45 0]",
        "[[30 450]; [-45 0]]",
        "P = [30° 900/2; -45° 0]",
        "30,0 450,0\n-45,0 0,0",
        "[ 30  450 ]\n[ -45  0 ]",
    ],
)
def test_rows_need_no_brackets_and_entries_no_semicolons(typed: str) -> None:
    assert judged(typed) is Code.RIGHT


@pytest.mark.parametrize(
    "typed",
    [
        "\\frac{60}{2} 450\n-45 0",
        "\\frac{60}{2}; 450\n-45; 0",
        "\\frac{60}{2}\t450\n-45\t0",
        "P = [\\frac{60}{2} 450; -45 0]",
        "\\frac{60}{2} & 450 \\\\ -45 & 0",
        "P=\\left[\\frac{60}{2} & 450\\\\-45 & 0\\right]",
        "30^\\circ\\quad 450\\\\ -45^\\circ\\; 0",
        "30{,}0 450\n-45 0",
        "$30{,}0 & 450 \\\\ -45 & 0$",
    ],
)
def test_rows_without_brackets_may_hold_latex(typed: str) -> None:
    assert judged(typed) is Code.RIGHT


@pytest.mark.parametrize("typed", ["(30) (450)\n(-45) (0)", "30 cos(0)*450\n-45 sin(0)"])
def test_lines_that_could_be_factors_are_rows(typed: str) -> None:
    assert judged(typed) is Code.RIGHT


@pytest.mark.parametrize(
    ("typed", "place"), [("30 450\n-45", 3), ("[30 450; -45 x]", 4), ("1 2 3", 2), ("[30 - 450; 1 0]", 13)]
)
def test_what_is_no_table_of_numbers_is_refused_where_it_was_typed(typed: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        TABLE.parse(typed, NOTHING)
    assert refused.value.position == place


@pytest.mark.parametrize(
    ("typed", "place", "entry"),
    [
        ("[[30; 450], [-45; ]]", 18, "(2, 2)"),
        ("[[; 450], [-45; 0]]", 2, "(1, 1)"),
        ("[[0,5; ], [; ]]", 7, "(1, 2)"),
        ("[[30, 450], [, 0]]", 13, "(2, 1)"),
        ("[30; ; 5]", 5, "(2, 1)"),
    ],
)
def test_an_empty_entry_is_told_by_row_and_column(typed: str, place: int, entry: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        TABLE.parse(typed, NOTHING)
    error = refused.value
    assert (error.reason, error.position, error.proposal.found) == (Reason.MISSING_ENTRY, place, entry)


def test_a_degree_sign_changes_nothing_in_a_column_of_lengths() -> None:
    assert judged("[[30; 900*sin(30°)], [-45; 0]]") is Code.RIGHT


def test_a_matrix_with_units_passes_its_own_samples_and_names_its_units() -> None:
    samples = TABLE.samples(ROWS)
    assert {judged(text) for text in samples.right} == {Code.RIGHT}
    assert Code.RIGHT not in {judged(text) for text in samples.wrong}
    assert TABLE.describe()["units"] == ["deg", "mm"]
    assert TABLE.apart(ROWS, ((pi / 6 + 2 * pi, 0.45), (-pi / 4, 0.0))) == pytest.approx(0, abs=1e-9)


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


@pytest.mark.parametrize("text", ["[1, 2; 3, 4] - 4,2 mm", "4,2 + [1, 2; 3, 4]", "pi[1; 2]", "[1, 2; 3, 4]^2 + 1"])
def test_a_matrix_beside_a_number_is_no_quantity(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Quantity("mm").parse(text, Symbols(()))


def test_a_number_that_is_asked_for_an_entry_is_unreadable() -> None:
    with pytest.raises(AnswerSyntaxError):
        Matrix(2, 1).parse("[pi[1; 2]; 2]", Symbols(()))


MEASURED = Matrix(1, 3, units=("deg", "mm", "kN*m"))


@pytest.mark.parametrize(
    "text",
    ["[30°, 1500 mm, 12 kN*m]", "[30, 1.5 m, 12 kN·m]", "[[30 deg; 150 cm; 12000 N*m]]", "[[30; 1500; 12]]",
     "[[0,5235987755982988 rad; 3/2 m; 12 kNm]]", "[[30; 1,5 м; 12 кН·м]]", "[[30; 1500; -(-12) kN*m^2/m]]"],
)  # fmt: skip
def test_an_entry_may_say_its_unit(text: str) -> None:
    assert MEASURED.parse(text, Symbols(())).rows[0] == pytest.approx((pi / 6, 1.5, 12e3))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("[[30; 1,5 kN; 12]]", Reason.OTHER_UNIT),
        ("[[30 m; 1500; 12]]", Reason.OTHER_UNIT),
        ("[[30; m; 12]]", Reason.NOT_A_NUMBER),
        ("[[30; 1 m + 2 mm; 12]]", Reason.NOT_A_NUMBER),
        ("[[30; 1 qq; 12]]", Reason.UNKNOWN_NAME),
        ("[[30; 2 m^99; 12]]", Reason.NOT_A_NUMBER),
        ("[[30; 1/0 m; 12]]", Reason.NOT_A_NUMBER),
    ],
)
def test_an_entry_with_a_unit_that_does_not_fit_is_refused(text: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        MEASURED.parse(text, Symbols(()))
    assert refused.value.reason is reason


def test_where_the_field_has_no_unit_an_entry_has_none() -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Matrix(1, 2).parse("[1 m, 2 m]", Symbols(()))
    assert (refused.value.reason, refused.value.position) == (Reason.OTHER_UNIT, 3)
