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


ARM = "l1: A > B, l_AB, Theta1\nl2: B > C, l_BC, alpha2\nl3: C > D, h3, alpha3\n"
CHAIN = "l_AB*{0}(Theta1) + l_BC*{0}(alpha2) + h3*{0}(alpha3)"
OWN_NAMES = {
    "one vector to the gripper": (
        "tmm2_oop",
        f"{ARM}r: A > D, r_D, phi\nclosure: l1 + l2 + l3 - r = 0\nx: {CHAIN.format('cos')} - r_D*cos(phi) = 0\n"
        f"y: {CHAIN.format('sin')} - r_D*sin(phi) = 0\nunknowns: r_D; phi",
    ),
    "one vector back from it": (
        "tmm2_oop",
        f"{ARM}r: D > A, r_D, phi\nclosure: l1 + l2 + l3 + r = 0\nx: {CHAIN.format('cos')} + r_D*cos(phi) = 0\n"
        f"y: {CHAIN.format('sin')} + r_D*sin(phi) = 0\nunknowns: phi; r_D",
    ),
    "the rod backwards": (
        "slider_crank_polygon",
        "l1: A > B, l1, alpha1\nl2: C > B, l2, beta\ns: C > A, s, 180°\nclosure: l1 - l2 + s = 0\n"
        "x: l1*cos(alpha1) - l2*cos(beta) - s = 0\ny: l1*sin(alpha1) - l2*sin(beta) = 0\nunknowns: beta; s",
    ),
}


@pytest.mark.parametrize(("exercise", "text"), OWN_NAMES.values(), ids=OWN_NAMES)
def test_own_names_and_senses_of_the_vectors_give_the_same_plots(exercise: str, text: str) -> None:
    task = deal(exercise, 7)
    drawn = typed_polygon(task, text)
    assert drawn is not None
    own, right = own_motion(task, drawn), own_motion(task, polygon(exercise))
    assert set(own) == set(right) != set()
    for name, rows in right.items():
        for row, other in zip(rows, own[name], strict=True):
            assert other == pytest.approx(row, rel=1e-6, abs=1e-6)


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
