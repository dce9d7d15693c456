"""Points in every branch of what turns: beside each border, in corners, near ends, and whether that is all.

Mutants of the search that live on and change nothing that can be seen: how much is spent on it beforehand; lengths that
are not compared, where they are the same.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from graders.language import parse, parse_line
from graders.language.tree import Tree
from graders.solutions.branches import MOST_TURNS, NONE, Branches, branch_starts
from graders.solutions.scene import Effort
from tests.graders.solutions.boxes import RANGES, SCENE, SYMBOLS

MANY = "+".join(f"|x - {k / 10}|" for k in range(2, 4 + MOST_TURNS))


def tree(text: str) -> Tree:
    found = parse(text, SYMBOLS)
    assert isinstance(found, Tree)
    return found


def starts(one: str, other: str = "0", most: int = 40) -> Branches:
    return branch_starts(SCENE, ((tree(one),), (tree(other),)), Effort(), most)


def named(point: list[float]) -> dict[str, float]:
    return dict(zip(RANGES, point, strict=True))


@pytest.mark.parametrize(
    ("text", "inside"),
    [
        ("max(0; x - 1.99)", lambda at: at["x"] > 1.99),
        ("|a - b|", lambda at: at["a"] > at["b"]),
        ("|a - b|", lambda at: at["a"] < at["b"]),
        ("max(0; x + a + b + s - 4.85)", lambda at: at["x"] + at["a"] + at["b"] + at["s"] > 4.85),
        ("max(0; 0.35 - x - a - b)", lambda at: at["x"] + at["a"] + at["b"] < 0.35),
    ],
)
@pytest.mark.parametrize("second", [False, True])
def test_there_is_a_point_in_every_branch_of_either_side(text: str, inside: object, second: bool) -> None:
    found = starts("y", text) if second else starts(text, "y")
    assert callable(inside) and found.proved
    assert {inside(named(point)) for point in found.points} == {True, False}
    assert all(low <= point[at] <= high for point in found.points for at, (low, high) in enumerate(RANGES.values()))


def test_lines_of_the_box_turn_too() -> None:
    scene = replace(SCENE, lines=(("k", parse_line("|a - b|")),))
    found = branch_starts(scene, ((parse_line("y - k"),), (tree("y"),)), Effort(), 40)
    assert {at["a"] > at["b"] for at in map(named, found.points)} == {True, False}


def test_where_nothing_turns_there_are_no_branches() -> None:
    assert starts("x + y", "|x|*a") == NONE
    assert starts("sin(x)", "y^2") == NONE


def test_more_turns_than_are_looked_at_leave_it_open() -> None:
    found = starts(MANY)
    assert found.points and not found.proved


def test_no_more_points_are_given_than_are_asked_for() -> None:
    assert len(starts("|a - b| + |x - 1|", most=3).points) == 3
