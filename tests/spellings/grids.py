"""Correct rewritings and wrong mutants of a numeric matrix."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

from tests.spellings.figures import comma, fraction
from tests.spellings.units import DEGREE, group_of

Rows = tuple[tuple[float, ...], ...]
Spelled = list[tuple[str, str]]


def _placed(entry: float, places: int) -> str:
    text = f"{entry:.{places}f}"
    return text.removeprefix("-") if float(text) == 0 else text


def _short(entry: float) -> str:
    text = _placed(entry, 6)
    return text.rstrip("0").rstrip(".")


def _comma(entry: float) -> str:
    return comma(_placed(entry, 4))


def _e(entry: float) -> str:
    return f"{entry:.5e}" if abs(entry) > 1e-9 else "0"


def _decimal(entry: float) -> str:
    return fraction(entry) if abs(entry) > 1e-9 else "0/1"


def nested(rows: Rows, write: Callable[[float], str], within: str, between: str) -> str:
    """Write a matrix as a list of rows."""
    return "[" + between.join("[" + within.join(map(write, row)) + "]" for row in rows) + "]"


def flat(rows: Rows, write: Callable[[float], str], within: str, between: str) -> str:
    """Write a matrix in one pair of brackets."""
    return "[" + between.join(within.join(map(write, row)) for row in rows) + "]"


def matrix(name: str, value: Rows, units: tuple[str, ...]) -> Spelled:
    """Give texts for a matrix whose values are in SI units and whose columns print units."""
    rows = in_units(value, units)
    found = [
        ("nested, points", nested(rows, _short, ", ", ", ")),
        ("nested, semicolons", nested(rows, _short, "; ", ", ")),
        ("nested, decimal commas", nested(rows, _comma, "; ", ", ")),
        ("nested, semicolons only", nested(rows, _comma, "; ", "; ")),
        ("nested, close", nested(rows, _short, ",", ",")),
        ("flat", flat(rows, _short, ", ", "; ")),
        ("flat, four decimals", flat(rows, lambda e: _placed(e, 4), ", ", "; ")),
        ("flat, true minus", flat(rows, _short, ", ", "; ").replace("-", "−")),
        ("name in front", f"{name} = {nested(rows, _short, '; ', ', ')}"),
        ("lines", nested(rows, _comma, "; ", ",\n ")),
        ("no-break spaces", nested(rows, _short, ";\u00a0", ",\u00a0")),
        ("e-notation", nested(rows, _e, "; ", ", ")),
        ("fractions", nested(rows, _decimal, "; ", ", ")),
        ("brackets around entries", nested(rows, lambda e: f"({_short(e)})", "; ", ", ")),
        ("halves", nested(rows, lambda e: f"2*({_placed(e / 2, 8)})", "; ", ", ")),
        ("spaces around", f"  {nested(rows, _short, ' ; ', ' , ')}  "),
    ]
    return found + _angles(value, units)


def in_units(value: Rows, units: tuple[str, ...]) -> Rows:
    """Give the numbers that stand in the fields."""
    if not units:
        return value
    factors = [group_of(unit)[1] for unit in units]
    return tuple(tuple(entry / factor for entry, factor in zip(row, factors, strict=True)) for row in value)


def _angles(value: Rows, units: tuple[str, ...]) -> Spelled:
    """Columns of angles with the degree sign, a turn more, and as parts of pi."""
    turned = [group_of(unit)[0] == "angle" for unit in units]
    if not any(turned):
        return []

    def written(angle: Callable[[float], str]) -> str:
        rows = [
            [angle(raw) if turns else _short(shown) for raw, shown, turns in zip(row, fields, turned, strict=True)]
            for row, fields in zip(value, in_units(value, units), strict=True)
        ]
        return "[" + ", ".join("[" + "; ".join(row) + "]" for row in rows) + "]"

    return [
        ("degree signs", written(lambda a: f"{_short(a / DEGREE)}°")),
        ("a turn more", written(lambda a: f"{_short((a + 2 * pi) / DEGREE)}°")),
        ("a turn less", written(lambda a: f"{_short((a - 2 * pi) / DEGREE)}°")),
    ]


def wrong_matrix(value: Rows, units: tuple[str, ...], rtol: float) -> Spelled:
    """Give wrong matrices: one entry, a row, a column, the whole, the shape; what changes nothing is left out."""
    scale = max(1.0, *(abs(entry) for row in value for entry in row))
    miss = 1.2 * rtol * scale
    changed = {
        "opposite sign": tuple(tuple(-e for e in row) for row in value),
        "ten times": tuple(tuple(10 * e for e in row) for row in value),
        "twice": tuple(tuple(2 * e for e in row) for row in value),
        "rows exchanged": (value[1], value[0], *value[2:]),
        "columns exchanged": tuple((row[1], row[0], *row[2:]) for row in value),
        "first entry just off": ((value[0][0] + miss, *value[0][1:]), *value[1:]),
        "last entry just off": (*value[:-1], (*value[-1][:-1], value[-1][-1] - miss)),
        "one more everywhere": tuple(tuple(e + 1 for e in row) for row in value),
        "nothing": tuple(tuple(0.0 for _ in row) for row in value),
        "last column in thousandths": tuple((*row[:-1], row[-1] / 1000) for row in value),
        "a row lost": value[:-1],
        "transposed": tuple(zip(*value, strict=True)),
        **{f"sign of entry {i}, {j}": _signed(value, i, j) for i in range(len(value)) for j in range(len(value[0]))},
    }
    kept = [(kind, rows) for kind, rows in changed.items() if _apart(value, rows, units, 1.1 * rtol * scale)]
    return [(kind, nested(_fitting(rows, units), lambda e: f"{e:.12f}", "; ", ", ")) for kind, rows in kept]


def _signed(value: Rows, i: int, j: int) -> Rows:
    return tuple(tuple(-e if (k, m) == (i, j) else e for m, e in enumerate(row)) for k, row in enumerate(value))


def _fitting(rows: Rows, units: tuple[str, ...]) -> Rows:
    return in_units(rows, units) if len(rows[0]) == len(units) else rows


def _apart(one: Rows, other: Rows, units: tuple[str, ...], bound: float) -> bool:
    if (len(one), len(one[0])) != (len(other), len(other[0])):
        return True
    turned = [group_of(unit)[0] == "angle" for unit in units] or [False] * len(one[0])
    return any(
        abs((a - b + pi) % (2 * pi) - pi if turns else a - b) > bound
        for row, second in zip(one, other, strict=True)
        for a, b, turns in zip(row, second, turned, strict=True)
    )
