"""Dimension lines below a drawing: nearest first, texts never over one another or over a line."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import pi

from figures.canvas import Piece, Text
from figures.label import number
from figures.lines import SMALL_HEAD, head, thin
from figures.placing import GAP

ROW = 24.0  # the figures of a narrow screen, larger than those of a wide one, clear the line above them
RISE = 5.0  # of the base line above the line
PAST = 5.0  # extension lines beyond the line


@dataclass(frozen=True, slots=True)
class Dimension:
    """A length to be shown: from one abscissa to another, user units, with its text and unit."""

    start: float
    end: float
    text: str


@dataclass(frozen=True, slots=True)
class _Set:
    """A dimension with its row (0 is nearest) and the abscissa of the middle of its text."""

    dimension: Dimension
    row: int
    text_at: float


def level(dimensions: Iterable[Dimension], top: float, foot: float, held: Mapping[float, float]) -> tuple[Piece, ...]:
    """Draw horizontal dimensions in rows below a drawing.

    Args:
        dimensions: What to show, in any order.
        top: The ordinate above which nothing of them may stand.
        foot: The ordinate where extension lines begin.
        held: For some abscissas, another ordinate where theirs begin.
    """
    ordered = sorted(dimensions, key=lambda d: (abs(d.end - d.start), d.start))
    placed = _arranged(tuple(Dimension(min(d.start, d.end), max(d.start, d.end), d.text) for d in ordered))
    marks: list[Piece] = []
    for one in placed:
        marks += _drawn(one, top - ROW - one.row * ROW)
    return (*_extensions(placed, top, {**dict.fromkeys(_ends(placed), foot), **held}), *marks)


def _arranged(dimensions: Sequence[Dimension]) -> list[_Set]:
    """Give every dimension the nearest row in which it and its text are free; a crowded one moves out a row."""
    rows = [0] * len(dimensions)
    while True:
        _spread(dimensions, rows)
        placed: list[_Set] = []
        for at, dimension in enumerate(dimensions):
            middle = _free_text(at, dimensions, rows, placed)
            if middle is None:
                rows[at] += 1
                break
            placed.append(_Set(dimension, rows[at], middle))
        else:
            return placed


def _spread(dimensions: Sequence[Dimension], rows: list[int]) -> None:
    for at, one in enumerate(dimensions):
        while any(rows[at] == rows[i] and _overlap(one, dimensions[i]) for i in range(at)):
            rows[at] += 1


def _overlap(one: Dimension, other: Dimension) -> bool:
    return one.start < other.end - 1e-6 and other.start < one.end - 1e-6


def _free_text(at: int, dimensions: Sequence[Dimension], rows: Sequence[int], placed: Sequence[_Set]) -> float | None:
    """Where the text of a dimension stands: inside, aside of the middle, outside; None where all is taken."""
    own, half = dimensions[at], number(dimensions[at].text).width / 2 + GAP
    beyond = [d for d, row in zip(dimensions, rows, strict=True) if row >= rows[at] - 1]
    lines = [x for d in beyond for x in (d.start, d.end)]
    spans = [d for i, d in enumerate(dimensions) if rows[i] == rows[at] and i != at]
    taken = [(p.text_at, number(p.dimension.text).width / 2 + GAP) for p in placed if p.row == rows[at]]
    heads = [end for i, d in enumerate(dimensions) if rows[i] == rows[at] - 1 for end in _heads(d)]
    for middle in _trials(own, half, max(lines), min(lines)):
        span = Dimension(min(middle - half, own.start), max(middle + half, own.end), "")
        room = Dimension(middle - half, middle + half, "")
        if any(room.start < x < room.end for x in lines) or any(_overlap(room, head) for head in heads):
            continue
        if any(_overlap(span, other) for other in spans):
            continue
        if all(abs(middle - other) >= half + width for other, width in taken):
            return middle
    return None


def _is_small(one: Dimension) -> bool:
    return one.end - one.start < 2.5 * SMALL_HEAD[0]


def _heads(one: Dimension) -> tuple[Dimension, Dimension]:
    """Where the heads of a dimension lie: inside it, outside a small one. They reach down into the next row."""
    inward = -SMALL_HEAD[0] if _is_small(one) else SMALL_HEAD[0]
    starts, ends = sorted((one.start, one.start + inward)), sorted((one.end - inward, one.end))
    return Dimension(starts[0], starts[1], ""), Dimension(ends[0], ends[1], "")


def _trials(own: Dimension, half: float, right: float, left: float) -> tuple[float, ...]:
    middle, width = (own.start + own.end) / 2, own.end - own.start
    inside = tuple(middle + share * width for share in (0, -0.25, 0.25, -0.35, 0.35)) if 2 * half <= width else ()
    return (*inside, own.end + half + 10, own.start - half - 10, right + half + 10, left - half - 10)


def _drawn(one: _Set, y: float) -> tuple[Piece, ...]:
    start, end = complex(one.dimension.start, y), complex(one.dimension.end, y)
    label = number(one.dimension.text)
    text = Text(complex(one.text_at, y + RISE), label, "middle")
    reach = (one.text_at - label.width / 2, one.text_at + label.width / 2)
    if not _is_small(one.dimension):
        line = thin(complex(min(reach[0], start.real), y), complex(max(reach[1], end.real), y))
        return (line, head(start, pi, "thin", SMALL_HEAD), head(end, 0, "thin", SMALL_HEAD), text)
    line = thin(complex(min(reach[0], start.real - 16), y), complex(max(reach[1], end.real + 16), y))
    return (line, head(start, 0, "thin", SMALL_HEAD), head(end, pi, "thin", SMALL_HEAD), text)


def _ends(placed: Sequence[_Set]) -> list[float]:
    return [x for one in placed for x in (one.dimension.start, one.dimension.end)]


def _extensions(placed: Sequence[_Set], top: float, feet: Mapping[float, float]) -> tuple[Piece, ...]:
    depth: dict[float, int] = {}
    for one in placed:
        for x in (one.dimension.start, one.dimension.end):
            depth[x] = max(depth.get(x, 0), one.row)
    ends = {x: top - ROW - row * ROW - PAST for x, row in sorted(depth.items())}
    return tuple(thin(complex(x, feet[x]), complex(x, y)) for x, y in ends.items())
