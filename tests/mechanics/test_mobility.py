"""The true mobility is found by moving: rank at a place reached by finite steps, against the formula."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import pytest

from mechanics.mobility import Joint, local_freedoms, plane, space


def bar(*at: float, links: str) -> Joint:
    return Joint("R", tuple(links), at)


def four_bar(third: float = 1.0) -> list[Joint]:
    """A parallelogram on the base (0,0)-(3,0) with cranks of length 1 at 1 rad, and a third crank in the middle."""
    x, y = cos(1.0), sin(1.0)
    return [
        bar(0, 0, links="01"),
        bar(x, y, links="12"),
        bar(3 + x, y, links="23"),
        bar(3, 0, links="30"),
        bar(1.5, 0, links="04"),
        bar(1.5 + third * x, third * y, links="42"),
    ]


def test_a_four_bar_moves_as_counted() -> None:
    found = plane("0123", four_bar()[:4])
    assert (found.formula, found.instantaneous, found.true, found.passive, found.loops) == (1, 1, 1, 0, 1)
    assert (found.moving, found.classes) == (3, {5: 4})


def test_a_third_equal_crank_is_a_passive_constraint() -> None:
    """STR-5: formal mobility 0, rank 11 of 12, true mobility 1."""
    found = plane("01234", four_bar())
    assert (found.formula, found.true, found.passive, found.rank) == (0, 1, 1, 11)


def test_a_third_crank_of_another_length_only_trembles() -> None:
    """The cranks are parallel in this position: an instantaneous freedom that is no motion."""
    found = plane("01234", four_bar(third=1.2))
    assert (found.formula, found.instantaneous, found.true, found.passive) == (0, 1, 0, 0)


def test_a_straightened_two_bar_has_an_instantaneous_freedom_only() -> None:
    found = plane("012", [bar(0, 0, links="01"), bar(1, 0, links="12"), bar(3, 0, links="20")])
    assert (found.formula, found.instantaneous, found.true) == (0, 1, 0)


def straight(*links: str, y: float = -1.0) -> list[Joint]:
    """Two bars in line between pivots of the frame: they tremble, and do not move."""
    one, other = links
    return [bar(0, y, links="0" + one), bar(1.2, y, links=one + other), bar(3, y, links=other + "0")]


def test_bars_that_only_tremble_add_no_freedom_to_a_mechanism_that_moves() -> None:
    one = plane("012356", [*four_bar()[:4], *straight("5", "6")])
    assert (one.instantaneous, one.true) == (2, 1)
    passive = plane("0123456", [*four_bar(), *straight("5", "6")])
    assert (passive.formula, passive.instantaneous, passive.true, passive.passive) == (0, 2, 1, 1)


def test_one_motion_is_found_among_many_directions_that_tremble() -> None:
    pairs = ("ab", "cd", "ef", "gh", "ij", "kl", "mn", "op")
    many = [joint for y, pair in enumerate(pairs) for joint in straight(*pair, y=-1.0 - y)]
    found = plane("01234" + "".join(pairs), [*four_bar(), *many])
    assert (found.instantaneous, found.true) == (9, 1)


def test_two_passive_mechanisms_beside_bars_that_tremble_have_two_freedoms() -> None:
    other = [replace(joint, links=tuple("0789x"["01234".index(link)] for link in joint.links)) for joint in four_bar()]
    found = plane("0123456789x", [*four_bar(), *straight("5", "6"), *other])
    assert (found.instantaneous, found.true) == (3, 2)


def test_in_space_too_bars_that_tremble_add_no_freedom() -> None:
    z = (0.0, 0.0, 1.0)
    flat = [*four_bar()[:4], *straight("5", "6")]
    drawn = [replace(joint, at=(*(joint.at or ()), 0.0), direction=z) for joint in flat]
    found = space("012356", drawn)
    assert (found.instantaneous, found.true) == (2, 1)


def test_a_flattened_parallelogram_has_two_free_directions_but_one_freedom() -> None:
    joints = [bar(0, 0, links="01"), bar(1, 0, links="12"), bar(4, 0, links="23"), bar(3, 0, links="30")]
    found = plane("0123", joints)
    assert (found.instantaneous, found.true) == (2, 1)


def test_a_slider_crank_and_a_cam_with_a_roller() -> None:
    slider = [
        bar(0, 0, links="01"),
        bar(1, 1, links="12"),
        bar(3, 0, links="23"),
        Joint("P", ("3", "0"), (3, 0), (1, 0)),
    ]
    assert plane("0123", slider).true == 1
    cam = [
        bar(0, 0, links="01"),
        Joint("H", ("1", "2"), (0.2, 1.0), (0.1, 1.0)),
        bar(0.25, 1.5, links="23"),
        Joint("P", ("3", "0"), (0.25, 2.0), (0, 1)),
    ]
    assert local_freedoms("0123", cam) == {"2": 1}  # welded to the follower the roller leaves one freedom
    assert local_freedoms("0123", slider) == {}
    found = plane("0123", cam)
    assert (found.formula, found.true, found.classes) == (2, 2, {5: 3, 4: 1})  # the roller's own turn is one of them


def test_a_joint_of_three_links_counts_twice() -> None:
    triple = plane("0123", [bar(0, 0, links="01"), Joint("R", ("1", "2", "3"), (1, 1)), bar(2, 0, links="20"),
                            bar(1, -3, links="30")])  # fmt: skip
    assert triple.classes == {5: 5} and triple.formula == -1


def test_without_places_only_the_formula_speaks() -> None:
    joints = [
        Joint(kind, links) for kind, links in zip("RRSS", (("0", "1"), ("3", "0"), ("1", "2"), ("2", "3")), strict=True)
    ]
    found = space("0123", joints)
    assert (found.formula, found.true, found.passive, found.loops) == (2, None, None, 1)


def axis(kind: str, links: str, at: tuple[float, ...], direction: tuple[float, ...], pitch: float = 0.0) -> Joint:
    return Joint(kind, tuple(links), at, direction, pitch=pitch)


def test_a_planar_four_bar_in_space_has_three_passive_constraints() -> None:
    z = (0.0, 0.0, 1.0)
    places = [(0.0, 0.0, 0.0), (0.3, 1.0, 0.0), (2.0, 1.4, 0.0), (2.5, 0.0, 0.0)]
    found = space("0123", [axis("R", ends, at, z) for ends, at in zip(("01", "12", "23", "30"), places, strict=True)])
    assert (found.formula, found.true, found.passive) == (-2, 1, 3)


def test_a_coupler_with_two_spheres_spins() -> None:
    joints = [
        axis("R", "01", (0, 0, 0), (1, 0, 0)),
        Joint("S", ("1", "2"), (0, 0.6, 0.8)),
        Joint("S", ("2", "3"), (2, 1, 1.5)),
        axis("R", "30", (2, 1, 0), (0, 1, 0)),
    ]
    found = space("0123", joints)
    assert (found.formula, found.true, found.passive) == (2, 2, 0)
    assert local_freedoms("0123", joints, in_space=True) == {"2": 1}


def test_local_freedoms_need_places() -> None:
    with pytest.raises(ValueError, match="joint 1: local freedoms need the place"):
        local_freedoms("01", [Joint("R", ("0", "1"))])


def test_a_link_in_no_joint_is_named() -> None:
    with pytest.raises(ValueError, match="link '7' is in no joint"):
        plane("017", [bar(0, 0, links="01")])


@pytest.mark.parametrize(("kind", "freedoms"), [("R", 1), ("P", 1), ("H", 1), ("C", 2), ("U", 2), ("S", 3), ("E", 3),
                                                ("L", 4), ("B", 5)])  # fmt: skip
def test_a_single_pair_leaves_the_freedoms_of_its_class(kind: str, freedoms: int) -> None:
    found = space("01", [axis(kind, "01", (0.3, 0.2, 0.1), (1, 2, 3), pitch=0.5)])
    assert (found.formula, found.instantaneous, found.true) == (freedoms, freedoms, freedoms)


def test_a_screw_press_has_one_freedom() -> None:
    """A screw in the frame, a nut kept from turning by a guide: C between screw and frame, H to the nut, P to frame."""
    x = (1.0, 0.0, 0.0)
    joints = [axis("R", "01", (0, 0, 0), x), axis("H", "12", (1, 0, 0), x, pitch=0.1), axis("P", "20", (1, 1, 0), x)]
    found = space("012", joints)
    assert (found.formula, found.true, found.passive) == (-3, 1, 4)


def test_a_universal_joint_turns_about_its_own_two_axes() -> None:
    joint = Joint("U", ("0", "1"), (0, 0, 0), (1, 0, 0), second=(0, 1, 0))
    assert space("01", [joint]).true == 2


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        (Joint("Q", ("0", "1")), "kind 'Q'"),
        (Joint("R", ("0", "9")), "'9' is no link"),
        (Joint("R", ("0",)), "two or more"),
        (Joint("P", ("0", "1"), (0, 0)), "needs a direction"),
        (Joint("P", ("0", "1"), (0, 0), (0, 0)), "needs a direction"),
        (Joint("R", ("0", "1"), (0, float("nan"))), "must be finite"),
        (Joint("R", ("0", "1"), (0, 0, 0)), "needs 2 numbers"),
    ],
)
def test_impossible_joints_are_refused_by_name(joint: Joint, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        plane("01", [joint])


def test_the_frame_must_be_there_and_names_single() -> None:
    with pytest.raises(ValueError, match="frame"):
        plane("12", [])
    with pytest.raises(ValueError, match="twice"):
        plane("011", [])


@pytest.mark.parametrize("far", [1e3, -1e4])
def test_a_drawing_far_from_the_origin_has_the_same_mobility(far: float) -> None:
    moved = [replace(joint, at=(joint.at[0] + far, joint.at[1] - far)) for joint in four_bar() if joint.at]
    found = plane("01234", moved)
    assert (found.instantaneous, found.true, found.rank) == (1, 1, 11)
    rods = [
        replace(joint, at=(joint.at[0] + far, joint.at[1], far), direction=(0, 0, 1))
        for joint in four_bar()[:4]
        if joint.at
    ]
    assert space("0123", rods).true == 1


def test_a_turned_drawing_has_the_same_mobility() -> None:
    def turned(joint: Joint) -> Joint:
        assert joint.at is not None
        (x, y), c, s = joint.at, cos(pi / 5), sin(pi / 5)
        return Joint(joint.kind, joint.links, (c * x - s * y + 7, s * x + c * y - 3))

    assert plane("01234", [turned(joint) for joint in four_bar()]).true == 1
