"""What is asked of equations: the box in which their solutions count, and its points.

Mutants of the module that live on change nothing that can be seen:

* lengths that are not compared, where they are the same; more than one state at which slopes are taken, of which there
  are four; steps of another size for the slopes, to the other side first;
* what is found of equations that do not determine the unknowns, of which it is only told that they do not.
"""

from __future__ import annotations

from graders.solutions.posed import Task, box_of
from tests.graders.solutions.crank import BOX, L3, ROD, STATES

SPANS = ((-1.2, 1.2), (0.0, 0.8))


def test_the_points_of_a_task_lie_all_over_its_spans() -> None:
    scene = Task(("alpha2", "l3"), SPANS, L3).scene
    assert scene.names == (*BOX, "alpha2", "l3") and scene.ranges[-2:] == SPANS
    for at, (low, high) in zip((-2, -1), SPANS, strict=True):
        column = [point[at] for point in scene.points]
        quarter = (high - low) / 4
        assert low <= min(column) < low + quarter and high - quarter < max(column) <= high


def test_the_box_of_states_holds_their_names_points_and_lines() -> None:
    box = box_of(L3.states)
    assert box.names == tuple(BOX) and box.lines == (ROD,) and box.points == STATES.points
    assert box.ranges == tuple((one.low, one.high) for one in BOX.values())
