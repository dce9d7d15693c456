"""Scheme of the offset slider-crank in one fixed pose: true scale would give the answers away."""

from __future__ import annotations

from collections.abc import Mapping
from math import asin, cos, radians, sin
from typing import Any

from figures.canvas import Drawing, Piece
from figures.joints import ground, ground_line, revolute, slider
from figures.label import number, point, symbol
from figures.lines import arc, axis, hidden, thin, thin_arrow
from figures.members import link
from figures.picture import Picture, Table
from figures.placing import written
from figures.plane import Point, direction, left_of, unit

CRANK, ROD, HEIGHT, CRANK_ANGLE = 128.0, 340.0, 60.0, radians(62)
WIDTH = 572.0
A: Point = 0j
B = CRANK * unit(CRANK_ANGLE)
C = complex(CRANK * cos(CRANK_ANGLE) + ROD * cos(asin((HEIGHT - CRANK * sin(CRANK_ANGLE)) / ROD)), HEIGHT)
BELOW = -34j  # where the coordinate of the slider is dimensioned


def figure(givens: object, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the mechanism; the figure does not depend on the givens."""
    table = Table(tuple(words["header"]), tuple(tuple(row) for row in words["rows"]))
    pieces = (*_frame(), *_links(), *_angles(), *_lengths(), *_names())
    return Picture(Drawing(pieces).to_svg("offset-slider-crank", words["title"], words["description"], WIDTH), table)


def _frame() -> tuple[Piece, ...]:
    """The x axis through A, the guide above it, and the frame."""
    x = (axis(A - 56, complex(C.real + 66, 0)), *written(symbol("x", "thin"), complex(C.real + 62, 8), "middle"))
    return (*x, *ground(A), *ground_line(C - 60 - 15j, C + 62 - 15j), hidden(complex(-56, HEIGHT), C + 66))


def _links() -> tuple[Piece, ...]:
    return (slider(C), link(A, B, C), *(mark for at in (A, B, C) for mark in revolute(at)))


def _angles() -> tuple[Piece, ...]:
    """Arcs from the direction of x at A and B, and the sense of the crank."""
    turn = direction(B, C)
    return (
        *arc(A, 44, 0, CRANK_ANGLE),
        *written(symbol("α1"), A + 52 * unit(CRANK_ANGLE / 2) - 2j),
        thin(B, B + 112),
        *arc(B, 92, 0, turn),
        *written(symbol("α2"), B + 118 - 3j),
        *arc(A, 86, radians(76), radians(108), "vel"),
        *written(symbol("ω1", "vel"), A + 100 * unit(radians(94)), "middle"),
    )


def _lengths() -> tuple[Piece, ...]:
    """The height of the guide, and the coordinate of the slider below."""
    foot, end = complex(-44, 0), complex(C.real, 0) + BELOW
    return (
        *thin_arrow(foot + 20j, foot + HEIGHT * 1j),
        *thin_arrow(foot + 40j, foot),
        *written(symbol("h"), foot - 14 + 26j, "middle"),
        thin(A - 22j, A + BELOW - 6j),
        hidden(C - 34j, end - 6j),
        *thin_arrow(A + BELOW, end),
        *written(symbol("l3"), (A + BELOW + end) / 2 + 8.5j, "middle"),
    )


def _names() -> tuple[Piece, ...]:
    """Letters of the points, numbers of the links."""
    places = (("A", A - 16 + 9j), ("B", B + 16j), ("C", C + 26j))
    middles = (("1", left_of(A, B, -14, 0.66)), ("2", left_of(B, C, 12, 0.6)), ("3", C + 42 + 22j))
    return (
        *(piece for name, at in places for piece in written(point(name), at, "middle")),
        *(piece for name, at in middles for piece in written(number(name), at, "middle")),
    )
