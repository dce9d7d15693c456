"""The plain part of the language read at once: names, numbers, `+ - * / ^`, brackets, calls, `<u>^n`, `=`, matrices.

Most answers hold nothing else. Whatever else stands in a text, and every error, is left to the parser, whose trees
these are: None means *ask the parser*.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache

from graders.language.symbols import FUNCTIONS, Symbols, function_named
from graders.language.tree import Binary, Call, Grid, Name, Number, Relation, Tree, Unary, order_exists

PLAIN = re.compile(r"[A-Za-z0-9_ .+\-*/^();<>]{1,250}")
SIGNS = "+-*/^();<>"
BETWEEN = re.compile(r"\] ?[,;] ?\[")
DECIMAL = re.compile(r"\d,\d")
POWER_OF_TEN = re.compile(r"(?<![\w.])(\d[\d.]{0,39}e)-(?=\d{1,3}(?![\w.]))")  # 1e-6, which is no difference
LITERAL = re.compile(r"(\d+(?:\.\d+)?)(?:e(!?\d{1,3}))?")
PI = Name("pi")
LONGEST = 1200  # of a matrix: too short for the bound on nodes
WIDEST = 16
DEPTH = 40
DIGITS = 40


class Unusual(Exception):
    """Something that the parser has to look at."""


def read(text: str, symbols: Symbols) -> Tree | None:
    """Read a plain text over the declared symbols, or give None."""
    if text[:1] == "[":
        return _grid(text.rstrip(), symbols)
    if PLAIN.fullmatch(text) is None:
        return _equation(text, symbols)
    try:
        return _Reader(_pieces(text), symbols).whole()
    except (Unusual, IndexError):  # IndexError: the text ends too early
        return None


def _equation(text: str, symbols: Symbols) -> Tree | None:
    """Read an equation with two plain sides."""
    left, equals, right = text.partition("=")
    if not equals or left.endswith(("<", ">")) or PLAIN.fullmatch(left) is None or PLAIN.fullmatch(right) is None:
        return None
    sides = read(left, symbols), read(right, symbols)
    return None if sides[0] is None or sides[1] is None else Relation(("=",), (sides[0], sides[1]))


def _pieces(text: str) -> list[str]:
    if "e-" in text:
        text = POWER_OF_TEN.sub(r"\1!", text)
    for sign in SIGNS:
        if sign in text:
            text = text.replace(sign, f" {sign} ")
    return text.split()


def _grid(text: str, symbols: Symbols) -> Tree | None:
    """Read a matrix whose entries are plain: `[[a; b], [c; d]]`, `[[a, b], [c, d]]` or `[a, b; c, d]`."""
    nested = text.startswith("[[") and text.endswith("]]")
    if len(text) > LONGEST or not text.endswith("]") or (not nested and (";" not in text or DECIMAL.search(text))):
        return None
    lines = BETWEEN.split(text[2:-2]) if nested else text[1:-1].split(";")
    rows = [_row(line, ";" if nested and ";" in line else ",", symbols) for line in lines]
    width = len(rows[0])
    if any(None in row or len(row) != width for row in rows) or max(len(rows), width) > WIDEST:
        return None
    return Grid(tuple([tuple([entry for entry in row if entry is not None]) for row in rows]))


def _row(line: str, separator: str, symbols: Symbols) -> list[Tree | None]:
    return [read(entry, symbols) if "[" not in entry else None for entry in line.split(separator)]


class _Reader:
    """One pass over the pieces, the last of them first in the list; `piece` is the next one, empty at the end."""

    __slots__ = ("depth", "nodes", "piece", "pieces", "symbols")

    def __init__(self, pieces: list[str], symbols: Symbols) -> None:
        pieces.append("")
        pieces.reverse()
        self.pieces, self.symbols, self.nodes = pieces, symbols, symbols.nodes
        self.depth, self.piece = 0, pieces.pop()

    def whole(self) -> Tree:
        tree = self.sum()
        if self.piece:
            raise Unusual
        return tree

    def sum(self) -> Tree:
        tree = self.product()
        while True:
            operator = self.piece
            if operator != "+" and operator != "-":
                return tree
            self.piece = self.pieces.pop()
            tree = Binary(operator, tree, self.product())

    def product(self) -> Tree:
        tree = self.factor()
        while True:
            operator = self.piece
            if operator != "*" and operator != "/":
                return tree
            self.piece = self.pieces.pop()
            tree = Binary(operator, tree, self.factor())

    def factor(self) -> Tree:
        piece = self.piece
        self.piece = self.pieces.pop()
        tree: Tree | None = self.nodes.get(piece)
        if tree is None:
            if piece == "-" or piece == "+":
                return Unary(piece, self.deeper(_Reader.factor))
            tree = self.other(piece)
        if self.piece == "^":
            self.piece = self.pieces.pop()
            return Binary("^", tree, self.exponent())
        return tree

    def exponent(self) -> Tree:
        piece, pieces = self.piece, self.pieces
        if not piece.isdecimal() or pieces[-1] == "^":
            return self.deeper(_Reader.factor)
        self.piece = pieces.pop()  # most exponents are figures
        return _number(piece)

    def other(self, piece: str) -> Tree:
        """Read an operand that is no symbol met before."""
        if piece == "(":
            tree = self.deeper(_Reader.sum)
            self.close(")")
            return tree
        if piece == "<":
            return self.macaulay()
        if piece[0].isdecimal():
            return _number(piece)
        if self.symbols.calls(piece):
            return self.call(piece)
        known = piece in self.nodes or not piece[0].isalpha()
        node = None if known else self.symbols.node(piece)
        return node or (PI if piece == "pi" else self.call(function_named(piece)))

    def call(self, function: str | None) -> Tree:
        if function is None or self.piece != "(":
            raise Unusual
        arguments: list[Tree] = []
        pieces = self.pieces
        symbol = self.nodes.get(pieces[-1])
        if symbol is not None and pieces[-2] == ")":  # most arguments are symbols
            arguments.append(symbol)
            pieces.pop()
            pieces.pop()
            self.piece = pieces.pop()
        else:
            self.several(arguments)
        least, most = FUNCTIONS[function]
        if not least <= len(arguments) <= most or (function == "macaulay" and not order_exists(arguments[1])):
            raise Unusual
        return Call(function, tuple(arguments))

    def several(self, arguments: list[Tree]) -> None:
        """Read the arguments of a call, up to its closing bracket."""
        while not arguments or self.piece == ";":
            self.piece = self.pieces.pop()
            arguments.append(self.deeper(_Reader.sum))
        self.close(")")

    def macaulay(self) -> Tree:
        """Read `<u>^n` with a plain order; without one the parser has to look."""
        tree = self.deeper(_Reader.sum)
        self.close(">")
        self.close("^")
        order, self.piece = self.piece, self.pieces.pop()
        if not order.isdecimal() or len(order) > 2 or self.piece == "^":
            raise Unusual
        return Call("macaulay", (tree, _number(order)))

    def close(self, bracket: str) -> None:
        if self.piece != bracket:
            raise Unusual
        self.piece = self.pieces.pop()

    def deeper(self, read: Callable[[_Reader], Tree]) -> Tree:
        """Read what stands within the present one."""
        self.depth += 1
        if self.depth > DEPTH:
            raise Unusual
        tree = read(self)
        self.depth -= 1
        return tree


@lru_cache(maxsize=4096)
def _number(piece: str) -> Number:
    found = LITERAL.fullmatch(piece)
    if found is None or len(piece) > DIGITS:
        raise Unusual
    digits, power = found.groups()
    return Number(digits, int(power.replace("!", "-"))) if power else Number(digits)
