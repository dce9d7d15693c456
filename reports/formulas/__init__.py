"""Presentation MathML read once, for the three notations of documents."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree import ElementTree

ROWS = ("math", "mrow", "mstyle", "semantics", "mpadded", "menclose", "mphantom")
OPENING = {"(": ")", "[": "]", "{": "}"}
FUNCTIONS = frozenset((
    "sin", "cos", "tan", "cot", "tg", "ctg", "asin", "acos", "atan", "acot", "atan2", "arcsin", "arccos", "arctan",
    "arctg", "sinh", "cosh", "tanh", "exp", "ln", "log", "min", "max", "sign", "abs",
))  # fmt: skip


@dataclass(frozen=True, slots=True)
class Node:
    """A node of a formula: its kind, its text (leaves) and its parts.

    Kinds: identifier, number, operator, text, space, row, group (a bracketed row), sub, sup, subsup, over, under,
    fraction, root, table (its parts are rows of cells).
    """

    kind: str
    text: str = ""
    parts: tuple[Node, ...] = ()


LEAVES = {"mi": "identifier", "mn": "number", "mo": "operator", "mtext": "text", "ms": "text", "mspace": "space"}
SHAPES = {
    "msub": "sub", "msup": "sup", "msubsup": "subsup", "mover": "over", "munder": "under", "mfrac": "fraction",
    "mroot": "root", "mtable": "table", "mtr": "row", "mtd": "row",
}  # fmt: skip


def read(mathml: str) -> Node:
    """Read a formula.

    Raises:
        ValueError: An element that our formulas do not have, or XML that is not well-formed.
    """
    try:
        return _node(ElementTree.fromstring(mathml))
    except ElementTree.ParseError as error:
        raise ValueError(f"not MathML: {error}") from None


def _node(element: ElementTree.Element) -> Node:
    tag = element.tag.rpartition("}")[2]
    if tag in LEAVES:
        return Node(LEAVES[tag], (element.text or "").strip() if tag != "mtext" else element.text or "")
    parts = tuple(_node(child) for child in element)
    if tag in ROWS:
        return _row(parts)
    if tag == "msqrt":
        return Node("root", "", (_row(parts),))
    if tag not in SHAPES:
        raise ValueError(f"<{tag}> is no part of a formula")
    return Node("row", "", parts) if SHAPES[tag] == "row" else Node(SHAPES[tag], "", parts)


def _row(parts: tuple[Node, ...]) -> Node:
    """Gather brackets that belong together into groups."""
    found = list(_grouped(list(parts)))
    return found[0] if len(found) == 1 else Node("row", "", tuple(found))


def _grouped(parts: list[Node]) -> Iterator[Node]:
    at = 0
    while at < len(parts):
        one = parts[at]
        close = _closing(parts, at) if one.kind == "operator" and one.text in OPENING else None
        if close is None:
            yield one
            at += 1
            continue
        yield Node("group", one.text + parts[close].text, tuple(_grouped(parts[at + 1 : close])))
        at = close + 1


def _closing(parts: list[Node], start: int) -> int | None:
    opening, depth = parts[start].text, 0
    for at in range(start, len(parts)):
        if parts[at].kind == "operator":
            depth += (parts[at].text == opening) - (parts[at].text == OPENING[opening])
            if depth == 0:
                return at
    return None
