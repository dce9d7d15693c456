"""Where labels stand: the first free place in the order of trial, with a leader as the last resort."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from figures.canvas import Line, Piece, Text
from figures.label import Anchor, Label
from figures.lines import head, leader
from figures.plane import Box, Point, Segment

Spot = tuple[Point, Anchor]

GAP = 2.0


@dataclass(frozen=True, slots=True)
class _Taken:
    """What is on the sheet: the rooms of its texts and its lines."""

    texts: tuple[Box, ...]
    lines: tuple[Segment, ...]

    def leaves(self, box: Box) -> bool:
        if any(box.overlaps(text) for text in self.texts):
            return False
        return not any(box.crossed_by(line) for line in self.lines)

    def lets(self, way: Segment) -> bool:
        return not any(text.crossed_by(way) for text in self.texts)


def _taken(pieces: Iterable[Piece]) -> _Taken:
    held = tuple(pieces)
    texts = tuple(piece.box for piece in held if isinstance(piece, Text))
    return _Taken(texts, tuple(line for piece in held if not isinstance(piece, Text) for line in piece.segments()))


def is_free(box: Box, pieces: Iterable[Piece]) -> bool:
    """Whether no line and no text comes into the box."""
    return _taken(pieces).leaves(box)


def place(label: Label, spots: Sequence[Spot], pieces: Iterable[Piece], *targets: Point) -> tuple[Piece, ...]:
    """Set a label on the first free spot; where none is free, on a shelf with a leader to the object.

    Args:
        label: What to write.
        spots: Base-line points with anchors, best first.
        pieces: What is drawn already.
        targets: Points of the object a leader may lead to, best first; the first spot when there are none.

    Raises:
        ValueError: No shelf is free either.
    """
    taken = _taken(pieces)
    for at, anchor in spots:
        if taken.leaves(label.box(at, anchor).grown(GAP)):
            return written(label, at, anchor)
    return _on_a_shelf(label, targets or (spots[0][0],), taken)


def written(label: Label, at: Point, anchor: Anchor = "start") -> tuple[Piece, ...]:
    """A label as pieces: its text and, for a vector, the arrow above it."""
    text = Text(at, label, anchor)
    if not label.arrow:
        return (text,)
    middle = {"start": at + 6, "middle": at, "end": at - 6}[anchor] + 19j
    bar = (middle - 7 - 0.6j, middle + 3 - 0.6j, middle + 3 + 0.6j, middle - 7 + 0.6j)
    return (text, Line(f"h-{label.arrow}", bar, closed=True), head(middle + 8, 0, label.arrow, (5.0, 2.2)))


def _on_a_shelf(label: Label, targets: Sequence[Point], taken: _Taken) -> tuple[Piece, ...]:
    lift = (1 - label.box(0, "start").bottom) * 1j
    crossing: tuple[Piece, ...] = ()
    for target, shelf in _shelves(label, targets):
        low = min(shelf, key=lambda end: end.real) + lift
        if not taken.leaves(label.box(low, "start").grown(GAP)):
            continue
        marks = (*leader(target, shelf), *written(label, low))
        if taken.lets((target, shelf[0])) and taken.lets(shelf):
            return marks
        crossing = crossing or marks  # a leader over a text is better than no label
    if not crossing:
        raise ValueError(f"no room for the label {label.text}{label.index}")
    return crossing


def _shelves(label: Label, targets: Sequence[Point]) -> Iterator[tuple[Point, Segment]]:
    """Shelves above the targets with the leader joining them at their start, the nearest and steepest first."""
    asides = (0, 10, -10, 30, -30, 50, -50, 80, -80, 120, -120, 160, -160)
    moves = [complex(aside, rise) for rise in range(24, 400, 8) for aside in asides]
    for move in sorted(moves, key=lambda move: 1.5 * abs(move.real) + move.imag):
        for target in targets:
            start = target + move
            yield target, (start, start + (label.width if move.real >= 0 else -label.width))


def spread(wanted: Sequence[float], widths: Sequence[float]) -> list[float]:
    """Move the middles of things in a row as little as keeps them apart.

    Args:
        wanted: Where the middles would like to be, in ascending order.
        widths: How wide each thing is.

    Source:
        Pool adjacent violators: neighbours that would overlap become a block about the mean of their wishes.
    """
    blocks: list[tuple[float, float, list[int]]] = []  # start, width, members
    for at, (middle, width) in enumerate(zip(wanted, widths, strict=True)):
        blocks.append((middle - width / 2, width, [at]))
        while len(blocks) > 1 and blocks[-2][0] + blocks[-2][1] > blocks[-1][0]:
            (_, one, members), (_, other, more) = blocks[-2:]
            blocks[-2:] = [_block([*members, *more], one + other, wanted, widths)]
    starts = [(start, member, members) for start, _, members in blocks for member in members]
    return [start + sum(widths[m] for m in group if m < at) + widths[at] / 2 for start, at, group in starts]


def _block(
    members: list[int], width: float, wanted: Sequence[float], widths: Sequence[float]
) -> tuple[float, float, list[int]]:
    before = [sum(widths[m] for m in members if m < member) + widths[member] / 2 for member in members]
    start = sum(wanted[member] - offset for member, offset in zip(members, before, strict=True)) / len(members)
    return (start, width, members)
