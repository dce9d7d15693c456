"""All frames of the RRP arm, placed by eye in space: which way each axis points, and the table that follows from it.

Nothing of the judge is used: angles are measured between axes, at three positions of the arm.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import atan2, cos, pi, remainder, sin
from typing import NamedTuple

from exercises.manipulators.rrp_table import Givens
from graders.chain.frames import Vector

RISES = {"down": (-pi / 2, 1), "up": (pi / 2, -1), "level_up": (0.0, 1), "level_down": (0.0, -1)}  # of the slide
TURNS = {0: "0", 1: "pi/2", 2: "pi", -1: "-pi/2"}
CHOICES = tuple(product((1, -1), repeat=5))  # senses of z1, x1, z2, x2, x3
Axes = tuple[list[Vector], list[Vector]]


class Row(NamedTuple):
    """A row of the table: the variable in theta, quarter turns beside it, the shift, quarter turns about x."""

    variable: str
    quarters: int
    shift: str
    alpha: int

    @property
    def text(self) -> str:
        """Write the row."""
        turn = TURNS[_quarter(self.quarters)]
        theta = turn if not self.variable else f"{self.variable} + {turn}"
        return f"[{theta}; {self.shift}; 0; {TURNS[_quarter(self.alpha)]}]"


Rows = tuple[Row, Row, Row]


def written(rows: Rows) -> str:
    """Write a table."""
    return "[" + "; ".join(row.text for row in rows) + "]"


def table(givens: Givens, choice: tuple[int, ...]) -> Rows:
    """Measure the table of a choice of frames."""
    at, about, along = (_axes(givens, choice, *q) for q in ((0.3, 0.4), (0.4, 0.4), (0.3, 0.5)))
    theta, first, second = _thetas(at), _thetas(about), _thetas(along)
    senses = [
        round(remainder(one - other, 2 * pi) / 0.1) for one, other in zip((first[0], second[1]), theta, strict=False)
    ]
    alphas = [_angle(one, two, x) for one, two, x in zip(at[1], at[1][1:], at[0][1:], strict=False)]
    return (
        Row(_signed(senses[0], "q1"), round((theta[0] - senses[0] * 0.3) / (pi / 2)), "L1", _quarters(alphas[0])),
        Row(_signed(senses[1], "q2"), round((theta[1] - senses[1] * 0.4) / (pi / 2)), "0", _quarters(alphas[1])),
        Row("", _quarters(theta[2]), _signed(choice[2], "q3"), _quarters(alphas[2])),
    )


def right(givens: Givens) -> set[str]:
    """Write the tables of all choices."""
    return {written(table(givens, choice)) for choice in CHOICES}


def slips(rows: Rows) -> Iterator[tuple[Rows, str]]:
    """Give tables with one slip each, and the codes by which it may be called.

    A half turn of x2 or x3 is the same as other signs beside it, and may be called so.
    """
    names = {1: "offset", 2: "offset variable_sign alpha_sign", 3: "offset"}
    for at, row in enumerate(rows):
        for quarters, code in names.items():
            yield _with(rows, at, row._replace(quarters=row.quarters + quarters)), code
        yield _with(rows, at, row._replace(alpha=-row.alpha)), "alpha_sign"
        yield _with(rows, at, row._replace(alpha=0)), "alpha convention" if at == 0 else "alpha"
        yield _with(rows, at, row._replace(alpha=2)), "alpha"
        if row.variable:
            yield _with(rows, at, row._replace(variable=_signed(-1, row.variable))), "variable_sign"
    yield _with(rows, 0, rows[0]._replace(shift="-L1")), "length_sign"
    yield _with(rows, 0, rows[0]._replace(shift="0")), "length"
    yield _with(rows, 2, rows[2]._replace(shift=_signed(-1, rows[2].shift))), "variable_sign"


def _with(rows: Rows, at: int, row: Row) -> Rows:
    found = list(rows)
    found[at] = row
    return found[0], found[1], found[2]


def _axes(givens: Givens, choice: tuple[int, ...], q1: float, q2: float) -> Axes:
    """Give x0 … x3 and z0 … z3: z1 level, z2 along the slide, z3 to the side where M stands."""
    (zero, sense), (z1, x1, z2, x2, x3) = RISES[givens.measure], choice
    rise, left = zero + sense * q2, (-sin(q1), cos(q1), 0.0)
    z = [(0.0, 0.0, 1.0), _times(z1, left), _times(z2, (cos(rise) * cos(q1), cos(rise) * sin(q1), sin(rise)))]
    z.append(_times(1 if givens.side == "left" else -1, left))
    senses = zip((x1, x2, x3), z[:-1], z[1:], strict=True)
    return [(1.0, 0.0, 0.0), *(_times(sign, _cross(one, other)) for sign, one, other in senses)], z


def _thetas(axes: Axes) -> list[float]:
    x, z = axes
    return [_angle(one, other, about) for one, other, about in zip(x, x[1:], z, strict=False)]


def _angle(one: Vector, other: Vector, about: Vector) -> float:
    return atan2(_dot(_cross(one, other), about), _dot(one, other))


def _quarters(angle: float) -> int:
    return _quarter(round(angle / (pi / 2)))


def _quarter(quarters: int) -> int:
    return (quarters + 1) % 4 - 1


def _signed(sense: int, name: str) -> str:
    return name if sense > 0 else name[1:] if name.startswith("-") else "-" + name


def _times(factor: int, v: Vector) -> Vector:
    return factor * v[0], factor * v[1], factor * v[2]


def _dot(u: Vector, w: Vector) -> float:
    return u[0] * w[0] + u[1] * w[1] + u[2] * w[2]


def _cross(u: Vector, w: Vector) -> Vector:
    return u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]
