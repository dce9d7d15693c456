"""Formulas of a request, alone, in matrices and in lists: equal as functions on the box."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from graders.comparison.outcome import EQUAL, NOWHERE, UNDECIDED, Answer, Verdict, Why, different
from graders.comparison.request import Request
from graders.comparison.texts import trees
from graders.equality import Comparison, Finding, between, between_entries
from graders.judge import Domain
from graders.language.tree import Binary, Call, Grid, Index, Name, Relation, Tree, Unary, walk

NO_FORMULA = (Relation, Grid, Index)


def compare_expressions(request: Request, secret: bytes) -> Answer:
    """Compare two formulas."""
    (a,), (b,) = trees(request)
    if not (_is_formula(a) and _is_formula(b)):
        return different(Why.SHAPE)
    return compared(a, b, request, secret)


def compare_matrices(request: Request, secret: bytes) -> Answer:
    """Compare two matrices entry by entry."""
    (a,), (b,) = trees(request)
    if not (isinstance(a, Grid) and isinstance(b, Grid)):
        return different(Why.SHAPE)
    if not all(_is_formula(entry) for grid in (a, b) for row in grid.rows for entry in row):
        return different(Why.SHAPE)
    if (len(a.rows), len(a.rows[0])) != (len(b.rows), len(b.rows[0])):
        return different(Why.SHAPE)
    one, other = ([filled(entry, request.fixed) for row in grid.rows for entry in row] for grid in (a, b))
    return _worst([_answered(found) for found in between_entries(one, other, _box(request), secret)])


def compare_lists(request: Request, secret: bytes) -> Answer:
    """Compare two lists of formulas in any order: their number first, then pairs of equal ones."""
    a, b = trees(request)
    if not all(map(_is_formula, (*a, *b))):
        return different(Why.SHAPE)
    if len(a) != len(b):
        return different(Why.COUNT)
    left, undecided = list(b), False
    for one in a:
        answers = [(compared(one, other, request, secret), other) for other in left]
        match = next((other for found, other in answers if found.verdict is Verdict.EQUAL), None)
        if match is not None:
            left.remove(match)
        elif any(found.verdict is Verdict.UNDECIDED for found, _ in answers):
            undecided = True
        else:
            return different(Why.VALUE, next((found.witness for found, _ in answers), ()))
    return UNDECIDED if undecided else EQUAL


def _worst(answers: Sequence[Answer]) -> Answer:
    order = (Verdict.DIFFERENT, Verdict.UNDECIDED, Verdict.EQUAL)
    return min(answers, key=lambda found: order.index(found.verdict))


def compared(a: Tree, b: Tree, request: Request, secret: bytes) -> Answer:
    """Compare two formulas on the box of a request."""
    return _answered(between(filled(a, request.fixed), filled(b, request.fixed), _box(request), secret))


def _box(request: Request) -> dict[str, Domain]:
    return {name: Domain(low, high) for name, (low, high) in request.box.items()}


def _answered(found: Comparison) -> Answer:
    match found.finding:
        case Finding.EQUAL:
            return EQUAL
        case Finding.UNDECIDED:
            return UNDECIDED
        case Finding.NOWHERE:
            return NOWHERE
        case finding:
            return different(Why.UNDEFINED if finding is Finding.UNDEFINED else Why.VALUE, found.witness)


def filled(tree: Tree, values: Mapping[str, Tree]) -> Tree:
    """Put values in the place of names."""
    if not values:
        return tree
    match tree:
        case Name(name=name):
            return values.get(name, tree)
        case Unary(operand=operand):
            return replace(tree, operand=filled(operand, values))
        case Binary(left=left, right=right):
            return replace(tree, left=filled(left, values), right=filled(right, values))
        case Call(arguments=arguments):
            return replace(tree, arguments=tuple(filled(one, values) for one in arguments))
        case _:
            return tree


def _is_formula(tree: Tree) -> bool:
    return not any(isinstance(node, NO_FORMULA) for node in walk(tree))
