"""Where a formula turns inside a box: what is told without a search, and what stands on both sides."""

from __future__ import annotations

import pytest

from graders import Domain
from graders.equality import Comparison, Finding, between
from graders.equality.pair import EQUAL, Pair
from graders.judge import Formula
from graders.language import parse_line
from graders.states import spread

BOX = {"c": Domain(-2, 2), "r": Domain(1, 2), "x": Domain(0, 1), "y": Domain(0, 1), "z": Domain(-1, 1)}


def pair(a: str, b: str) -> Pair:
    return Pair(parse_line(b), Formula(parse_line(a), spread(BOX, b"turns")), mutual=True)


def found(a: str, b: str) -> set[Finding]:
    one, other = parse_line(a), parse_line(b)
    return {between(one, other, BOX, b"turns").finding, between(other, one, BOX, b"turns").finding}


@pytest.mark.parametrize(
    "text",
    [
        "sqrt(z^2)",
        "sqrt(4*z^2*r)",
        "ln(abs(z))",
        "(z^2)^(3/2)",
        "root(z; 3)",
        "root(z*z; 4)",
        "log(x*z^2/c^4)",
        "acos(cos(c))",
        "asin(sin(2*c))",
    ],
)
def test_a_root_of_an_even_power_turns_where_its_base_changes_sign(text: str) -> None:
    turns = pair(text, "r").turns
    assert turns and not any(turn.edge for turn in turns)


@pytest.mark.parametrize(
    "text", ["sqrt(z)", "sqrt(c*z)", "sqrt(z^3)", "root(z; 4)", "ln(-z^2*c)", "z^1.5", "sqrt(0*z^2)"]
)
def test_a_root_of_anything_else_ends_where_that_is_below_zero(text: str) -> None:
    assert any(turn.edge for turn in pair(text, "r").turns)


@pytest.mark.parametrize(
    "text",
    [
        "atan2(r; z)",
        "atan2(z; r)",
        "atan2(x*r; c)",
        "acos((r^2 + 9 - (1 + r + x)^2)/(6*r))",
        "acos(z/sqrt(z^2 + x^2))",
        "asin((r^2 - 1 - x)/(r^2 + 1 + x))",
    ],
)
def test_a_direction_never_cut_and_an_arc_that_never_ends_do_not_turn(text: str) -> None:
    other = "r + 0*sqrt(((1 + r + x)^2 - (3 - r)^2)*((r + 3)^2 - (1 + r + x)^2)*r^2*(1 + x)) + 0*z^2"
    assert not pair(text, other).turns


@pytest.mark.parametrize("text", ["atan2(z; c)", "atan2(z; -r)", "acos(cos(c))", "asin((1 + x)*r/2)", "acos(abs(z))"])
def test_a_direction_that_may_be_cut_and_an_arc_that_may_end_turn(text: str) -> None:
    assert pair(text, "r").turns


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("r*(<c - x>^2 - <c - y>^1 + <z - x>^3 - <z - y>^2)", "r*<c - x>^2 + r*<z - x>^3 - <c - y>^1*r - <z - y>^2*r"),
        (
            "x*abs(c - x)*(abs(c - y) + abs(z - x) + abs(z - y) + abs(c - z)*abs(c + z))",
            "x*(abs(y - c) + abs(2*z - 2*y)/2)*abs(x - c) + (abs(x - z) + abs(c - z)*abs(z + c))*x*abs(c - x)",
        ),
        ("sqrt(c)*sqrt(z)*(sqrt(c - z) + r)", "r*sqrt(c)*sqrt(z) + sqrt(z)*sqrt(c - z)*sqrt(c)"),
        ("(max(c; z) - min(z; c))*(max(x; z) + max(y; z))", "max(c; z)*max(x; z) + max(c; z)*max(y; z) "
         "- min(z; c)*(max(x; z) + max(y; z))"),
    ],
)  # fmt: skip
def test_what_turns_on_both_sides_needs_no_cases(a: str, b: str, monkeypatch: pytest.MonkeyPatch) -> None:
    said, agree = list[tuple[bool, bool]](), Pair._agree

    def listened(self: Pair, parted: bool) -> bool:
        said.append((parted, agree(self, parted)))
        return said[-1][1]

    monkeypatch.setattr(Pair, "_agree", listened)
    assert found(a, b) == {Finding.EQUAL}
    assert set(said) == {(False, True)}


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("sqrt(z^2*x)", "z*sqrt(x)"),
        ("root(z; 3)", "z^(1/3)"),
        ("ln(z^2)/2", "ln(z)"),
        ("(z^2)^(3/2)", "z^3"),
        ("root(z^2*r; 4)", "sqrt(z)*root(r; 4)"),
        ("atan2(r; z)", "atan(r/z)"),
        ("acos((r^2 + 1 - x^2)/(2*r))", "acos((r^2 + 1 - x^2)/(2*r)) + 1e-9*<x - 0.9999>^1"),
        ("acos(z/sqrt(z^2 + x^2))", "asin(x/sqrt(z^2 + x^2))"),
        ("acos(abs(z))*r", "acos(z)*r"),
        ("acos(cos(r*z))", "r*z"),
        ("asin(sin(r*x))", "r*x"),
        ("asin(cos(c))", "pi/2 - c"),
        ("r*<c - x>^2*<z - y>^1", "r*<c - x>^2*<z - y>^1*<c - x>^0 + 1e-7*<z - y>^1*<0.001 - y>^1"),
        ("r + sqrt(c) - sqrt(c)", "r + sqrt(z) - sqrt(z)"),
        ("abs(c)*abs(z)", "abs(c)*abs(z)*sqrt(c)/sqrt(c)"),
    ],
)
def test_a_difference_beside_what_turns_is_found(a: str, b: str) -> None:
    assert found(a, b) <= {Finding.DIFFERENT, Finding.UNDEFINED}


def test_the_search_is_left_out_where_every_sign_was_met(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(*_: object) -> Comparison:
        raise AssertionError

    monkeypatch.setattr("graders.equality.probing.Search.beside", nothing)
    for a, b in (("root(z; 3)", "sign(z)*abs(z)^(1/3)"), ("root(z^4; 4)", "abs(z)"), ("ln(z^2)", "2*ln(abs(z))")):
        assert pair(a, b).compared() == EQUAL
