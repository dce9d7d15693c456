"""Plots over time, one under the other on a common time axis, each to its own scale."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import isfinite

from figures.canvas import Drawing, Line, Piece, Text
from figures.label import number, symbol
from figures.lines import thin
from figures.picture import Picture, Words

SPAN = 470.0
HEIGHT = 70.0  # between the least and the largest value
ROOM = 44.0  # between two plots
TEXT = 7.0  # from a base line to the middle of its digits


@dataclass(frozen=True, slots=True)
class Series:
    """Values at equal steps of time: symbol and unit above, style of the line, least and largest as text."""

    name: str
    unit: str
    style: str
    values: tuple[float, ...]
    least: str
    largest: str


def draw(prefix: str, words: Words, end: str, series: Sequence[Series]) -> Picture:
    """Draw plots under one another.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        end: The last moment, as text.
        series: What to plot, from top to bottom.

    Raises:
        ValueError: There is nothing to plot, fewer than two values, or one that is not finite.
    """
    if not series:
        raise ValueError("there is nothing to plot")
    for one in series:
        if len(one.values) < 2 or not all(map(isfinite, one.values)):
            raise ValueError(f"{one.name} has no curve")
    pieces = [piece for row, one in enumerate(series) for piece in _panel(one, -row * (HEIGHT + ROOM))]
    low = -(len(series) - 1) * (HEIGHT + ROOM) - HEIGHT
    pieces += [Text(complex(0, low - 20), number("0"), "middle"), Text(complex(SPAN, low - 20), number(end), "end")]
    return Picture(Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description), words.table)


def _panel(one: Series, top: float) -> Iterator[Piece]:
    """The axes, the curve between its least and largest value (zero always belongs), the values at the axis."""
    low, high = min(0.0, *one.values), max(0.0, *one.values)
    scale = HEIGHT / (high - low or 1.0)
    base = top - HEIGHT - low * scale
    yield thin(complex(0, top), complex(0, top - HEIGHT))
    yield thin(complex(0, base), complex(SPAN, base))
    step = SPAN / (len(one.values) - 1)
    yield Line(one.style, tuple(complex(k * step, base + value * scale) for k, value in enumerate(one.values)))
    name = symbol(one.name)
    yield Text(complex(8, top + 6), name)
    yield Text(complex(8 + name.width, top + 6), number(f"[{one.unit}]"))
    yield Text(complex(-8, base - TEXT), number("0"), "end")
    for value, text in ((low, one.least), (high, one.largest)):
        if abs(value) * scale > 2.5 * TEXT:
            yield Text(complex(-8, base + value * scale - TEXT), number(text), "end")
