"""What is told of a task before a card is dealt."""

from __future__ import annotations

import pytest

from server.sets.foresight import Task, Uneven, refuse_unfit, traits, uneven
from server.web.errors import Refused


@pytest.mark.parametrize(
    "task",
    [
        (("planetary", "gear_train"), {}),  # 5 steps, and 4 or 5
        (("slider_crank", "no_longer_there"), {"l1": (0.05, 0.08)}),
        (("beam_diagrams",), {"q1": (1.0, 2.0)}),  # of many loads, a given of some draws only
        (("slider_crank",), {"l1": (0.12, 9.0)}),
        (("slider_crank",), {"l1": (0.0, 0.04)}),
        (("mobility",), {}),
    ],
)
def test_what_dealing_may_yet_take_is_left_to_it(task: Task) -> None:
    with pytest.raises(Refused) as refused:
        refuse_unfit([task, (("slider_crank",), {"l9": (0.0, 1.0)})])
    assert refused.value.field == "items.1.limits"  # of the other task alone


@pytest.mark.parametrize(
    ("task", "code", "field"),
    [
        (("slider_crank", "four_bar"), "unequal_steps", "items.1.pool"),
        (("gear_train", "slider_crank", "simple_beam"), "unequal_steps", "items.1.pool"),
        (("mobility",), "unknown_given", "items.1.limits"),
        (("slider_crank",), "unknown_given", "items.1.limits"),
        (("slider_crank",), "limit_outside", "items.1.limits"),
    ],
)
def test_what_can_never_be_published_is_told_by_task_and_field(task: tuple[str, ...], code: str, field: str) -> None:
    limits = {"unknown_given": {"l9": (0.0, 1.0)}, "limit_outside": {"l1": (5.0, 6.0)}}.get(code, {})
    with pytest.raises(Refused) as refused:
        refuse_unfit([(("planetary",), {}), (task, limits)])
    assert (refused.value.status_code, refused.value.code, refused.value.field) == (422, code, field)


def test_givens_that_few_draws_have_are_known() -> None:
    assert {"F1", "F3", "q1"} <= set(traits("beam_diagrams").givens)
    assert traits("stepped_shaft").steps == {14, 18, 22}


def test_a_pool_of_which_most_draws_differ_in_steps_is_foreseen_within_the_limits() -> None:
    pool = ("gear_train", "planetary")
    assert uneven([(("slider_crank",), {}), (pool, {})]) == (Uneven(2, "gear_train (4); planetary (5)"),)
    assert uneven([(("slider_crank_polygon", "offset_slider_crank"), {})]) == ()
    assert uneven([(pool, {name: (0.0, -1.0) for name in traits("gear_train").givens[:1]})]) == ()  # none is within
