"""Zeros along a symbol: those of a parabola come together, that of what only rises or falls comes alone."""

from __future__ import annotations

import pytest
from flint import arb
from hypothesis import assume, given
from hypothesis import strategies as st

from graders.language import Symbols, parse
from graders.language.balls import precision
from graders.solutions.scene import BITS, Effort, Residuals, Scene, Side
from graders.solutions.zeros import Line, Zero, inside, only, parabola, scanned

SCENE = Scene(("x", "p", "q"), ((-1.0, 3.0), (-4.0, 4.0), (-4.0, 4.0)), ())


def line(text: str, p: float = 0.0, q: float = 0.0) -> Line:
    tree = parse(text, Symbols(SCENE.names))
    return Line(Side(Residuals(SCENE, [[tree]], Effort()), 0), (0.0, p, q), 0)


def places(found: list[Zero] | None) -> list[float]:
    assert found is not None
    return sorted(float(zero.point[0].mid()) for zero in found)


@given(st.floats(-4, 4), st.floats(-4, 4))
def test_a_parabola_has_the_zeros_it_was_made_of(p: float, q: float) -> None:
    assume(p == q or abs(p - q) > 1e-9)  # nearer ones are one
    with precision(BITS):
        found = parabola(line("(x - p)*(x - q)", p, q))
    assert places(found) == pytest.approx(sorted(root for root in {p, q} if -1 <= root <= 3), abs=1e-15)


def test_the_zeros_of_a_parabola_are_enclosed() -> None:
    with precision(BITS):
        found = parabola(line("x^2 - 2"))
        assert found is not None
        assert [zero.point[0].contains(arb(2).sqrt()) for zero in found] == [True]  # the other one is beyond the range


def test_a_parabola_that_touches_has_one_zero_and_one_above_none() -> None:
    with precision(BITS):
        assert places(parabola(line("x^2 - 2*p*x + p^2", 0.7))) == pytest.approx([0.7])
        assert places(parabola(line("x^2 + 1"))) == []


def test_what_is_no_parabola_after_all_is_left_open() -> None:
    with precision(BITS):
        assert parabola(line("(x - p)*(x - q) - x^2 + x")) is None
        assert parabola(line("x^2 + sqrt(p)", -1.0)) is None


@given(st.floats(-4, 4), st.floats(-4, 4))
def test_doubles_tell_which_zeros_of_a_parabola_lie_in_the_range(p: float, q: float) -> None:
    values = [(x - p) * (x - q) for x in (-1.0, 1.0, 3.0)]
    if abs(p - q) > 1e-3 and all(min(abs(root + 1), abs(root - 3)) > 1e-6 for root in (p, q)):
        assert inside(*values) == tuple(-1 <= root <= 3 for root in sorted((p, q)))


@pytest.mark.parametrize("text", ["exp(x) - q", "x^3 - q", "1/(x + 1.001) - q", "atan(x) - q/9", "exp(9*x) - q"])
@pytest.mark.parametrize("q", [0.5, 1.0, 3.9])
def test_the_only_zero_is_that_of_a_scan(text: str, q: float) -> None:
    with precision(BITS):
        found, beside = only(line(text, q=q)), list(scanned(line(text, q=q)))
    assert [zero.point[0].overlaps(beside[0].point[0]) for zero in [found] if zero is not None] == [True]


@pytest.mark.parametrize("text", ["exp(x) + 1", "ln(x) - q", "x - 4"])
def test_without_a_change_of_sign_between_the_ends_there_is_no_zero(text: str) -> None:
    with precision(BITS):
        assert only(line(text)) is None
