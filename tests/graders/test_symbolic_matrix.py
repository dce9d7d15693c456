"""Matrices of formulas: judged entry by entry, multiplied out where the reference is a product."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Domain, Formula, SymbolicMatrix, Symbols
from graders.language import Reason, parse_line
from graders.language.grids import rows_of
from graders.language.tree import Grid
from graders.states import spread
from graders.verdict import Entries, Verdict
from tests.graders.effort import effort

BOX = {"q1": Domain(-3, 3), "q2": Domain(-3, 3), "a1": Domain(0.2, 0.6), "a2": Domain(0.2, 0.6)}
STATES = spread(BOX, b"matrix")
TURN = "[[cos(q1); -sin(q1); a1*cos(q1)], [sin(q1); cos(q1); a1*sin(q1)], [0; 0; 1]]"
SECOND = TURN.replace("1)", "2)").replace("a1", "a2")
JUDGE = SymbolicMatrix("T", 3, 3)
SYMBOLS = Symbols(BOX, ["T"])
REFERENCE = Formula(parse_line(TURN), STATES)


def product() -> Formula:
    grids = {name: rows_of(parse_line(line), {}) for name, line in (("A1", TURN), ("A2", SECOND))}
    rows = rows_of(parse_line("A1*A2"), {name: rows for name, rows in grids.items() if rows})
    assert rows is not None
    return Formula(Grid(rows), STATES)


def judged(text: str, reference: Formula = REFERENCE) -> Verdict:
    return JUDGE.check(JUDGE.parse(text, SYMBOLS), reference)


@pytest.mark.parametrize("reference", [REFERENCE, product()])
def test_a_symbolic_matrix_passes_its_own_samples(reference: Formula) -> None:
    samples = JUDGE.samples(reference)
    assert {judged(text, reference).code for text in (*samples.right, JUDGE.show(reference))} == {Code.RIGHT}
    assert all(judged(text, reference).code is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            JUDGE.parse(text, SYMBOLS)


def test_a_product_written_with_sums_of_angles_is_right() -> None:
    text = (
        "[[cos(q1 + q2); -sin(q1 + q2); a1*cos(q1) + a2*cos(q1 + q2)],"
        " [sin(q1 + q2); cos(q1 + q2); a1*sin(q1) + a2*sin(q1 + q2)], [0; 0; 1]]"
    )
    assert judged(text, product()).code is Code.RIGHT
    assert judged(text.replace("sin(q1) +", "sin(q1) -"), product()).details == Entries(((2, 3),), 9)


@pytest.mark.parametrize(
    ("change", "score", "places"),
    [
        (("-sin(q1)", "sin(q1)"), 2 / 3, ((1, 2),)),
        (("a1*cos(q1)", "a1*|cos(q1)|"), 2 / 3, ((1, 3),)),
        (("0; 0; 1", "0; 0; 0"), 2 / 3, ((3, 3),)),
        (("a1*cos(q1)", "sqrt(-a1)"), 2 / 3, ((1, 3),)),
        (("cos(q1)", "sin(q1)"), 0, ((1, 1), (1, 3), (2, 2))),
    ],
)
def test_entries_that_are_off_are_named_and_zeros_earn_nothing(
    change: tuple[str, str], score: float, places: tuple[tuple[int, int], ...]
) -> None:
    verdict = judged(TURN.replace(*change))
    assert verdict.details == Entries(places, 9)
    assert verdict.score == pytest.approx(score)


def test_another_shape_and_open_entries() -> None:
    assert judged("[[cos(q1); -sin(q1)], [sin(q1); cos(q1)]]").code is Code.WRONG_SHAPE
    assert judged(TURN.replace("0; 0; 1", "0; 0; 1 + sign(sin(q1)^2 + cos(q1)^2 - 1)")).code is Code.UNDECIDED


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("[[q3; 1]]", Reason.UNKNOWN_NAME),
        ("[[T; 1]]", Reason.FORBIDDEN_NAME),
        ("cos(q1)", Reason.WRONG_SHAPE),
        ("[[<q1>^-1; 1]]", Reason.IMPULSE),
        ("[[1; [2; 3]]]", Reason.NOT_AN_EXPRESSION),
        ("[[1; 2], [3]]", Reason.RAGGED_MATRIX),
    ],
)
def test_what_is_no_matrix_of_formulas_is_refused(text: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        JUDGE.parse(text, SYMBOLS)
    assert refused.value.reason is reason


def test_a_symbolic_matrix_is_echoed_described_and_carried() -> None:
    answer = JUDGE.parse(TURN, SYMBOLS)
    assert "<mtable" in JUDGE.echo(answer).mathml and JUDGE.echo(answer).text == TURN
    assert JUDGE.describe() == {"rows": 3, "columns": 3}
    assert JUDGE.carried(answer) == answer and SymbolicMatrix("T", 2, 2).carried(answer) is None
    assert JUDGE.apart(REFERENCE, REFERENCE) == 0 and JUDGE.apart(product(), REFERENCE) == float("inf")


@pytest.mark.parametrize(
    ("line", "entries"),
    [
        ("2*A", (("2*q1", "2*a1"), ("0", "2"))),
        ("A/2", (("q1/2", "a1/2"), ("0/2", "1/2"))),
        ("-A", (("-q1", "-a1"), ("0", "-1"))),
        ("A - A*A", (("q1 - q1*q1", "a1 - (q1*a1 + a1)"), ("0", "1 - 1"))),
        ("A[1; 2]*A", (("a1*q1", "a1*a1"), ("0", "a1"))),
    ],
)
def test_a_matrix_is_multiplied_out(line: str, entries: tuple[tuple[str, ...], ...]) -> None:
    matrix = rows_of(parse_line("[[q1; a1], [0; 1]]"), {})
    assert matrix is not None
    assert rows_of(parse_line(line), {"A": matrix}) == tuple(tuple(map(parse_line, row)) for row in entries)


def test_shapes_that_do_not_fit_are_an_error_of_the_author() -> None:
    row = rows_of(parse_line("[[q1, a1]]"), {})
    assert row is not None and rows_of(parse_line("q1 + a1"), {}) is None
    with pytest.raises(ValueError):
        rows_of(parse_line("A*A"), {"A": row})


@pytest.mark.parametrize("sum_of", ["0*sign(sin({k}*q1 + {at}))", "sign(sin({k}*q1)^2 + cos({k}*q1)^2 - 1)"])
def test_a_matrix_that_turns_in_every_entry_is_bounded_as_a_whole(sum_of: str) -> None:
    rows = [row.split("; ") for row in TURN.strip("[]").split("], [")]
    for at, row in enumerate(rows):
        row[:] = ["+".join([entry, *(sum_of.format(k=k, at=at) for k in range(1, 6))]) for entry in row]
    text = "[" + ", ".join("[" + "; ".join(row) + "]" for row in rows) + "]"
    assert judged(text).code in (Code.RIGHT, Code.UNDECIDED)
    assert effort(lambda: judged(text), enough=0.1) < 0.1
