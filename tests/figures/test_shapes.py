from __future__ import annotations

from itertools import pairwise
from math import cos, pi, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from figures import joints, lines, loads, members, space
from figures.canvas import Circle, Line, Piece, Strokes, Text, bounds
from figures.label import point, symbol
from figures.picture import Table
from figures.placing import is_free, place, spread
from figures.plane import Point, direction, unit
from figures.polygon import Side, polygon, side

angles = st.floats(-pi, pi)


def heads(pieces: tuple[Piece, ...]) -> list[Line]:
    return [piece for piece in pieces if isinstance(piece, Line) and piece.style.startswith("h-")]


def styles(pieces: tuple[Piece, ...]) -> set[str]:
    return {piece.style for piece in pieces if not isinstance(piece, Text) and hasattr(piece, "style")}


@given(angles, st.floats(20, 300))
def test_the_tip_of_a_vector_is_its_end_and_the_shaft_stops_inside_the_head(angle: float, length: float) -> None:
    end = length * unit(angle)
    shaft, head = lines.vector(0, end)
    assert isinstance(shaft, Line) and isinstance(head, Line)
    assert head.points[0] == end
    assert length - 11 < abs(shaft.points[1]) < length


@given(angles, st.floats(0.4, 3), st.booleans(), st.floats(30, 90))
def test_the_head_of_an_arc_ends_it_and_points_along_it(start: float, sweep: float, back: bool, radius: float) -> None:
    end = start - sweep if back else start + sweep
    (head,) = heads(lines.arc(0, radius, start, end))
    tip, *base = head.points
    assert tip == pytest.approx(radius * unit(end))
    along = direction(sum(base) / 2, tip)
    tangent = unit(end) * (-1j if back else 1j)
    assert (unit(along) * tangent.conjugate()).real > cos(radians(12))


def test_hatching_lies_on_the_right_every_seven_units() -> None:
    strokes = lines.hatch(0, 100).pairs
    assert all(start.imag == pytest.approx(0) and end.imag < 0 for start, end in strokes)
    assert {round((b[0] - a[0]).real, 6) for a, b in pairwise(strokes)} == {7}
    assert all(end.real >= 0 and start.real <= 100 for start, end in strokes)


def test_a_leader_reaches_the_nearer_end_of_its_shelf() -> None:
    line = lines.leader(0, (50 + 40j, 20 + 40j))[1]
    assert isinstance(line, Line) and line.points == (0, 20 + 40j, 50 + 40j)


def test_supports_stand_below_their_point_and_are_symmetric() -> None:
    for support in (members.pin_support(0), members.roller_support(0)):
        solid = tuple(piece for piece in support if not isinstance(piece, Strokes))
        box = bounds(solid)
        assert box.left == pytest.approx(-box.right) and box.top == pytest.approx(4, abs=0.1)
        assert "f-hatch" in styles(support)


def test_a_wall_is_hatched_away_from_the_member() -> None:
    assert bounds(members.fixed_end(0, pi)).left < -7 and bounds(members.fixed_end(0, pi)).right < 1e-9
    assert bounds(members.fixed_end(0, 0)).right > 7 and bounds(members.fixed_end(0, 0)).left > -1e-9


def test_joints_follow_the_drawing_language() -> None:
    assert [piece.radius for piece in joints.revolute(0, double=True) if isinstance(piece, Circle)] == [8, 5]
    block = bounds((joints.slider(0),))
    assert (block.right - block.left, block.top - block.bottom) == (52, 30)
    fork = joints.gripper(0, 0)
    assert abs(fork.points[1] - fork.points[2]) == 18 and fork.points[0].real > 0


@pytest.mark.parametrize("down", [True, False])
def test_a_force_points_its_way(down: bool) -> None:
    (head,) = heads(loads.force(5, 80, down))
    assert head.points[0] == (5 if down else 5 + 80j)


def test_arrows_are_in_proportion_but_never_too_short() -> None:
    assert [loads.arrow_length(value, 8) for value in (8, -6, 1)] == [80, 60, 40]
    assert loads.arrow_length(0, 0) == 80


def test_a_distributed_load_follows_its_line_and_leaves_out_arrows_without_room() -> None:
    falling = loads.distributed(0, 300, 0, 30)
    assert isinstance(falling[0], Line) and falling[0].points == (0, 300 + 30j)
    tips = [head.points[0] for head in heads(falling)]
    assert tips and all(tip.imag == 0 for tip in tips) and len(tips) < 11
    assert all(head.points[0].imag == 20 for head in heads(loads.distributed(0, 90, -20, -20)))


@pytest.mark.parametrize("sense", [True, False])
def test_a_couple_turns_its_way(sense: bool) -> None:
    (head,) = heads(loads.couple(0, sense))
    assert (head.points[0].real < 0) is sense


@pytest.mark.parametrize("positive", [True, False])
def test_the_near_side_of_a_positive_torque_goes_down(positive: bool) -> None:
    (head,) = heads(loads.torque(0, positive))
    assert (head.points[0].imag < 0) is positive


def test_a_side_of_a_polygon_carries_its_name_under_an_arrow_on_the_wanted_side() -> None:
    for aside in (1, -1):
        marks = side(Side(0, 200, "l2", aside))
        (text,) = [mark for mark in marks if isinstance(mark, Text)]
        assert (text.at.imag > 0) == (aside > 0)
        assert not text.box.crossed_by((0, 200))
    assert len(polygon((Side(0, 50, ""), Side(50, 50j, "")))) == 4


def test_a_label_takes_the_first_free_spot() -> None:
    wall = Line("f-link", (5 - 50j, 5 + 50j))
    (text,) = place(point("A"), ((0, "start"), (30 + 0j, "start")), (wall,))
    assert isinstance(text, Text) and text.at == 30


def test_a_label_without_a_free_spot_gets_a_leader() -> None:
    wall = Line("f-link", (5 - 50j, 5 + 50j))
    dot, shelf, text = place(symbol("F1"), ((0, "start"),), (wall,), 5 + 40j)
    assert isinstance(dot, Circle) and dot.centre == 5 + 40j and isinstance(shelf, Line)
    assert isinstance(text, Text) and is_free(text.box, (wall, shelf))


def test_a_label_that_fits_nowhere_is_an_error() -> None:
    grid = tuple(Line("f-thin", (complex(-300, y), complex(300, y))) for y in range(-20, 600, 5))
    with pytest.raises(ValueError, match="no room"):
        place(symbol("F1"), ((0, "start"),), grid)


@given(st.lists(st.floats(0, 300), min_size=1, max_size=6).map(sorted))
def test_things_in_a_row_move_apart_only_as_far_as_needed(wanted: list[float]) -> None:
    widths = [20.0 + 5 * i for i in range(len(wanted))]
    found = spread(wanted, widths)
    gaps = [b - a - (v + w) / 2 for a, b, v, w in zip(found, found[1:], widths, widths[1:], strict=False)]
    assert all(gap > -1e-6 for gap in gaps)
    if len(found) == 1 or all(b - a >= 50 for a, b in pairwise(wanted)):
        assert found == pytest.approx(wanted)
    assert sum(found) == pytest.approx(sum(wanted), abs=1e-6 * len(wanted) + 1e-6)


def test_a_row_of_another_length_is_refused() -> None:
    with pytest.raises(ValueError, match="cells"):
        Table(("a", "b"), (("1",),))


def test_projection_keeps_lengths_across_the_line_of_sight() -> None:
    level = space.cross(space.Z, space.EYE)
    long = sum(part * part for part in level) ** 0.5
    assert abs(space.seen(level)) == pytest.approx(long)
    assert abs(space.seen(space.EYE)) == pytest.approx(0, abs=1e-12)
    assert space.seen(space.Z).imag > 0


@given(angles)
def test_the_end_of_a_cylinder_turned_to_the_eye_is_whole(angle: float) -> None:
    along = space.turn(space.X, space.Y, angle)
    body, cap = space.cylinder((0, 0, 0), along, 30, 12)
    assert isinstance(body, Line) and isinstance(cap, Line) and len(cap.points) == 32
    toward = space.dot(along, space.EYE)
    middle: Point = sum(cap.points) / 32
    expected = space.seen(space.plus((0, 0, 0), (15 if toward > 0 else -15, along)))
    assert middle == pytest.approx(expected, abs=1e-9)


def test_a_spatial_arc_ends_in_the_direction_of_its_angle() -> None:
    pieces = space.spatial_arc((0, 0, 0), 50, space.X, space.Y, pi / 2)
    (head,) = heads(pieces)
    assert head.points[0] == pytest.approx(space.seen((0, 50, 0)))
