"""The formats of documents, and what each is called on its way."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from reports.document import Document

MEDIA: Mapping[str, str] = {
    "pdf": "application/pdf",
    "docx": "application/vnd.openxmlformats-officedocument.wordprocessingml.document",
    "typ": "text/plain; charset=utf-8",
    "md": "text/markdown; charset=utf-8",
}
FORMATS = tuple(MEDIA)


def written(document: Document, format_: str) -> bytes:
    """Write a document in a format; the same document gives the same bytes.

    Raises:
        KeyError: There is no such format.
    """
    return WRITERS[format_](document)


def _pdf(document: Document) -> bytes:
    from reports.pdf import pdf  # the engine is loaded by those who print

    return pdf(document)


def _docx(document: Document) -> bytes:
    from reports.docx import docx_bytes

    return docx_bytes(document)


def _typst(document: Document) -> bytes:
    from reports.typst import source

    return source(document).encode()


def _markdown(document: Document) -> bytes:
    from reports.markdown import markdown

    return markdown(document).encode()


WRITERS: Mapping[str, Callable[[Document], bytes]] = {"pdf": _pdf, "docx": _docx, "typ": _typst, "md": _markdown}
