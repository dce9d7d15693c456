"""Loads: force, distributed load, couple, torque on a shaft. Each has a head as well as its colour."""

from __future__ import annotations

from math import ceil, copysign, pi, radians

from figures.canvas import Line, Piece
from figures.lines import arc, thin_arrow, vector
from figures.plane import Point

LONGEST, SHORTEST = 80.0, 40.0
COUPLE_RADIUS = 52.0
TORQUE_HEIGHT = 48.0
_HALF_COUPLE = radians(38)


def arrow_length(value: float, largest: float) -> float:
    """The length of a force arrow: in proportion to the largest force, never too short to see."""
    return max(SHORTEST, LONGEST * abs(value) / largest) if largest > 0 else LONGEST


def force(at: Point, length: float, down: bool) -> tuple[Piece, ...]:
    """A force above a point of a level member: its tip on the member when it presses, its tail when it pulls."""
    far = at + length * 1j
    return vector(far, at, "load") if down else vector(at, far, "load")


def distributed(start: Point, end: Point, first: float, last: float) -> tuple[Piece, ...]:
    """A distributed load: thin arrows under a line whose height follows q(x).

    Args:
        start: Where it begins on the member.
        end: Where it ends.
        first: The height of the line at the start, user units, negative for a load that acts upwards.
        last: The same at the end.
    """
    count = max(2, ceil(abs(end - start) / 30))
    line = Line("f-loadthin", (start + abs(first) * 1j, end + abs(last) * 1j))
    marks: list[Piece] = [line]
    for i in range(count + 1):
        share = i / count
        foot, height = start + (end - start) * share, first + (last - first) * share
        if abs(height) >= 12:
            far = foot + abs(height) * 1j
            marks += (
                thin_arrow(far, foot, "load", "f-loadthin")
                if height > 0
                else thin_arrow(foot, far, "load", "f-loadthin")
            )
    return tuple(marks)


def couple(at: Point, counter_clockwise: bool, radius: float = COUPLE_RADIUS) -> tuple[Piece, ...]:
    """A couple on a member: an arc of 76 degrees above the point, its head the sense."""
    turn = copysign(_HALF_COUPLE, 1 if counter_clockwise else -1)
    return arc(at, radius, pi / 2 - turn, pi / 2 + turn, "load")


def torque(at: Point, positive: bool, height: float = TORQUE_HEIGHT) -> tuple[Piece, ...]:
    """A torque: the near half of an arc around a level shaft, with a head.

    Args:
        at: The point of the axis.
        positive: Whether the torque turns about +x by the right-hand rule, so that the near side goes down.
        height: The upright radius of the arc.
    """
    return turn_mark(at, positive, height, "load")


def turn_mark(at: Point, positive: bool, height: float, style: str = "vel") -> tuple[Piece, ...]:
    """The sense of rotation of a level shaft, drawn as a torque is."""
    reach = radians(95) if positive else radians(-95)
    return arc(at, 15.0, reach, -reach, style, height)
