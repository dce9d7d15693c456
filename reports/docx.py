"""Documents as DOCX: real headings, tables and equations (Office Math), drawings as pictures with alternative text."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Callable
from datetime import datetime
from typing import Any

import docx
from docx.document import Document as Word
from docx.enum.text import WD_ALIGN_PARAGRAPH, WD_BREAK, WD_TAB_ALIGNMENT
from docx.oxml import parse_xml
from docx.oxml.ns import qn
from docx.shared import Mm, Pt
from docx.text.paragraph import Paragraph as WordParagraph

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
from reports.formulas.omml import pieces
from reports.pdf import png

EPOCH = datetime(2000, 1, 1)
UNSEEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
TEXT_WIDTH = 170.0  # mm
FACE = "Times New Roman"
SMALL = '<w:rPr><w:sz w:val="18"/></w:rPr>'  # half points
BREAK = "\u200b"  # no width; a line may end here
RULES = ("bottom", "between")  # in the order of the standard
SIZES = {"Title": 14, "Heading 1": 12, "Heading 2": 11}  # pt


def docx_bytes(document: Document) -> bytes:
    """Write a document; the same document gives the same bytes."""
    word = docx.Document()
    _set_up(word, document)
    for block in document.blocks:
        WRITERS[type(block)](word, block)
    held = io.BytesIO()
    word.save(held)
    return _timeless(held.getvalue())


def _set_up(word: Word, document: Document) -> None:
    section = word.sections[0]
    section.page_width, section.page_height = Mm(210), Mm(297)
    section.left_margin = section.right_margin = section.top_margin = section.bottom_margin = Mm(20)
    style = word.styles["Normal"]
    style.font.name, style.font.size = FACE, Pt(11)
    style.element.rPr.append(parse_xml(f'<w:lang {_W} w:val="{TAGS[document.language]}"/>'))
    core = word.core_properties
    core.title, core.author, core.comments = document.title, "", ""
    core.created = core.modified = EPOCH
    core.last_modified_by, core.revision = "", 1
    core.language = TAGS[document.language]
    for name, size in SIZES.items():
        _plain(word, name, size)
    word.add_heading(document.title, 0).alignment = WD_ALIGN_PARAGRAPH.CENTER
    word.add_paragraph(document.subtitle).alignment = WD_ALIGN_PARAGRAPH.CENTER
    _foot(section.footer.paragraphs[0], document.foot)


def _plain(word: Word, name: str, size: float) -> None:
    """Let a heading stand in the letters of the text, black and without a line below."""
    style = word.styles[name]
    look, room = style.element.rPr, style.element.pPr
    for part in (qn("w:rFonts"), qn("w:color")):
        look.remove(look.find(part))
    for line in room.findall(qn("w:pBdr")):
        room.remove(line)
    style.font.name, style.font.size, style.font.bold = FACE, Pt(size), True
    style.paragraph_format.space_before, style.paragraph_format.space_after = Pt(size), Pt(3)


def _foot(paragraph: WordParagraph, text: str) -> None:
    """Write the foot with the number of the page at the end of the line."""
    paragraph.style = "Normal"  # that of a footer has tabs of its own
    paragraph.paragraph_format.tab_stops.add_tab_stop(Mm(TEXT_WIDTH), WD_TAB_ALIGNMENT.RIGHT)
    _line(paragraph, (f"{text}\t",), small=True)
    for field, after in (("PAGE", " / "), ("NUMPAGES", "")):
        paragraph._p.append(
            parse_xml(f'<w:fldSimple {_W} w:instr="{field}"><w:r>{SMALL}<w:t>1</w:t></w:r></w:fldSimple>')
        )
        _line(paragraph, (after,), small=True)


_W = 'xmlns:w="http://schemas.openxmlformats.org/wordprocessingml/2006/main"'
TAGS = {"pl": "pl-PL", "en": "en-GB", "ru": "ru-RU"}


def _clean(text: str) -> str:
    """Leave out what XML cannot hold."""
    return UNSEEN.sub("", text)


def _line(paragraph: WordParagraph, runs: Line, small: bool = False) -> None:
    for run in runs:
        if isinstance(run, str):
            written = paragraph.add_run(_clean(run))
            written.font.size = Pt(9) if small else None
        else:
            for number, piece in enumerate(pieces(run.mathml)):
                if number:
                    paragraph.add_run(BREAK)
                paragraph._p.append(parse_xml(piece))


def _heading(word: Word, block: Heading) -> None:
    word.add_heading(_clean(block.text), block.level)


def _paragraph(word: Word, block: Paragraph) -> None:
    paragraph = word.add_paragraph()
    paragraph.paragraph_format.space_before = Pt(6) if block.quiet else None  # not at the foot of a table
    paragraph.paragraph_format.keep_with_next = block.kept or None
    _line(paragraph, block.line, block.quiet)
    if block.aside:
        paragraph.paragraph_format.tab_stops.add_tab_stop(Mm(TEXT_WIDTH), WD_TAB_ALIGNMENT.RIGHT)
        _line(paragraph, (f"\t{block.aside}",), small=True)


def _bullets(word: Word, block: Bullets) -> None:
    for item in block.lines:
        _line(word.add_paragraph(style="List Number" if block.numbered else "List Bullet"), item)


def _drawing(word: Word, block: Drawing) -> None:
    _picture(word.add_paragraph(), block)


def _beside(word: Word, block: Beside) -> None:
    """A table without borders: readers differ on when two pictures share a line."""
    table = word.add_table(rows=1, cols=len(block.drawings))
    for cell, drawing in zip(table.rows[0].cells, block.drawings, strict=True):
        _picture(cell.paragraphs[0], drawing)


def _picture(paragraph: WordParagraph, block: Drawing) -> None:
    run = paragraph.add_run()
    run.add_picture(io.BytesIO(png(block.svg, block.description)), width=Mm(TEXT_WIDTH * block.width))
    for shown in run._r.iter(qn("wp:docPr")):
        shown.set("descr", _clean(block.description))


def _table(word: Word, block: Table) -> None:
    rows = ([tuple((cell,) for cell in block.header)] if block.header else []) + list(block.rows)
    table = word.add_table(rows=len(rows), cols=len(rows[0]), style="Table Grid")
    for place, row in zip(table.rows, rows, strict=True):
        for cell, line in zip(place.cells, row, strict=True):
            _line(cell.paragraphs[0], line)


def _facts(word: Word, block: Facts) -> None:
    table = word.add_table(rows=1, cols=len(block.pairs), style="Table Grid")
    for cell, (name, value) in zip(table.rows[0].cells, block.pairs, strict=True):
        _line(cell.paragraphs[0], (name,), small=True)
        _line(cell.add_paragraph(), (value,))


def _ruled(word: Word, block: Ruled) -> None:
    """Lines to write on: empty paragraphs with a border below, and between, where a reader would join them."""
    for _ in range(block.lines):
        paragraph = word.add_paragraph()
        borders = "".join(f'<w:{side} w:val="single" w:sz="4" w:space="1" w:color="8C8C8C"/>' for side in RULES)
        paragraph._p.get_or_add_pPr().append(parse_xml(f"<w:pBdr {_W}>{borders}</w:pBdr>"))


def _break(word: Word, block: Break) -> None:
    word.add_paragraph().add_run().add_break(WD_BREAK.PAGE)


def _timeless(packed: bytes) -> bytes:
    """Pack again with one date for all parts."""
    held = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(packed)) as old, zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as new:
        for part in sorted(old.namelist()):
            new.writestr(zipfile.ZipInfo(part, (2000, 1, 1, 0, 0, 0)), old.read(part), zipfile.ZIP_DEFLATED)
    return held.getvalue()


WRITERS: dict[type[Block], Callable[[Word, Any], None]] = {
    Heading: _heading, Paragraph: _paragraph, Bullets: _bullets, Drawing: _drawing, Table: _table, Ruled: _ruled,
    Facts: _facts, Beside: _beside, Break: _break,
}  # fmt: skip
