from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from figures import rod_group, slider_crank
from figures.gear_train import Mesh, Wheel, draw
from figures.picture import Picture, Table, Words
from tests.depth import amount
from tests.figures.reading import assert_sound, classes, heads, segments, texts, view

WORDS = Words("Figure", "Description", Table(("name",), (("1",),)))


def crank(names: slider_crank.Names | None = None) -> str:
    return slider_crank.draw("k", WORDS, names or slider_crank.Names()).svg


def arm(names: rod_group.Names | None = None, frames: tuple[int, ...] = (0, 1, 2, 3)) -> str:
    return rod_group.draw("r", WORDS, names or rod_group.Names(), frames).svg


def test_the_slider_crank_is_sound_and_says_every_name() -> None:
    svg = crank()
    assert_sound(svg)
    said = sorted(one.text for one in texts(svg))
    assert said == sorted(["A", "B", "C", "1", "2", "3", "l1", "l2", "l3", "α1", "α1", "α2", "ω1", "x"])


def test_the_polygon_closes_under_the_scheme() -> None:
    nodes = [round(tip.real, 1) + 1j * round(tip.imag, 1) for tip in heads(crank(), "pos") if tip.imag < -50]
    ends = [node for node in nodes if nodes.count(node) == 2]
    assert len(set(ends)) == 1, "the rod's vector and the slider's end in one node"


def test_the_sense_of_the_crank_is_in_its_head() -> None:
    ccw, cw = (slider_crank.draw("k", WORDS, slider_crank.Names(), sense).svg for sense in ("ccw", "cw"))
    assert heads(ccw, "vel")[0].real < heads(cw, "vel")[0].real


def test_what_has_no_name_is_not_drawn() -> None:
    bare = slider_crank.Names(("", "", ""), ("", "", ""), ("", "", ""), ("", ""), "")
    svg = crank(bare)
    assert [one.text for one in texts(svg)] == ["x"]
    assert not heads(svg, "thin") and not heads(svg, "vel")
    nothing = rod_group.Names(("", "", ""), ("", "", ""), "")
    assert texts(arm(nothing, ())) == [] and not heads(arm(nothing, ()), "thin")


def test_figures_may_stand_on_one_page() -> None:
    one = slider_crank.draw("a", WORDS, slider_crank.Names()).svg
    other = slider_crank.draw("b", WORDS, slider_crank.Names()).svg
    ids = re.findall(r' id="([^"]+)"', one + other)
    assert len(ids) == len(set(ids)) == 6


@pytest.mark.parametrize("frames", [(), (0,), (0, 3), (0, 1, 2, 3)])
def test_the_arm_is_sound_with_any_frames(frames: tuple[int, ...]) -> None:
    svg = arm(frames=frames)
    assert_sound(svg)
    said = [one.text for one in texts(svg)]
    assert {"q1", "q2", "q3", "L1", "L2", "L3", "M"} <= set(said)
    assert sorted(name for name in said if name[0] in "xyz") == sorted(
        f"{axis}{number}" for number in frames for axis in ("xyz" if number == 0 else "xz")
    )


def test_an_unknown_frame_is_refused() -> None:
    with pytest.raises(ValueError, match="frames 0 to 3"):
        arm(frames=(0, 4))


@st.composite
def trains(draw_: st.DrawFn) -> list[Mesh]:
    meshes: list[Mesh] = []
    number, before = 1, Wheel("z1", draw_(st.integers(15, 90)))
    ring = False
    for _ in range(draw_(st.integers(1, 4))):
        idle = bool(meshes) and not ring and draw_(st.booleans())
        first = before if idle or not meshes else Wheel(f"z{number}'", draw_(st.integers(15, 90)))
        kind = draw_(st.sampled_from(("external", "internal")))
        low = first.size + 1 if kind == "internal" and idle else 15
        size = draw_(st.integers(int(low), int(low) + 120))
        second = Wheel(f"z{number + 1}", size + (size == first.size))
        meshes.append(Mesh(first, second, "internal" if kind == "internal" else "external"))
        number, before, ring = number + 1, second, kind == "internal" and second.size > first.size
    return meshes


@settings(max_examples=amount(20, 60), deadline=None)
@given(trains(), st.booleans())
def test_a_random_gear_train_is_sound_and_names_every_wheel_once(meshes: list[Mesh], sense: bool) -> None:
    shafts = [f"{number}" for number in range(len(meshes) + 1)]
    svg = draw("g", WORDS, meshes, shafts, ("ω1", f"ω{len(meshes) + 1}"), "+" if sense else "").svg
    assert_sound(svg)
    said = sorted(one.text for one in texts(svg))
    wheels = {wheel.name.replace("'", "′") for mesh in meshes for wheel in (mesh.driver, mesh.driven)}
    assert said == sorted([*wheels, *shafts, "ω1", f"ω{len(meshes) + 1}"])
    assert classes(svg).count("f-link") == len(meshes) + 1
    assert view(svg).right - view(svg).left < 640


def test_the_two_meshes_of_an_idler_stand_in_one_plane() -> None:
    idler = Wheel("z2", 30)
    one = [Mesh(Wheel("z1", 20), idler), Mesh(idler, Wheel("z3", 40))]
    two = [Mesh(Wheel("z1", 20), idler), Mesh(Wheel("z2'", 25), Wheel("z3", 40))]
    planes = [
        {round(a.real) for a, b in segments(draw("g", WORDS, train).svg) if upright(a, b)} for train in (one, two)
    ]
    assert [len(found) for found in planes] == [1, 2]


def upright(start: complex, end: complex) -> bool:
    return start.real == end.real and abs(end - start) > 30


def test_only_a_told_sense_is_drawn() -> None:
    train = [Mesh(Wheel("z1", 20), Wheel("z2", 30))]
    assert heads(draw("g", WORDS, train).svg, "vel") == []
    down, up = (heads(draw("g", WORDS, train, sense=sense).svg, "vel")[0] for sense in ("+", "-"))
    assert down.imag < up.imag


@pytest.mark.parametrize(
    "meshes",
    [
        [],
        [Mesh(Wheel("z1", 0), Wheel("z2", 30))],
        [Mesh(Wheel("z1", 30), Wheel("z2", 30), "internal")],
        [Mesh(Wheel("z1", 20), Wheel("z2", 60), "internal"), Mesh(Wheel("z2", 60), Wheel("z3", 30))],
        [Mesh(Wheel("z1", 20), Wheel("z2", 60)), Mesh(Wheel("z2", 60), Wheel("z3", 30), "internal")],
    ],
)
def test_a_train_that_cannot_be_drawn_is_refused(meshes: list[Mesh]) -> None:
    with pytest.raises(ValueError):
        draw("g", WORDS, meshes)


def test_every_composite_is_drawn_twice_with_the_same_bytes() -> None:
    def all_of_them() -> list[Picture]:
        return [
            slider_crank.draw("k", WORDS, slider_crank.Names()),
            rod_group.draw("r", WORDS, rod_group.Names()),
            draw("g", WORDS, [Mesh(Wheel("z1", 20), Wheel("z2", 30))], ("I", "II"), ("n1", "n2"), "+"),
        ]

    assert all_of_them() == all_of_them()
