from __future__ import annotations

from itertools import accumulate, pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from figures.picture import Table, Words
from figures.shaft import Dimension, Ends, Segment, Torque, draw
from tests.depth import amount
from tests.figures.reading import assert_sound, classes, heads, texts

WORDS = Words("Shaft", "Stepped", Table(("name",), (("T1",),)))

sizes = st.tuples(st.integers(10, 100), st.integers(20, 80), st.sampled_from((0, 10, 15)))


@settings(max_examples=amount(13, 40), deadline=None)
@given(st.lists(sizes, min_size=1, max_size=5), st.sampled_from(("left", "right", "both", "none")), st.integers(0, 31))
def test_texts_of_a_random_shaft_stand_apart(drawn: list[tuple[int, int, int]], fixed: Ends, signs: int) -> None:
    segments = [
        Segment(length / 100, outer, bore, f"Ø{outer}/Ø{bore}" if bore else f"Ø{outer}")
        for length, outer, bore in drawn
    ]
    joints = list(accumulate((segment.length for segment in segments), initial=0.0))
    torques = [Torque(x, 1 if signs >> i & 1 else -1, f"+T{i}") for i, x in enumerate(joints[1:], 1)]
    lengths = [Dimension(a, b, f"{1000 * (b - a):.0f} mm") for a, b in pairwise(joints)]
    svg = draw("s", WORDS, segments, torques, fixed, lengths, ("A", "B")).svg
    assert_sound(svg)
    assert {one.name for one in torques} | {segment.text for segment in segments} <= {one.text for one in texts(svg)}
    walls = {"left": 1, "right": 1, "both": 2, "none": 0}[fixed]
    assert classes(svg).count("f-hatch") == walls
    assert classes(svg).count("f-hid") == 2 * sum(segment.bore > 0 for segment in segments)


def test_the_same_shaft_is_drawn_with_the_same_bytes() -> None:
    one, other = (draw("s", WORDS, [Segment(1, 50)], [Torque(1, 1, "+T1")], "left") for _ in range(2))
    assert one == other and one.table is WORDS.table


def test_a_positive_torque_ends_below_the_axis() -> None:
    for value in (1, -1):
        (tip,) = heads(draw("s", WORDS, [Segment(1, 50)], [Torque(0.5, value, "")], "none").svg, "load")
        assert (tip.imag < 0) == (value > 0)


@pytest.mark.parametrize(
    ("segments", "x"), [([], 0), ([Segment(0, 50)], 0), ([Segment(1, 20, 20)], 0), ([Segment(1, 50)], 1.2)]
)
def test_a_shaft_that_cannot_be_drawn_is_refused(segments: list[Segment], x: float) -> None:
    with pytest.raises(ValueError):
        draw("s", WORDS, segments, [Torque(x, 1, "T1")], "left")
