"""Equations are equal when they have the same solutions, and a difference is proved at a witness.

Mutants of the comparison that live on change no verdict: other points and values of the unknown at which a ratio is
taken, one of them more or fewer; a ratio where both are zero; zeros known already that are found anew, more lines or
starts than are needed; what is left in an equation that might have been left out; what work is said to cost.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from random import Random

import pytest

from graders.equality import Finding
from graders.language import Symbols, parse
from graders.language.balls import precision
from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.program import Builder, Runner
from graders.language.tree import Relation
from graders.solutions.equations import Pair, compare_equations
from graders.solutions.found import Found
from graders.solutions.reduction import degrees, degrees_along, reduced, residual
from graders.solutions.scene import BITS, WORK, scene_of
from tests.graders.effort import effort
from tests.graders.rewriting import SYMBOLS, drawn
from tests.graders.solutions.boxes import RANGES, SCENE, relation

MANY = "+".join(f"|x - {k / 10}|" for k in range(2, 17))  # more places to turn than are looked at
EQUAL = [
    ("a2", "l1*sin(a1) + l2*sin(a2) = e", "e - l1*sin(a1) = l2*sin(a2)"),
    ("a2", "l1*sin(a1) + l2*sin(a2) = e", "2*e - 2*l1*sin(a1) - 2*l2*sin(a2) = 0"),
    ("a2", "l1*sin(a1) + l2*sin(a2) = e", "a2 = asin((e - l1*sin(a1))/l2)"),
    ("l3", "l1*cos(a1) + l2*cos(a2) = l3", "l3/l2 = cos(a2) + l1/l2*cos(a1)"),
    ("l3", "l2^2 = (l3 - l1*cos(a1))^2 + (l1*sin(a1))^2", "l3^2 - 2*l1*l3*cos(a1) = l2^2 - l1^2"),
    ("w2", "w2*l2*cos(a2) = -w1*l1*cos(a1)", "w2 = -w1*l1*cos(a1)/(l2*cos(a2))"),
    ("x", "x = a", "x^2 = a^2"),
    ("x", "sqrt(x + a) = x", "x + a = x^2"),
    ("y", "y = a", "(y - a)^2 = 0"),
    ("y", "y = a", "(y - a)^3*exp(y) = 0"),
    ("y", "y = a", "y^2 - 2*a*y + a^2 = 0"),
    ("y", "y = a", "-|y - a| = 0"),
    ("y", "y = a", "sqrt(y - a) = 0"),
    ("y", "y = a", "(y - a)/(y - b) = 0"),
    ("y", "y = -a", "(y^2 - a^2)/(y - a) = 0"),
    ("y", "y = a", "(y - a)^2/(y - a) = 0"),
    ("y", "y = a", "sign(y - a) = 0"),
    ("y", "y = a", "<y>^1 = a"),
    ("y", "y = ln(a)", "exp(y) = a"),
    ("y", "y*cos(a) = sin(a)", "y = tan(a)"),
    ("y", "|y| = a", "y^2 = a^2"),
    ("y", "(y - a)*(y - b) = 0", "y^2 - (a + b)*y + a*b = 0"),
    ("y", "a = b", "2*a - 2*b = 0"),
    ("y", "a = b", "-|a - b|^3 = 0"),
    ("y", "(y - a)*sqrt(b) = 0", "(y - a)^(1/3) = 0"),
    ("y", "x^2 + y^2 + 1 = 0", "2*x^2 + 2*y^2 + 2 = 0"),
    ("y", "y - 5 = |y - a|", "2*y - 10 = |2*y - 2*a|"),
    ("y", "1/(y - 5) + 1/a = 1/b", "y = 5 + a*b/(a - b)"),
    ("y", "(y - a)*(y + b)/(y + 5) = 0", "y^2 + (b - a)*y = a*b"),
    ("x", "1/tan(x) = a", "x = atan(1/a)"),
    ("y", "1e200*y = 1e200*a", "1e-200*y = 1e-200*a"),
    ("y", "y^40 = a^40", "|y| = a"),
    ("y", "(y - a)^3 + (y - a)^5 = 0", "y = a"),
    ("y", "(y - a)*(sqrt(y - b) - a) = 0", "((y - a)*(sqrt(y - b) - a) - 0)/(1 + y^2) = 0"),
]
EQUAL += [  # without a solution in the box, with a value on a part of it only: the ratio tells
    ("y", "sqrt(y + 1.7) + a = 0", "2*sqrt(y + 1.7) + 2*a = 0"),
    ("y", "ln(y + 2) = a + 5", "2*ln(y + 2) = 2*a + 10"),
    ("y", "sqrt(2 - y) = a + 5", "b*sqrt(2 - y) = b*(a + 5)"),
]
EQUAL += [  # what is left out, and denominators
    ("y", "3*(y - a)^2 = 0", "y = a"),
    ("y", "(y - a)^2*b = 0", "y = a"),
    ("y", "(y - a)^2/b = 0", "y = a"),
    ("y", "root(y - a; 3) = 0", "y = a"),
    ("y", "root(y - a; 3)/2 = 0", "2*(y - a)^3 = 0"),
    ("y", "(y - a)^(-1) = 1", "y = a + 1"),
    ("y", "1/(y + 5) + a = b + y", "1 = (b + y - a)*(y + 5)"),
    ("y", "b*(a/(y + 5)) = y/(y + 6)", "a*b*(y + 6) = y*(y + 5)"),
    ("y", "(a/(y + 5))/(y + 6) = b/9", "9*a = b*(y + 5)*(y + 6)"),
    ("y", "(y/(y + 5))/a = b", "y = a*b*(y + 5)"),
    ("y", "y/(b/(y + 5)) = a", "y*(y + 5) = a*b"),
    ("y", "y/(1 - 1/(y + 5)) = a", "y*(y + 5) = a*(y + 4)"),
    ("y", "1/(y + 5) - 1/(y + 6) = a/9", "9 = a*(y + 5)*(y + 6)"),
]
DIFFERENT = [
    ("a2", "l1*sin(a1) + l2*sin(a2) = e", "l1*sin(a1) - l2*sin(a2) = e"),
    ("a2", "l1*sin(a1) + l2*sin(a2) = e", "l1*sin(a1) + l2*cos(a2) = e"),
    ("a2", "tan(a2) = -l1*sin(a1)/(l3 - l1*cos(a1))", "a2 = atan2(-l1*sin(a1); l3 - l1*cos(a1))"),
    ("phi", "l1*sin(a1) + l2*sin(phi) = e", "phi = asin((e - l1*sin(a1))/l2)"),
    ("l3", "l1*cos(a1) + l2*cos(a2) = l3", "l3 - l1*cos(a1) = l2*cos(a2)*(1 + 1e-9)"),
    ("l3", "l1*cos(a1) + l2*cos(a2) = l3", "l3 - l1*cos(a1) = l2*cos(a2) + 1e-25"),
    ("x", "x = a", "x = x"),
    ("x", "x = a", "0 = 1"),
    ("x", "x = a", "a = b"),
    ("x", "x = a", "x = 1e12*a"),
    ("y", "y = a", "y^2 = a^2"),
    ("y", "y^2 - 2*a*y + a^2 = 0", "y = b"),
    ("y", "(y^2 - 2*a*y + a^2)*(y - b) = 0", "y = b"),
    ("y", "1/(y - b) = 0", "y = b"),
    ("y", "(y^2 - a^2)/(y - a) = 0", "y^2 = a^2"),
    ("y", "sqrt(y + a) = y", "y + a = y^2"),
    ("y", "sin(y) = 0", "sin(2*y) = 0"),
    ("y", "|y| = a", "y = a"),
    ("y", "<y - a>^1 = 0", "y = a"),
    ("y", "sign(y - a) = 1/2", "y = a"),
    ("y", "y = |a - b|", "y = a - b"),
    ("y", "(y - a)*(y - b)/(y - b) = 0", "(y - a)*(y - b) = 0"),
    ("y", "1/(y - 5) + 1/a = 1/b", "y = 5 - a*b/(a - b)"),
    ("y", "(y - a)*(y - b) = 0", "y = a"),
    ("y", "y*sqrt(y - b) = a*sqrt(y - b)", "y = a"),
    ("y", "(y - a)*(sqrt(y - b) - a) = 0", "(y - a)*(y - a^2 - b) = 0"),
    ("y", "y = -y", "y = y"),
    ("y", "(y - a)^(-1) = 0", "y = a"),
    ("y", "ln(y) = -a", "ln(y) = -a*(1 + <x - 1.9>^1)"),
    ("y", f"y = {MANY} - 12", f"y = 12 - ({MANY})"),
    ("y", "(y - a)*sqrt(a - 0.5) = 0", "y = a"),
    ("y", "(y - a)*root(b - 0.5; 4) = 0", "(y - a)^3 = 0"),
    ("y", "sqrt((y - a)*sqrt(-b)) = 0", "y = a"),
    ("y", "(y^3 + y - a)*asin(1 + a) = 0", "y^3 + y = a"),
]


def compared(unknown: str, reference: str, answer: str) -> Found:
    return compare_equations(relation(answer), relation(reference), SCENE, unknown)


@pytest.mark.parametrize(("unknown", "one", "other"), EQUAL)
def test_the_same_solutions_are_equal_either_way(unknown: str, one: str, other: str) -> None:
    assert compared(unknown, one, other).finding is Finding.EQUAL
    assert compared(unknown, other, one).finding is Finding.EQUAL


@pytest.mark.parametrize(("unknown", "one", "other"), DIFFERENT)
def test_other_solutions_are_different_with_a_witness_that_solves_one_of_them(
    unknown: str, one: str, other: str
) -> None:
    for reference, answer in ((one, other), (other, one)):
        found = compared(unknown, reference, answer)
        assert found.finding is Finding.DIFFERENT
        point = dict(found.witness)
        assert all(RANGES[name][0] - 1e-12 <= value <= RANGES[name][1] + 1e-12 for name, value in point.items())
        assert solves(reference if found.lost else answer, point)


def solves(text: str, point: Mapping[str, float]) -> bool:
    """Tell in doubles whether the sides agree at a point, as far as rounding lets them."""
    builder = Builder(list(point))
    left, right = relation(text).sides
    runner = Runner(builder.program(builder.add(left), builder.add(right)), DOUBLES)
    try:
        one, other = run(runner, list(point.values()))
    except UndefinedError:
        return False
    return bool(abs(one - other) <= 1e-6 * max(1.0, abs(one), abs(other)))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("x^2 + 1 = 0", "x^2 + 2 = 0"),
        ("y = a + 5", "y = a + 6"),
        ("y = a + 5", "y = a + 5 + <a - 0.97>^1"),
        ("y = sqrt(-a)", "y*b = sqrt(-a)*b"),
        ("y = a + 5", "y = a + 5 + 0*sqrt(y + 1)"),
        ("y = a + 5", "y = a + 5 + 0*ln(a - b)"),
    ],
)
def test_without_a_solution_in_the_box_nothing_is_proved(one: str, other: str) -> None:
    assert compared("x", one, other).finding is Finding.UNDECIDED
    assert compared("y", other, one).finding is Finding.UNDECIDED


def test_where_a_branch_may_have_been_missed_nothing_is_equal() -> None:
    assert compared("y", f"y = {MANY} - 12", f"2*y = 2*({MANY}) - 24").finding is Finding.UNDECIDED


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("3*(y*sin(a)) = 3*0", "y*sin(a) = 0"),
        ("(a^2*y*<<3>^1>^2 - 0)*(2 + sin(x)) = 0", "a^2*y*<<3>^1>^2 = 0"),
    ],
)
def test_where_a_factor_without_the_unknown_is_zero_the_same_equations_are_not_different(one: str, other: str) -> None:
    assert compared("x", one, other).finding is not Finding.DIFFERENT
    assert compared("x", other, one).finding is not Finding.DIFFERENT


def test_a_root_that_few_values_of_the_others_bring_into_the_range_counts() -> None:
    ranges = {"l1": (0.04, 0.12), "l2": (0.2, 0.6), "a1": (0.0, 2 * pi), "s": (-0.16, 1.44)}  # 0.2 - 0.12 < 0.16
    scene = scene_of(tuple(ranges), tuple(ranges.values()), b"1085")
    circle = relation("(s - l1*cos(a1))^2 + (l1*sin(a1))^2 = l2^2")
    one_root = relation("s = l1*cos(a1) + sqrt(l2^2 - (l1*sin(a1))^2)")
    assert compare_equations(one_root, circle, scene, "s").finding is Finding.DIFFERENT


def test_a_root_counts_that_steps_do_not_close_in_on() -> None:
    ranges = {"sx": (-2e8, 2e8), "sy": (-2e8, 2e8), "t": (-1e8, 1e8), "s": (-4e8, 4e8)}
    scene = scene_of(tuple(ranges), tuple(ranges.values()), b"")
    texts = "s = (sx + sy)/2 + sqrt(((sx - sy)/2)^2 + t^2)", "atan(s^2 - (sx + sy)*s + sx*sy - t^2) = atan(0)"
    greater, both = (parse(text, Symbols(ranges)) for text in texts)
    assert isinstance(greater, Relation)
    assert isinstance(both, Relation)
    found = compare_equations(greater, both, scene, "s")
    assert (found.finding, found.lost) == (Finding.DIFFERENT, True)


@pytest.mark.parametrize(
    ("unknown", "one", "other", "most"),
    [
        ("l3", "l2^2 = (l3 - l1*cos(a1))^2 + (l1*sin(a1))^2", "l3 = l1*cos(a1) + sqrt(l2^2 - (l1*sin(a1))^2)", 4000),
        ("y", "exp(-y*a) = b", "y = -ln(b)/a", 600),
        ("x", "16*a/(pi*x^3) = b", "x = root(16*a/(pi*b); 3)", 800),
        ("a2", "tan(a2) = a/b", "a2 = atan2(a; b)", 500),
        ("y", "a/(y + b) = 1/3", "y = 3*a - b", 800),
        ("w3", "(w1 - w3)/(w2 - w3) = -b/a", "w3*(a + b) = w1*a + w2*b", 800),
        ("y", "|y| = a", "y^2 = a^2", 3500),
        ("y", "b*(a/(y + 5)) = y/(y + 6)", "a*b*(y + 6) = y*(y + 5)", 2200),
        ("y", "(a/(y + 5))/(y + 6) = b/9", "9*a = b*(y + 5)*(y + 6)", 2400),
        ("y", "y/(1 - 1/(y + 5)) = a", "y*(y + 5) = a*(y + 4)", 2800),
        ("y", "1/(y + 5) - 1/(y + 6) = a/9", "9 = a*(y + 5)*(y + 6)", 2500),
        ("y", "-1/(y + 5) = y - a", "(a - y)*(y + 5) = 1", 1900),
    ],
)
def test_what_shows_all_its_zeros_on_a_line_at_once_is_not_searched(
    unknown: str, one: str, other: str, most: int
) -> None:
    written = [residual(relation(text)) for text in (one, other)]
    trees = [reduced(tree, frozenset((unknown,))) for tree in written]
    with precision(BITS):
        pair = Pair(SCENE, written, trees, SCENE.names.index(unknown))
        pair.known(pair.by_ratio() or pair.by_straight() or pair.by_zeros())
    assert WORK - pair.both.effort.left < most


@pytest.mark.parametrize(
    ("unknown", "one", "other", "lost"),
    [
        ("l3", "l1*cos(a1) + l2*cos(a2) = l3", "l3 = l1*cos(a1) - l2*cos(a2)", True),
        ("y", "exp(y) = a", "y = -ln(a)", False),
        ("y", "x*y = a", "y = a*(1 + 1e-9)/x", True),
    ],
)
def test_a_zero_of_an_affine_side_tells_two_equations_apart_at_once(
    unknown: str, one: str, other: str, lost: bool
) -> None:
    written = [residual(relation(text)) for text in (one, other)]
    trees = [reduced(tree, frozenset((unknown,))) for tree in written]
    with precision(BITS):
        pair = Pair(SCENE, written, trees, SCENE.names.index(unknown))
        found = pair.by_straight()
    assert found is not None
    assert (found.finding, found.lost) == (Finding.DIFFERENT, lost)
    assert solves(one if lost else other, dict(found.witness))
    assert WORK - pair.both.effort.left < 6 * pair.both.cost


def test_the_degrees_along_a_program_are_those_of_its_tree() -> None:
    rng = Random(1)
    for tree in (drawn(rng, 1 + at % 4) for at in range(400)):
        builder = Builder(SYMBOLS)
        slot, found = builder.add(tree), degrees(tree, {})
        program = builder.program(slot)
        assert {name: degrees_along(program, at)[slot] for at, name in enumerate(SYMBOLS)} == {
            name: found.get(name, 0) for name in SYMBOLS
        }


def test_both_sides_of_an_identity_and_of_the_same_text_are_equal() -> None:
    assert compared("x", "x = x", "2*x = x + x").finding is Finding.EQUAL
    assert compared("x", "x = a", "x = a").finding is Finding.EQUAL


def test_the_points_are_the_secret_of_the_server() -> None:
    scenes = [scene_of(("x", "a"), ((0, 2), (0.1, 1)), secret) for secret in (b"one", b"other", b"one")]
    assert scenes[0].points == scenes[2].points != scenes[1].points


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("y = " + "+".join(f"sin({k}*y*a)" for k in range(1, 90)), "y = a"),
        ("y = " + "^".join(["a"] * 40), "y = b"),
        ("sin(" * 25 + "y" + ")" * 25 + " = a/9", "y = b"),
        ("tan(1e9*y) = a", "tan(1e9*y) = a + 1e-9"),
    ],
)
def test_a_hostile_equation_costs_little(one: str, other: str) -> None:
    assert compared("y", one, other).finding in (Finding.DIFFERENT, Finding.UNDECIDED)
    assert effort(lambda: compared("y", one, other), enough=0.1) < 0.1
