"""Equations and inequalities as students type them: one, or several parted by semicolons or lines."""

from __future__ import annotations

from collections.abc import Iterator

from graders.formulas import place_of
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.parser import parse
from graders.language.piece import Piece
from graders.language.symbols import Symbols
from graders.language.tree import Grid, Index, Relation, names, walk
from graders.solutions.inequalities import is_inequality
from graders.solutions.reduction import is_equation

MOST_EQUATIONS = 12


def read_equation(text: str, symbols: Symbols, unknowns: frozenset[str]) -> Relation:
    """Read one equation in the symbols of the task and the unknowns; raises AnswerSyntaxError."""
    tree = _relation(text, symbols, unknowns)
    if not is_equation(tree):
        raise AnswerSyntaxError(Reason.NOT_AN_EQUATION, 0, text.strip()[:20])
    return tree


def read_inequality(text: str, symbols: Symbols) -> Relation:
    """Read an inequality or a chain of them; raises AnswerSyntaxError."""
    tree = _relation(text.replace("=<", "<=").replace("=>", ">="), symbols, frozenset())
    if not is_inequality(tree):
        raise AnswerSyntaxError(Reason.NOT_AN_INEQUALITY, 0, text.strip()[:20])
    return tree


def read_equations(text: str, symbols: Symbols, unknowns: frozenset[str]) -> tuple[Relation, ...]:
    """Read several equations, parted by semicolons or lines; raises AnswerSyntaxError."""
    found: list[Relation] = []
    pieces = list(parted(text))
    if not pieces:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    if len(pieces) > MOST_EQUATIONS:
        raise AnswerSyntaxError(Reason.TOO_LONG, pieces[MOST_EQUATIONS].place)
    for piece in pieces:
        found.append(piece.read(lambda text: read_equation(text, symbols, unknowns)))
    return tuple(found)


def parted(text: str) -> Iterator[Piece]:
    """Part a text at line ends and at semicolons outside brackets; blank parts are passed over."""
    start = depth = 0
    for place, char in enumerate(text + "\n"):
        depth += (char in "([{") - (char in ")]}")
        if char == "\n" or (char == ";" and depth <= 0):
            if text[start:place].strip():
                yield Piece(text[start:place], start)
            start, depth = place + 1, 0


def _relation(text: str, symbols: Symbols, unknowns: frozenset[str]) -> Relation:
    tree = parse(text, symbols)
    if not isinstance(tree, Relation) or any(isinstance(node, Grid | Index) for node in walk(tree)):
        reason = Reason.NOT_AN_EQUATION if unknowns else Reason.NOT_AN_INEQUALITY
        raise AnswerSyntaxError(reason, 0, text.strip()[:20])
    forbidden = sorted(names(tree) - symbols.names - unknowns)
    if forbidden:
        raise AnswerSyntaxError(Reason.FORBIDDEN_NAME, place_of(forbidden[0], text), forbidden[0])
    return tree
