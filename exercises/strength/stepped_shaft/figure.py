"""The shaft as drawn for one student: segments, wall, torques by name and sense, and the given lengths."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from exercises.strength.stepped_shaft.parts import structure
from exercises.words import printed_number, with_unit
from figures import shaft
from figures.picture import Picture, Table, Words
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.stepped_shaft import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the shaft to the scale of its length; every number shown is given."""
    held = structure(givens)
    table = Table(tuple(words["header"]), tuple(_rows(givens, held, words, lang)))
    return shaft.draw(
        "stepped-shaft",
        Words(words["title"], words["description"], table),
        [shaft.Segment(part.L, part.D, part.d, _diameters(part, lang)) for part in held.segments],
        [shaft.Torque(one.x, one.T, _signed(one, index)) for index, one in enumerate(held.torques, 1)],
        "left" if givens.wall == "left" else "right",
        [shaft.Dimension(start, end, _shown(end - start, "m", lang)) for start, end in pairwise(held.ends)],
    )


def _rows(
    givens: Givens, held: members.Shaft, words: Mapping[str, Any], lang: str
) -> Iterator[tuple[str, str, str, str]]:
    """Name, kind, place and size of everything drawn."""
    yield "", words["wall"], words[givens.wall], ""
    for index, (segment, part) in enumerate(zip(givens.segments, held.segments, strict=True), 1):
        kind = words["kinds"][type(segment).__name__]
        yield str(index), kind, _shown(part.L, "m", lang), f"{_diameters(part, lang)} mm"
    for index, (torque, placed) in enumerate(zip(givens.torques, held.torques, strict=True), 1):
        kind = words["kinds"][type(torque).__name__]
        yield f"M{index}", kind, _shown(placed.x, "m", lang), _shown(torque.M, "N*m", lang)


def _signed(torque: members.Torque, index: int) -> str:
    return f"{'+' if torque.T > 0 else '-'}M{index}"


def _diameters(part: members.Segment, lang: str) -> str:
    outer, bore = (printed_number(d, "mm", lang) for d in (part.D, part.d))
    return f"⌀{outer}/{bore}" if part.d else f"⌀{outer}"


def _shown(value: float, unit: str, lang: str) -> str:
    return with_unit(printed_number(value, unit, lang), unit, lang)
