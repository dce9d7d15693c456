"""What is told of a table of a cycle beside right and wrong: scores, what is off, what is written, distances.

The mutant of this judge that lives on changes nothing that can be seen: the default of the decimal mark of an echo, in
which no decimal stands.
"""

from __future__ import annotations

from math import inf, pi, sin

import pytest

from graders import Code, Series, Symbols
from graders.common_slips import NONE
from graders.cycle.curve import Rows
from graders.cycle.table import Column
from graders.remarks import Remarks, Slip
from graders.verdict import Verdict

NOTHING = Symbols(())
COLUMNS = (Column("t", "ms"), Column("alpha", "deg"), Column("x", "mm"), Column("y", "m"))
JUDGE = Series(COLUMNS, abscissae=2)


def truth(rows: int = 36, length: float = 0.5) -> Rows:
    turns = [2 * pi * k / rows for k in range(rows + 1)]
    return tuple((length * turn / (2 * pi), turn, 0.05 * sin(turn) + 0.2, 2 + sin(2 * turn)) for turn in turns)


TRUE = truth()


def judged(text: str) -> Verdict:
    return JUDGE.check(JUDGE.parse(text, NOTHING), TRUE)


def typed(factors: tuple[float, float] = (1.0, 1.0), rows: int = 36) -> str:
    return JUDGE.show(tuple((t, turn, x * factors[0], y * factors[1]) for t, turn, x, y in TRUE[: rows + 1]))


@pytest.mark.parametrize(
    ("text", "score", "code", "right"),
    [
        (typed((1.0, -1.0)), 0.5, Code.SOME_MARKS, 1),
        (typed((-1.0, 1.0)), 0.5, Code.SOME_MARKS, 1),
        (typed((-1.0, -1.0)), 0.0, Code.NO_MARKS, 0),
        (typed(rows=20), 0.0, Code.NO_MARKS, 0),
        (typed(rows=30), 0.0, Code.NO_MARKS, 0),
    ],
)
def test_columns_that_are_right_are_counted(text: str, score: float, code: Code, right: int) -> None:
    verdict = judged(text)
    assert (verdict.score, verdict.code) == (score, code)
    assert isinstance(verdict.details, Remarks)
    assert (verdict.details.right, verdict.details.total) == (right, 2)
    assert verdict.details.found


def test_a_table_is_told_to_be_right_without_naming_what_is_off() -> None:
    lines = typed().split("\n")
    for text, right in (
        (typed(), True),
        (typed((1.0, -1.0)), False),
        (typed(rows=30), False),
        ("\n".join(line.rpartition("; ")[0] for line in lines), False),
    ):
        assert JUDGE.right(JUDGE.parse(text, NOTHING), TRUE) is right
        assert (judged(text).code is Code.RIGHT) is right
        assert JUDGE.slips(JUDGE.parse(text, NOTHING), TRUE) == NONE


def test_a_third_of_the_columns_earns_a_third() -> None:
    judge = Series((*COLUMNS[:1], *COLUMNS[2:], Column("z", "m")))
    rows = tuple((t, x, y, x) for t, _, x, y in TRUE)
    text = judge.show(tuple((t, x, -y, -z) for t, x, y, z in rows))
    assert judge.check(judge.parse(text, NOTHING), rows).score == 0.333333


def test_a_table_is_written_over_its_first_abscissa_in_the_units_asked_for() -> None:
    lines = JUDGE.show(TRUE).split("\n")
    assert lines[:2] == ["t [ms]; x [mm]; y [m]", "0; 200; 2"]
    assert lines[9] == "111.11111; 249.24039; 2.3420201"
    assert len(lines) == 38


def test_a_table_is_carried_with_the_columns_typed_in_the_basic_units() -> None:
    answer = JUDGE.parse("t [ms]; y; x\n0; 1; 2\n500; 3; 4", NOTHING)
    assert JUDGE.carried(answer) == ((0.0, 1.0, 0.002), (0.5, 3.0, 0.004))
    assert JUDGE.echo(answer).text == "2 × (t [ms]; y [m]; x [mm])"
    assert JUDGE.echo(answer).mathml == ""


def test_distance_is_measured_on_the_scale_of_each_column() -> None:
    moved = tuple((t, turn, x + 0.001, y) for t, turn, x, y in TRUE)
    raised = tuple((t, turn, x, 2 * y) for t, turn, x, y in TRUE)
    assert JUDGE.apart(TRUE, moved) == JUDGE.apart(moved, TRUE) == pytest.approx(0.001 / (0.01 * 0.05), rel=0.01)
    assert JUDGE.apart(TRUE, raised) == JUDGE.apart(raised, TRUE) == pytest.approx(2.9848 / 0.0196962, rel=0.01)
    slow = truth(length=1.0)
    assert JUDGE.apart(TRUE, slow) == JUDGE.apart(slow, TRUE) == pytest.approx(50)
    assert JUDGE.apart(TRUE, TRUE[:-1]) == inf
    flat = tuple((t, turn, 0.2, y) for t, turn, _, y in TRUE)
    assert JUDGE.apart(flat, flat) == 0
    still = tuple((t, turn, 0.0, y) for t, turn, _, y in TRUE)
    assert JUDGE.apart(still, still) == 0


def test_the_field_names_its_columns() -> None:
    assert JUDGE.describe() == {
        "columns_asked": [{"name": column.name, "unit": column.unit} for column in COLUMNS],
        "least_rows": 24,
        "amplitude": 0.01,
    }


def test_a_gap_is_told_before_the_columns() -> None:
    details = judged(typed((1.0, -1.0), rows=30)).details
    assert isinstance(details, Remarks)
    assert [remark.slip for remark in details.found] == [Slip.NOT_A_CYCLE]
