"""What a document is made of, before it becomes Typst, DOCX or Markdown.

Text is plain text and formulas are presentation MathML: nothing of a student's hand is ever markup.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias
from xml.etree import ElementTree


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula inside a line."""

    mathml: str

    @property
    def spoken(self) -> str:
        """Give it in one line of text, for those who do not see it."""
        return _spoken(ElementTree.fromstring(self.mathml))


JOINTS = {"mtable": " | ", "mtr": "; ", "mfrac": "/", "msup": "^"}


def _spoken(element: ElementTree.Element) -> str:
    tag = element.tag.rpartition("}")[2]
    parts = [_spoken(child) for child in element]
    if tag == "msqrt":
        return f"√({''.join(parts)})"
    if tag == "msubsup":
        return "{}{}^{}".format(*parts)
    if tag == "mfrac":
        parts = [one if one.isalnum() else f"({one})" for one in parts]
    return (element.text or "") + JOINTS.get(tag, "").join(parts)


Run: TypeAlias = str | Formula
Line: TypeAlias = tuple[Run, ...]


@dataclass(frozen=True, slots=True)
class Heading:
    """A heading; level 1 is the title of a section."""

    text: str
    level: int = 1


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A line of text that wraps.

    Quiet ones are notes; an aside stands at the end of the line, quietly; a kept one stays on the page of what follows.
    """

    line: Line
    quiet: bool = False
    aside: str = ""
    kept: bool = False


@dataclass(frozen=True, slots=True)
class Bullets:
    """A list, numbered or not."""

    lines: tuple[Line, ...]
    numbered: bool = False


@dataclass(frozen=True, slots=True)
class Drawing:
    """A figure as SVG with what it shows in words."""

    svg: str
    description: str
    width: float = 0.8  # of the text's width


@dataclass(frozen=True, slots=True)
class Beside:
    """Drawings side by side, each in its share of the text's width."""

    drawings: tuple[Drawing, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """Rows under a header; cells are lines."""

    header: tuple[str, ...]
    rows: tuple[tuple[Line, ...], ...]


@dataclass(frozen=True, slots=True)
class Ruled:
    """Room to write by hand: so many lines, or squared paper of that height."""

    lines: int
    squared: bool = False


@dataclass(frozen=True, slots=True)
class Facts:
    """The title block: names and values."""

    pairs: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Break:
    """A new page."""


Block: TypeAlias = Heading | Paragraph | Bullets | Drawing | Beside | Table | Ruled | Facts | Break


@dataclass(frozen=True, slots=True)
class Document:
    """A document in one language; the foot stands on every page."""

    title: str
    subtitle: str
    language: str
    blocks: tuple[Block, ...]
    foot: str = ""


def from_html(html: str) -> Iterator[Block]:
    """Turn a statement of ours (paragraphs and lists with MathML inside) into blocks.

    Raises:
        ValueError: An element that statements do not have.
    """
    for block in ElementTree.fromstring(f"<div>{html}</div>"):
        if block.tag == "p":
            yield Paragraph(line_of(block))
        elif block.tag == "ul":
            yield Bullets(tuple(line_of(item) for item in block))
        else:
            raise ValueError(f"<{block.tag}> is no part of a statement")


def line_from_html(html: str) -> Line:
    """Turn an inline text of ours (MathML and spans) into a line."""
    return line_of(ElementTree.fromstring(f"<p>{html}</p>"))


def line_of(element: ElementTree.Element) -> Line:
    """Read text, formulas and spans in order."""
    return tuple(_runs(element))


def _runs(element: ElementTree.Element) -> Iterator[Run]:
    if element.text:
        yield element.text
    for child in element:
        if child.tag == "math":
            tail, child.tail = child.tail, None
            yield Formula(ElementTree.tostring(child, encoding="unicode"))
            child.tail = tail
        else:
            yield from _runs(child)
        if child.tail:
            yield child.tail


def plain(line: Line) -> str:
    """Give the text of a line, formulas by their letters."""
    return "".join(run if isinstance(run, str) else run.spoken for run in line)


def in_rows(mathml: str) -> list[str]:
    """Cut a formula that is a column of lines into its lines; any other formula is one line."""
    root = ElementTree.fromstring(mathml)
    table = root.find("mtable")
    cells = [row[0] for row in table if len(row) == 1] if table is not None and len(root) == 1 else []
    if not cells or table is None or len(cells) != len(table):
        return [mathml]
    return [
        f"<math>{''.join(ElementTree.tostring(part, encoding='unicode') for part in cell)}</math>" for cell in cells
    ]
