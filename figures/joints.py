"""Joints of planar schemes: revolute, its ground, the prismatic slider with its guide, the gripper."""

from __future__ import annotations

from math import pi

from figures.canvas import Circle, Line, Piece
from figures.lines import hatch
from figures.plane import Point, unit

PIN_RADIUS = 5.0


def revolute(at: Point, double: bool = False) -> tuple[Piece, ...]:
    """A revolute joint, drawn after the links it joins; a double joint has a second circle around it."""
    pin = Circle("f-o", at, PIN_RADIUS)
    return (Circle("f-o", at, 8.0), pin) if double else (pin,)


def ground(at: Point, angle: float = 0.0) -> tuple[Piece, ...]:
    """The frame under a revolute joint: a triangle on a hatched base.

    Args:
        at: The centre of the joint.
        angle: The direction of the base, radians; the frame lies on its right.
    """
    along, down = unit(angle), unit(angle - pi / 2)
    base = at + 22 * down
    triangle = Line("f-o", (at, base - 13 * along, base + 13 * along), closed=True)
    return (triangle, *ground_line(base - 22 * along, base + 22 * along))


def ground_line(start: Point, end: Point) -> tuple[Piece, ...]:
    """A line of the frame, hatched on the right of the way from ``start`` to ``end``."""
    return (Line("f-thick", (start, end)), hatch(start, end))


def slider(at: Point, angle: float = 0.0, width: float = 52.0, height: float = 30.0) -> Line:
    """The block of a prismatic joint, its pin on the guide axis."""
    along, across = width / 2 * unit(angle), height / 2 * unit(angle + pi / 2)
    return Line("f-body", (at - along - across, at + along - across, at + along + across, at - along + across), True)


def gripper(at: Point, angle: float) -> Line:
    """An open fork at the end of a rod that runs along ``angle``."""
    along, across = unit(angle), unit(angle + pi / 2)
    return Line(
        "f-thick", (at + 12 * along + 9 * across, at + 9 * across, at - 9 * across, at + 12 * along - 9 * across)
    )
