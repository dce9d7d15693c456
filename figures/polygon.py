"""Vector polygons: sides with heads at the nodes and a named vector beside each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import copysign, pi

from figures.canvas import Drawing, Piece
from figures.label import point, symbol
from figures.lines import vector
from figures.picture import Picture, Table
from figures.placing import Spot, place, written
from figures.plane import Point, direction, left_of, unit

RING = tuple(k * pi / 4 for k in (3, 2, 4, 1, 5, 0, 6, 7))  # where the letter of a node is tried


@dataclass(frozen=True, slots=True)
class Side:
    """One vector of the polygon; its name stands on the left of its way (+1) or on the right (-1)."""

    start: Point
    end: Point
    name: str
    aside: float = 1.0
    style: str = "pos"
    share: float = 0.5


def side(one: Side) -> tuple[Piece, ...]:
    """The vector with its head at the end node and its name, under an arrow, beside it."""
    arrow = vector(one.start, one.end, one.style)
    if not one.name:
        return arrow
    label = symbol(one.name, one.style, arrow=True)
    normal = copysign(1.0, one.aside) * 1j * unit(direction(one.start, one.end))
    # the near side of the label's room clears the line by 8
    box = label.box(0, "middle")
    reach = abs(normal.real) * label.width / 2 + (
        -normal.imag * box.bottom if normal.imag > 0 else -normal.imag * box.top
    )
    at = left_of(one.start, one.end, 0, one.share) + (8 + reach) * normal
    return (*arrow, *written(label, at, "middle"))


def polygon(sides: tuple[Side, ...]) -> tuple[Piece, ...]:
    """All sides of a polygon, in their order."""
    return tuple(mark for one in sides for mark in side(one))


def between(
    prefix: str,
    title: str,
    nodes: Mapping[str, Point],
    vectors: Sequence[tuple[str, str, str]],
    axes: Sequence[Piece],
    width: float,
) -> Picture:
    """Draw vectors between nodes, each with its name, as a student chose them.

    Args:
        prefix: The id of the figure on its page.
        title: What it shows.
        nodes: Letters of the nodes and where they are.
        vectors: Name, start and end of each vector; one with an unknown node is left out.
        axes: What is drawn under them.
        width: The least width of the view.
    """
    pieces: list[Piece] = [*axes]
    known = [(name, nodes[a], nodes[b]) for name, a, b in vectors if a in nodes and b in nodes and nodes[a] != nodes[b]]
    for _, start, end in known:
        pieces += vector(start, end)
    for name, at in nodes.items():
        spots: list[Spot] = [(at + far * unit(turn) - 6j, "middle") for far in (18, 24) for turn in RING]
        pieces += place(point(name), spots, pieces)
    for name, start, end in known:
        beside = [(off, share) for off in (18, -18, 26) for share in (0.5, 0.35, 0.65)]
        spots = [(left_of(start, end, off, share) - 5j, "middle") for off, share in beside]
        pieces += place(symbol(name, "pos"), spots, pieces)
    rows = tuple((name, f"{a} → {b}") for name, a, b in vectors)
    svg = Drawing(tuple(pieces)).to_svg(prefix, title, "; ".join(f"{n}: {way}" for n, way in rows), width)
    return Picture(svg, Table(("", ""), rows))
