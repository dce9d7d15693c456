"""The RRR arm in space with its joint axes, coordinates, lengths and Denavit-Hartenberg frames (standard convention).

The first axis is vertical, the second and third are parallel and level; frames 2 and 3 stand at the elbow (domain
DH-15). The pose is always the same and not to scale. Positive q1 and q2 turn counter-clockwise about z0 and z1; q3
bends the last link down from the second.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, radians

from figures.canvas import Circle, Drawing, Line, Piece
from figures.joints import ground_line
from figures.label import Label, point, symbol
from figures.lines import axis, hidden
from figures.picture import Picture, Words
from figures.placing import Spot, place
from figures.plane import Point, direction, left_of, unit
from figures.space import Vector, X, Y, Z, arrow, cylinder, plus, seen, spatial_arc, turn

WIDTH = 572.0
_Q1, _Q2, _Q3 = radians(70), radians(48), radians(68)
_L1, _L2, _L3 = 150.0, 230.0, 215.0
_AXIS = 62.0  # the length of a frame's axes

_OUT = turn(X, Y, _Q1)  # the level direction of the arm
_LEVEL = turn(X, Y, _Q1 - pi / 2)  # the second and the third joint axis
_UPPER = turn(_OUT, Z, _Q2)
_LOWER = turn(_OUT, Z, _Q2 - _Q3)
_BASE: Vector = (0.0, 0.0, 0.0)
_SHOULDER = plus(_BASE, (_L1, Z))
_ELBOW = plus(_SHOULDER, (_L2, _UPPER))
_TOOL = plus(_ELBOW, (_L3, _LOWER))


@dataclass(frozen=True, slots=True)
class Names:
    """The names in the figure; an empty one is left out, with its arc."""

    coordinates: tuple[str, str, str] = ("q1", "q2", "q3")
    lengths: tuple[str, str, str] = ("L1", "L2", "L3")
    tool: str = "M"


def draw(prefix: str, words: Words, names: Names, frames: Sequence[int] = (0, 1, 2, 3)) -> Picture:
    """Draw the arm.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        names: Letters of the coordinates, the lengths and the tool point.
        frames: Which of the frames 0 to 3 are drawn, as their x and z (of frame 0 also y).

    Raises:
        ValueError: There is no such frame.
    """
    if not set(frames) <= {0, 1, 2, 3}:
        raise ValueError(f"the arm has frames 0 to 3, not {tuple(frames)}")
    pieces: list[Piece] = [*_axes(), *_arm()]
    pieces += _arcs(names)
    tips = [tip for number in sorted(set(frames)) for tip in _frame(number)]
    for start, along, length, _ in tips:
        pieces += arrow(start, along, length)
    _name(pieces, names, tips)
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


_Tip = tuple[Vector, Vector, float, str]


def _frame(number: int) -> tuple[_Tip, ...]:
    """Where the axes of a frame start, their directions, lengths and names."""
    match number:
        case 0:
            above = plus(_SHOULDER, (24.0, Z))
            return ((_BASE, X, 104.0, "x_0"), (_BASE, Y, 104.0, "y_0"), (above, Z, _AXIS, "z_0"))
        case 1:
            return ((_SHOULDER, _OUT, 104.0, "x_1"), (plus(_SHOULDER, (18.0, _LEVEL)), _LEVEL, _AXIS, "z_1"))
        case 2:
            return ((_ELBOW, _UPPER, 104.0, "x_2"), (plus(_ELBOW, (18.0, _LEVEL)), _LEVEL, _AXIS, "z_2"))
        case _:
            beyond = plus(_ELBOW, (18.0 + _AXIS, _LEVEL))  # z3 lies on z2
            return ((_TOOL, _LOWER, _AXIS, "x_3"), (beyond, _LEVEL, _AXIS / 3, "z_3"))


def _axes() -> tuple[Piece, ...]:
    lines = ((_BASE, Z, 0.0, _L1 + 60), (_SHOULDER, _LEVEL, -44.0, 44.0), (_ELBOW, _LEVEL, -44.0, 44.0))
    return tuple(axis(seen(plus(at, (low, along))), seen(plus(at, (high, along)))) for at, along, low, high in lines)


def _arm() -> tuple[Piece, ...]:
    base, shoulder, elbow, tool = map(seen, (_BASE, _SHOULDER, _ELBOW, _TOOL))
    return (
        *ground_line(base - 26 - 5j, base + 26 - 5j),
        *cylinder(plus(_BASE, (16.0, Z)), Z, 30.0, 13.0),
        Line("f-link", (seen(plus(_BASE, (31.0, Z))), shoulder)),
        Line("f-link", (elbow, tool)),
        *cylinder(_ELBOW, _LEVEL, 32.0, 12.0),
        Line("f-link", (shoulder, elbow)),
        *cylinder(_SHOULDER, _LEVEL, 32.0, 12.0),
        Circle("f-o", tool, 5.0),
    )


def _arcs(names: Names) -> list[Piece]:
    pieces: list[Piece] = []
    first, second, third = names.coordinates
    if first:
        pieces += (hidden(seen(_BASE), seen(plus(_BASE, (104.0, _OUT)))), *spatial_arc(_BASE, 78.0, X, Y, _Q1))
    if second:
        pieces += (_reference(_SHOULDER, _OUT), *spatial_arc(_SHOULDER, 74.0, _OUT, Z, _Q2))
    if third:
        lower = turn(_UPPER, turn(_OUT, Z, _Q2 + pi / 2), -pi / 2)
        pieces += (_reference(_ELBOW, _UPPER), *spatial_arc(_ELBOW, 74.0, _UPPER, lower, _Q3))
    return pieces


def _reference(at: Vector, along: Vector) -> Line:
    return hidden(seen(at), seen(plus(at, (98.0, along))))


def _name(pieces: list[Piece], names: Names, tips: Sequence[_Tip]) -> None:
    for start, along, length, name in tips:
        tip = seen(plus(start, (length, along)))
        pieces += place(symbol(name, "thin"), _beyond(tip, direction(seen(start), tip)), pieces, tip)
    for name, at in zip(names.coordinates, _arc_middles(), strict=True):
        pieces += place(symbol(name), _outside(*at), pieces, at[1]) if name else ()
    ends = ((_BASE, _SHOULDER), (_SHOULDER, _ELBOW), (_ELBOW, _TOOL))
    for name, (start, end) in zip(names.lengths, ends, strict=True):
        pieces += place(symbol(name), _along(symbol(name), seen(start), seen(end)), pieces) if name else ()
    pieces += place(point(names.tool), ((seen(_TOOL) + 9 + 6j, "start"),), pieces) if names.tool else ()


def _arc_middles() -> tuple[tuple[Point, Point], ...]:
    """For each coordinate the centre of its arc and the middle of it."""
    bent = turn(_OUT, Z, _Q2 - _Q3 / 2)
    middles = ((_BASE, turn(X, Y, _Q1 / 2), 78.0), (_SHOULDER, turn(_OUT, Z, _Q2 / 2), 74.0), (_ELBOW, bent, 74.0))
    return tuple((seen(at), seen(plus(at, (radius, along)))) for at, along, radius in middles)


def _beyond(tip: Point, angle: float) -> tuple[Spot, ...]:
    """Around a tip, beginning with its own direction."""
    turns = ((0.0, 20), (0.7, 20), (-0.7, 20), (1.4, 20), (-1.4, 20), (1.4, 25), (-1.4, 25))
    return tuple((tip + away * unit(angle + by) - 7j, "middle") for by, away in turns)


def _outside(centre: Point, middle: Point) -> tuple[Spot, ...]:
    """Outside an arc, inside it, and a little to either side."""
    angle = direction(centre, middle)
    offsets = (22 * unit(angle), 26 * unit(angle + 0.5), 26 * unit(angle - 0.5), -18 * unit(angle), 32 * unit(angle))
    return tuple((middle + by - 7j, "middle") for by in offsets)


def _along(label: Label, start: Point, end: Point) -> tuple[Spot, ...]:
    """Beside a link, the left side first."""
    aside = 12 + label.width / 2
    return tuple(
        (left_of(start, end, way * aside, share) - 7j, "middle") for share in (0.5, 0.4, 0.6) for way in (1, -1)
    )
