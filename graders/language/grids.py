"""Matrices of formulas multiplied out entry by entry, so that every entry is a formula of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from graders.language.tree import Binary, Grid, Index, Name, Number, Tree, Unary

Rows: TypeAlias = tuple[tuple[Tree, ...], ...]

ZERO, ONE = Number("0"), Number("1")


def rows_of(tree: Tree, grids: Mapping[str, Rows]) -> Rows | None:
    """Give the entries of a matrix; None for a formula that is no matrix.

    Args:
        tree: A matrix, or sums and products of matrices.
        grids: Matrices by their names.

    Raises:
        ValueError: The shapes do not fit.
    """
    match tree:
        case Grid(rows=rows):
            return tuple(tuple(_plain(entry, grids) for entry in row) for row in rows)
        case Name(name=name):
            return grids.get(name)
        case Unary(operator=operator, operand=operand):
            inner = rows_of(operand, grids)
            return inner and tuple(tuple(_signed(operator, entry) for entry in row) for row in inner)
        case Binary(operator=operator, left=left, right=right):
            return _combined(operator, left, right, grids)
    return None


def _combined(operator: str, left: Tree, right: Tree, grids: Mapping[str, Rows]) -> Rows | None:
    one, other = rows_of(left, grids), rows_of(right, grids)
    if one is not None and other is not None:
        return _product(one, other) if operator == "*" else _by_entries(operator, one, other)
    if one is not None:
        factor = _plain(right, grids)
        return tuple(tuple(_times(operator, entry, factor) for entry in row) for row in one)
    if other is not None:
        factor = _plain(left, grids)
        return tuple(tuple(_times(operator, factor, entry) for entry in row) for row in other)
    return None


def _by_entries(operator: str, one: Rows, other: Rows) -> Rows:
    pairs = zip(one, other, strict=True)
    return tuple(tuple(_sum(operator, a, b) for a, b in zip(x, y, strict=True)) for x, y in pairs)


def _product(one: Rows, other: Rows) -> Rows:
    if len(one[0]) != len(other):
        raise ValueError("the shapes of the matrices do not fit a product")
    columns = list(zip(*other, strict=True))
    return tuple(tuple(_dot(row, column) for column in columns) for row in one)


def _dot(row: tuple[Tree, ...], column: tuple[Tree, ...]) -> Tree:
    total: Tree = ZERO
    for a, b in zip(row, column, strict=True):
        total = _sum("+", total, _times("*", a, b))
    return total


def _sum(operator: str, a: Tree, b: Tree) -> Tree:
    if b == ZERO:
        return a
    return (b if operator == "+" else _signed("-", b)) if a == ZERO else Binary(operator, a, b)


def _times(operator: str, a: Tree, b: Tree) -> Tree:
    if operator == "*" and ZERO in (a, b):
        return ZERO
    if operator == "*" and a == ONE:
        return b
    return a if b == ONE else Binary(operator, a, b)


def _signed(operator: str, tree: Tree) -> Tree:
    return tree if tree == ZERO or operator == "+" else Unary(operator, tree)


def _plain(tree: Tree, grids: Mapping[str, Rows]) -> Tree:
    """Put the entries of named matrices in the place of their indices."""
    match tree:
        case Index(matrix=matrix, row=row, column=column):
            rows = rows_of(matrix, grids)
            if rows is None or len(rows) < row or len(rows[0]) < column:
                raise ValueError("no such entry")
            return rows[row - 1][column - 1]
        case Binary(operator=operator, left=left, right=right):
            return Binary(operator, _plain(left, grids), _plain(right, grids), tree.implicit)
        case Unary(operator=operator, operand=operand):
            return Unary(operator, _plain(operand, grids))
    return tree
