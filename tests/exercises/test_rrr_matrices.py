"""What is accepted as the table, the matrices and the point of the RRR arm."""

from __future__ import annotations

from math import pi

import pytest

from exercises.exercise import Submission, Variant
from exercises.grading import grade, reference
from exercises.manipulators.rrr_matrices import EXERCISE, Givens
from exercises.solving import solved
from graders import Code, Outcome

GIVENS = Givens(0.42, 0.36, 0.28, -35 * pi / 180, 50 * pi / 180, -80 * pi / 180, "x")
VARIANT = Variant("rrr_matrices", EXERCISE.version, 0, GIVENS)


def code(answer: str, text: str) -> Code:
    return grade(Submission(VARIANT, {answer: text})).verdicts[answer].code


@pytest.mark.parametrize(
    "table",
    [
        "[[-35; 0,42; 0; 90], [50; 0; 0,36; 0], [80; 0; 0; 0]]",
        "[[-35°; 0.42; 0; 90°], [50°; 0; 0.36; 0], [-280°; 0; 0; 0]]",
        "P = [[325; 0.42; 0; 90], [50; 0; 0.36; 0], [80; 0; 0; 0]]",
    ],
)
def test_a_table_is_read_in_degrees_and_metres(table: str) -> None:
    assert code("P", table) is Code.RIGHT


def test_a_table_of_another_convention_or_order_is_not_right() -> None:
    assert code("P", "[[0; 0; 0.42; -35], [90; 0; 0; 50], [0; 0.36; 0; 80]]") is not Code.RIGHT


@pytest.mark.parametrize(
    ("rows", "mistake"),
    [
        ("[[q1; L1; 0; 0], [q2; 0; L2; 0], [-q3; 0; 0; 0]]", "alpha_forgotten"),
        ("[[q1; L1; 0; pi/2], [q2; 0; L2; pi/2], [-q3; 0; 0; 0]]", "alpha2_turned"),
    ],
)
def test_an_angle_between_axes_that_is_wrong_is_told_by_what_follows(rows: str, mistake: str) -> None:
    known = solved(VARIANT)
    values = known.again(replaced={"P": rows})
    typed = {name: judge.show(values[name]) for name, judge in known.answers.items() if not judge.symbolic}
    found = grade(Submission(VARIANT, {**reference(VARIANT), **typed}))
    assert (found.mistake, found.slip) == (mistake, None)


@pytest.mark.parametrize(
    "formula",
    [
        "cos(q1)*(L3*cos(q2-q3) + L2*cos(q2))",
        "x = L3*cos(q1)*(cos(q2)*cos(q3) + sin(q2)*sin(q3)) + L2*cos(q1)*cos(q2)",
        "L2*cos q1 cos q2 + L3/2*(cos(q1+q2-q3) + cos(q1-q2+q3))",
    ],
)
def test_the_formula_may_have_any_form(formula: str) -> None:
    assert code("x_formula", formula) is Code.RIGHT


def test_matrices_follow_from_a_wrong_table() -> None:
    """The third angle with the wrong sign; everything after it done right."""
    c, s = 0.1736481777, 0.9848077530
    answers = reference(VARIANT) | {"P": "[[-35; 0.42; 0; 90], [50; 0; 0.36; 0], [-80; 0; 0; 0]]"}
    answers["A3"] = f"[[{c}; {s}; 0; 0], [-{s}; {c}; 0; 0], [0; 0; 1; 0], [0; 0; 0; 1]]"
    verdicts = grade(Submission(VARIANT, {name: answers[name] for name in ("P", "A1", "A2", "A3")})).verdicts
    assert verdicts["P"].outcome is Outcome.PARTLY
    assert [verdicts[name].code for name in ("A1", "A2", "A3")] == [Code.RIGHT, Code.RIGHT, Code.FOLLOWED]


@pytest.mark.parametrize("front", ["", "x = ", "x_M = ", "xM="])
def test_the_formula_may_be_named_by_the_coordinate_or_by_that_of_the_point(front: str) -> None:
    assert code("x_formula", front + reference(VARIANT)["x_formula"]) is Code.RIGHT


def test_the_formula_may_not_be_named_by_another_coordinate() -> None:
    assert code("x_formula", "y_M = " + reference(VARIANT)["x_formula"]) is Code.UNREADABLE
