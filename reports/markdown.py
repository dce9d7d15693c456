"""Documents as Markdown with LaTeX between dollar signs."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from reports.document import (
    Beside,
    Block,
    Break,
    Bullets,
    Document,
    Drawing,
    Facts,
    Heading,
    Line,
    Paragraph,
    Ruled,
    Table,
)
from reports.formulas.latex import formula

MARKS = re.compile(r"([\\`*_{}\[\]()#+\-.!|<>~$&])")


def markdown(document: Document) -> str:
    """Write a document; drawings are named, not held."""
    head = [f"# {escaped(document.title)}", escaped(document.subtitle)]
    return "\n\n".join([*head, *(WRITERS[type(block)](block) for block in document.blocks)]) + "\n"


def escaped(text: str) -> str:
    """Write a text so that no mark of it is Markdown or HTML."""
    return MARKS.sub(r"\\\1", " ".join(text.split("\n")))


def _line(runs: Line) -> str:
    return "".join(escaped(run) if isinstance(run, str) else f"${formula(run.mathml)}$" for run in runs)


def _paragraph(block: Paragraph) -> str:
    written = f"*{_line(block.line)}*" if block.quiet and plain_line(block) else _line(block.line)
    return f"{written} *({escaped(block.aside)})*" if block.aside else written


def _heading(block: Heading) -> str:
    """Headings keep the words of the form, character by character."""
    return f"{'#' * (block.level + 1)} {block.text}"


def _bullets(block: Bullets) -> str:
    return "\n".join(f"{f'{n}.' if block.numbered else '-'} {_line(item)}" for n, item in enumerate(block.lines, 1))


def _drawing(block: Drawing) -> str:
    return f"[{escaped(block.description)}]"


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _table(block: Table) -> str:
    columns = len(block.header) or len(block.rows[0])
    head = [escaped(cell) for cell in block.header] or [" "] * columns
    rows = [[_line(cell) for cell in row] for row in block.rows]
    return "\n".join(map(_row, [head, ["---"] * columns, *rows]))


def _facts(block: Facts) -> str:
    return "\n".join(f"- {escaped(name)}: {escaped(value)}" for name, value in block.pairs)


WRITERS: dict[type[Block], Callable[[Any], str]] = {
    Heading: _heading, Bullets: _bullets, Table: _table, Facts: _facts,
    Paragraph: _paragraph,
    Drawing: _drawing,
    Beside: lambda block: "\n\n".join(map(_drawing, block.drawings)),
    Ruled: lambda block: "\n\n".join(["&nbsp;"] * block.lines),
    Break: lambda block: "---",
}  # fmt: skip


def plain_line(block: Paragraph) -> bool:
    """Tell whether a line is text only, so that it can be set in italics."""
    return all(isinstance(run, str) for run in block.line) and any(str(run).strip() for run in block.line)
