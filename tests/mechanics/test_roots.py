"""Sign changes of polynomials, near tangency and with coefficients of every size."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.roots import Quartic, crossings


def value(polynomial: Quartic, t: float) -> float:
    return sum(c * t**power for power, c in enumerate(polynomial))


def found_by_derivatives(polynomial: Quartic, end: float) -> list[float]:
    """Crossings of the polynomial, from those of its derivatives, the lowest first."""
    chain = [polynomial]
    for _ in range(3):
        last = chain[-1]
        chain.append((last[1], 2 * last[2], 3 * last[3], 4 * last[4], 0.0))
    inner: list[float] = []
    for each in reversed(chain):
        inner = list(crossings(each, end, inner))
    return inner


@given(st.lists(st.floats(0.05, 0.95), min_size=1, max_size=4, unique=True), st.sampled_from([1.0, -3.0, 1e-12, 1e12]))
def test_roots_put_in_are_found(roots: list[float], factor: float) -> None:
    roots = sorted(roots)
    if any(b - a < 0.01 for a, b in pairwise(roots)):
        return
    product = [factor]
    for root in roots:
        product = [a - root * b for a, b in zip([0.0, *product], [*product, 0.0], strict=True)]
    padded = (*product, *[0.0] * (5 - len(product)))
    polynomial: Quartic = (padded[0], padded[1], padded[2], padded[3], padded[4])
    assert found_by_derivatives(polynomial, 1.0) == pytest.approx(roots, abs=1e-9)


@pytest.mark.parametrize("leading", [0.0, 1e-300, 1e-17, -1e-16, 1e-9])
def test_tiny_leading_coefficient_keeps_the_near_root(leading: float) -> None:
    assert list(crossings((-1.0, 2.0, leading, 0.0, 0.0), 1.0)) == pytest.approx([0.5], abs=1e-8)


def test_touching_without_crossing_is_no_sign_change() -> None:
    polynomial: Quartic = (0.25 + 1e-12, -1.0, 1.0, 0.0, 0.0)
    assert list(crossings(polynomial, 1.0, [0.5])) == []


def test_two_crossings_a_hair_apart_are_both_found() -> None:
    polynomial: Quartic = (0.25 - 1e-10, -1.0, 1.0, 0.0, 0.0)
    assert list(crossings(polynomial, 1.0, [0.5])) == pytest.approx([0.5 - 1e-5, 0.5 + 1e-5], abs=1e-9)


def test_zero_exactly_at_an_inner_place_is_named() -> None:
    assert list(crossings((0.25, -1.0, 1.0, 0.0, 0.0), 1.0, [0.5])) == [0.5]


def test_steep_rise_beside_a_flat_stretch_is_bracketed() -> None:
    """Newton's tangent is level at the left end of t^4 = 1e-12 and leaves the bracket."""
    assert list(crossings((-1e-12, 0.0, 0.0, 0.0, 1.0), 1.0)) == pytest.approx([1e-3], rel=1e-9)


def test_inflection_inside_the_bracket_does_not_stop_the_search() -> None:
    polynomial: Quartic = (-0.125 + 1e-9, 0.75, -1.5, 1.0, 0.0)  # (t - 1/2)^3 + 1e-9
    root = crossings(polynomial, 1.0)
    assert list(root) == pytest.approx([0.5 - 1e-3], abs=1e-6)
    assert value(polynomial, root[0]) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("rounding", [0.0, 1e-17, -1e-17, 3e-16])
def test_a_zero_at_the_end_that_rounding_moved_is_there_or_nowhere(side: int, rounding: float) -> None:
    """(t - 1)(t^2 + 1): its one root is the right end of the stretch, where the sum of its terms is all rounding."""
    polynomial: Quartic = (side * (-1.0 + rounding), side * 1.0, side * -1.0, side * 1.0, 0.0)
    found = list(crossings(polynomial, 1.0))
    assert found == [] or found == pytest.approx([1.0], rel=1e-15)
    assert all(0 <= t <= 1 for t in found)
