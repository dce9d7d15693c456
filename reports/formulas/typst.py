"""Formulas in the notation of Typst. Every text stands in a string, so nothing typed can become code."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable

from reports.formulas import FUNCTIONS, Node, read

OPERATORS = {
    "+": "+", "−": "minus", "-": "minus", "=": "=", "·": "dot.op", "⋅": "dot.op", "×": "times", "/": "slash",
    "≤": "<=", "≥": ">=", "<": "<", ">": ">", "≈": "approx", "±": "plus.minus", "→": "->", "′": "prime",
    "°": "degree", "∑": "sum", "∫": "integral", "∞": "infinity", ",": 'comma', ";": "semi", ":": "colon", "|": "bar.v",
    "(": "paren.l", ")": "paren.r", "[": "bracket.l", "]": "bracket.r", "{": "brace.l", "}": "brace.r",
    "⟨": "chevron.l", "⟩": "chevron.r", "…": "dots.h", "": "",
}  # fmt: skip
TIMES = Node("operator", "·")
KEPT = 'thin class("normal", dot.op) thin'  # no line ends behind it
LONGEST = 14  # parts of a term that surely fits on a line
UNSEEN = frozenset(("Cc", "Cf", "Cs", "Co", "Cn"))
ACCENTS = {"˙": "dot", "¨": "dot.double", "→": "arrow", "¯": "macron", "^": "hat", "~": "tilde"}


def quoted(text: str) -> str:
    """Write a text as a string of Typst; what nobody can see is left out."""
    if not text.replace("\n", "").isprintable():  # drawings, the long texts, are
        text = "".join(c for c in text if c == "\n" or unicodedata.category(c) not in UNSEEN)
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\r", "") + '"'


def formula(mathml: str) -> str:
    """Write a formula as the inside of `$…$`."""
    return _written(read(mathml))


def _written(node: Node) -> str:
    return WRITERS[node.kind](node)


def _identifier(node: Node) -> str:
    if len(node.text) == 1 and (node.text.isalpha() or node.text == "∞"):
        return node.text
    return f"op({quoted(node.text)})" if node.text in FUNCTIONS else f"upright({quoted(node.text)})"


def _operator(node: Node) -> str:
    return OPERATORS[node.text] if node.text in OPERATORS else quoted(node.text)


def _row(node: Node) -> str:
    product = KEPT if _has_short_terms(node) else OPERATORS["·"]
    written = (product if part == TIMES else _written(part) for part in node.parts)
    first, *rest = written if node.parts else [""]
    signed = f'class("normal", {first})' if first in ("minus", "+") else first
    return _joined(filter(None, (signed, *rest)))


def _has_short_terms(node: Node) -> bool:
    """Tell whether each term of a row surely fits on a line."""
    signs = [at for at, part in enumerate(node.parts) if part.kind == "operator" and part.text in "+−="]
    ends = zip([-1, *signs], [*signs, len(node.parts)], strict=True)
    return all(end - start <= LONGEST for start, end in ends)


def _joined(parts: Iterable[str]) -> str:
    """Join with blanks, but none beside a string: there Typst would show it."""
    text = ""
    for part in parts:
        text += part if not text or text.endswith('"') or part.startswith('"') else f" {part}"
    return text


def _group(node: Node) -> str:
    inner = _row(node)
    return f"lr({OPERATORS[node.text[0]]} {inner} {OPERATORS[node.text[1]]})"


def _attached(*places: str) -> Callable[[Node], str]:
    def write(node: Node) -> str:
        base, *marks = (_written(part) or '""' for part in node.parts)
        said = ", ".join(f"{place}: {mark}" for place, mark in zip(places, marks, strict=True))
        return f"attach({base}, {said})"

    return write


def _over(node: Node) -> str:
    base, mark = node.parts
    if mark.text in ACCENTS:
        return f"accent({_written(base)}, {ACCENTS[mark.text]})"
    return f"attach({_written(base)}, t: {_written(mark)})"


def _fraction(node: Node) -> str:
    above, below = (_written(part) or '""' for part in node.parts)
    return f"frac({above}, {below})"


def _root(node: Node) -> str:
    if len(node.parts) == 1:
        return f"sqrt({_written(node.parts[0])})"
    inside, degree = map(_written, node.parts)
    return f"root({degree}, {inside})"


def _table(node: Node) -> str:
    rows = "; ".join(", ".join(_written(cell) or '""' for cell in row.parts) for row in node.parts)
    return f"mat(delim: #none, {rows})"


WRITERS: dict[str, Callable[[Node], str]] = {
    "identifier": _identifier, "operator": _operator, "row": _row, "group": _group, "fraction": _fraction,
    "root": _root, "table": _table, "over": _over, "sub": _attached("b"), "sup": _attached("t"),
    "subsup": _attached("b", "t"), "under": _attached("b"), "number": lambda node: quoted(node.text),
    "text": lambda node: quoted(node.text), "space": lambda node: "thin",
}  # fmt: skip
