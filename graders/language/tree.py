"""The tree of an expression: what the student wrote, not a simplified form of it.

Round trip: `parse(text_of(tree)) == tree` for every tree the parser can make.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from dataclasses import dataclass as node
    from fractions import Fraction
else:

    def node(*, frozen: bool, slots: bool) -> Callable[[type], type]:
        """Make a class of nodes; mypy keeps them frozen, for a guard at every field makes reading twice as slow."""
        return dataclass(slots=slots, unsafe_hash=frozen)


@node(frozen=True, slots=True)
class Number:
    """An unsigned decimal as typed: digits with a point at most, and a power of ten."""

    digits: str
    exponent: int = 0

    @property
    def exact(self) -> Fraction:
        """Give the exact rational value; the reader bounds the exponent before this is called."""
        from fractions import Fraction  # doubles do without it

        return Fraction(self.digits) * Fraction(10) ** self.exponent

    @property
    def whole(self) -> bool:
        """Tell whether it is written as a whole number of at most nine figures."""
        return not self.exponent and self.digits.isdigit() and len(self.digits) < 10


@node(frozen=True, slots=True)
class Name:
    """A declared symbol, or `pi`."""

    name: str


@node(frozen=True, slots=True)
class Unary:
    """A sign in front (`+`, `-`) or the degree sign behind (`°`)."""

    operator: str
    operand: Tree


@node(frozen=True, slots=True)
class Binary:
    """One of `+ - * / ^`; `implicit` marks a product written by juxtaposition."""

    operator: str
    left: Tree
    right: Tree
    implicit: bool = False


@node(frozen=True, slots=True)
class Call:
    """A function of the language applied to its arguments."""

    function: str
    arguments: tuple[Tree, ...]


@node(frozen=True, slots=True)
class Angle:
    """Degrees with minutes and seconds of arc: `12°22'12"`."""

    degrees: Number
    minutes: Number
    seconds: Number | None = None


@node(frozen=True, slots=True)
class Grid:
    """A matrix literal, rows of equal length."""

    rows: tuple[tuple[Tree, ...], ...]


@node(frozen=True, slots=True)
class Index:
    """One element of a matrix, row and column counted from 1."""

    matrix: Tree
    row: int
    column: int


@node(frozen=True, slots=True)
class Relation:
    """A chain `a = b`, `a < b <= c`; one operator fewer than sides."""

    operators: tuple[str, ...]
    sides: tuple[Tree, ...]


Tree: TypeAlias = Number | Name | Unary | Binary | Call | Angle | Grid | Index | Relation


def children(tree: Tree) -> tuple[Tree, ...]:
    """Give the direct subtrees in the order they are written."""
    if isinstance(tree, Binary):
        return (tree.left, tree.right)
    match tree:
        case Unary(operand=operand):
            return (operand,)
        case Call(arguments=arguments):
            return arguments
        case Grid(rows=rows):
            return tuple(entry for row in rows for entry in row)
        case Index(matrix=matrix):
            return (matrix,)
        case Relation(sides=sides):
            return sides
        case _:
            return ()


def names(tree: Tree) -> frozenset[str]:
    """Give the symbols that occur in a tree, `pi` left out."""
    return frozenset({node.name for node in walk(tree) if isinstance(node, Name)} - {"pi"})


def walk(tree: Tree) -> Iterator[Tree]:
    """Visit a tree and all its subtrees, parents first."""
    pending = [tree]
    while pending:
        node = pending.pop()
        yield node
        if not isinstance(node, (Name, Number)):  # most nodes are leaves
            pending.extend(reversed(children(node)))


def mapped(tree: Tree, change: Callable[[Tree], Tree]) -> Tree:
    """Change a tree from its leaves up."""
    match tree:
        case Unary(operand=operand):
            tree = replace(tree, operand=mapped(operand, change))
        case Binary(left=left, right=right):
            tree = replace(tree, left=mapped(left, change), right=mapped(right, change))
        case Call(arguments=arguments):
            tree = replace(tree, arguments=tuple(mapped(one, change) for one in arguments))
        case Grid(rows=rows):
            tree = replace(tree, rows=tuple(tuple(mapped(one, change) for one in row) for row in rows))
        case Index(matrix=matrix):
            tree = replace(tree, matrix=mapped(matrix, change))
        case Relation(sides=sides):
            tree = replace(tree, sides=tuple(mapped(one, change) for one in sides))
    return change(tree)


def order_exists(order: Tree) -> bool:
    """Tell whether a Macaulay bracket may have an order: a symbol, or a whole number from -2 (a moment) to 100."""
    negative = isinstance(order, Unary) and order.operator == "-"
    number = order.operand if isinstance(order, Unary) else order
    return not isinstance(number, Number) or (number.whole and int(number.digits) <= (2 if negative else 100))


def impulse(call: Call) -> bool:
    """Tell whether a Macaulay bracket has a negative order: a force or a moment at a point, which has no value."""
    order = call.arguments[-1]
    return call.function == "macaulay" and isinstance(order, Unary) and order.operator == "-"
