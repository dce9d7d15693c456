"""The sheet: pieces of a drawing, the room they take, and the SVG text they make."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, cos, pi, sin
from typing import Protocol

from figures.label import Anchor, Label, escaped
from figures.plane import Box, Point, Segment

MARGIN = 6.0


class Piece(Protocol):
    """One mark on the sheet."""

    def svg(self) -> str:
        """Its element."""
        ...

    def segments(self) -> tuple[Segment, ...]:
        """Straight stretches that follow its lines (a text: the sides of its room)."""
        ...


def coordinate(value: float) -> str:
    """A number with at most one decimal, never a negative zero."""
    rounded = round(value, 1) + 0.0
    return f"{rounded:.0f}" if rounded.is_integer() else f"{rounded:.1f}"


def _at(place: Point) -> str:
    return f"{coordinate(place.real)} {coordinate(-place.imag)}"


@dataclass(frozen=True, slots=True)
class Line:
    """A polyline, or a polygon when closed."""

    style: str
    points: tuple[Point, ...]
    closed: bool = False

    def svg(self) -> str:
        end = "Z" if self.closed else ""
        return f'<path class="{self.style}" d="M{"L".join(map(_at, self.points))}{end}"/>'

    def segments(self) -> tuple[Segment, ...]:
        ends = (*self.points[1:], self.points[0]) if self.closed else self.points[1:]
        return tuple(zip(self.points, ends, strict=False))


@dataclass(frozen=True, slots=True)
class Strokes:
    """Separate straight strokes in one element."""

    style: str
    pairs: tuple[Segment, ...]

    def svg(self) -> str:
        way = "".join(f"M{_at(start)}L{_at(end)}" for start, end in self.pairs)
        return f'<path class="{self.style}" d="{way}"/>'

    def segments(self) -> tuple[Segment, ...]:
        return self.pairs


@dataclass(frozen=True, slots=True)
class Arc:
    """A part of a circle or of an upright ellipse, from ``start`` to ``end`` (radians; less than a full turn)."""

    style: str
    centre: Point
    radius: float
    start: float
    end: float
    height: float | None = None  # the upright radius of an ellipse

    def at(self, angle: float) -> Point:
        """The point of the curve at an angle."""
        height = self.radius if self.height is None else self.height
        return self.centre + complex(self.radius * cos(angle), height * sin(angle))

    def svg(self) -> str:
        height = self.radius if self.height is None else self.height
        flags = f"{int(abs(self.end - self.start) > pi)} {int(self.end < self.start)}"
        radii = f"{coordinate(self.radius)} {coordinate(height)}"
        return (
            f'<path class="{self.style}" d="M{_at(self.at(self.start))}A{radii} 0 {flags} {_at(self.at(self.end))}"/>'
        )

    def segments(self) -> tuple[Segment, ...]:
        count = max(4, ceil(abs(self.end - self.start) / (pi / 12)))
        points = [self.at(self.start + (self.end - self.start) * i / count) for i in range(count + 1)]
        return tuple(pairwise(points))


@dataclass(frozen=True, slots=True)
class Circle:
    """A full circle."""

    style: str
    centre: Point
    radius: float

    def svg(self) -> str:
        x, y = _at(self.centre).split()
        return f'<circle class="{self.style}" cx="{x}" cy="{y}" r="{coordinate(self.radius)}"/>'

    def segments(self) -> tuple[Segment, ...]:
        return Arc(self.style, self.centre, self.radius, 0, 2 * pi).segments()


@dataclass(frozen=True, slots=True)
class Text:
    """A label with its base line at a point."""

    at: Point
    label: Label
    anchor: Anchor = "start"

    @property
    def box(self) -> Box:
        """The room the label takes at its largest."""
        return self.label.box(self.at, self.anchor)

    def svg(self) -> str:
        x, y = _at(self.at).split()
        classes = f' class="{self.label.classes}"' if self.label.classes else ""
        anchor = f' text-anchor="{self.anchor}"' if self.anchor != "start" else ""
        return f'<text x="{x}" y="{y}"{classes}{anchor}>{self.label.svg()}</text>'

    def segments(self) -> tuple[Segment, ...]:
        corners = self.box.corners
        return tuple(zip(corners, (*corners[1:], corners[0]), strict=True))


def bounds(pieces: Iterable[Piece]) -> Box:
    """The box that holds all pieces.

    Raises:
        ValueError: There are no pieces.
    """
    return Box.around(end for piece in pieces for segment in piece.segments() for end in segment)


@dataclass(frozen=True, slots=True)
class Drawing:
    """Pieces in the order in which they cover one another."""

    pieces: tuple[Piece, ...]

    def to_svg(self, prefix: str, title: str, description: str, width: float = 0.0) -> str:
        """Write the drawing, its view fitted to its contents.

        Args:
            prefix: The id of the figure on its page; letters, digits and hyphens.
            title: What the figure is.
            description: What is where.
            width: The least width of the view, in user units; narrower contents stand in its middle.

        Raises:
            ValueError: The prefix cannot be an id, or there are no pieces.
        """
        if not prefix.replace("-", "").isalnum() or not prefix.isascii() or not prefix[0].isalpha():
            raise ValueError(f"{prefix!r} cannot be the id of a figure")
        head = (
            f'<svg class="fig" id="{prefix}" viewBox="{self._view(width)}" role="img" '
            f'aria-labelledby="{prefix}-t {prefix}-d"><title id="{prefix}-t">{escaped(title)}</title>'
            f'<desc id="{prefix}-d">{escaped(description)}</desc>'
        )
        return head + "".join(piece.svg() for piece in self.pieces) + "</svg>"

    def _view(self, width: float) -> str:
        box = bounds(self.pieces).grown(MARGIN)
        spare = max(0.0, width - (box.right - box.left)) / 2
        left, top = box.left - spare, -box.top
        sides = (box.right + spare - left, box.top - box.bottom)
        return " ".join(coordinate(float(value)) for value in (left, top, *map(ceil, sides)))
