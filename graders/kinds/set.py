"""Judge of a set of numbers or tuples of numbers: all branches of a position task."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from html import escape
from math import inf, pi
from typing import Any, ClassVar

from graders.amounts import Amount
from graders.common_slips import CommonSlip, Slips
from graders.judge import Echo, Samples
from graders.judge import Matrix as Rows
from graders.kinds.quantity import Quantity
from graders.language.latex_reader import through
from graders.language.latex_source import is_latex
from graders.language.piece import Piece
from graders.language.symbols import Symbols
from graders.tuples import read_items
from graders.units import read_unit
from graders.verdict import RIGHT, Branches, Code, Verdict, wrong

EMPTY = "∅"
ANGLE = (0, 0, 0, 1, 0)
FACTORS = (  # that mend a number
    (CommonSlip.OPPOSITE_SIGN, (-1.0,)),
    (CommonSlip.DEGREES_RADIANS, (180 / pi, pi / 180)),
    (CommonSlip.KILO_PREFIX, (1e-3, 1e3)),
)
Item = tuple[Amount, ...]


@dataclass(frozen=True, slots=True)
class Set:
    """A set of numbers or of tuples of numbers, in any order: `12,5 mm; 13 mm`, `(30; 45; 60); (30; 10; -60)`.

    The reference has one row a branch. The score is the share of the branches found, less the share of what is given
    beyond their number, at least 0; a branch given twice counts once.

    Args:
        units: The unit of each number of an item, printed at the field; a bare number is read in it. One unit stands
            for a set of plain numbers. Whole turns of an angle do not count.
        names: The names of the numbers of an item, by which they may be typed: `q1 = 30, q2 = 45`.
        rtol: Relative tolerance of each number.
        atol: Absolute floor of each number in SI units; one number for all, or one for each.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
    """

    units: str | tuple[str, ...]
    names: tuple[str, ...] = ()
    rtol: float = 0.005
    atol: float | tuple[float, ...] = 0.0
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "set"
    symbolic: ClassVar[bool] = False

    @property
    def parts(self) -> tuple[Quantity, ...]:
        """Give the judge of each number of an item."""
        return _parts(self.units, self.rtol, self.atol)

    def parse(self, text: str, symbols: Symbols) -> tuple[Item, ...]:
        """Read the items; `none`, `brak`, `нет` or `∅` is the empty set. Raises AnswerSyntaxError."""
        if is_latex(text):
            return through(text, lambda plain: self._read(plain, symbols))
        return self._read(text, symbols)

    def _read(self, text: str, symbols: Symbols) -> tuple[Item, ...]:
        items = read_items(text, len(self.parts), self.names)
        return tuple(
            tuple(_amount(part, piece, symbols) for part, piece in zip(self.parts, item, strict=True)) for item in items
        )

    def check(self, answer: tuple[Item, ...], reference: Rows) -> Verdict:
        """Count the branches found, lost, given twice and given beyond them."""
        fits = [[self._is(item, row) for row in reference] for item in answer]
        right, extra = matching(fits), max(0, len(answer) - len(reference))
        if right == len(answer) == len(reference):
            return RIGHT
        score = (right - extra) / max(1, len(reference))
        if score <= 0:
            return wrong(self._slip(answer, right))
        doubled = sum(map(any, fits)) > right
        return Verdict(score, _code(right, len(answer), len(reference), doubled), Branches(right, len(answer)))

    def right(self, answer: tuple[Item, ...], reference: Rows) -> bool:
        """Tell whether the branches are those of the reference."""
        if len(answer) != len(reference):
            return False
        return matching([[self._is(item, row) for row in reference] for item in answer]) == len(reference)

    def _is(self, item: Item, row: Sequence[float]) -> bool:
        parts = zip(self.parts, item, row, strict=True)
        return all(part.check(amount, number).code is Code.RIGHT for part, amount, number in parts)

    def _slip(self, answer: tuple[Item, ...], right: int) -> Code:
        """Without a branch found, a unit of another quantity is named."""
        pairs = [(part, amount) for item in answer for part, amount in zip(self.parts, item, strict=True)]
        strange = any(part.check(amount, amount.value).code is Code.WRONG_DIMENSION for part, amount in pairs)
        return Code.WRONG_DIMENSION if strange and not right else Code.WRONG

    def slips(self, answer: tuple[Item, ...], reference: Rows) -> Slips:
        """Tell whether the branches are right but for one slip in one number of each, or in all that may have it."""
        if len(answer) != len(reference):
            return frozenset()
        return frozenset(
            slip
            for slip, factors in FACTORS
            if any(self._mended(answer, reference, at, factor) for at in self._places(slip) for factor in factors)
        )

    def _places(self, slip: CommonSlip) -> list[tuple[int, ...]]:
        """Give the numbers of an item that may have a slip, each for itself and all together."""
        angles = slip is CommonSlip.DEGREES_RADIANS
        prone = [at for at, part in enumerate(self.parts) if not angles or _is_angle(part)]
        return [*((at,) for at in prone), tuple(prone)]

    def _mended(self, answer: tuple[Item, ...], reference: Rows, places: tuple[int, ...], factor: float) -> bool:
        mended = tuple(
            tuple(replace(a, value=a.value * factor) if at in places else a for at, a in enumerate(item))
            for item in answer
        )
        return self.check(mended, reference) is RIGHT

    def show(self, reference: Rows) -> str:
        """Write the branches in the printed units, eight figures."""
        return "; ".join(self._shown(row) for row in reference) or EMPTY

    def _shown(self, row: Sequence[float]) -> str:
        numbers = [_bare(part, number) for part, number in zip(self.parts, row, strict=True)]
        return f"({'; '.join(numbers)})" if len(numbers) > 1 else numbers[0]

    def samples(self, reference: Rows) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        last = reference[-1] if reference else (1.0,) * len(self.parts)
        strange = tuple(number * 1.5 + 0.2 + 9 * part.atol for part, number in zip(self.parts, last, strict=True))
        more = self.show((*reference, strange))
        less = self.show(reference[:-1]) if reference else more
        short = ("(1; 2", "(1; 2; 3; 4; 5; 6; 7)") if len(self.parts) > 1 else ("1; (2", "1; x")
        right = (self.show(reference), self.show(reference[::-1]), *self._spellings(reference))
        return Samples(right, (more, less), ("", "abc", *short))

    def _spellings(self, reference: Rows) -> tuple[str, ...]:
        if not reference:
            return ("none", "brak", "нет", "{}")
        turned = [tuple(n + 2 * pi * _is_angle(p) for p, n in zip(self.parts, r, strict=True)) for r in reference]
        texts = ["\n".join(map(self._shown, turned)), "{" + self.show(reference) + "}"]
        if self.names and len(self.parts) > 1:
            texts.append("; ".join(self._named(row) for row in reference))
        return tuple(texts)

    def _named(self, row: Sequence[float]) -> str:
        numbers = zip(self.names, self.parts, row, strict=True)
        return ", ".join(f"{name} = {_bare(part, number)}" for name, part, number in numbers)

    def echo(self, answer: tuple[Item, ...], comma: bool = False) -> Echo:
        """Say which items were read, and in which unit where it is the same for all."""
        echoes = [[part.echo(amount, comma) for part, amount in zip(self.parts, item, strict=True)] for item in answer]
        units = {one.unit for item in echoes for one in item}
        common = units.pop() if len(units) == 1 else None
        text = "; ".join(_joined([_text(one, common is None) for one in item], "; ") for item in echoes) or EMPTY
        marked = [_joined([_mathml(one, common is None) for one in item], "<mo>;</mo>", *FENCES) for item in echoes]
        inner = "<mo>;</mo>".join(marked) or f"<mi>{EMPTY}</mi>"
        return Echo(f"<math><mrow>{inner}</mrow></math>", text, common)

    def carried(self, answer: tuple[Item, ...]) -> Rows | None:
        """Give the items as rows in SI units; nothing for an empty set."""
        return tuple(tuple(amount.value for amount in item) for item in answer) or None

    def apart(self, one: Rows, other: Rows) -> float:
        """Give the least bound in tolerances within which the branches can be paired."""
        if len(one) != len(other):
            return inf
        parts = self.parts
        far = [[max(p.apart(a, b) for p, a, b in zip(parts, x, y, strict=True)) for y in other] for x in one]
        bounds = sorted({0.0, *(bound for row in far for bound in row)})
        return next(bound for bound in bounds if matching([[d <= bound for d in row] for row in far]) == len(one))

    def describe(self) -> Mapping[str, Any]:
        """Give names, units and tolerances of the numbers of an item."""
        names = self.names or ("",) * len(self.parts)
        each = [{"name": name, **part.describe()} for name, part in zip(names, self.parts, strict=True)]
        units = {part.unit for part in self.parts}
        return {"components": each, **({"unit": units.pop()} if len(units) == 1 else {})}


FENCES = ("<mo>(</mo>", "<mo>)</mo>")


@lru_cache(maxsize=256)
def _parts(units: str | tuple[str, ...], rtol: float, atol: float | tuple[float, ...]) -> tuple[Quantity, ...]:
    units = (units,) if isinstance(units, str) else units
    floors = (atol,) * len(units) if isinstance(atol, int | float) else atol
    return tuple(Quantity(unit, rtol=rtol, atol=floor) for unit, floor in zip(units, floors, strict=True))


def _amount(part: Quantity, piece: Piece, symbols: Symbols) -> Amount:
    return piece.read(lambda text: part.parse(text, symbols))


def _code(right: int, given: int, expected: int, doubled: bool) -> Code:
    if doubled:
        return Code.DOUBLED_BRANCH
    if right == given:
        return Code.LOST_BRANCH
    return Code.SURPLUS_BRANCH if right == expected else Code.SOME_BRANCHES


def matching(fits: Sequence[Sequence[bool]]) -> int:
    """Count the pairs of the largest matching, each row and each column used once at most (augmenting paths)."""
    taken: dict[int, int] = {}
    return sum(_augment(row, fits, taken, set()) for row in range(len(fits)))


def _augment(row: int, fits: Sequence[Sequence[bool]], taken: dict[int, int], seen: set[int]) -> bool:
    for column, fit in enumerate(fits[row]):
        if fit and column not in seen:
            seen.add(column)
            if column not in taken or _augment(taken[column], fits, taken, seen):
                taken[column] = row
                return True
    return False


def _is_angle(part: Quantity) -> bool:
    return read_unit(part.unit).dimension == ANGLE


def _bare(part: Quantity, number: float) -> str:
    return f"{number / read_unit(part.unit).factor:.8g}"


def _joined(parts: list[str], between: str, left: str = "(", right: str = ")") -> str:
    return left + between.join(parts) + right if len(parts) > 1 else parts[0]


def _text(echo: Echo, unit: bool) -> str:
    return f"{echo.text} {echo.unit}".rstrip() if unit and echo.unit != "1" else echo.text


def _mathml(echo: Echo, unit: bool) -> str:
    inner = echo.mathml.removeprefix("<math>").removesuffix("</math>")
    return inner + f"<mtext> {escape(echo.unit)}</mtext>" if unit and echo.unit not in (None, "", "1") else inner
