"""Documents as PDF: tagged, fonts embedded, the same bytes for the same document."""

from __future__ import annotations

from functools import lru_cache
from threading import Lock
from typing import Literal

import typst as engine

from figures.paper import on_paper
from reports.document import Document
from reports.formulas.typst import quoted
from reports.typst import source
from reports.words import FOLDER

DOTS = 220.0  # of a PNG, to the inch
LOCK = Lock()  # the compiler is one, and it keeps what it has laid out


def pdf(document: Document) -> bytes:
    """Print a document as tagged PDF (PDF/UA-1).

    Letters that no font of ours has are printed as boxes; the standard refuses them, so it is not claimed then.
    """
    text = source(document).encode()
    try:
        return _printed(text, ["ua-1"])
    except engine.TypstError:
        return _printed(text, [])


def _printed(text: bytes, standards: list[Literal["ua-1"]]) -> bytes:
    with LOCK:
        made = _compiler().compile(text, format="pdf", pdf_standards=[*standards], timestamp=0)
    assert isinstance(made, bytes)
    return made


def png(svg: str, description: str) -> bytes:
    """Print one drawing as PNG, for word processors that show no SVG."""
    page = "#set page(width: auto, height: auto, margin: 2pt)\n"
    image = f'#image(bytes({quoted(on_paper(svg))}), format: "svg", alt: {quoted(description)})'
    with LOCK:
        made = _compiler().compile((page + image).encode(), format="png", ppi=DOTS, timestamp=0)
    assert isinstance(made, bytes)
    return made


@lru_cache(maxsize=1)
def _compiler() -> engine.Compiler:
    """Keep one compiler: its own fonts only, and a root that holds nothing but our words; it writes no file."""
    nowhere = str(FOLDER)
    fonts = engine.Fonts(include_system_fonts=False, include_embedded_fonts=True)
    return engine.Compiler(root=nowhere, font_paths=fonts, package_path=nowhere, package_cache_path=nowhere)
