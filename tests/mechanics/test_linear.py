"""Gaussian elimination, in floats and exact."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import linear
from mechanics.errors import SingularError
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

small = st.integers(-9, 9)


@st.composite
def integer_systems(draw: st.DrawFn) -> tuple[list[list[int]], list[int]]:
    size = draw(st.integers(1, 5))
    row = st.lists(small, min_size=size, max_size=size)
    return draw(st.lists(row, min_size=size, max_size=size)), draw(row)


@quick
@given(integer_systems())
def test_exact_solution_satisfies_every_equation_exactly(system: tuple[list[list[int]], list[int]]) -> None:
    matrix, right = system
    try:
        unknowns = linear.solve([[Fraction(x) for x in row] for row in matrix], [Fraction(x) for x in right])
    except SingularError:
        assume(False)
    for row, value in zip(matrix, right, strict=True):
        assert sum(a * x for a, x in zip(row, unknowns, strict=True)) == value


@quick
@given(integer_systems())
def test_floats_agree_with_exact_arithmetic(system: tuple[list[list[int]], list[int]]) -> None:
    matrix, right = system
    try:
        exact = linear.solve([[Fraction(x) for x in row] for row in matrix], [Fraction(x) for x in right])
    except SingularError:
        with pytest.raises(SingularError):
            linear.solve([[float(x) for x in row] for row in matrix], [float(x) for x in right])
        return
    found = linear.solve([[float(x) for x in row] for row in matrix], [float(x) for x in right])
    assert found == pytest.approx([float(x) for x in exact], rel=1e-8, abs=1e-8)


def test_rows_and_columns_of_very_different_size_keep_their_digits() -> None:
    found = linear.solve([[1e-9, 2e3], [3e-12, 4.0]], [1e-9 + 2e3, 3e-12 + 4.0])
    assert found == pytest.approx([1.0, 1.0], rel=1e-3)


def test_a_zero_on_the_diagonal_is_pivoted_away() -> None:
    assert linear.solve([[0.0, 2.0], [4.0, 0.0]], [2.0, 8.0]) == [2.0, 1.0]


@pytest.mark.parametrize("matrix", [[[1.0, 2.0], [2.0, 4.0]], [[0.0, 0.0], [1.0, 1.0]], [[1.0, 0.0], [1.0, 0.0]]])
def test_a_dependent_system_is_refused(matrix: list[list[float]]) -> None:
    with pytest.raises(SingularError):
        linear.solve(matrix, [1.0, 1.0])


def test_a_system_that_is_not_square_is_refused() -> None:
    with pytest.raises(ValueError, match="2 equations need 2 unknowns"):
        linear.solve([[1.0], [2.0]], [1.0, 2.0])


@quick
@given(integer_systems())
def test_equations_added_one_by_one_give_the_same_unknowns(system: tuple[list[list[int]], list[int]]) -> None:
    matrix, right = system
    basis: dict[int, list[int]] = {}
    agreed = [linear.extend(basis, [*row, value]) for row, value in zip(matrix, right, strict=True)]
    one_by_one = [linear.determined(basis, i) for i in range(len(matrix))]
    try:
        exact = linear.solve([[Fraction(x) for x in row] for row in matrix], [Fraction(x) for x in right])
    except SingularError:
        assert None in one_by_one
        return
    assert all(agreed)
    assert one_by_one == exact


def test_an_equation_that_follows_agrees_and_one_that_contradicts_does_not() -> None:
    basis: dict[int, list[int]] = {}
    assert linear.extend(basis, [1, 1, 3])
    assert linear.extend(basis, [2, 2, 6])
    assert not linear.extend(basis, [2, 2, 7])
    assert linear.determined(basis, 0) is None
    assert linear.extend(basis, [1, -1, 1])
    assert [linear.determined(basis, i) for i in (0, 1)] == [Fraction(2), Fraction(1)]
