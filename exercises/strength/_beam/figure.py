"""A beam as drawn for one student: supports, loads by name and sense, and the given lengths."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from exercises.strength._beam.members import Loaded, places
from exercises.words import printed_number, with_unit
from figures import beam
from figures.picture import Picture, Table, Words
from mechanics import members


def drawn_beam(
    prefix: str, givens: Loaded, words: Mapping[str, Any], lang: str, points: Sequence[tuple[str, float]] = ()
) -> Picture:
    """Draw a beam to the scale of its length; every number shown is given.

    Args:
        prefix: The id of the figure on its page.
        givens: The beam.
        words: Title, description, header, the kinds of members, and `point` for what the further points are.
        lang: The reader's language.
        points: Further named points with their places, m.
    """
    loads = [_drawn(load.load(), index) for index, load in enumerate(givens.loads, 1)]
    held = [
        beam.Support(x, support.holds, support.name) for support, x in zip(givens.supports, places(givens), strict=True)
    ]
    ends = (*(one.x for one in held), *(x for _, x in points), givens.L, *(x for one in loads for x in _reach(one)))
    table = Table(tuple(words["header"]), tuple(_rows(givens, words, lang, points)))
    return beam.draw(
        prefix,
        Words(words["title"], words["description"], table),
        givens.L,
        held,
        loads,
        [beam.Dimension(0, x, _metres(x, lang)) for x in sorted(set(ends)) if x > 0],
        [beam.Mark(x, name) for name, x in points],
    )


def _metres(x: float, lang: str) -> str:
    return with_unit(printed_number(x, "m", lang), "m", lang)


def _drawn(load: members.Load, index: int) -> beam.Load:
    match load:
        case members.Force(x=x, F=F):
            return beam.Force(x, F, f"F{index}")
        case members.Moment(x=x, M=M):
            return beam.Couple(x, M, f"M{index}")
        case members.Distributed(x1=start, x2=end, w1=w):
            return beam.Distributed(start, end, w, w, f"q{index}")


def _reach(load: beam.Load) -> tuple[float, ...]:
    return (load.start, load.end) if isinstance(load, beam.Distributed) else (load.x,)


def _rows(
    givens: Loaded, words: Mapping[str, Any], lang: str, points: Sequence[tuple[str, float]]
) -> Iterator[tuple[str, str, str]]:
    """Name, kind and place of everything drawn; sizes stand in the statement."""
    for support, x in zip(givens.supports, places(givens), strict=True):
        yield support.name, words["kinds"][type(support).__name__], _metres(x, lang)
    for index, load in enumerate(givens.loads, 1):
        one = _drawn(load.load(), index)
        yield one.name, words["kinds"][type(load).__name__], " – ".join(_metres(x, lang) for x in _reach(one))
    for name, x in points:
        yield name, words["point"], _metres(x, lang)
