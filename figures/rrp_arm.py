"""The RRP arm in space: a vertical axis, a level one, and a slide at a right angle to it (domain DH-13).

The pose is not to scale; it depends only on how the second coordinate is measured, so that its arc is easy to see. The
tool point M stands beside the end of the slide, at a right angle to the plane in which the slide swings.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, radians
from typing import Literal

from figures.canvas import Circle, Drawing, Line, Piece
from figures.joints import ground_line
from figures.label import point, symbol
from figures.lines import axis, hidden, thin
from figures.picture import Picture, Words
from figures.placing import Spot, place
from figures.plane import Point, direction, unit
from figures.space import Vector, X, Y, Z, arrow, cylinder, plus, seen, sleeve, spatial_arc, turn

Measure = Literal["down", "up", "level_up", "level_down"]
Side = Literal["left", "right"]

WIDTH = 560.0
_Q1 = radians(74)
_RISE = {"down": radians(-22), "up": radians(6), "level_up": radians(58), "level_down": radians(-28)}
_L1, _Q3, _D = 225.0, 270.0, 88.0
_AXIS = 62.0
_BESIDE = 30.0  # of the dimension of the slide from its line

_OUT = turn(X, Y, _Q1)  # the level direction of the arm
_RIGHT = turn(X, Y, _Q1 - pi / 2)  # the second joint axis, to the right of one who looks along the arm
_DOWN: Vector = (0.0, 0.0, -1.0)
_BASE: Vector = (0.0, 0.0, 0.0)
_SHOULDER = plus(_BASE, (_L1, Z))


@dataclass(frozen=True, slots=True)
class Names:
    """The names in the figure; an empty one is left out, with its arc or dimension."""

    coordinates: tuple[str, str, str] = ("q1", "q2", "q3")
    lengths: tuple[str, str] = ("L1", "d")
    tool: str = "M"


@dataclass(frozen=True, slots=True)
class _Arm:
    """The places of a pose."""

    measure: Measure
    side: Side

    @property
    def along(self) -> Vector:
        """The direction of the slide."""
        return turn(_OUT, Z, _RISE[self.measure])

    @property
    def across(self) -> Vector:
        """The direction from the slide to the tool point."""
        return _RIGHT if self.side == "right" else plus(_BASE, (-1, _RIGHT))

    @property
    def end(self) -> Vector:
        return plus(_SHOULDER, (_Q3, self.along))

    @property
    def tool(self) -> Vector:
        return plus(self.end, (_D, self.across))

    @property
    def zero(self) -> Vector:
        """The direction from which the second coordinate is measured."""
        return {"down": _DOWN, "up": Z}.get(self.measure, _OUT)

    @property
    def turned(self) -> float:
        """The second coordinate in the pose, radians."""
        rise = _RISE[self.measure]
        return {"down": rise + pi / 2, "up": pi / 2 - rise, "level_up": rise, "level_down": -rise}[self.measure]

    @property
    def towards(self) -> Vector:
        """The direction that the second coordinate reaches after a quarter of a turn."""
        return {"level_up": Z, "level_down": _DOWN}.get(self.measure, _OUT)


def draw(prefix: str, words: Words, measure: Measure, side: Side, names: Names | None = None) -> Picture:
    """Draw the arm with frame 0 and the z axis of frame 3.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        measure: From where and in which sense the second coordinate is measured: from the vertical down or up towards
            the arm, or from the level up or down.
        side: On which side of the slide the tool point stands, for one who looks along the arm.
        names: Letters of the coordinates, the lengths and the tool point.
    """
    arm, names = _Arm(measure, side), names or Names()
    pieces: list[Piece] = [*_axes(arm), *_bodies(arm), *_arcs(arm, names)]
    tips = _tips(arm)
    for start, along, length, _ in tips:
        pieces += arrow(start, along, length)
    _name(pieces, arm, names, tips)
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


_Tip = tuple[Vector, Vector, float, str]


def _tips(arm: _Arm) -> tuple[_Tip, ...]:
    """Where the printed axes start, their directions, lengths and names."""
    above = plus(_SHOULDER, (28.0, Z))
    return (
        (_BASE, X, 112.0, "x_0"),
        (_BASE, Y, 112.0, "y_0"),
        (above, Z, _AXIS, "z_0"),
        (arm.tool, arm.across, _AXIS, "z_3"),
    )


def _axes(arm: _Arm) -> tuple[Piece, ...]:
    lines = (
        (_BASE, Z, 0.0, _L1 + 70),
        (_SHOULDER, _RIGHT, -52.0, 52.0),
        (_SHOULDER, arm.along, -30.0, _Q3 + 34),
    )
    return tuple(axis(seen(plus(at, (low, along))), seen(plus(at, (high, along)))) for at, along, low, high in lines)


def _bodies(arm: _Arm) -> tuple[Piece, ...]:
    base, end, tool = map(seen, (_BASE, arm.end, arm.tool))
    guide, behind = plus(_SHOULDER, (128.0, arm.along)), plus(_SHOULDER, (98.0, arm.along))
    return (
        *ground_line(base - 26 - 5j, base + 26 - 5j),
        *cylinder(plus(_BASE, (16.0, Z)), Z, 30.0, 13.0),
        Line("f-link", (seen(plus(_BASE, (31.0, Z))), seen(_SHOULDER))),
        *cylinder(_SHOULDER, _RIGHT, 34.0, 13.0),
        Line("f-link", (seen(plus(_SHOULDER, (13.0, arm.along))), seen(behind))),
        *sleeve(guide, arm.along, _RIGHT, 60.0, 24.0),
        Line("f-link", (seen(plus(_SHOULDER, (158.0, arm.along))), end, tool)),
        Circle("f-o", tool, 5.0),
    )


def _arcs(arm: _Arm, names: Names) -> list[Piece]:
    pieces: list[Piece] = []
    first, second, third = names.coordinates
    if first:
        pieces += (hidden(seen(_BASE), seen(plus(_BASE, (112.0, _OUT)))), *spatial_arc(_BASE, 84.0, X, Y, _Q1))
    if second:
        pieces += (
            hidden(seen(_SHOULDER), seen(plus(_SHOULDER, (104.0, arm.zero)))),
            *spatial_arc(_SHOULDER, 84.0, arm.zero, arm.towards, arm.turned),
        )
    if third:
        pieces += _dimension(arm)
    return pieces


def _dimension(arm: _Arm) -> tuple[Piece, ...]:
    """The way of the slide from the second joint axis, beside it."""
    over = (seen(plus(at, (_BESIDE + 6, _beside(arm)))) for at in (_SHOULDER, arm.end))
    lines = tuple(thin(seen(at), tip) for at, tip in zip((_SHOULDER, arm.end), over, strict=True))
    return (*lines, *arrow(*_way(arm)))


def _way(arm: _Arm) -> tuple[Vector, Vector, float]:
    return plus(_SHOULDER, (_BESIDE, _beside(arm))), arm.along, _Q3


def _beside(arm: _Arm) -> Vector:
    """At a right angle to the slide in the plane of the arm, away from the arc of the second coordinate."""
    above = arm.measure in ("down", "level_up")
    return turn(_OUT, Z, _RISE[arm.measure] + (pi / 2 if above else -pi / 2))


def _name(pieces: list[Piece], arm: _Arm, names: Names, tips: Sequence[_Tip]) -> None:
    for start, along, length, name in tips:
        tip = seen(plus(start, (length, along)))
        pieces += place(symbol(name, "thin"), _around(tip, direction(seen(start), tip), 20), pieces, tip)
    for name, (centre, middle) in zip(names.coordinates, _middles(arm), strict=True):
        spots = _around(middle, direction(centre, middle), 20)
        pieces += place(symbol(name), spots, pieces, middle) if name else ()
    ends = ((_BASE, _SHOULDER), (arm.end, arm.tool))
    for name, (start, end) in zip(names.lengths, ends, strict=True):
        middle = (seen(start) + seen(end)) / 2
        pieces += (
            place(symbol(name), _around(middle, direction(seen(start), seen(end)) + pi / 2, 16), pieces) if name else ()
        )
    tool = seen(arm.tool)
    pieces += place(point(names.tool), _around(tool, -pi / 2, 18), pieces, tool) if names.tool else ()


def _middles(arm: _Arm) -> tuple[tuple[Point, Point], ...]:
    """For the two arcs their centres and middles; for the slide a point of it and the middle of its dimension."""
    half = turn(arm.zero, arm.towards, arm.turned / 2)
    along = plus(_SHOULDER, (0.6 * _Q3, arm.along))
    return (
        (seen(_BASE), seen(plus(_BASE, (84.0, turn(X, Y, _Q1 / 2))))),
        (seen(_SHOULDER), seen(plus(_SHOULDER, (84.0, half)))),
        (seen(along), seen(plus(along, (_BESIDE, _beside(arm))))),
    )


def _around(at: Point, angle: float, away: float) -> tuple[Spot, ...]:
    """Around a point, beginning in a direction."""
    turns = ((0.0, 0), (0.6, 0), (-0.6, 0), (1.2, 0), (-1.2, 0), (0.0, 8), (pi, 0), (1.9, 4), (-1.9, 4), (0.9, 10))
    return tuple((at + (away + more) * unit(angle + by) - 7j, "middle") for by, more in turns)
