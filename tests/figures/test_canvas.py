from __future__ import annotations

import xml.etree.ElementTree as ET
from math import cos, hypot, pi, radians, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from figures.canvas import Arc, Circle, Drawing, Line, Strokes, Text, bounds, coordinate
from figures.label import number, point, symbol
from figures.plane import Box, left_of

SVG = "{http://www.w3.org/2000/svg}"


def parsed(
    drawing: Drawing, prefix: str = "f", title: str = "t", description: str = "d", width: float = 0
) -> ET.Element:
    return ET.fromstring(drawing.to_svg(prefix, title, description, width))


def test_a_figure_is_an_image_named_by_its_title_and_description() -> None:
    root = parsed(Drawing((Circle("f-o", 0, 5),)), "beam-1", "A beam", "On two supports")
    assert (root.get("role"), root.get("class"), root.get("id")) == ("img", "fig", "beam-1")
    texts = {child.get("id"): child.text for child in root}
    assert [texts[name] for name in (root.get("aria-labelledby") or "").split()] == ["A beam", "On two supports"]


@given(st.text(), st.text())
def test_any_words_make_well_formed_text(title: str, name: str) -> None:
    drawing = Drawing((Text(0, point(name)), Circle("f-o", 0, 5)))
    root = parsed(drawing, "f", title, name)
    assert [child.tag for child in root] == ["title", "desc", "text", "circle"]


def test_markup_in_words_stays_text() -> None:
    root = parsed(Drawing((Text(0, number('<b>&"x"')), Circle("f-o", 0, 5))), title="a < b & c")
    assert root[0].text == "a < b & c"
    assert root[2].text == '<b>&"x"'


@pytest.mark.parametrize("prefix", ["", "1a", "a b", 'a"', "-a", "ą"])
def test_a_prefix_that_is_no_id_is_refused(prefix: str) -> None:
    with pytest.raises(ValueError, match="id of a figure"):
        Drawing((Circle("f-o", 0, 5),)).to_svg(prefix, "t", "d")


def test_an_empty_drawing_is_refused() -> None:
    with pytest.raises(ValueError):
        Drawing(()).to_svg("f", "t", "d")


@given(st.floats(-1e4, 1e4))
def test_a_coordinate_has_at_most_one_decimal_and_no_negative_zero(value: float) -> None:
    text = coordinate(value)
    assert text != "-0" and len(text.partition(".")[2]) <= 1
    assert float(text) == pytest.approx(value, abs=0.0501)


def test_y_points_up_on_the_sheet() -> None:
    assert Line("f-link", (0, 10 + 20j)).svg() == '<path class="f-link" d="M0 0L10 -20"/>'
    assert Circle("f-o", 3 + 4j, 5).svg() == '<circle class="f-o" cx="3" cy="-4" r="5"/>'
    assert Strokes("f-hatch", ((0, 1j), (2, 3))).svg() == '<path class="f-hatch" d="M0 0L0 -1M2 0L3 0"/>'


@given(st.floats(-pi, pi), st.floats(0.1, 6.2), st.booleans())
def test_an_arc_takes_the_way_its_angles_say(start: float, sweep: float, clockwise: bool) -> None:
    """Follow SVG's own rule (SVG 1.1, F.6.5): flags and end points give back the centre."""
    arc = Arc("f-thin", 0, 50, start, start - sweep if clockwise else start + sweep)
    large, turn = map(int, arc.svg().split("A")[1].split()[3:5])
    assert large == (sweep > pi)
    (x1, y1), (x2, y2) = [(at.real, -at.imag) for at in (arc.at(arc.start), arc.at(arc.end))]
    chord = hypot(x2 - x1, y2 - y1)
    away = max(50**2 - chord**2 / 4, 0) ** 0.5 * (-1 if large == turn else 1)
    centre = ((x1 + x2) / 2 - away * (y2 - y1) / chord, (y1 + y2) / 2 + away * (x2 - x1) / chord)
    assert hypot(*centre) < 1e-3


def test_an_arc_is_followed_within_a_hundredth_of_its_radius() -> None:
    arc = Arc("f-thin", 0, 50, 0, 2)
    for start, end in arc.segments():
        assert abs((start + end) / 2) > 49.5


def test_an_ellipse_has_its_own_height() -> None:
    assert Arc("f-load", 0, 10, 0, pi / 2, 48).at(pi / 2) == pytest.approx(48j)
    assert "A10 48 0" in Arc("f-load", 0, 10, 0, pi / 2, 48).svg()


def test_the_view_holds_all_contents_and_centres_narrow_ones() -> None:
    drawing = Drawing((Line("f-link", (-10 + 5j, 30 - 7j)),))
    assert parsed(drawing).get("viewBox") == "-16 -11 52 24"
    left, _, width, _ = map(float, (parsed(drawing, width=200).get("viewBox") or "").split())
    assert (left + width / 2, width) == (10, 200)


def test_a_text_stands_where_its_anchor_says() -> None:
    label = number("1,5 m")
    boxes = [Text(100, label, anchor).box for anchor in ("start", "middle", "end")]
    assert boxes[0].left == 100 and boxes[2].right == 100
    assert (boxes[1].left + boxes[1].right) / 2 == pytest.approx(100)
    assert bounds((Text(100, label),)) == boxes[0]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("F1", 'F<tspan class="s up" dy="5">1</tspan>'),
        ("R_A", 'R<tspan class="s" dy="5">A</tspan>'),
        ("z2'", 'z<tspan class="s up" dy="5">2′</tspan>'),
        ("-T2", '−T<tspan class="s up" dy="5">2</tspan>'),
        ("x_0", 'x<tspan class="s up" dy="5">0</tspan>'),
        ("q", "q"),
        ("1", "1"),
    ],
)
def test_the_index_of_a_name_is_a_subscript(name: str, text: str) -> None:
    assert symbol(name).svg() == text


def test_a_box_knows_what_crosses_it() -> None:
    box = Box(0, 0, 10, 10)
    assert box.crossed_by((-5 + 5j, 15 + 5j)) and box.crossed_by((2 + 2j, 3 + 3j)) and box.crossed_by((5 - 5j, 5 + 5j))
    assert not box.crossed_by((-5 + 0j, 15 + 0j)), "a line along its side stays outside"
    assert not box.crossed_by((-5 + 4j, 4 + 16j)) and not box.crossed_by((11 + 1j, 20 + 5j))
    assert box.overlaps(Box(9, 9, 12, 12)) and not box.overlaps(Box(10, 0, 12, 10))


@given(st.floats(0, 2 * pi), st.floats(1, 50))
def test_the_left_of_a_way_is_counter_clockwise_of_it(angle: float, offset: float) -> None:
    end = 100 * complex(cos(angle), sin(angle))
    at = left_of(0, end, offset)
    assert (end.conjugate() * at).imag == pytest.approx(100 * offset)
    assert abs(at) == pytest.approx(hypot(50, offset))


def test_degrees_are_never_meant() -> None:
    assert Arc("f-thin", 0, 1, 0, radians(90)).at(radians(90)) == pytest.approx(1j)
