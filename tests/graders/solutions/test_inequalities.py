"""Inequalities are equal when they hold at the same points: inside, on the borders and between them.

Mutants of the comparison that live on change no verdict: corners a little outside the box; borders of one line that are
known already, or one more of them; borders looked for down a slope although lines have met them; what is noted as
unsure where the comparison ends anyway; the end of the last stretch of a line, within which another point is tested.
"""

from __future__ import annotations

import pytest

from graders.equality import Finding
from graders.language import Symbols, parse
from graders.language.balls import precision
from graders.language.tree import Relation
from graders.solutions.found import Found
from graders.solutions.inequalities import INEQUALITY_WORK, Regions, compare_inequalities
from graders.solutions.scene import BITS, scene_of
from tests.graders.effort import effort
from tests.graders.solutions.boxes import SCENE, relation

EQUAL = [
    ("y < a", "a > y"),
    ("y < a", "2*y - 2*a < 0"),
    ("0 < y <= a", "a >= y > 0"),
    ("0 < y < a", "y*(a - y) > 0"),
    ("0 <= y <= a", "y*(y - a) <= 0"),
    ("|y| < a", "-a < y < a"),
    ("|y| < a", "y^2 < a^2"),
    ("y^2 >= 0", "1 > 0"),
    ("y^2 + 1 > 0", "y^2 + 2 > 0"),
    ("l1 + l2 < r3 + l4", "l2 < r3 + l4 - l1"),
    ("sqrt(y) < a", "0 <= y < a^2"),
    ("ln(y) > 0", "y > 1"),
    ("y/a > b", "y > a*b"),
    ("y/(y - a) > 0", "y*(y - a) > 0"),
    ("y < a < y + 1", "a - 1 < y < a"),
    ("sin(y) > 0", "0 < y < pi"),
    ("(y - a)^3 > 0", "3*(y - a)^3 > 3*0"),
    ("-b <= y*sin(x) <= a", "a >= y*sin(x) >= -b"),
    ("y < sqrt(a - b)", "(y - sqrt(a - b))*(a - b) < 0"),
    ("y*(y - a) < 0", "y*(y - a) + 0*sqrt(y) < 0"),
    ("max(0; y - a)*x > 0", "y > a"),
]
DIFFERENT = [
    ("y < a", "y <= a"),
    ("y < a", "y < a*(1 + 1e-9)"),
    ("y <= a", "y < a + 1e-30"),
    ("y < a", "y > a"),
    ("0 < y < a", "y > 0"),
    ("0 < y <= a", "0 < y < a"),
    ("|y| <= a", "y^2 < a^2"),
    ("|y| < a", "y < a"),
    ("(y - a)^2 > 0", "1 > 0"),
    ("y < a", "0 < 1"),
    ("l1 + l2 <= r3 + l4", "l1 + l2 < r3 + l4"),
    ("sqrt(y) < a", "y < a^2"),
    ("1/y < a", "1 < a*y"),
    ("max(y; z) < a", "y < a"),
    ("x^2 + y^2 + 0*sqrt(y) < 1", "x^2 + y^2 < 1"),
    ("(y - a)^2 > 0", "(y - a)^2 > 1e-25"),
    ("max(0; y - a)*(y - b)^2 > 0", "y > a"),
]


def compared(reference: str, answer: str) -> Found:
    return compare_inequalities(relation(answer), relation(reference), SCENE)


@pytest.mark.parametrize(("one", "other"), EQUAL)
def test_the_same_region_is_equal_either_way(one: str, other: str) -> None:
    assert compared(one, other).finding is compared(other, one).finding is Finding.EQUAL


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_another_region_is_different_with_a_witness(one: str, other: str) -> None:
    found, back = compared(one, other), compared(other, one)
    assert found.finding is back.finding is Finding.DIFFERENT
    assert found.witness and found.lost is not back.lost


def test_a_flat_border_between_a_true_one_and_a_false_one_counts() -> None:
    scene = scene_of(("phi", "mu"), ((-1.5, 1.5), (0.05, 0.325)))
    one, other = (parse(text, Symbols(scene.names)) for text in ("tan(phi) < phi", "sin(phi) < mu"))
    assert isinstance(one, Relation)
    assert isinstance(other, Relation)
    assert compare_inequalities(other, one, scene).finding is Finding.DIFFERENT


def test_a_border_of_both_is_looked_for_once() -> None:
    both = Regions(SCENE, relation("|y*sin(x)| <= a"), relation("-a <= y*sin(x) <= a"))
    with precision(BITS):
        assert both.known().finding is Finding.EQUAL
    assert INEQUALITY_WORK - both.effort.left < 18_000


@pytest.mark.parametrize(("terms", "finding"), [(16, Finding.EQUAL), (40, Finding.UNDECIDED)])
def test_what_is_dear_is_equal_once_a_point_with_all_its_lines_was_tested(terms: int, finding: Finding) -> None:
    long = "y < " + "+".join(f"atan(y/{k} + a)" for k in range(2, terms))
    back = "y < " + "+".join(f"atan(a + y/{k})" for k in range(terms - 1, 1, -1))
    assert compared(long, back).finding is finding


def test_a_hostile_inequality_costs_little() -> None:
    long = "y < " + "+".join(f"asin(y/{k} + a)" for k in range(2, 100))
    back = "y < " + "+".join(f"asin(a + y/{k})" for k in range(99, 1, -1))
    assert effort(lambda: compared(long, back), enough=0.1) < 0.1


@pytest.mark.parametrize("seed", range(24))
def test_a_border_that_hardly_any_line_meets_is_tested_for_every_seed(seed: int) -> None:
    ranges = {"l1": (0.04, 0.12), "l2": (0.1, 0.6), "e": (0.01, 0.09), "phi": (0.0, 6.3)}
    scene = scene_of(tuple(ranges), tuple(ranges.values()), bytes([seed]))
    for text in ("l1 + e < l2", "l2 - l1 - e > 1e-9", "e^2 <= (l2 - l1)^2"):
        found = compare_inequalities(relation(text), relation("l1 + e <= l2"), scene)
        assert found.finding is Finding.DIFFERENT


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("sqrt(y) < a", "sqrt(y)*sqrt(a - b) < a*sqrt(a - b)"),
        ("sqrt(y) < a/3", "sqrt(y)*sqrt(x - 0.2) < a/3*sqrt(x - 0.2)"),
        ("a + ln(y) < 0", "0*sqrt(x - 0.2) > a + ln(y)"),
    ],
)
def test_what_holds_between_an_edge_and_a_border_counts_for_every_seed(one: str, other: str, seed: int) -> None:
    scene = scene_of(("x", "y", "a", "b"), ((0.1, 2), (-2, 2), (0.1, 1), (0.1, 1)), bytes([seed]))
    for answer, reference in ((one, other), (other, one)):
        found = compare_inequalities(relation(answer), relation(reference), scene)
        assert found.finding is Finding.DIFFERENT
