"""A beam with its supports, loads and dimensions, drawn in the true scale of its length.

Forces and distributed loads are positive upwards, couples counter-clockwise; lengths are in one unit of the caller's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import Literal, assert_never

from figures import dimensions as dims
from figures.canvas import Drawing, Piece
from figures.label import point, symbol
from figures.loads import COUPLE_RADIUS, arrow_length, couple, distributed, force
from figures.members import BEAM_DEPTH, bar, fixed_end, pin_support, roller_support
from figures.picture import Picture, Words
from figures.placing import Spot, place
from figures.plane import Point

SPAN = 470.0
WIDTH = 572.0
LOAD_HEIGHT = 30.0
_TOP, _UNDER = BEAM_DEPTH / 2 + 1, -BEAM_DEPTH / 2
_STOREY = LOAD_HEIGHT + 8  # from one distributed load to the next above it


@dataclass(frozen=True, slots=True)
class Support:
    """A support and the name of its point."""

    x: float
    kind: Literal["pin", "roller", "fixed"]
    name: str = ""


@dataclass(frozen=True, slots=True)
class Mark:
    """A named point of the beam without a support."""

    x: float
    name: str


@dataclass(frozen=True, slots=True)
class Force:
    """A point force; its arrow is drawn in proportion to its size."""

    x: float
    value: float
    name: str


@dataclass(frozen=True, slots=True)
class Distributed:
    """A load that runs linearly from ``first`` at ``start`` to ``last`` at ``end``; uniform when they are equal."""

    start: float
    end: float
    first: float
    last: float
    name: str


@dataclass(frozen=True, slots=True)
class Couple:
    """A couple; only its sense is drawn."""

    x: float
    value: float
    name: str


@dataclass(frozen=True, slots=True)
class Dimension:
    """A length to show under the beam, with its text and unit."""

    start: float
    end: float
    text: str


Load = Force | Distributed | Couple


def draw(
    prefix: str,
    words: Words,
    length: float,
    supports: Sequence[Support],
    loads: Sequence[Load],
    dimensions: Sequence[Dimension] = (),
    marks: Sequence[Mark] = (),
) -> Picture:
    """Draw a beam.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        length: The length of the beam, positive.
        supports: At any places; a fixed one at an end of the beam.
        loads: At any places; those of one kind may overlap.
        dimensions: Lengths to show below, in any order.
        marks: Further named points.

    Raises:
        ValueError: The length is not positive, something lies off the beam, or a fixed support is not at an end.
    """
    _check(length, supports, loads, dimensions, marks)
    scale = SPAN / length
    storeys = _storeys(loads)
    pieces: list[Piece] = [bar(0, SPAN)]
    for support in supports:
        pieces += _support(support, length, scale)
    for load in loads:
        pieces += _load(load, loads, storeys, scale)
    low = min(_lowest(supports), -14.0)
    lengths = [dims.Dimension(round(d.start * scale, 1), round(d.end * scale, 1), d.text) for d in dimensions]
    pieces += dims.level(lengths, low, _UNDER - 7, {round(s.x * scale, 1): low - 2 for s in supports})
    _name(pieces, supports, loads, marks, storeys, scale)
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def _check(
    length: float,
    supports: Sequence[Support],
    loads: Sequence[Load],
    dimensions: Sequence[Dimension],
    marks: Sequence[Mark],
) -> None:
    if not length > 0:
        raise ValueError(f"a beam {length} long cannot be drawn")
    places = [*(support.x for support in supports), *(mark.x for mark in marks)]
    places += [end for one in dimensions for end in (one.start, one.end)]
    places += [x for load in loads for x in _reach(load)]
    for x in places:
        if not -1e-9 <= x / length <= 1 + 1e-9:
            raise ValueError(f"{x} lies off a beam {length} long")
    for support in supports:
        if support.kind == "fixed" and min(support.x, length - support.x) > 1e-9 * length:
            raise ValueError(f"a fixed support at {support.x} is not at an end of the beam")


def _reach(load: Load) -> tuple[float, ...]:
    return (load.start, load.end) if isinstance(load, Distributed) else (load.x,)


def _support(support: Support, length: float, scale: float) -> tuple[Piece, ...]:
    at = complex(support.x * scale, _UNDER)
    if support.kind == "pin":
        return pin_support(at)
    if support.kind == "roller":
        return roller_support(at)
    return fixed_end(complex(at.real, 0), pi if support.x < length / 2 else 0.0)


def _storeys(loads: Sequence[Load]) -> dict[Distributed, int]:
    """Overlapping distributed loads stand above one another."""
    storeys: dict[Distributed, int] = {}
    for load in loads:
        if isinstance(load, Distributed):
            below = [storeys[o] for o in storeys if o.start < load.end and load.start < o.end]
            storeys[load] = next(level for level in range(len(loads)) if level not in below)
    return storeys


def _roof(x: float, storeys: dict[Distributed, int]) -> float:
    """The height of what is distributed over a place."""
    return max(
        (_TOP + level * _STOREY + LOAD_HEIGHT for d, level in storeys.items() if d.start <= x <= d.end), default=_TOP
    )


def _load(load: Load, loads: Sequence[Load], storeys: dict[Distributed, int], scale: float) -> tuple[Piece, ...]:
    match load:
        case Force():
            return force(complex(load.x * scale, _TOP), _force_height(load, loads, storeys), load.value < 0)
        case Distributed():
            return _spread(load, storeys[load], scale)
        case Couple():
            return couple(complex(load.x * scale, 0), load.value > 0, _couple_radius(load, storeys))
    assert_never(load)


def _force_height(load: Force, loads: Sequence[Load], storeys: dict[Distributed, int]) -> float:
    largest = max(abs(other.value) for other in loads if isinstance(other, Force))
    return max(arrow_length(load.value, largest), _roof(load.x, storeys) - _TOP + 24)


def _couple_radius(load: Couple, storeys: dict[Distributed, int]) -> float:
    return max(COUPLE_RADIUS, _roof(load.x, storeys) + 14)


def _spread(load: Distributed, storey: int, scale: float) -> tuple[Piece, ...]:
    foot, largest = complex(0, _TOP + storey * _STOREY), max(abs(load.first), abs(load.last))
    first, last = (-LOAD_HEIGHT * value / largest for value in (load.first, load.last))
    return distributed(foot + load.start * scale, foot + load.end * scale, first, last)


def _lowest(supports: Sequence[Support]) -> float:
    depths = {"pin": _UNDER - 32.0, "roller": _UNDER - 36.0, "fixed": -52.0}
    return min((depths[support.kind] for support in supports), default=_UNDER)


def _name(
    pieces: list[Piece],
    supports: Sequence[Support],
    loads: Sequence[Load],
    marks: Sequence[Mark],
    storeys: dict[Distributed, int],
    scale: float,
) -> None:
    for support in supports:
        pieces += (
            place(point(support.name), _beside(support, scale), pieces, complex(support.x * scale, 0))
            if support.name
            else ()
        )
    for mark in marks:
        pieces += place(point(mark.name), _near(mark.x * scale), pieces, complex(mark.x * scale, 0))
    for load in loads:
        if load.name:
            target, spots = _load_spots(load, loads, storeys, scale)
            pieces += place(symbol(load.name, "load"), spots, pieces, target)


def _beside(support: Support, scale: float) -> tuple[Spot, ...]:
    """The outer side of a support at an end, else one side of its triangle."""
    x = support.x * scale
    off = 16 if support.kind == "fixed" else 12
    outer: tuple[Spot, ...] = ()
    if x < 1:
        outer = ((x - off - 8j, "end"),)
    elif x > SPAN - 1:
        outer = ((x + off - 8j, "start"),)
    low = -27j if support.kind != "fixed" else -66j
    return (*outer, (x - 26 + low, "end"), (x + 26 + low, "start"))


def _near(x: float) -> tuple[Spot, ...]:
    """Beyond a free end, else below the beam and above it."""
    if x < 1:
        return ((x - 8 - 8j, "end"), (x - 26j, "middle"))
    if x > SPAN - 1:
        return ((x + 8 - 8j, "start"), (x - 26j, "middle"))
    return (
        (x - 28j, "middle"),
        (x + 5 - 28j, "start"),
        (x - 5 - 28j, "end"),
        (x + 5 + 14j, "start"),
        (x - 5 + 14j, "end"),
    )


def _load_spots(
    load: Load, loads: Sequence[Load], storeys: dict[Distributed, int], scale: float
) -> tuple[Point, tuple[Spot, ...]]:
    match load:
        case Force():
            top = complex(load.x * scale, _TOP + _force_height(load, loads, storeys))
            return top - 8j, ((top + 8 - 16j, "start"), (top - 8 - 16j, "end"), (top + 12j, "middle"))
        case Couple():
            return _couple_spots(load.x * scale, _couple_radius(load, storeys))
        case Distributed():
            line = _spread(load, storeys[load], scale)[0].segments()[0]
            return _along(*line)
    assert_never(load)


def _couple_spots(x: float, radius: float) -> tuple[Point, tuple[Spot, ...]]:
    side, low, top = 0.62 * radius + 8, 0.79 * radius - 8, complex(x, radius)
    return top, ((top + 12j, "middle"), (complex(x + side, low), "start"), (complex(x - side, low), "end"))


def _along(start: Point, end: Point) -> tuple[Point, tuple[Spot, ...]]:
    shares = (0.5, 0.25, 0.75, 0.12, 0.88, 0.38, 0.62)
    spots: list[Spot] = [(start + share * (end - start) + 12j, "middle") for share in shares]
    return (start + end) / 2, tuple(spots)
