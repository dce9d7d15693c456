"""Units as engineers write them, in Polish, English and Russian: one table, one small reader.

A dimension is the powers of (length, mass, time, angle, temperature). A tag tells apart what has equal powers but
is not the same: energy (J) is not torque, and a frequency in Hz is not an angular velocity.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import lru_cache

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.proposals import nearest, spellings
from graders.language.symbols import DEGREES, LOOK_ALIKES, SUPERSCRIPTS
from graders.language.tokens import SAME, SPACES
from graders.unit_words import PER, words


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of measurement: powers of the base dimensions, factor to SI, and tag (energy, cycle, turn or none)."""

    dimension: tuple[int, int, int, int, int]
    factor: float
    tag: str = ""


LONGEST = 120
GREATEST = 1e150  # of a factor to SI
NONE = Unit((0, 0, 0, 0, 0), 1.0)


def _unit(
    factor: float, length: int = 0, mass: int = 0, time: int = 0, angle: int = 0, heat: int = 0, tag: str = ""
) -> Unit:
    return Unit((length, mass, time, angle, heat), factor, tag)


TURN = 2 * math.pi
SPEED_OF_ROTATION = (0, 0, -1, 1, 0)
PREFIXED = {
    "m": _unit(1, 1), "м": _unit(1, 1),
    "g": _unit(1e-3, 0, 1), "г": _unit(1e-3, 0, 1),
    "s": _unit(1, 0, 0, 1), "с": _unit(1, 0, 0, 1),
    "N": _unit(1, 1, 1, -2), "Н": _unit(1, 1, 1, -2),
    "Pa": _unit(1, -1, 1, -2), "Па": _unit(1, -1, 1, -2),
    "J": _unit(1, 2, 1, -2, tag="energy"), "Дж": _unit(1, 2, 1, -2, tag="energy"),
    "W": _unit(1, 2, 1, -3), "Вт": _unit(1, 2, 1, -3),
    "Hz": _unit(1, 0, 0, -1, tag="cycle"), "Гц": _unit(1, 0, 0, -1, tag="cycle"),
    "rad": _unit(1, angle=1), "рад": _unit(1, angle=1),
}  # fmt: skip
PREFIXES = {
    "": 1.0, "k": 1e3, "M": 1e6, "G": 1e9, "c": 1e-2, "m": 1e-3, "μ": 1e-6, "u": 1e-6, "n": 1e-9, "d": 1e-1, "h": 1e2,
    "da": 10.0, "к": 1e3, "М": 1e6, "Г": 1e9, "м": 1e-3, "мк": 1e-6, "с": 1e-2, "д": 1e-1,
}  # fmt: skip
RUN_TOGETHER = (("N", ("m", "cm", "mm")), ("Н", ("м", "см", "мм")))  # kNm is kN·m, and kNm² is kN·m²
PLAIN = {
    **dict.fromkeys(("°", *DEGREES), _unit(math.pi / 180, angle=1)),
    **dict.fromkeys(("'", "arcmin"), _unit(math.pi / 10800, angle=1)),
    **dict.fromkeys(('"', "arcsec"), _unit(math.pi / 648000, angle=1)),
    **dict.fromkeys(("obr", "об", "rev", "turn"), _unit(TURN, angle=1, tag="turn")),
    **dict.fromkeys(("rpm", "RPM"), _unit(TURN / 60, 0, 0, -1, 1, tag="turn")),
    **dict.fromkeys(("min", "мин"), _unit(60, 0, 0, 1)),
    **dict.fromkeys(("h", "godz", "ч"), _unit(3600, 0, 0, 1)),
    **dict.fromkeys(("t", "т"), _unit(1e3, 0, 1)),
    **dict.fromkeys(("sec", "sek", "сек"), _unit(1, 0, 0, 1)),
    **dict.fromkeys(("K", "К"), _unit(1, heat=1)),
    **dict.fromkeys(("kgf", "кгс"), _unit(9.80665, 1, 1, -2)),
    "bar": _unit(1e5, -1, 1, -2), "бар": _unit(1e5, -1, 1, -2),
    "%": _unit(1e-2), "in": _unit(0.0254, 1), "1": NONE,
}  # fmt: skip


def _table() -> dict[str, Unit]:
    found = {}
    for symbol, unit in PREFIXED.items():
        cyrillic = any("а" <= c.lower() <= "я" for c in symbol)
        for prefix, factor in PREFIXES.items():
            if not prefix or cyrillic == ("а" <= prefix[0].lower() <= "я"):
                found[prefix + symbol] = Unit(unit.dimension, factor * unit.factor, unit.tag)
    return found | PLAIN


def _compounds(table: dict[str, Unit]) -> dict[str, tuple[Unit, Unit]]:
    forces = [(force, lengths) for base, lengths in RUN_TOGETHER for force in table if force.endswith(base)]
    return {force + length: (table[force], table[length]) for force, lengths in forces for length in lengths}


TABLE = _table()
COMPOUNDS = _compounds(TABLE)
RARE = tuple(prefix + "rad" for prefix in PREFIXES if prefix)  # grad means another unit than Grad
NAMES = spellings({name: name for name in (*TABLE, *COMPOUNDS) if name not in RARE})
WORDS = dict(words())
WHOLE = {"r/min": "rpm"}  # a lone r may be rad as well
TO_CYRILLIC = str.maketrans({latin: cyrillic for cyrillic, latin in LOOK_ALIKES.items()})
PIECE = re.compile(
    r"(?P<name>[^\W\d_²³¹⁰ⁱ-₉]+|[°'\"%])|(?P<number>\d+)|(?P<raised>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?P<mark>\*\*|[-*/^().])"
)


@lru_cache(maxsize=2048)
def read_unit(text: str) -> Unit:
    """Read a unit such as `N/mm^2`, `kN·m`, `obr/min`, `1/s`; a dot or a blank is a product.

    Raises:
        AnswerSyntaxError: Unknown unit, with its place in the text.
    """
    if len(text) > LONGEST:
        raise AnswerSyntaxError(Reason.UNKNOWN_UNIT, 0, text[:12])
    plain = "".join(" " if c in SPACES else SAME.get(c, "μ" if c == "µ" else c) for c in text)
    reader = _UnitReader(WHOLE.get(plain.replace(" ", ""), plain))
    try:
        unit = reader.product()
    except (OverflowError, ZeroDivisionError):
        raise AnswerSyntaxError(Reason.TOO_LARGE, 0, text[:12]) from None
    if reader.kind != "end":
        raise reader.error()
    if not 1 / GREATEST < unit.factor < GREATEST:
        raise AnswerSyntaxError(Reason.TOO_LARGE, 0, text[:12])
    return unit


class _UnitReader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.place = 0
        self.depth = 0
        self.step()

    def step(self) -> None:
        while self.place < len(self.text) and self.text[self.place] == " ":
            self.place += 1
        self.start = self.place
        found = PIECE.match(self.text, self.place)
        if found is None:
            self.kind, self.piece = ("end", "") if self.place >= len(self.text) else ("bad", self.text[self.place])
            return
        self.kind, self.piece = ("mark", "/") if found.group() in PER else (found.lastgroup or "bad", found.group())
        self.place = found.end()

    def error(self) -> AnswerSyntaxError:
        if self.kind == "end":
            return AnswerSyntaxError(Reason.NEEDS_OPERAND, self.start)
        return AnswerSyntaxError(Reason.UNKNOWN_UNIT, self.start, self.piece, nearest_unit(self.piece))

    def product(self) -> Unit:
        unit, divide = self.power(), False
        while self.kind not in ("end", "bad") and self.piece != ")":
            divide = False
            if self.piece in ("*", ".", "/", "-"):  # also kN-m
                divide, stop = self.piece == "/", self.piece == "."
                self.step()
                if stop and (self.kind == "end" or self.piece == "/"):  # a full stop after an abbreviation
                    continue
            unit = times(unit, self.power(), -1 if divide else 1)
        return unit

    def power(self) -> Unit:
        rest, unit = self.atom()
        return times(rest, unit, self.raised_to())

    def raised_to(self) -> int:
        if self.piece in ("^", "**") and self.kind == "mark":
            self.step()
            return self.exponent()
        if self.kind == "raised":
            power = int("".join(SUPERSCRIPTS[c] for c in self.piece[:3]))
            if abs(power) > 9:
                raise self.error()
            self.step()
            return power
        if self.piece == "-" and self.text[self.place : self.place + 1].isdigit():  # s-1
            return self.exponent()
        if self.kind == "number" and self.piece in ("2", "3", "4") and self.text[self.start - 1] != " ":
            return self.exponent()
        return 1

    def exponent(self) -> int:
        bracket = self.piece == "("
        if bracket:
            self.step()
        sign = -1 if self.piece == "-" else 1
        if sign < 0:
            self.step()
        if self.kind != "number" or len(self.piece) > 1:
            raise self.error()
        power = sign * int(self.piece)
        self.step()
        if bracket and self.piece == ")":
            self.step()
        return power

    def atom(self) -> tuple[Unit, Unit]:
        """Read a unit: what a power leaves alone, and what it raises."""
        if self.piece == "(" and self.depth < 4:
            self.depth += 1
            self.step()
            unit = self.product()
            if self.piece != ")":
                raise self.error()
            self.step()
            self.depth -= 1
            return NONE, unit
        found = _named(self.piece) or _named(self.piece.translate(TO_CYRILLIC))
        after = self.text[self.place :].lstrip(" )")
        alone = self.kind == "number" and after[:1] != "/" and self.text.strip() != "1"  # 1/s, never kN * 1
        if found is None or alone or self.kind not in ("name", "number"):
            raise self.error()
        self.step()
        return found


@lru_cache(maxsize=512)
def nearest_unit(piece: str) -> str:
    """Give the unit that a piece may mean: `kN` for KN, `MPa` for Mpa; empty where none is near."""
    found = nearest(piece, NAMES) if piece.isalpha() and len(piece) < 9 else ""
    if (
        found.startswith(("M", "\u041c")) and piece.lower() in TABLE
    ):  # MM is typed for mm: whoever means a megametre writes it as one
        return piece.lower()
    return found if len(piece) > 2 or found.lower() == piece.lower() else ""  # two letters are near to too many


def _named(piece: str) -> tuple[Unit, Unit] | None:
    unit = TABLE.get(piece)
    if unit is None and piece in WORDS:
        unit = read_unit(WORDS[piece])
    return (NONE, unit) if unit else COMPOUNDS.get(piece)


def times(one: Unit, other: Unit, power: int) -> Unit:
    """Multiply a unit by a power of another."""
    a, b = one.dimension, other.dimension
    dimension = (
        a[0] + power * b[0],
        a[1] + power * b[1],
        a[2] + power * b[2],
        a[3] + power * b[3],
        a[4] + power * b[4],
    )
    return Unit(dimension, one.factor * float(other.factor) ** power, _tag(one, other, power))


def _tag(one: Unit, other: Unit, power: int) -> str:
    if one == NONE and power == 1:
        return other.tag
    return one.tag if other == NONE else "turn" if "turn" in (one.tag, other.tag) else ""


def tidy(text: str) -> str:
    """Take the blanks and the needless brackets out of a unit that a formula editor wrote."""
    plain = re.sub(r" *([-*/^().]) *", r"\1", text).strip()
    plain = re.sub(r"\(([^()*/ ]+)\)", r"\1", re.sub(r"\(([^()*/ ]+)\)", r"\1", plain))
    return plain[1:-1] if plain[:1] == "(" and plain.find(")") == len(plain) - 1 else plain


def fits(typed: Unit, expected: Unit) -> bool:
    """Tell whether a typed unit measures the expected quantity.

    An angle may be left out of a unit (1/s for rad/s); energy and cycles stand only for themselves.
    """
    if typed.tag not in ("", "turn", expected.tag):
        return False
    if typed.dimension == expected.dimension:
        return True
    without = (*typed.dimension[:3], expected.dimension[3], typed.dimension[4])
    return typed.dimension[3] == 0 and without == expected.dimension and typed != NONE


def readings(typed: Unit, expected: Unit) -> tuple[float, ...]:
    """Give the factors to SI that a typed unit may have at a field, the likelier first.

    A speed of rotation without its angle counts turns where the field counts turns or the time is no second: `1/min`
    is a turn a minute. There it may count radians as well.
    """
    speed = expected.dimension == SPEED_OF_ROTATION and typed.dimension == (0, 0, -1, 0, 0)
    if speed and (expected.tag == "turn" or typed.factor != 1):
        return typed.factor * TURN, typed.factor
    return (typed.factor,)
