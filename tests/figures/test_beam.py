from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from figures.beam import Couple, Dimension, Distributed, Force, Load, Mark, Support, draw
from figures.dimensions import ROW
from figures.picture import Table, Words
from tests.depth import amount
from tests.figures.reading import assert_sound, classes, heads, segments, texts

WORDS = Words("Beam", "On two supports", Table(("name",), (("F1",),)))
SIMPLE = (Support(0, "pin", "A"), Support(4, "roller", "B"))

tenths = st.integers(0, 50).map(lambda n: n / 10)
senses = st.sampled_from((-3.0, -1.0, 2.0))


@st.composite
def loads(draw_: st.DrawFn) -> list[Load]:
    """Loads of every kind; two forces, or two couples, never at the same place."""
    found: list[Load] = []
    alone = {"F": draw_(st.permutations(range(51))), "M": draw_(st.permutations(range(51)))}
    for number in range(1, draw_(st.integers(1, 5)) + 1):
        kind, value = draw_(st.sampled_from("FqM")), draw_(senses)
        if kind == "q":
            start, end = sorted(draw_(st.tuples(tenths, tenths).filter(lambda ends: ends[0] != ends[1])))
            found.append(Distributed(start, end, value, value, f"q{number}"))
        else:
            found.append((Force if kind == "F" else Couple)(alone[kind][number] / 10, value, f"{kind}{number}"))
    return found


def places(found: list[Load]) -> list[float]:
    ends = {x for one in found for x in ((one.start, one.end) if isinstance(one, Distributed) else (one.x,))}
    return sorted(ends | {0.0, 5.0})


@settings(max_examples=amount(20, 60), deadline=None)
@given(loads(), st.integers(0, 20), st.integers(30, 50))
def test_texts_of_a_random_beam_stand_apart_and_are_crossed_by_nothing(
    found: list[Load], left: int, right: int
) -> None:
    supports = (Support(left / 10, "pin", "A"), Support(right / 10, "roller", "B"))
    xs = places(found)
    lengths = [Dimension(a, b, f"{b - a:.2f} m") for a, b in pairwise(xs)]
    lengths += [Dimension(0, x, f"{x:.2f} m") for x in xs[1:]]
    picture = draw("b", WORDS, 5, supports, found, lengths)
    assert_sound(picture.svg)
    named = {one.text for one in texts(picture.svg)}
    assert {one.name for one in found} | {"A", "B"} | {one.text for one in lengths} <= named


def test_the_same_beam_is_drawn_with_the_same_bytes() -> None:
    found: list[Load] = [Force(1.5, -6, "F1"), Distributed(1, 3, -2, -2, "q2"), Couple(2, 1, "M3")]
    one, other = (draw("b", WORDS, 4, SIMPLE, list(found), [Dimension(0, 4, "4 m")]) for _ in range(2))
    assert one == other and one.table is WORDS.table


def test_a_force_stands_at_its_place_in_scale() -> None:
    svg = draw("b", WORDS, 4, SIMPLE, [Force(1, -6, "F1"), Force(3, -3, "F2")]).svg
    (x1, x2) = (tip.real for tip in heads(svg, "load"))
    assert x2 == pytest.approx(3 * x1, abs=0.2)


def test_a_mirrored_beam_is_the_mirrored_drawing() -> None:
    one = draw("b", WORDS, 4, (Support(0.5, "pin"), Support(4, "pin")), [Force(1, -6, ""), Couple(3, 2, "")]).svg
    other = draw("b", WORDS, 4, (Support(0, "pin"), Support(3.5, "pin")), [Force(3, -6, ""), Couple(1, -2, "")]).svg
    span = max(tip.real for tip in heads(one, "load")) + min(tip.real for tip in heads(other, "load"))
    mirrored = sorted(round(span - tip.real, 1) for tip in heads(other, "load"))
    assert mirrored == pytest.approx(sorted(tip.real for tip in heads(one, "load")), abs=0.21)
    assert sorted(classes(one)) == sorted(classes(other))


def test_senses_are_seen_in_the_heads() -> None:
    down, up = (heads(draw("b", WORDS, 4, SIMPLE, [Force(2, value, "F1")]).svg, "load")[0] for value in (-1, 1))
    assert up.imag > down.imag
    left, right = (heads(draw("b", WORDS, 4, SIMPLE, [Couple(2, value, "M1")]).svg, "load")[0] for value in (1, -1))
    assert left.real < right.real


def test_overlapping_distributed_loads_stand_above_one_another() -> None:
    pair = [Distributed(0, 3, -1, -1, "q1"), Distributed(1, 4, -1, -1, "q2")]
    feet = {round(tip.imag) for tip in heads(draw("b", WORDS, 4, SIMPLE, pair).svg, "load")}
    apart = [Distributed(0, 1, -1, -1, "q1"), Distributed(1, 4, -1, -1, "q2")]
    assert len(feet) == 2
    assert len({round(tip.imag) for tip in heads(draw("b", WORDS, 4, SIMPLE, apart).svg, "load")}) == 1


@pytest.mark.parametrize("x", [0.0, 3.0])
def test_a_cantilever_has_its_wall_outside_its_end(x: float) -> None:
    svg = draw("b", WORDS, 3, [Support(x, "fixed", "A")], [Force(3 - x, -1, "F1")], (), [Mark(3 - x, "B")]).svg
    assert_sound(svg)
    wall = [line for line in segments(svg) if abs(line[1] - line[0]) == pytest.approx(96, abs=0.2)]
    assert len(wall) == 1 and wall[0][0].real == pytest.approx(470 * x / 3, abs=0.1)
    label = next(one for one in texts(svg) if one.text == "A")
    assert (label.box.right < 0) if x == 0 else (label.box.left > 470)


def test_named_points_and_small_gaps_find_room() -> None:
    marks = [Mark(0, "C"), Mark(2, "D"), Mark(4, "E")]
    supports = (Support(1, "pin", "A"), Support(3, "roller", "B"))
    lengths = [Dimension(2, 2.1, "100 mm"), Dimension(2.1, 2.2, "100 mm"), Dimension(4, 0, "4000 mm")]
    svg = draw("b", WORDS, 4, supports, [Distributed(0, 4, 0, -2, "q1")], lengths, marks).svg
    assert_sound(svg)
    assert {"A", "B", "C", "D", "E"} <= {one.text for one in texts(svg)}


def test_dimensions_that_share_no_place_share_the_nearest_row() -> None:
    lengths = [Dimension(0, 2, "2 m"), Dimension(2, 4, "2 m"), Dimension(0, 4, "4 m")]
    rows = [one.box.bottom for one in texts(draw("b", WORDS, 4, SIMPLE, [], lengths).svg) if "m" in one.text]
    assert sorted(rows) == pytest.approx([rows[2], rows[2] + ROW, rows[2] + ROW])


@pytest.mark.parametrize(
    ("length", "supports", "found"),
    [
        (0, SIMPLE, []),
        (float("nan"), SIMPLE, []),
        (4, SIMPLE, [Force(4.1, -1, "F1")]),
        (4, SIMPLE, [Distributed(-1, 2, -1, -1, "q1")]),
        (4, (Support(2, "fixed", "A"),), []),
    ],
)
def test_a_beam_that_cannot_be_drawn_is_refused(length: float, supports: list[Support], found: list[Load]) -> None:
    with pytest.raises(ValueError):
        draw("b", WORDS, length, supports, found)


def test_an_unloaded_beam_on_nothing_is_still_a_beam() -> None:
    assert_sound(draw("b", WORDS, 4, (), (), [Dimension(0, 4, "4 m")]).svg)
