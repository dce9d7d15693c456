"""Documents as Typst source. All text stands in strings: what a student typed is never markup or code."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from figures.paper import on_paper
from reports.document import (
    Beside,
    Block,
    Break,
    Bullets,
    Document,
    Drawing,
    Facts,
    Formula,
    Heading,
    Line,
    Paragraph,
    Ruled,
    Table,
)  # fmt: skip
from reports.formulas.typst import formula, quoted

PREAMBLE = """#set document(title: {title}, date: none)
#set page(paper: "a4", margin: (x: 20mm, top: 18mm, bottom: 20mm), numbering: "1 / 1", footer: context [
  #set text(size: 8pt, fill: luma(90))
  #query(<foot>).first().value #h(1fr) #counter(page).display("1 / 1", both: true)
])
#set text(font: "Libertinus Serif", size: 11pt, lang: {language}, region: none, hyphenate: true)
#set par(justify: false, leading: 0.65em)
#show heading: set block(above: 1.4em, below: 0.7em)
#show heading: set text(hyphenate: false)
#show heading.where(level: 1): set text(size: 12pt)
#metadata({foot}) <foot>
#align(center)[#text(size: 14pt, weight: "bold")[#{title}] #linebreak() #text(size: 11pt)[#{subtitle}]]
"""


def source(document: Document) -> str:
    """Write a document; the same document gives the same text."""
    head = PREAMBLE
    for name, text in (
        ("title", document.title), ("subtitle", document.subtitle), ("foot", document.foot),
        ("language", document.language),
    ):  # fmt: skip
        head = head.replace("{" + name + "}", quoted(text))
    return head + "\n".join(WRITERS[type(block)](block) for block in document.blocks) + "\n"


def line(runs: Line) -> str:
    """Write a line as content."""
    return "".join(f"#{quoted(run)}" if isinstance(run, str) else _equation(run) for run in runs)


@lru_cache(maxsize=256)
def _equation(run: Formula) -> str:
    equation = f"math.equation(alt: {quoted(run.spoken)}, ${formula(run.mathml)}$)"
    return f"#box(inset: (y: 0.6em), {equation})" if "<mtable" in run.mathml else f"#{equation}"  # or lines overlap


def _heading(block: Heading) -> str:
    return f"#heading(level: {block.level})[#{quoted(block.text)}]"


def _paragraph(block: Paragraph) -> str:
    inner = line(block.line)
    if block.aside:
        note = f"text(size: 9pt, fill: luma(70))[#{quoted(block.aside)}]"
        inner = f"#grid(columns: (1fr, auto), column-gutter: 1em, align: bottom, [{inner}], {note})"
    inner = f"#text(size: 9pt, fill: luma(70))[{inner}]" if block.quiet else inner
    return f"#block{'(sticky: true)' if block.kept else ''}[{inner}]"


def _bullets(block: Bullets) -> str:
    items = ", ".join(f"[{line(item)}]" for item in block.lines)
    return f"#{'enum' if block.numbered else 'list'}({items})"


def _drawing(block: Drawing) -> str:
    return f"#align(center)[#{_image(block, f'{100 * block.width:g}%')}]"


def _beside(block: Beside) -> str:
    shares = "".join(f"{drawing.width:g}fr, " for drawing in block.drawings)
    images = ", ".join(_image(drawing, "100%") for drawing in block.drawings)
    return f"#grid(columns: ({shares}), column-gutter: 1em, align: bottom, {images})"


def _image(drawing: Drawing, width: str) -> str:
    svg, alt = quoted(on_paper(drawing.svg)), quoted(drawing.description)
    return f'image(bytes({svg}), format: "svg", width: {width}, alt: {alt})'


def _table(block: Table) -> str:
    header = ", ".join(f"[*#{quoted(cell)}*]" for cell in block.header)
    head = f"table.header({header}), " if header else ""
    cells = ", ".join(f"[{line(cell)}]" for row in block.rows for cell in row)
    columns = "(" + "1fr, " * (len(block.header) or len(block.rows[0])) + ")"
    return f"#table(columns: {columns}, stroke: 0.5pt + luma(140), inset: 6pt, {head}{cells})"


def _ruled(block: Ruled) -> str:
    if block.squared:
        tile = "tiling(size: (5mm, 5mm))[#box(width: 5mm, height: 5mm, stroke: 0.25pt + luma(190))]"
        return f"#pdf.artifact(rect(width: 100%, height: {block.lines * 8}mm, stroke: 0.5pt + luma(140), fill: {tile}))"
    rule = "#v(8mm - 0.5pt) #line(length: 100%, stroke: 0.5pt + luma(140))"
    return f"#pdf.artifact(block[{rule * block.lines}])"


def _facts(block: Facts) -> str:
    cells = ", ".join(
        f"[#text(size: 8pt, fill: luma(70))[#{quoted(k)}] #linebreak() #{quoted(v)}]" for k, v in block.pairs
    )
    shares = "(1.6fr, " + "1fr, " * (min(4, len(block.pairs)) - 1) + ")"
    return f"#table(columns: {shares}, stroke: 0.5pt, inset: 6pt, {cells})"


WRITERS: dict[type[Block], Callable[[Any], str]] = {
    Heading: _heading, Paragraph: _paragraph, Bullets: _bullets, Drawing: _drawing, Table: _table, Ruled: _ruled,
    Beside: _beside,
    Facts: _facts, Break: lambda block: "#pagebreak()",
}  # fmt: skip
