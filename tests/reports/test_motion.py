"""The plots of a report follow the student's own projections: right ones the true motion, wrong ones their own."""

from __future__ import annotations

import pytest

from exercises import catalogue, solving
from exercises.grading import reference
from exercises.variants import deal
from figures import plot
from figures.picture import Table, Words
from graders.polygon.drawn import Drawn
from reports.motion import POINTS, own_motion
from reports.tmm2 import typed_polygon

LABORATORIES = [name for name in catalogue.ids() if catalogue.load(name).exercise.report]


def polygon(exercise: str, old: str = "", new: str = "") -> Drawn:
    task = deal(exercise, 7)
    drawn = typed_polygon(task, reference(task)["polygon"].replace(old, new))
    assert drawn is not None
    return drawn


@pytest.mark.parametrize("exercise", LABORATORIES)
def test_right_projections_begin_as_the_oracle_says_and_their_rates_are_slopes(exercise: str) -> None:
    task = deal(exercise, 7)
    loaded = catalogue.load(exercise).exercise
    assert loaded.machine is not None
    machine, moved = loaded.machine(task.givens), own_motion(task, polygon(exercise))
    assert set(moved) == {one.name for one in machine.plotted}
    truth = loaded.oracle(task.givens)
    for one in machine.plotted:
        rows = moved[one.name]
        for name, value in zip((one.name, one.rate, one.surge), rows[0], strict=True):
            if name in truth:
                assert value == pytest.approx(truth[name], rel=1e-9, abs=1e-9)
        step = machine.span / (POINTS - 1)
        for order in (0, 1):
            slopes = [(rows[k + 1][order] - rows[k - 1][order]) / (2 * step) for k in range(1, POINTS - 1)]
            largest = max(abs(row[order + 1]) for row in rows)
            assert max(abs(s - row[order + 1]) for s, row in zip(slopes, rows[1:], strict=False)) < 0.05 * largest


def test_wrong_projections_move_their_own_way_and_insoluble_ones_not_at_all() -> None:
    task = deal("tmm2_oop", 7)
    wrong = own_motion(task, polygon("tmm2_oop", "l_AB*cos(Theta1) +", "l_AB*sin(Theta1) +"))
    right = own_motion(task, polygon("tmm2_oop"))
    assert wrong["y_D"] == right["y_D"] and abs(wrong["x_D"][0][0] - right["x_D"][0][0]) > 0.1
    assert own_motion(task, polygon("tmm2_oop", "unknowns: x_D; y_D", "unknowns: x_D")) == {}
    assert own_motion(task, polygon("tmm2_oop", " - x_D = 0", " - y_D = 0")) == {}
    assert solving.solved(task).values["x_D"] == pytest.approx(right["x_D"][0][0])


def test_a_plot_names_its_extremes_and_refuses_what_is_no_curve() -> None:
    words = Words("t", "t", Table((), ()))
    made = plot.draw("p", words, "2 s", [plot.Series("x_D", "m", "f-pos", (0.0, 1.0, -2.0), "−2", "1")]).svg
    assert ">−2</text>" in made and ">1</text>" in made and ">2 s</text>" in made and made.count("<path") == 3
    for values in ((), (1.0,), (1.0, float("nan"))):
        with pytest.raises(ValueError, match="no curve"):
            plot.draw("p", words, "2 s", [plot.Series("x_D", "m", "f-pos", values, "", "")])
    with pytest.raises(ValueError, match="nothing"):
        plot.draw("p", words, "2 s", [])
