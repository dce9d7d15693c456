"""Differences that hide: in a narrow branch, in one corner, under a steep exponent, behind the rounding of doubles."""

from __future__ import annotations

from typing import Any

import pytest

from graders import DHTable, Domain, Outcome, Polygon, Symbols, comparison
from graders.equality import Comparison, Finding, between
from graders.language import parse_line
from tests.graders.chain.truth import motion
from tests.graders.polygon.mechanisms import SLIDER

BOX = {"r": Domain(1, 2), "x": Domain(0, 1), "y": Domain(0, 1), "z": Domain(-1, 1)}
VARS = {"r": ["1", "2"], "x": ["0", "1"], "y": ["0", "1"], "z": ["-1", "1"]}
UNKNOWN: dict[str, Any] = {"equation": "x", "system": ["x", "z"]}
NOISE = "sign(sin(y)^2 + cos(y)^2 - 1)"  # of zero, which is zero


def found(a: str, b: str) -> set[Comparison]:
    return {between(parse_line(a), parse_line(b), BOX), between(parse_line(b), parse_line(a), BOX)}


def verdict(kind: str, a: Any, b: Any) -> str:
    request: dict[str, Any] = {"kind": kind, "a": a, "b": b, "vars": VARS}
    if kind in UNKNOWN:
        request["solve_for"] = UNKNOWN[kind]
    return str(comparison.answer(request)["verdict"])


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("r + max(0; sin(1e6*x) - 0.9999999)", "r"),
        ("r + max(0; sin(1e4*x) - 0.999999)", "r"),
        ("r + max(0; cos(1e3*x) + cos(1e3*y) - 1.99999)", "r"),
        ("r + max(0; 1e-5 - (x - 0.31)^2 - (y - 0.77)^2 - (z - 0.11)^2)", "r"),
        ("r + max(0; 1e-4 - max(abs(x - 0.3123); abs(y - 0.7171); abs(z + 0.2121)))", "r"),
        ("r + max(0; 0.001 - abs(x - 0.4))*max(0; 0.001 - abs(y - 0.3))", "r"),
        ("r + <x - 0.999>^1*<y - 0.999>^1", "r"),
        ("r + <x - 0.4>^1*<y - 0.4>^1*<0.40001 - x>^1*<0.40001 - y>^1", "r"),
        ("r + max(min(x; y) - 0.9999; 0)", "r"),
        ("max(x; min(y; z - 0.9999))", "max(x; -1)"),
        ("sqrt((sin(50*x) - 0.999)^2)", "0.999 - sin(50*x)"),
        ("sqrt((sin(5000*x) - 0.9999999)^2)", "0.9999999 - sin(5000*x)"),
        ("atan2(z; y - 1e-6)", "atan(z/(y - 1e-6))"),
        ("asin(sin(1.5708*x))", "1.5708*x"),
        ("sign(x*y - 0.99999)", "-1"),
        ("r + exp(-1e8*(x - 0.5)^2)", "r"),
        ("r + exp(-1e4*x*y)*1e-3", "r"),
        ("r + (4*x*(1 - x))^200", "r"),
    ],
)
def test_a_difference_is_found_in_a_narrow_place(a: str, b: str) -> None:
    assert {one.finding for one in found(a, b)} == {Finding.DIFFERENT}
    assert all(one.witness for one in found(a, b))


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (f"r + {NOISE}", "r"),
        (f"r*{NOISE}", "0"),
        ("r + max(0; sin(x)^2 + cos(x)^2 - 1 - 1e-12)", "r"),
        ("r + max(0; sin(1e6*x) - 1)", "r"),
        ("max(0; x - y)*max(0; y - x) + r", "r"),
        ("<x - y>^0*<y - x>^0 + r", "r"),
        ("max(x; min(y; z))", "min(max(x; y); max(x; z))"),
        ("max(x; y)*min(x; y)", "x*y"),
        ("abs(x^2 + y^2 - 2*x*y)", "(x - y)^2"),
        ("abs(sin(1e5*x))", "sqrt(1 - cos(1e5*x)^2)"),
        ("atan2(x - 0.5; y - 0.5)", "2*atan((x - 0.5)/(sqrt((x - 0.5)^2 + (y - 0.5)^2) + (y - 0.5)))"),
        ("r + max(0; sin(300*x)*sin(200*y) - 1.0001)", "r"),
    ],
)
def test_what_is_equal_is_never_called_different(a: str, b: str) -> None:
    assert {one.finding for one in found(a, b)} <= {Finding.EQUAL, Finding.UNDECIDED}


@pytest.mark.parametrize(
    "nowhere",
    [
        "atan2(acos(cos(z)) - abs(z); 0)",
        "atan2(0; acos(cos(z)) - abs(z))",
        "atan2(x - abs(x); sin(z)^2 + cos(z)^2 - 1)",
    ],
)
def test_an_angle_without_a_direction_is_never_a_value(nowhere: str) -> None:
    assert {one.finding for one in found(f"r + 0*{nowhere}", "r")} & {Finding.EQUAL} == set()
    assert verdict("equation", f"z = r + 0*{nowhere}", "z = r") != "equal"


def test_a_branch_that_is_neither_found_nor_excluded_leaves_the_pair_open() -> None:
    assert {one.finding for one in found("r + max(0; sin(300*x)*sin(200*y) - 0.9999)", "r")} == {Finding.UNDECIDED}


@pytest.mark.parametrize(
    ("kind", "a", "b"),
    [
        ("equation", "x = y", "x*(1 + max(0; sin(1e6*y) - 0.9999999)) = y"),
        ("equation", "x = y", "x - y + <y - 0.99>^1*<z - 0.99>^1 = 0"),
        ("equation", "x = y", "(x - y)*<x - 0.0001>^0 = 0"),
        ("equation", "x = y", "x = y + max(0; 0.0001 - abs(y - 0.3))"),
        ("inequality", "x < y", "x - y + max(0; sin(1e4*y) - 0.99999) < 0"),
        ("inequality", "x < y", "x < y + max(0; 0.0001 - abs(y - 0.3))"),
        ("inequality", "x < y", "(x - y)*(z - 0.9999) > 0"),
        ("system", ["x + z = r", "x - z = y"], ["x = (r + y)/2", "z = (r - y)/2 + max(0; sin(1e4*y) - 0.99999)"]),
        ("matrix", "[[r; x], [y; z]]", "[[r + max(0; sin(1e6*x) - 0.9999999); x], [y; z]]"),
    ],
)
def test_sets_of_solutions_differ_in_a_narrow_branch(kind: str, a: Any, b: Any) -> None:
    assert {verdict(kind, a, b), verdict(kind, b, a)} == {"different"}


@pytest.mark.parametrize(
    ("kind", "a", "b"),
    [
        ("equation", "x = y", f"x + {NOISE} = y"),
        ("equation", "x = y", "(x - y)*(1 + sign(sin(x)^2 + cos(x)^2 - 1)) = 0"),
        ("inequality", "x < y", f"x - y < {NOISE}"),
        ("system", ["x + z = r", "x - z = y"], [f"x = (r + y)/2 + {NOISE}", "z = (r - y)/2"]),
        ("matrix", "[[r; x], [y; z]]", f"[[r + {NOISE}; x], [y; z]]"),
    ],
)
def test_the_sign_of_a_rounding_error_tells_nothing(kind: str, a: Any, b: Any) -> None:
    assert {verdict(kind, a, b), verdict(kind, b, a)} <= {"equal", "undecided"}


@pytest.mark.parametrize(
    ("entry", "outcome"),
    [
        ("q1 + sign((L1 + 1/3)^2 - L1^2 - 2*L1/3 - 1/9)", Outcome.UNDECIDED),
        ("q1 + sign(sin(q2)^2 + cos(q2)^2 - 1)", Outcome.UNDECIDED),
        ("q1 + max(0; sin(1e6*q1) - 0.9999999)", Outcome.UNDECIDED),
        ("q1*sign(L1)", Outcome.RIGHT),
        ("q1 + max(0; L1)", Outcome.WRONG),
    ],
)
def test_a_table_whose_entries_hang_on_a_sign_is_right_only_where_it_is_sure(entry: str, outcome: Outcome) -> None:
    judge, truth = DHTable("RRP"), motion("RRP")
    table = judge.parse(f"[[{entry}; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]", Symbols(truth.names))
    assert judge.check(table, truth).outcome is outcome


@pytest.mark.parametrize(
    ("factor", "outcome"),
    [
        ("(1 + sign(sin(alpha1)^2 + cos(alpha1)^2 - 1))", Outcome.UNDECIDED),
        ("(1 + max(0; sin(1e6*alpha1) - 0.9999999))", Outcome.UNDECIDED),
        ("(1 + <sin(alpha1)^2 + cos(alpha1)^2 - 1>^0)", Outcome.UNDECIDED),
        ("1", Outcome.RIGHT),
    ],
)
def test_a_projection_that_hangs_on_a_sign_is_kept_for_the_lecturer(factor: str, outcome: Outcome) -> None:
    text = SLIDER.polygon.replace("x: l1*", f"x: {factor}*l1*")
    assert factor in text
    judge = Polygon(SLIDER.nodes, "alpha2")
    known = list(SLIDER.states()[0].names)
    assert judge.check(judge.parse(text, Symbols(known, [*known, "alpha2", "l3"])), SLIDER).outcome is outcome
