"""The figure of the four-bar linkage, and the scheme of the slider-crank without its polygon."""

from __future__ import annotations

from figures import four_bar, slider_crank
from figures.picture import Table, Words
from tests.figures.reading import assert_sound, classes, heads, texts

WORDS = Words("Figure", "Description", Table(("name",), (("1",),)))


def bars(names: four_bar.Names | None = None, diagonal: bool = False) -> str:
    return four_bar.draw("f", WORDS, names or four_bar.Names(), diagonal=diagonal).svg


def test_the_four_bar_is_sound_and_says_every_name() -> None:
    for diagonal in (False, True):
        assert_sound(bars(diagonal=diagonal))
    said = sorted(one.text for one in texts(bars()))
    assert said == sorted(["A", "B", "C", "D", "1", "2", "3", "α1", "α2", "α3", "ω1", "x"])


def test_the_diagonal_is_drawn_where_it_tells_the_assemblies_apart() -> None:
    assert "f-hid" in classes(bars(diagonal=True))
    assert "f-hid" not in classes(bars())


def test_the_sense_of_the_crank_is_in_its_head() -> None:
    ccw, cw = (four_bar.draw("f", WORDS, four_bar.Names(), sense).svg for sense in ("ccw", "cw"))
    assert heads(ccw, "vel")[0].real < heads(cw, "vel")[0].real


def test_what_has_no_name_is_not_drawn() -> None:
    svg = bars(four_bar.Names(("", "", "", ""), ("", "", ""), ("", "", ""), ""))
    assert [one.text for one in texts(svg)] == ["x"]
    assert not heads(svg, "thin") and not heads(svg, "vel")


def test_a_scheme_without_its_polygon_shows_no_vector() -> None:
    names = slider_crank.Names(angles=("α1", ""))
    svg = slider_crank.draw("k", WORDS, names, polygon=False).svg
    assert_sound(svg)
    assert sorted(one.text for one in texts(svg)) == sorted(["A", "B", "C", "1", "2", "3", "α1", "ω1", "x"])
    assert not heads(svg, "pos")


def test_figures_are_drawn_twice_with_the_same_bytes() -> None:
    assert bars() == bars()
