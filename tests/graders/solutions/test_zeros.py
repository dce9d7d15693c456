"""Zeros along a symbol: those of a parabola come together, that of what only rises or falls comes alone."""

from __future__ import annotations

import pytest
from flint import arb
from hypothesis import assume, given
from hypothesis import strategies as st

from graders.language import Symbols, parse
from graders.language.balls import precision
from graders.solutions.scene import BITS, Effort, Residuals, Scene, Side
from graders.solutions.zeros import Line, Zero, inside, jumps, only, parabola, scanned, steep

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


@given(st.floats(-0.9, 2.9))
def test_a_zero_in_doubles_is_taken_where_it_is_near_enough(p: float) -> None:
    with precision(BITS):
        rough, fine = only(line("exp(x) - exp(p)", p), lambda _: True), only(line("exp(x) - exp(p)", p))
    assert rough is not None
    assert fine is not None
    assert rough.point[0].contains(arb(p))
    assert fine.point[0].contains(arb(p))
    assert rough.point[0].rad() > fine.point[0].rad()
    assert float(rough.point[0].rad()) < 1e-8
    assert float(fine.point[0].rad()) < 1e-40


def test_a_zero_that_is_known_is_not_looked_for_again() -> None:
    known = Zero((arb(0.99, 1e-3),), (0,), both=True)
    found = list(scanned(line("sin(3*(x - 0.99))*exp(x)"), known=[known]))
    assert [zero.both for zero in found] == [False, True, False]
    assert found[1] is known


def test_of_two_known_zeros_in_one_place_each_is_looked_for() -> None:
    known = [Zero((arb(x),), (0,), both=True) for x in (0.985, 0.995)]
    assert [zero.both for zero in scanned(line("sin(3*(x - 0.99))*exp(x)"), known=known)] == [False] * 3


@pytest.mark.parametrize("size", ["1e17", "1e30", "1e60"])
def test_a_zero_on_which_steps_do_not_close_in_is_proved_by_halves(size: str) -> None:
    with precision(BITS):
        found = list(scanned(line(f"atan({size}*(x^2 - 2)) - atan(0)")))
        assert [zero.point[0].contains(arb(2).sqrt()) for zero in found] == [True]


@pytest.mark.parametrize(
    "text", ["sign(x - p)", "atan2(x - p; -1)", "<x - p>^0 - 1/2", "1/(x - p)", "tan(x - p + pi/2)"]
)
def test_a_jump_and_a_pole_are_no_steep_zeros(text: str) -> None:
    with precision(BITS):
        assert steep(line(text, 0.7), 0.7) is None


@pytest.mark.parametrize(
    ("text", "expected"),
    [("<x>^1 - q", False), ("<x>^0 - q", True), ("<x>^p - q", True), ("sign(x)", True), ("tan(x)", False)],
)
def test_what_jumps_is_told_by_its_operations(text: str, expected: bool) -> None:
    assert jumps(line(text).side.pair.program) is expected
