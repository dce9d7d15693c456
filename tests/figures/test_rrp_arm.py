"""The RRP arm: sound in every pose, all names said, the sense of the second coordinate in its head."""

from __future__ import annotations

from typing import get_args

import pytest

from figures import rrp_arm
from figures.picture import Table, Words
from figures.rrp_arm import Measure, Side
from tests.figures.reading import assert_sound, heads, texts

WORDS = Words("Figure", "Description", Table(("name",), (("1",),)))


def arm(measure: Measure, side: Side, names: rrp_arm.Names | None = None) -> str:
    return rrp_arm.draw("a", WORDS, measure, side, names).svg


@pytest.mark.parametrize("side", get_args(Side))
@pytest.mark.parametrize("measure", get_args(Measure))
def test_the_arm_is_sound_and_says_every_name(measure: Measure, side: Side) -> None:
    svg = arm(measure, side)
    assert_sound(svg)
    said = sorted(one.text for one in texts(svg))
    assert said == sorted(["x0", "y0", "z0", "z3", "q1", "q2", "q3", "L1", "d", "M"])
    assert len(heads(svg, "thin")) == 7  # four axes, two arcs, the way of the slide


@pytest.mark.parametrize("side", get_args(Side))
def test_what_has_no_name_is_not_drawn(side: Side) -> None:
    svg = arm("down", side, rrp_arm.Names(("", "", ""), ("", ""), ""))
    assert sorted(one.text for one in texts(svg)) == ["x0", "y0", "z0", "z3"]
    assert len(heads(svg, "thin")) == 4


def test_the_second_coordinate_ends_at_the_slide_from_the_side_it_is_measured() -> None:
    up, down = (heads(arm(measure, "left"), "thin") for measure in ("level_up", "level_down"))
    assert len(up) == len(down) and up != down
