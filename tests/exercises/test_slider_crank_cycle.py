"""What the cycle of the slider-crank promises beyond the contract of every exercise."""

from __future__ import annotations

from math import pi

import pytest

from exercises import variants
from exercises.catalogue import load
from exercises.exercise import Submission
from exercises.grading import grade, reference
from exercises.linkages.slider_crank_cycle.cycle import cycle
from exercises.presenting import solution
from exercises.solving import Solved
from graders import Code, Outcome
from graders.remarks import Remarks, Slip

L1, L2, SPEED = 0.08, 0.3, 30.0
TURN = 2 * pi / SPEED


def test_velocity_and_acceleration_are_the_derivatives_of_the_position() -> None:
    step = 1e-4
    for shift in (0.3, 1.9, 4.4):
        (_, _, x1, v1, _), (_, _, x, v, a), (_, _, x2, v2, _) = (
            cycle(L1, L2, shift + SPEED * k * step, SPEED, TURN)[0] for k in (-1, 0, 1)
        )
        assert (x2 - x1) / (2 * step) == pytest.approx(v, rel=1e-4)
        assert (v2 - v1) / (2 * step) == pytest.approx(a, rel=1e-4)
        assert L2 - L1 < x < L2 + L1


def test_turning_backwards_runs_through_the_same_places() -> None:
    forth, back = (cycle(L1, L2, 0.7, speed, TURN) for speed in (SPEED, -SPEED))
    assert [row[2] for row in forth] == pytest.approx([row[2] for row in reversed(back)])
    assert [row[3] for row in forth] == pytest.approx([-row[3] for row in reversed(back)])
    assert [row[4] for row in forth] == pytest.approx([row[4] for row in reversed(back)])


def test_the_mean_velocity_of_a_cycle_is_zero() -> None:
    rows = cycle(L1, L2, 0.7, SPEED, TURN)[:-1]
    assert sum(row[3] for row in rows) == pytest.approx(0, abs=1e-9)
    assert sum(row[4] for row in rows) == pytest.approx(0, abs=1e-6)


def test_a_cycle_computed_with_the_wrong_speed_is_right_in_itself() -> None:
    variant = variants.deal("slider_crank_cycle", 3)
    exercise = load("slider_crank_cycle").exercise
    expected = variants.predictions(Solved(exercise, variant))["turns_a_second"]
    typed = {name: judge.show(expected[name]) for name, judge in Solved(exercise, variant).answers.items()}
    verdicts = grade(Submission(variant, typed)).verdicts
    assert verdicts["omega1"].outcome is Outcome.WRONG
    assert {verdicts["T"].code, verdicts["cycle"].code} == {Code.FOLLOWED}


def test_a_column_of_the_opposite_sign_is_named() -> None:
    variant = variants.deal("slider_crank_cycle", 5)
    right = reference(variant)
    head, *rows = right["cycle"].split("\n")
    cells = [row.split("; ") for row in rows]
    turned = "\n".join([head, *("; ".join((t, x, f"{-float(v):.8g}", a)) for t, x, v, a in cells)])
    verdict = grade(Submission(variant, {**right, "cycle": turned})).verdicts["cycle"]
    assert verdict.score == pytest.approx(2 / 3, abs=1e-5)
    assert isinstance(verdict.details, Remarks)
    assert [(one.slip, one.name) for one in verdict.details.found] == [(Slip.COLUMN_SIGN, "v")]


def test_the_worked_solution_shows_a_dozen_rows() -> None:
    shown = solution(variants.deal("slider_crank_cycle", 2), "pl")[-1].value
    assert shown.startswith("t [s] · x [mm] · v [m/s] · a [m/s^2] | 0 · ")
    assert shown.count("|") == 13 and "." not in shown
