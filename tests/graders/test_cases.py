"""Equality in every case of signs: what is shown without a search, and what must not be."""

from __future__ import annotations

import pytest

from graders import Domain
from graders.equality import Comparison, Finding, between
from graders.equality.pair import Pair
from graders.language import parse_line

BOX = {"c": Domain(-2, 2), "r": Domain(1, 2), "x": Domain(0, 1), "y": Domain(0, 1), "z": Domain(-1, 1)}


def found(a: str, b: str) -> set[Finding]:
    one, other = parse_line(a), parse_line(b)
    return {between(one, other, BOX, b"cases").finding, between(other, one, BOX, b"cases").finding}


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("r*<z - x>^2", "r*(z - x)*<z - x>^1"),
        ("abs(3*z - 3*x)", "3*abs(x - z)"),
        ("max(z; x) + min(z; x)", "x + z"),
        ("max(z; x) - min(z; x)", "sqrt((x - z)^2)"),
        ("sqrt(4*c^2 + 4*z^2)", "2*sqrt(c^2 + z^2)"),
        ("ln(3*x) - ln(x) + z", "ln(3) + z"),
        ("sqrt(1 - sin(3*z)^2)", "abs(cos(3*z))"),
        ("z*sign(z)", "abs(z)"),
        ("acos(-z)", "pi/2 + asin(z)"),
        ("exp(-900*x)*r", "r/exp(900*x)"),
        ("atan2(2*z; 2*c)", "atan2(z; c)"),
        ("max(0; min(1; z + x))", "<z + x>^1 - <z + x - 1>^1"),
        ("max(c; z; x)", "max(max(x; z); c)"),
        ("abs(c*z)", "abs(c)*abs(z)"),
        ("<z - x>^0 + <x - z>^0", "1"),
        ("<<z + r>^1 - r>^1", "<z>^1"),
        ("r*z - r*<z - x>^1", "min(r*z; r*x)"),
        ("z + acos(sin(c)^2 + cos(c)^2)", "z"),
        ("tanh(40*c)", "1 - 2/(exp(80*c) + 1)"),
        ("r*exp(-90*x*y)", "r*exp(-90*x)^y"),
        ("sqrt(x*y)", "sqrt(x)*sqrt(y)"),
    ],
)
def test_what_is_equal_in_every_case_needs_no_search(a: str, b: str, monkeypatch: pytest.MonkeyPatch) -> None:
    said, in_every_case = list[Comparison | None](), Pair._in_every_case

    def listened(self: Pair) -> Comparison | None:
        said.append(in_every_case(self))
        return said[-1]

    monkeypatch.setattr(Pair, "_in_every_case", listened)
    assert found(a, b) == {Finding.EQUAL}
    assert all(said)


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("sqrt(c^2*z^2)", "c*sqrt(z^2)"),
        ("sqrt((z - 0.9999)^2)", "0.9999 - z"),
        ("r + ln(z) - ln(z)", "r"),
        ("r + 0*sqrt(z)", "r"),
        ("r*sqrt(z)/sqrt(z)", "r"),
        ("r + 0*asin(2*x)", "r"),
        ("root(exp(100*c*r); 3)", "root(exp(100*c*r); 3) + 1e-6*<2*z - 0.95>^1"),
        ("r + 0*ln(<-z>^2)", "r"),
        ("abs(c*z)", "abs(c)*z"),
        ("r + <x - 2>^1", "r + <x - 2>^c"),
        ("sign(<sin(2/r)>^1)", "sign(<2*sin(1/x)*cos(1/x)>^1)"),
        ("max(0; min(1; c))", "<c>^1 - <c - 1.0001>^1"),
        ("r + 0*atan2(<z>^1; <z>^1)", "r"),
        ("r + 0*<x>^c", "r"),
        ("r + 0*log(2; c)", "r"),
        ("r + 0*<z>^1*ln(z + 0.9999)", "r"),
        ("z*sqrt(1 - c^2/4)", "abs(z)*sqrt(1 - c^2/4)"),
        ("atan2(-z; -c)", "atan2(z; c)"),
        ("sqrt(-z)*sqrt(-c)", "sqrt(z*c)"),
        ("ln(z^2*r)", "2*ln(z) + ln(r)"),
        ("r*exp(-900*x)", "r*exp(-900*x*(1 + 1e-12))"),
        ("max(z; c)", "max(z; c) + 1e-9*<z - 0.9999>^1"),
    ],
)
def test_what_differs_in_one_case_is_found(a: str, b: str) -> None:
    assert found(a, b) <= {Finding.DIFFERENT, Finding.UNDEFINED}


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("<1 - sin(z)^2 - cos(z)^2>^0 + <sin(z)^2 + cos(z)^2 - 1>^0", "1"),
        ("sign(sqrt(z^2) - abs(z))^2", "1"),
        ("<sqrt(z^2) - abs(z)>^0 + <abs(z) - sqrt(z^2)>^0", "1"),
        ("r + 0/(sqrt(z^2) - abs(z))", "r"),
        ("r + 0/(acos(cos(c)) - abs(c))", "r"),
        ("r*(acos(cos(c)) - abs(c))/(acos(cos(c)) - abs(c))", "r"),
        ("sign(acos(cos(c)) - abs(c))^2", "1"),
        ("r + 0*ln((sqrt(z^2) - abs(z))^2)", "r"),
        ("<acos(cos(c)) - abs(c)>^0 + <abs(c) - acos(cos(c))>^0", "1"),
    ],
)
def test_what_hangs_on_a_hidden_zero_is_never_called_equal(a: str, b: str) -> None:
    assert Finding.EQUAL not in found(a, b)
