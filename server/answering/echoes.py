"""What was understood of a line, as formulas between which a narrow page may break it."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

SIGNS = ("+", "−", "=")
SHORT = 24  # letters that fit on any screen
NEW_LINE = '<math display="block"></math>'  # the style sheet lets it take a line of no height


def breakable(mathml: str) -> str:
    """Cut a long formula before each sign that parts its terms, and a column of lines into its lines.

    Args:
        mathml: One `math` element, as the answer language writes it.
    """
    if not mathml or "<math" not in mathml:
        return mathml
    root = ElementTree.fromstring(mathml)
    lines = list(_lines(root))
    if len(lines) == 1 and len("".join(root.itertext())) <= SHORT:
        return mathml
    return NEW_LINE.join("".join(map(_formula, _pieces(line))) for line in lines)


def _lines(root: Element) -> Iterator[list[Element]]:
    """Give the parts of each line: of the rows of a column, else of the formula itself."""
    table = root.find("mtable")
    if table is None or table.get("columnalign") != "left" or len(root) > 1:
        yield _opened(list(root))
        return
    for row in table:
        yield _opened(list(row[0]))


def _opened(parts: list[Element]) -> list[Element]:
    """Take the last part out of its row, where it is one: the sum behind a label."""
    while parts and parts[-1].tag == "mrow" and any(_parts(one) for one in parts[-1]):
        parts = [*parts[:-1], *parts[-1]]
    return parts


def _pieces(parts: list[Element]) -> Iterator[list[Element]]:
    piece: list[Element] = []
    for part in parts:
        if piece and _parts(part):
            yield piece
            part.set("form", "infix")
            piece = []
        piece.append(part)
    yield piece


def _parts(one: Element) -> bool:
    """Tell whether this is a sign between terms."""
    return one.tag == "mo" and one.text in SIGNS and one.get("form") != "prefix"


def _formula(parts: list[Element]) -> str:
    return f"<math>{''.join(ElementTree.tostring(part, encoding='unicode') for part in parts)}</math>"
