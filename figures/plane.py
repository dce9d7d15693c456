"""Plane geometry of the sheet: points as complex numbers, boxes, and what crosses what."""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterable
from dataclasses import dataclass

Point = complex
Segment = tuple[Point, Point]


def unit(angle: float) -> Point:
    """The unit vector at an angle (radians from x)."""
    return rect(1, angle)


def direction(start: Point, end: Point) -> float:
    """The angle (radians from x) of the way from ``start`` to ``end``."""
    return phase(end - start)


def left_of(start: Point, end: Point, offset: float, share: float = 0.5) -> Point:
    """The point ``offset`` to the left of the way from ``start`` to ``end``, at a share of its length."""
    return start + share * (end - start) + offset * 1j * unit(direction(start, end))


@dataclass(frozen=True, slots=True)
class Box:
    """An upright rectangle."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, points: Iterable[Point]) -> Box:
        """The smallest box that holds the points.

        Raises:
            ValueError: There are no points.
        """
        held = tuple(points)
        xs, ys = [point.real for point in held], [point.imag for point in held]
        return cls(min(xs), min(ys), max(xs), max(ys))

    @property
    def corners(self) -> tuple[Point, Point, Point, Point]:
        """The corners, counter-clockwise from the lower left one."""
        low, high = self.bottom * 1j, self.top * 1j
        return (self.left + low, self.right + low, self.right + high, self.left + high)

    def grown(self, margin: float) -> Box:
        """The box with a margin on every side."""
        return Box(self.left - margin, self.bottom - margin, self.right + margin, self.top + margin)

    def overlaps(self, other: Box) -> bool:
        """Whether the insides of the two boxes meet."""
        across = self.left < other.right and other.left < self.right
        return across and self.bottom < other.top and other.bottom < self.top

    def crossed_by(self, segment: Segment) -> bool:
        """Whether a segment runs through the inside of the box (clipped side by side, after Liang and Barsky)."""
        start, end = segment
        if max(start.real, end.real) <= self.left or min(start.real, end.real) >= self.right:
            return False
        if max(start.imag, end.imag) <= self.bottom or min(start.imag, end.imag) >= self.top:
            return False
        way = end - start
        first, last = 0.0, 1.0
        for offset, speed, low, high in (
            (start.real, way.real, self.left, self.right),
            (start.imag, way.imag, self.bottom, self.top),
        ):
            if abs(speed) < 1e-9:
                if not low < offset < high:
                    return False
                continue
            enters, leaves = sorted(((low - offset) / speed, (high - offset) / speed))
            first, last = max(first, enters), min(last, leaves)
        return first < last
