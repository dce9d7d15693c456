"""Diagrams of internal forces along a bar, N, T, V or M, one under the other on a common length.

A curve is given in parts, each a polynomial of the distance from its start; between parts it may jump. Ordinates are
drawn to scale, each diagram to its own; `down` draws positive ones downwards, on the side of the stretched fibres.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from figures.canvas import Drawing, Line, Piece, Strokes, Text
from figures.label import number, symbol
from figures.lines import hidden, thin
from figures.picture import Picture, Words
from figures.placing import GAP, Spot, is_free, place, written
from figures.plane import Point

SPAN = 470.0
WIDTH = 572.0
HEIGHT = 56.0  # of the largest ordinate
_ROOM = 26.0  # for values above and below
_STEP = 12.0  # between ordinates
_BENDS = 24  # straight stretches of a curved part
_LEVEL = 1e-9  # of the largest ordinate: nothing is drawn


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a curve without a jump inside: its ends, and coefficients by powers of the distance from its start."""

    start: float
    end: float
    curve: tuple[float, ...]

    def at(self, x: float) -> float:
        """The ordinate at a place."""
        found = 0.0
        for coefficient in reversed(self.curve):
            found = found * (x - self.start) + coefficient
        return found


@dataclass(frozen=True, slots=True)
class Value:
    """An ordinate to be written out, with its text."""

    x: float
    height: float
    text: str


@dataclass(frozen=True, slots=True)
class Curve:
    """One diagram: its name, its parts from left to right, and the values to write."""

    name: str
    parts: tuple[Part, ...]
    values: tuple[Value, ...] = ()
    down: bool = False


@dataclass(frozen=True, slots=True)
class _Panel:
    """A curve laid out: its base line and its scales."""

    curve: Curve
    base: float
    across: float
    up: float

    def point(self, x: float, height: float) -> Point:
        return complex(x * self.across, self.base + self.up * height)

    def outline(self) -> list[Point]:
        """The curve from the base line at its start to the base line at its end."""
        parts = self.curve.parts
        ends = [self.point(parts[0].start, 0.0), self.point(parts[-1].end, 0.0)]
        return [ends[0], *(at for part in parts for at in self._bent(part)), ends[1]]

    def _bent(self, part: Part) -> Iterator[Point]:
        count = _BENDS if any(part.curve[2:]) else 1
        for step in range(count + 1):
            x = part.start + (part.end - part.start) * step / count
            yield self.point(x, part.at(x))

    def regions(self) -> Iterator[tuple[list[Point], float]]:
        """Neighbouring points on one side of the base line, with the side."""
        held: list[Point] = []
        for one, other in pairwise([*self.outline(), self.point(self.curve.parts[-1].end, 0.0)]):
            rise = one.imag - self.base
            if abs(rise) > 1:
                held.append(one)
            if held and (abs(rise) <= 1 or rise * (other.imag - self.base) <= 0):
                yield held, held[0].imag - self.base
                held = []


def draw(prefix: str, words: Words, length: float, curves: Sequence[Curve], places: Sequence[float] = ()) -> Picture:
    """Draw diagrams under one another.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        length: The length of the bar, positive.
        curves: What to draw, from top to bottom.
        places: Where thin lines run through all diagrams, under supports and loads.

    Raises:
        ValueError: The length is not positive, there is no curve, or one has no parts or leaves the bar.
    """
    _check(length, curves)
    panels = list(_laid_out(length, curves))
    lowest = panels[-1].base - HEIGHT - 8
    pieces: list[Piece] = [
        hidden(complex(x * SPAN / length, HEIGHT + 8), complex(x * SPAN / length, lowest)) for x in sorted(set(places))
    ]
    for panel in panels:
        pieces += _drawn(panel, pieces)
    for panel in panels:
        _write(panel, pieces)
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def _check(length: float, curves: Sequence[Curve]) -> None:
    if not length > 0:
        raise ValueError(f"a bar {length} long cannot be drawn")
    if not curves:
        raise ValueError("there is no diagram to draw")
    for curve in curves:
        if not curve.parts:
            raise ValueError(f"diagram {curve.name} has no parts")
        for part in curve.parts:
            if not -1e-9 * length <= part.start < part.end <= length * (1 + 1e-9):
                raise ValueError(f"diagram {curve.name}: {part.start} .. {part.end} lies off a bar {length} long")


def _laid_out(length: float, curves: Sequence[Curve]) -> Iterator[_Panel]:
    for row, curve in enumerate(curves):
        largest = max(abs(part.at(x)) for part in curve.parts for x in _within(part))
        up = HEIGHT / largest if largest > 0 else 0.0
        yield _Panel(curve, -row * 2 * (HEIGHT + _ROOM), SPAN / length, -up if curve.down else up)


def _within(part: Part) -> list[float]:
    return [part.start + (part.end - part.start) * step / _BENDS for step in range(_BENDS + 1)]


def _drawn(panel: _Panel, before: Sequence[Piece]) -> list[Piece]:
    """The area with its outline and base line, a sign in each region, and ordinates where no sign stands."""
    outline = panel.outline()
    base = (complex(0, panel.base), complex(SPAN, panel.base))
    pieces: list[Piece] = [Line("f-area", tuple(outline), closed=True), thin(*base), Line("f-thick", tuple(outline))]
    signs = [text for region, side in panel.regions() for text in _sign(panel, region, side, [*before, *pieces])]
    return [*pieces, *_ordinates(panel, signs), *signs]


def _sign(panel: _Panel, region: Sequence[Point], side: float, pieces: Iterable[Piece]) -> tuple[Text, ...]:
    """A plus or a minus inside a region, where there is room."""
    label = number("+" if (side > 0) == (panel.up > 0) else "−")
    held = tuple(pieces)
    first, last = region[0].real, region[-1].real
    for share in (0.5, 0.35, 0.65, 0.2, 0.8):
        x = first + share * (last - first)
        rise = min((at for at in region), key=lambda at: abs(at.real - x)).imag - panel.base
        spot = complex(x, panel.base + rise / 2 - 7)
        if is_free(label.box(spot, "middle").grown(GAP), held):
            return (Text(spot, label, "middle"),)
    return ()


def _ordinates(panel: _Panel, signs: Sequence[Text]) -> list[Piece]:
    """Thin strokes from the base line to the curve, at equal steps."""
    strokes = []
    for part in panel.curve.parts:
        start, end = part.start * panel.across, part.end * panel.across
        count = int((end - start) // _STEP)
        for step in range(1, count + 1):
            x = start + (end - start) * step / (count + 1)
            tip = panel.point(x / panel.across, part.at(x / panel.across))
            stroke = (complex(x, panel.base), tip)
            if abs(tip.imag - panel.base) > 2 and not any(sign.box.grown(GAP).crossed_by(stroke) for sign in signs):
                strokes.append(stroke)
    return [Strokes("f-ord", tuple(strokes))] if strokes else []


def _write(panel: _Panel, pieces: list[Piece]) -> None:
    """The name left of the base line, then the values, the largest first."""
    pieces += written(symbol(panel.curve.name), complex(-14, panel.base - 6), "end")
    for value in sorted(panel.curve.values, key=lambda value: -abs(value.height)):
        tip = panel.point(value.x, value.height)
        pieces += place(number(value.text), _spots(tip, tip.imag - panel.base), pieces, tip)


def _spots(tip: Point, rise: float) -> tuple[Spot, ...]:
    """Beyond the tip, on the side away from the base line; else beside it."""
    beyond = 8j if rise >= -_LEVEL else -20j
    nearer = -20j if rise >= -_LEVEL else 8j
    return (
        (tip + beyond, "middle"),
        (tip + beyond + 4, "start"),
        (tip + beyond - 4, "end"),
        (tip + 6 - 6j, "start"),
        (tip - 6 - 6j, "end"),
        (tip + nearer + 4, "start"),
        (tip + nearer - 4, "end"),
    )
