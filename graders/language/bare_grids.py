"""Matrices copied from a table or typed as in other programs: rows as lines or behind `;`, entries parted by blanks."""

from __future__ import annotations

import re

from graders.language.latex_source import undollared

GAPS = (";", "\t", "|", "&", ", ", " ")  # between the entries of a row, the surest first
LONGEST = 2000
BREAK = re.compile(r"\\\\")  # between the rows of LaTeX
SPACE = re.compile(r"\\(?:[,;:!> ]|q?quad\b)")
FENCE = re.compile(r"\\left(?=\[)|\\right(?=\])")


def bracketed(text: str) -> str:
    """Write the rows of a matrix with the brackets of the language: `1 0\\n0 1` and `[1 0; 0 1]` are `[[1;0], [0;1]]`.

    LaTeX may stand in the entries, and its marks between them: `\\frac{1}{2} & 0 \\\\ 0 & 1`.
    Empty where the text has no rows of one length: then it is no such matrix.
    """
    rows = [_entries(row) for row in _rows(_unmarked(text))] if len(text) <= LONGEST else []
    alone = len(rows) == 1 and "[" not in text
    if alone or len({len(row) for row in rows}) != 1 or len(rows[0]) < 2 or not all(map(all, rows)):
        return ""
    return "[" + ", ".join(f"[{'; '.join(row)}]" for row in rows) + "]"


def _unmarked(text: str) -> str:
    """Write the marks of LaTeX between rows and entries as those of plain text."""
    return FENCE.sub("", SPACE.sub(" ", BREAK.sub("\n", undollared(text))))


def _rows(text: str) -> list[str]:
    inside = text[text.find("=") + 1 :].strip()
    if "\n" in inside:
        return [row for row in map(_bare, inside.split("\n")) if row]
    return [_bare(row) for row in inside.removeprefix("[").removesuffix("]").split(";")]


def _bare(row: str) -> str:
    return row.strip().strip("[]|,;").strip(" ")


def _entries(row: str) -> list[str]:
    gap = next((gap for gap in GAPS if gap in row), " ")
    return [entry.strip() for entry in (row.split() if gap == " " else row.split(gap))]
