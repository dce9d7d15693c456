"""What a finished figure is: SVG text, and the same data as a table for those who do not see it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Table:
    """A figure as a table: every row has as many cells as the header.

    Raises:
        ValueError: A row is longer or shorter than the header.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def __post_init__(self) -> None:
        for row in self.rows:
            if len(row) != len(self.header):
                raise ValueError(f"row {row} has {len(row)} cells under {len(self.header)} headings")


@dataclass(frozen=True, slots=True)
class Words:
    """All that a figure says, in the reader's language."""

    title: str  # what it is
    description: str  # what is where, senses of loads; no answers
    table: Table


@dataclass(frozen=True, slots=True)
class Picture:
    """A finished figure: ``svg`` to stand on the page, ``table`` to stand beside it."""

    svg: str
    table: Table
