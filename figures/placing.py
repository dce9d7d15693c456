"""Where labels stand: the first free place in the order of trial, with a leader as the last resort."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from figures.canvas import Line, Piece, Text
from figures.label import Anchor, Label
from figures.lines import head, leader
from figures.plane import Box, Point

Spot = tuple[Point, Anchor]

GAP = 2.0


def is_free(box: Box, pieces: Iterable[Piece]) -> bool:
    """Whether no line and no text comes into the box."""
    return not any(_meets(box, piece) for piece in pieces)


def _meets(box: Box, piece: Piece) -> bool:
    if isinstance(piece, Text):
        return box.overlaps(piece.box)
    return any(box.crossed_by(segment) for segment in piece.segments())


def place(
    label: Label, spots: Sequence[Spot], pieces: Sequence[Piece], target: Point | None = None
) -> tuple[Piece, ...]:
    """Set a label on the first free spot; where none is free, on a shelf with a leader to ``target``.

    Args:
        label: What to write.
        spots: Base-line points with anchors, best first; the first one is also the default target.
        pieces: What is drawn already.
        target: The point of the object a leader leads to.
    """
    for at, anchor in spots:
        if is_free(label.box(at, anchor).grown(GAP), pieces):
            return written(label, at, anchor)
    return _on_a_shelf(label, spots[0][0] if target is None else target, pieces)


def written(label: Label, at: Point, anchor: Anchor = "start") -> tuple[Piece, ...]:
    """A label as pieces: its text and, for a vector, the arrow above it."""
    text = Text(at, label, anchor)
    if not label.arrow:
        return (text,)
    middle = {"start": at + 6, "middle": at, "end": at - 6}[anchor] + 19j
    bar = (middle - 7 - 0.6j, middle + 3 - 0.6j, middle + 3 + 0.6j, middle - 7 + 0.6j)
    return (text, Line(f"h-{label.arrow}", bar, closed=True), head(middle + 8, 0, label.arrow, (5.0, 2.2)))


def _on_a_shelf(label: Label, target: Point, pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    texts = [piece for piece in pieces if isinstance(piece, Text)]
    for rise in range(24, 400, 8):
        for aside in (10, -10, 30, -30, 50, -50):
            start = target + aside + rise * 1j
            shelf = (start, start + (label.width if aside > 0 else -label.width))
            low = min(shelf, key=lambda end: end.real) + (1 - label.box(0, "start").bottom) * 1j
            if not is_free(label.box(low, "start").grown(GAP), pieces):
                continue
            marks = leader(target, shelf)
            if not any(_meets(text.box, mark) for text in texts for mark in marks):
                return (*marks, *written(label, low))
    raise ValueError(f"no room for the label {label.text}{label.index}")
