"""The beam as drawn for one student: supports, loads by name and sense, and the given lengths."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from exercises.words import printed_number, with_unit
from figures import beam
from figures.picture import Picture, Table, Words
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.simple_beam import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the beam to the scale of its length; every number shown is given."""

    def metres(x: float) -> str:
        return with_unit(printed_number(x, "m", lang), "m", lang)

    A, B = (support.at(givens.L) for support in givens.supports)
    loads = [_drawn(load.load(), index) for index, load in enumerate(givens.loads, 1)]
    lengths = sorted({x for x in (A, B, givens.x_K, givens.L, *(x for one in loads for x in _reach(one))) if x > 0})
    table = Table(tuple(words["header"]), tuple(_rows(givens, words, metres)))
    return beam.draw(
        "simple-beam",
        Words(words["title"], words["description"], table),
        givens.L,
        (beam.Support(A, "pin", "A"), beam.Support(B, "roller", "B")),
        loads,
        [beam.Dimension(0, x, metres(x)) for x in lengths],
        (beam.Mark(givens.x_K, "K"),),
    )


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


def _rows(givens: Givens, words: Mapping[str, Any], metres: Callable[[float], str]) -> Iterator[tuple[str, str, str]]:
    """Name, kind and place of everything drawn; sizes stand in the statement."""
    for name, support in zip("AB", givens.supports, strict=True):
        yield name, words["kinds"][type(support).__name__], metres(support.at(givens.L))
    for index, load in enumerate(givens.loads, 1):
        drawn = _drawn(load.load(), index)
        yield drawn.name, words["kinds"][type(load).__name__], " – ".join(map(metres, _reach(drawn)))
    yield "K", words["point"], metres(givens.x_K)
