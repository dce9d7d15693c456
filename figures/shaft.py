"""A stepped shaft with its ends, torques and dimensions, its length in true scale.

Torques are positive about +x by the right-hand rule, x running to the right: the near side of the shaft goes down.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import pi
from typing import Literal

from figures import dimensions as dims
from figures.canvas import Drawing, Piece
from figures.label import number, point, symbol
from figures.lines import axis, thin, thin_arrow
from figures.loads import TORQUE_HEIGHT, torque
from figures.members import WALL, bar, bore, fixed_end
from figures.picture import Picture, Words
from figures.placing import GAP, Spot, place, spread, written

SPAN = 440.0
WIDTH = 572.0
THICKEST = 56.0
THINNEST = 16.0

Ends = Literal["left", "right", "both", "none"]


@dataclass(frozen=True, slots=True)
class Segment:
    """A stretch of one diameter; lengths in one unit, diameters in one unit."""

    length: float
    outer: float
    bore: float = 0.0
    text: str = ""  # its diameters, to stand above it


@dataclass(frozen=True, slots=True)
class Torque:
    """A torque; only its sense is drawn, and the name says it again by its sign (``+T1``, ``-T2``)."""

    x: float
    value: float
    name: str


@dataclass(frozen=True, slots=True)
class Dimension:
    """A length to show under the shaft, with its text and unit."""

    start: float
    end: float
    text: str


def draw(
    prefix: str,
    words: Words,
    segments: Sequence[Segment],
    torques: Sequence[Torque],
    fixed: Ends,
    dimensions: Sequence[Dimension] = (),
    ends: tuple[str, str] = ("", ""),
) -> Picture:
    """Draw a shaft.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        segments: From left to right, at least one.
        torques: At any places, measured from the left end.
        fixed: Which ends are built in.
        dimensions: Lengths to show below, in any order.
        ends: Names of the left and the right end.

    Raises:
        ValueError: There is no segment, a size is impossible, or something lies off the shaft.
    """
    _check(segments, torques, dimensions)
    length = sum(segment.length for segment in segments)
    scale = SPAN / length
    pieces: list[Piece] = [axis(-34, SPAN + 34)]
    pieces += _body(segments, scale)
    pieces += _walls(fixed)
    for one in torques:
        pieces += torque(complex(one.x * scale, 0), one.value > 0)
    low = -max(TORQUE_HEIGHT, WALL / 2) - 8
    lengths = [dims.Dimension(round(d.start * scale, 1), round(d.end * scale, 1), d.text) for d in dimensions]
    pieces += dims.level(lengths, low, low + 2, {})
    _name(pieces, segments, torques, ends, scale)
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def _check(segments: Sequence[Segment], torques: Sequence[Torque], dimensions: Sequence[Dimension]) -> None:
    if not segments:
        raise ValueError("a shaft has at least one segment")
    for segment in segments:
        if not (segment.length > 0 and segment.outer > segment.bore >= 0):
            raise ValueError(f"a segment {segment.length} long of {segment.outer} over {segment.bore} cannot be drawn")
    length = sum(segment.length for segment in segments)
    for x in (*(one.x for one in torques), *(end for one in dimensions for end in (one.start, one.end))):
        if not -1e-9 <= x / length <= 1 + 1e-9:
            raise ValueError(f"{x} lies off a shaft {length} long")


def _joints(segments: Sequence[Segment], scale: float) -> list[float]:
    return list(accumulate((segment.length * scale for segment in segments), initial=0.0))


def _thickness(segments: Sequence[Segment], diameter: float) -> float:
    return THICKEST * diameter / max(segment.outer for segment in segments)


def _body(segments: Sequence[Segment], scale: float) -> list[Piece]:
    pieces: list[Piece] = []
    for segment, (start, end) in zip(segments, pairwise(_joints(segments, scale)), strict=True):
        outer = max(_thickness(segments, segment.outer), THINNEST)
        pieces.append(bar(start, end, outer))
        if segment.bore > 0:
            pieces += bore(start, end, outer * segment.bore / segment.outer)
    return pieces


def _walls(fixed: Ends) -> tuple[Piece, ...]:
    left = fixed_end(0, pi) if fixed in ("left", "both") else ()
    right = fixed_end(SPAN, 0.0) if fixed in ("right", "both") else ()
    return (*left, *right)


def _name(
    pieces: list[Piece], segments: Sequence[Segment], torques: Sequence[Torque], ends: tuple[str, str], scale: float
) -> None:
    pieces += (*thin_arrow(SPAN + 34, SPAN + 46), *written(symbol("x", "thin"), SPAN + 46 + 8j, "middle"))
    pieces += _torque_names(torques, scale)
    for name, spots in zip(ends, _end_spots(), strict=True):
        pieces += place(point(name), spots, pieces) if name else ()
    stretches = zip(segments, pairwise(_joints(segments, scale)), strict=True)
    for segment, (start, end) in sorted(stretches, key=lambda one: -one[0].length):  # the long ones have room
        half = max(_thickness(segments, segment.outer), THINNEST) / 2
        targets = [complex(start + share * (end - start), half - 3) for share in (0.5, 0.7, 0.3, 0.85, 0.15)]
        pieces += (
            place(number(segment.text), _diameter_spots(start, end, half), pieces, *targets) if segment.text else ()
        )


def _end_spots() -> tuple[tuple[Spot, ...], tuple[Spot, ...]]:
    rises = (14j, 24j, -30j)
    left: tuple[Spot, ...] = tuple((-14 + rise, "end") for rise in rises)
    right: tuple[Spot, ...] = tuple((SPAN + aside + rise, "start") for rise in rises for aside in (14, 26))
    return left, right


def _torque_names(torques: Sequence[Torque], scale: float) -> list[Piece]:
    """The names in one row above the arcs; one that had to move aside keeps a thin line to its arc."""
    named = sorted((one for one in torques if one.name), key=lambda one: one.x)
    labels = [symbol(one.name, "load") for one in named]
    places = spread([one.x * scale for one in named], [label.width + 2 * GAP for label in labels])
    pieces: list[Piece] = []
    for one, label, x in zip(named, labels, places, strict=True):
        foot, top = complex(x, TORQUE_HEIGHT + 17), complex(one.x * scale, TORQUE_HEIGHT + 3)
        pieces += written(label, foot, "middle")
        if abs(x - one.x * scale) > 12:
            pieces.append(thin(top, complex(x, foot.imag + label.box(0, "start").bottom - 1)))
    return pieces


def _diameter_spots(start: float, end: float, half: float) -> tuple[Spot, ...]:
    above, below = (half + 8) * 1j, -(half + 20) * 1j
    shares = [start + share * (end - start) for share in (0.5, 0.4, 0.6)]
    return tuple((x + rise, "middle") for rise in (above, below) for x in shares)
