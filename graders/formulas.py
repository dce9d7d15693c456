"""Reading one formula of a student, and the forms in which a task may ask for it."""

from __future__ import annotations

import re
from enum import StrEnum

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols, key
from graders.language.tree import Binary, Call, Grid, Index, Relation, Tree, Unary, impulse, names, walk

INVERSE = frozenset(("asin", "acos", "atan", "acot", "atan2"))
BRACKET = re.compile(r"[<⟨]|\\langle|macaulay")


class Form(StrEnum):
    """A form that a task may ask for besides the value."""

    PRODUCT = "product"  # no sum or difference at the top
    NO_INVERSE = "no_inverse"  # no inverse trigonometric function


def checked(tree: Tree, text: str, symbols: Symbols) -> Tree:
    """Give a tree back if it is one formula with a value, in allowed symbols.

    Args:
        tree: What was read.
        text: What was typed, in which the place of an error is looked for.
        symbols: The symbols of the answer.

    Raises:
        AnswerSyntaxError: A relation or a matrix stands in it, a symbol that may not be used, or an impulse.
    """
    kinds = {type(node) for node in walk(tree)}
    if not kinds.isdisjoint((Relation, Grid, Index)):
        raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, 0, text.strip()[:20])
    if Call in kinds:
        refuse_impulses(tree, text)
    forbidden = sorted(names(tree) - symbols.names)
    if forbidden:
        raise AnswerSyntaxError(Reason.FORBIDDEN_NAME, place_of(forbidden[0], text), forbidden[0])
    return tree


def refuse_impulses(tree: Tree, text: str) -> None:
    """Raise AnswerSyntaxError where a bracket of order -1 or -2 stands: it is a load, not a value."""
    brackets = [node for node in walk(tree) if isinstance(node, Call) and node.function == "macaulay"]
    for number, bracket in enumerate(brackets):
        if impulse(bracket):
            places = [found.start() for found in BRACKET.finditer(text)]
            raise AnswerSyntaxError(Reason.IMPULSE, places[number] if number < len(places) else 0)


def place_of(name: str, text: str) -> int:
    """Find where a symbol was typed, whatever its spelling."""
    for length in range(1, 20):
        for start in range(len(text) - length + 1):
            if key(text[start : start + length]) == key(name):
                return start
    return 0


def has_form(tree: Tree, form: Form) -> bool:
    """Tell whether a formula is written in a form."""
    if form is Form.NO_INVERSE:
        return not any(isinstance(node, Call) and node.function in INVERSE for node in walk(tree))
    return not _sum(tree)


def _sum(tree: Tree) -> bool:
    """Tell whether a sum stands at the top, behind signs and beside plain numbers."""
    match tree:
        case Binary(operator="+" | "-"):
            return bool(names(tree))
        case Unary(operator="+" | "-", operand=operand):
            return _sum(operand)
        case Binary(operator="*" | "/", left=left, right=right) if not names(left) or not names(right):
            return _sum(left) if not names(right) else tree.operator == "*" and _sum(right)
    return False
