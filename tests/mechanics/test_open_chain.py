"""Freedoms of the last link by the rank of its twists, against singular values and turned drawings; rod groups."""

from __future__ import annotations

from math import cos, nan, sin
from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.open_chain import Axis, Kind, functional_group, spare_freedoms, tip_freedom
from tests.depth import amount

quick = settings(max_examples=amount(16, 50), deadline=None)
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
whole = st.integers(-3, 3).map(float)
vectors = st.tuples(whole, whole, whole)
axes = st.builds(Axis, st.sampled_from(get_args(Kind)), vectors.filter(any), vectors)


def chain(word: str, *directions: tuple[float, float, float]) -> list[Axis]:
    kinds: list[Kind] = ["R" if letter == "R" else "P" for letter in word]
    return [Axis(kind, direction) for kind, direction in zip(kinds, directions, strict=True)]


@quick
@given(st.lists(axes, max_size=8))
def test_the_last_link_has_as_many_freedoms_as_singular_values_say(joints: list[Axis]) -> None:
    twists = np.array([joint.twist(1.0) for joint in joints]).reshape(-1, 6)
    assert tip_freedom(joints) == np.linalg.matrix_rank(twists)
    assert tip_freedom(joints) + spare_freedoms(joints) == len(joints)


@quick
@given(st.lists(axes, max_size=7), st.floats(-3, 3), st.floats(0.01, 100), vectors)
def test_a_turned_moved_and_enlarged_drawing_has_the_same_freedoms(
    joints: list[Axis], turn: float, scale: float, shift: tuple[float, float, float]
) -> None:
    def turned(v: tuple[float, float, float]) -> tuple[float, float, float]:
        return cos(turn) * v[0] - sin(turn) * v[1], sin(turn) * v[0] + cos(turn) * v[1], v[2]

    def moved(v: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = turned(v)
        return scale * (x + shift[0]), scale * (y + shift[1]), scale * (z + shift[2])

    other = [Axis(joint.kind, turned(joint.direction), moved(joint.at)) for joint in joints]
    assert tip_freedom(other) == tip_freedom(joints)


def test_chains_of_the_domain() -> None:
    """STR-9: a telescope of five sections, a plane arm, an arm of seven revolutes."""
    telescope = chain("PPPPP", X, X, X, X, X)
    assert (tip_freedom(telescope), spare_freedoms(telescope)) == (1, 4)
    plane = [Axis("R", Z), Axis("R", Z, (1.0, 0.0, 0.0)), Axis("P", (1.0, 1.0, 0.0))]
    assert (tip_freedom(plane), spare_freedoms(plane)) == (3, 0)
    places = [(i * i / 3, (i % 3) / 2, i / 3) for i in range(7)]
    arm = [Axis("R", d, at) for d, at in zip((Z, Y, Z, Y, Z, Y, (1.0, 1.0, 0.0)), places, strict=True)]
    assert (tip_freedom(arm), spare_freedoms(arm)) == (6, 1)


@pytest.mark.parametrize(
    ("word", "directions", "group"),
    [
        ("PPP", (X, Y, Z), 1),
        ("PPP", (X, (1.0, 1.0, 0.0), Y), None),  # coplanar guides
        ("RPP", (Z, Z, X), 2),
        ("RPP", (Z, X, Z), 2),
        ("RPP", (Z, X, Y), None),
        ("RRP", (Z, Y, X), 3),
        ("RRP", (Z, Y, Z), 3),  # drawn with the arm upright: coplanar here, not in general
        ("RRP", (Z, Z, X), None),
        ("RRP", (Z, Y, Y), None),
        ("PRR", (Z, Z, Z), 4),
        ("PRR", (X, Z, Z), None),
        ("RRR", (Z, Y, Y), 5),
        ("RRR", (Z, Z, Z), None),
        ("RRR", (Z, Y, Z), None),  # parallel in the drawn position only
        ("PRP", (Z, Z, X), 6),
        ("PRP", (Z, X, X), None),
        ("RPR", (Z, Z, X), None),
    ],
)
def test_rod_groups_are_told_by_their_directions(
    word: str, directions: tuple[tuple[float, float, float], ...], group: int | None
) -> None:
    assert functional_group(chain(word, *directions)) == group


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Axis("C", X), "joint kind 'C'"),  # type: ignore[arg-type]
        (lambda: Axis("R", (0.0, 0.0, 0.0)), "direction must not be zero"),
        (lambda: Axis("R", X, (nan, 0.0, 0.0)), "axis: at"),
        (lambda: functional_group(chain("RR", X, Y)), "three joints, not 2"),
    ],
)
def test_impossible_chains_are_refused_by_name(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(ValueError, match=message):
        make()
