"""Correct rewritings and wrong mutants of a number with a unit, a whole number, a ratio and choices."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, islice, permutations
from math import copysign, pi, remainder

from tests.spellings.figures import arc, comma, fraction, rounded, scientific
from tests.spellings.units import GROUPS, group_of

Spelled = list[tuple[str, str]]
GAPS = {
    "a space": " ",
    "no space": "",
    "a no-break space": "\u00a0",
    "a thin space": "\u2009",
    "a narrow space": "\u202f",
}


def quantity(name: str, value: float, unit: str) -> Spelled:
    """Give texts for a value in SI units at a field that prints a unit."""
    kind, factor, group = group_of(unit)
    here = value / factor
    eight, printed = rounded(here, 8), unit if unit != "1" else ""
    found = [
        ("bare", eight),
        ("bare with a comma", comma(eight)),
        ("four figures", rounded(here, 4)),
        ("four figures and the unit", f"{comma(rounded(here, 4))} {printed}"),
        ("fifteen figures", rounded(here, 15)),
        ("name in front", f"{name} = {eight} {printed}"),
        ("name in front, close", f"{name}={comma(eight)}{printed}"),
        ("true minus", eight.replace("-", "−")),
        ("long minus", eight.replace("-", "–")),
        ("plus sign", eight if here < 0 else f"+{eight}"),
        ("spaces around", f"  {eight}\t"),
        ("fraction", fraction(here)),
        ("product", f"2*{comma(rounded(here / 2, 8))}" if here > 0 else f"-2*{rounded(-here / 2, 8)}"),
        ("full-width figures", "".join(chr(ord(c) + 0xFEE0) if c.isdigit() else c for c in eight)),
        *scientific(here),
    ]
    if printed:
        found += [(f"unit in brackets {a}{b}", f"{eight} {a}{printed}{b}") for a, b in ("[]", "()")]
        found += [(f"unit after {gap}", f"{eight}{blank}{printed}") for gap, blank in GAPS.items()]
        found += _other_units(value, group)
    return found + (_turned(value, unit) if kind == "angle" else [])


def _other_units(value: float, group: tuple[tuple[str, float], ...]) -> Spelled:
    found = []
    for number, (spelling, factor) in enumerate(group):
        written = rounded(value / factor, 7)
        found.append((f"in {spelling}", f"{comma(written) if number % 2 else written} {spelling}"))
    mantissa = scientific(value / group[0][1])[0][1]
    return [*found, ("e-notation in SI", f"{mantissa} {group[0][0]}")]


def _turned(value: float, unit: str) -> Spelled:
    degrees = value * 180 / pi
    whole = 360 if unit != "rad" else 2 * pi
    here = degrees if unit != "rad" else value
    found = [
        ("a turn more", rounded(here + whole, 9)),
        ("a turn less", comma(rounded(here - whole, 9))),
        ("two turns more, with the sign", f"{rounded(degrees + 720, 9)}°"),
        ("minus a turn, in words", f"{comma(rounded(degrees - 360, 9))} deg"),
        ("a turn more in radians", f"{rounded(value + 2 * pi, 9)} rad"),
        ("part of pi", f"{comma(rounded(value / pi, 8))}*pi rad"),
        ("part of π", f"{rounded(value / pi, 8)}π rad"),
    ]
    return found + arc(degrees)


def wrong_quantity(value: float, unit: str, rtol: float, atol: float) -> Spelled:
    """Give wrong texts: those whose value in SI units would still be inside the tolerance are left out."""
    kind, factor, group = group_of(unit)
    tolerance = max(rtol * abs(value), atol)
    near = copysign(1.2 * tolerance, value)
    found = {
        "opposite sign": -value,
        "ten times": 10 * value,
        "a tenth": value / 10,
        "twice": 2 * value,
        "half": value / 2,
        "just above": value + near,
        "just below": value - near,
        "degrees for radians": value * 180 / pi,
        "radians for degrees": value * pi / 180,
        "diameter for radius to the third": 8 * value,
        "one per cent and the tolerance": value + copysign(tolerance + 0.011 * abs(value), value),
        "zero": 0.0,
    }
    written = [
        (slip, f"{rounded(other / factor, 12)}") for slip, other in found.items() if _off(value, other, kind, tolerance)
    ]
    here = rounded(value / factor, 8)
    strange = "kg" if kind != "mass" else "m"
    return [
        *written,
        ("dimension error", f"{here} {strange}"),
        *_wrong_units(here, value, kind, group, factor, tolerance),
    ]


def _wrong_units(
    here: str, value: float, kind: str, group: tuple[tuple[str, float], ...], factor: float, tolerance: float
) -> Spelled:
    """The right figures in another unit of the same quantity: a lost or added prefix, radians for degrees."""
    others = [(spelling, value * other / factor) for spelling, other in group if other != factor]
    found = [(f"figures in {s}", f"{here} {s}") for s, other in others if _off(value, other, kind, tolerance)]
    squared = "" if kind == "number" else f"({group[0][0].rstrip('.')})^2"
    return [*found, ("unit squared", f"{here} {squared}")] if squared else found


def _off(value: float, other: float, kind: str, tolerance: float) -> bool:
    difference = remainder(other - value, 2 * pi) if kind == "angle" else other - value
    return abs(difference) > 1.1 * tolerance


def integer(name: str, value: float) -> Spelled:
    """Give texts for a whole number."""
    n = str(round(value))
    plus = n if n.startswith("-") else f"+{n}"
    return [
        ("bare", n), ("spaces", f"  {n} "), ("no-break space", f"\u00a0{n}"), ("plus", plus), ("comma", f"{n},0"),
        ("point", f"{n}.00"), ("name", f"{name} = {n}"), ("close name", f"{name}={n}"), ("tab", f"\t{n}"),
        ("true minus", n.replace("-", "−")), ("full stop", f"{n}."), ("new line", f"{n}\n"),
        ("full-width", "".join(chr(ord(c) + 0xFEE0) if c.isdigit() else c for c in n)),
    ]  # fmt: skip


def wrong_integer(value: float) -> Spelled:
    """Give wrong texts for a whole number."""
    n = round(value)
    others = (
        n + 1,
        n - 1,
        -n,
        10 * n,
        2 * n,
        n + 10,
        n * n,
        -n - 1,
        0,
        1000 * n,
        n + 2,
        n - 2,
        n + 3,
        n + 5,
        n - 7,
        n + 100,
    )
    return [("another number", str(other)) for other in dict.fromkeys(others) if other != n]


def ratio(name: str, value: float) -> Spelled:
    """Give texts for an exact ratio."""
    over, under = Fraction(value).limit_denominator(10**6).as_integer_ratio()
    sign, size = ("-", -over) if over < 0 else ("", over)
    return [
        ("in lowest terms", f"{over}/{under}"), ("spaces", f" {over} / {under} "), ("ratio", f"{over}:{under}"),
        ("ratio with spaces", f"{over} : {under}"), ("name", f"{name} = {over}/{under}"),
        ("not in lowest terms", f"{7 * over}/{7 * under}"), ("sign in front of brackets", f"{sign}({size}/{under})"),
        ("sign below the line", f"{size}/({sign}{under})" if sign else f"{size}/(+{under})"),
        ("true minus", f"{over}/{under}".replace("-", "−")), ("division sign", f"{over}÷{under}"),
        ("product", f"({over}/3)*(3/{under})"), ("a line of the formula editor", rf"{sign}\frac{{{size}}}{{{under}}}"),
        ("two signs", f"-(-{over}/{under})" if not sign else f"-({size}/{under})"), ("decimals", f"{over},0/{under}.0"),
    ]  # fmt: skip


def wrong_ratio(value: float, rtol: float) -> Spelled:
    """Give wrong texts for an exact ratio."""
    exact = Fraction(value).limit_denominator(10**6)
    near = [Fraction(str(round(value, places))) for places in (1, 2, 3)]
    others = [
        -exact,
        1 / exact,
        -1 / exact,
        exact + 1,
        exact - 1,
        2 * exact,
        exact / 2,
        1 - exact,
        exact**2,
        10 * exact,
    ]
    wrong = [other for other in (*others, *near, Fraction(0)) if abs(other - exact) > rtol * abs(exact)]
    return [("another ratio", str(other)) for other in dict.fromkeys(wrong)]


def several(value: str, options: tuple[str, ...]) -> Spelled:
    """Give texts for a selection, or for an order, of options."""
    chosen = [part for part in value.split("; ") if part]
    letters = ["abcdefghijkl"[options.index(part)] for part in chosen]
    if not chosen:
        return [("none", text) for text in ("-", "none", "brak", "нет", "∅", " - ")]
    joined = {
        "semicolons": "; ",
        "commas": ", ",
        "blanks": " ",
        "close semicolons": ";",
        "arrows": " → ",
        "ASCII": "->",
    }
    found = [(f"names with {kind}", mark.join(chosen)) for kind, mark in joined.items()]
    found += [(f"letters with {kind}", mark.join(letters)) for kind, mark in joined.items()]
    return [*found, ("capitals", "; ".join(letters).upper()), ("name in front", f"x = {'; '.join(letters)}")]


def wrong_several(value: str, options: tuple[str, ...], ordered: bool) -> Spelled:
    """Give selections, or orders, that are not right."""
    chosen = tuple(part for part in value.split("; ") if part)
    if ordered:
        other = [p for p in islice(permutations(chosen), 200) if p != chosen][-12:]
        return [("another order", "; ".join(p)) for p in other]
    every = [s for size in range(1, len(options) + 1) for s in combinations(options, size) if set(s) != set(chosen)]
    return [("another selection", "; ".join(s)) for s in every[-12:]]


def choice(name: str, value: str, options: tuple[str, ...]) -> Spelled:
    """Give texts for one of the options."""
    letter = "abcdefghijkl"[options.index(value)]
    twin = {"a": "а", "b": "В", "c": "с", "e": "е"}.get(letter, letter)
    return [
        ("option", value), ("upper option", value.upper()), ("spaces", f"  {value} "), ("letter", letter),
        ("capital", letter.upper()), ("bracket", f"{letter})"), ("brackets", f"({letter})"), ("stop", f"{letter}."),
        ("capital and bracket", f"{letter.upper()})"), ("look-alike", twin), ("name", f"{name} = {letter}"),
        ("no-break space", f"\u00a0{letter}"), ("capitalised", value.capitalize()),
    ]  # fmt: skip


def wrong_choice(value: str, options: tuple[str, ...]) -> Spelled:
    """Give the other options, by letter and by name, and what is no option."""
    others = [o for o in options if o != value]
    letters = [("abcdefghijkl"[options.index(o)]) for o in others]
    return [
        ("another", text)
        for text in (*others, *letters, *(x.upper() for x in letters), "?", value * 2, "0", "*", "a b")
    ]


__all__ = [
    "GROUPS",
    "choice",
    "integer",
    "quantity",
    "ratio",
    "several",
    "wrong_choice",
    "wrong_integer",
    "wrong_quantity",
    "wrong_ratio",
    "wrong_several",
]
