"""Formulas as Office Math, so that a word processor shows and edits them as equations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from xml.sax.saxutils import escape

from reports.formulas import FUNCTIONS, Node, read

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"
LEAST = 12  # letters of a piece before a line may break
ACCENTS = {"˙": "\u0307", "¨": "\u0308", "→": "\u20d7", "¯": "\u0304"}


def formula(mathml: str) -> str:
    """Write a formula as one `m:oMath` element."""
    return f'<m:oMath xmlns:m="{NAMESPACE}">{_written(read(mathml))}</m:oMath>'


def pieces(mathml: str) -> list[str]:
    """Write a formula as elements between which a line may break: a long sum before each sign that parts its terms."""
    found: list[list[Node]] = [[]]
    for node in _terms(read(mathml)):
        if found[-1] and node.kind == "operator" and node.text in "+−" and len(_letters(found[-1])) >= LEAST:
            found.append([])
        found[-1].append(node)
    return [f'<m:oMath xmlns:m="{NAMESPACE}">{"".join(map(_written, piece))}</m:oMath>' for piece in found]


def _terms(node: Node) -> Iterator[Node]:
    """Give the parts of a row, those of the rows in it too."""
    if node.kind != "row":
        yield node
    for part in node.parts if node.kind == "row" else ():
        yield from _terms(part)


def _letters(nodes: Iterable[Node]) -> str:
    return "".join(node.text + _letters(node.parts) for node in nodes)


def _written(node: Node) -> str:
    return WRITERS[node.kind](node)


def _run(text: str, upright: bool) -> str:
    style = '<m:rPr><m:sty m:val="p"/></m:rPr>' if upright else ""
    return f'<m:r>{style}<m:t xml:space="preserve">{escape(text)}</m:t></m:r>' if text else ""


def _identifier(node: Node) -> str:
    return _run(node.text, upright=len(node.text) > 1 or node.text in FUNCTIONS)


def _row(node: Node) -> str:
    return "".join(map(_written, node.parts))


def _part(name: str, node: Node) -> str:
    return f"<m:{name}>{_written(node)}</m:{name}>"


def _shape(element: str, *names: str) -> Callable[[Node], str]:
    def write(node: Node) -> str:
        parts = "".join(_part(name, part) for name, part in zip(names, node.parts, strict=True))
        return f"<m:{element}>{parts}</m:{element}>"

    return write


def _group(node: Node) -> str:
    marks = f'<m:begChr m:val="{escape(node.text[0])}"/><m:endChr m:val="{escape(node.text[1])}"/>'
    return f"<m:d><m:dPr>{marks}</m:dPr><m:e>{_row(node)}</m:e></m:d>"


def _over(node: Node) -> str:
    base, mark = node.parts
    if mark.text in ACCENTS:
        return f'<m:acc><m:accPr><m:chr m:val="{ACCENTS[mark.text]}"/></m:accPr>{_part("e", base)}</m:acc>'
    return f"<m:limUpp>{_part('e', base)}{_part('lim', mark)}</m:limUpp>"


def _root(node: Node) -> str:
    if len(node.parts) == 1:
        return f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/>{_part("e", node.parts[0])}</m:rad>'
    return f"<m:rad>{_part('deg', node.parts[1])}{_part('e', node.parts[0])}</m:rad>"


def _table(node: Node) -> str:
    rows = "".join("<m:mr>" + "".join(_part("e", cell) for cell in row.parts) + "</m:mr>" for row in node.parts)
    return f"<m:m>{rows}</m:m>"


WRITERS: dict[str, Callable[[Node], str]] = {
    "identifier": _identifier, "row": _row, "group": _group, "over": _over, "root": _root, "table": _table,
    "operator": lambda node: _run(node.text, upright=True), "number": lambda node: _run(node.text, upright=True),
    "text": lambda node: _run(node.text, upright=True), "space": lambda node: _run("\u2009", upright=True),
    "sub": _shape("sSub", "e", "sub"), "sup": _shape("sSup", "e", "sup"),
    "subsup": _shape("sSubSup", "e", "sub", "sup"),
    "under": _shape("limLow", "e", "lim"), "fraction": _shape("f", "num", "den"),
}  # fmt: skip
