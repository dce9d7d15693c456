"""Diagrams of internal forces: drawn to scale, texts apart, refusals named."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from figures.diagram import HEIGHT, SPAN, Curve, Part, Value, draw
from figures.picture import Table, Words
from tests.depth import amount
from tests.figures.reading import assert_sound, classes, texts

WORDS = Words("V and M", "Diagrams of a beam", Table(("x", "V"), (("0", "1"),)))
V = Curve("V", (Part(0, 1.5, (7.5, -2)), Part(1.5, 4, (-1.5, -2))), (Value(0, 7.5, "7.5"), Value(4, -6.5, "−6.5")))
M = Curve("M", (Part(0, 1.5, (0, 7.5, -1)), Part(1.5, 4, (9, -1.5, -1))), (Value(1.5, 9, "9"),), down=True)


def outline(svg: str, row: int = 0) -> list[complex]:
    """The points of the thick line of a diagram, y upwards."""
    (found, *_) = [p.get("d", "") for p in ET.fromstring(svg).iter("path") if p.get("class") == "f-thick"][row:]
    pairs = [step.split() for step in found[1:].split("L")]
    return [complex(float(x), -float(y)) for x, y in pairs]


def test_two_diagrams_stand_apart_with_their_names_and_values() -> None:
    picture = draw("vm", WORDS, 4, (V, M), (0, 1.5, 4))
    assert_sound(picture.svg)
    assert {"V", "M", "7.5", "−6.5", "9", "+", "−"} <= {one.text for one in texts(picture.svg)}
    assert picture.table is WORDS.table


def test_the_largest_ordinate_has_the_full_height_and_the_others_their_share() -> None:
    line = outline(draw("v", WORDS, 4, (V,)).svg)
    assert max(at.imag for at in line) == pytest.approx(HEIGHT, abs=0.1)
    assert min(at.imag for at in line) == pytest.approx(-HEIGHT * 6.5 / 7.5, abs=0.1)
    assert line[0] == 0 and line[-1].real == pytest.approx(SPAN)


def test_a_jump_is_a_vertical_stroke_at_its_place() -> None:
    line = outline(draw("v", WORDS, 4, (V,)).svg)
    at = [point.imag for point in line if abs(point.real - SPAN * 1.5 / 4) < 0.06]
    assert at == pytest.approx([HEIGHT * 4.5 / 7.5, -HEIGHT * 1.5 / 7.5], abs=0.1)


def test_a_curved_part_is_bent_and_a_straight_one_is_not() -> None:
    assert len(outline(draw("v", WORDS, 4, (V,)).svg)) == 6
    assert len(outline(draw("m", WORDS, 4, (M,)).svg)) > 40


def test_positive_ordinates_point_down_where_they_are_asked_to() -> None:
    up = outline(draw("m", WORDS, 4, (Curve("M", M.parts),)).svg)
    down = outline(draw("m", WORDS, 4, (M,)).svg)
    assert [at.conjugate() for at in down] == pytest.approx(up)
    assert {"+"} == {one.text for one in texts(draw("m", WORDS, 4, (Curve("M", M.parts, down=True),)).svg)} - {"M"}


def test_a_diagram_of_nothing_is_its_base_line() -> None:
    svg = draw("n", WORDS, 2, (Curve("N", (Part(0, 2, (0.0,)),), (Value(1, 0, "0"),)),)).svg
    assert_sound(svg)
    assert {at.imag for at in outline(svg)} == {0} and "f-ord" not in classes(svg)


@pytest.mark.parametrize(
    ("length", "curves", "message"),
    [
        (0.0, (V,), "0.0 long"),
        (4.0, (), "no diagram"),
        (4.0, (Curve("T", ()),), "T has no parts"),
        (3.0, (V,), "lies off"),
        (4.0, (Curve("V", (Part(2, 2, (1,)),)),), "lies off"),
    ],
)
def test_what_cannot_be_drawn_is_refused_by_name(length: float, curves: tuple[Curve, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        draw("v", WORDS, length, curves)


heights = st.integers(-9, 9).map(float)


@settings(max_examples=amount(8, 15), deadline=None)
@given(st.lists(st.tuples(heights, heights, heights), min_size=1, max_size=6), st.booleans())
def test_texts_of_a_random_diagram_are_crossed_by_nothing(found: list[tuple[float, ...]], down: bool) -> None:
    parts = tuple(Part(k, k + 1, curve) for k, curve in enumerate(found))
    values = tuple(Value(p.start, p.at(p.start), f"{p.at(p.start):.1f} kN") for p in parts)
    curves = (Curve("V", parts, values, down), Curve("M", parts, values[:2]))
    assert_sound(draw("v", WORDS, len(found), curves, range(len(found) + 1)).svg)
