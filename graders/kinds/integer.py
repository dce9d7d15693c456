"""Judge of a whole number."""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.amounts import EQUALS
from graders.asides import without_asides
from graders.common_slips import NONE, Slips
from graders.judge import Echo, Samples
from graders.kinds.rational import Rational
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_reader import through
from graders.language.latex_source import is_latex
from graders.language.symbols import Symbols
from graders.verdict import RIGHT, Code, Verdict, wrong

WHOLE = re.compile(r"\s*(?:[\w\s.+*/()·⋅×:^−–=-]{0,50}[=≈]\s*)?([-+−–]?)\s*(\d{1,15})(?:[.,]0{0,9})?\s*")
COUNTED = re.compile(r"(?<=\d) {0,3}(?:zębów|zęby|zebow|teeth|tooth|зубьев|зубья|зуба|зуб|szt|pcs|шт)\.?\s{0,9}$")
LONG = 20
FULL_WIDTH = {0xFF10 + figure: str(figure) for figure in range(10)}


@dataclass(frozen=True, slots=True)
class Integer:
    """A whole number, judged exactly."""

    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "integer"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> int:
        """Read `12`, `-3`, `45,0`, `z3 = 45`, `47 teeth`, `20+27`; raises AnswerSyntaxError."""
        if not text.strip():
            raise AnswerSyntaxError(Reason.EMPTY, 0)
        if is_latex(text):
            return through(text, lambda plain: self.parse(plain, symbols))
        plain = COUNTED.sub("", without_asides(text)).translate(FULL_WIDTH)
        found = WHOLE.fullmatch(plain) if len(plain) <= 60 else None
        if found is not None and found[2].isascii():
            return _told_once(-int(found[2]) if found[1] in ("-", "−", "–") else int(found[2]), plain)
        with suppress(AnswerSyntaxError):
            value = Rational().parse(plain, symbols).value
            if value.denominator == 1 and "," not in plain and "." not in plain:
                return int(value)
        raise AnswerSyntaxError(Reason.NOT_AN_INTEGER, 0, text.strip()[:20])

    def check(self, answer: int, reference: float) -> Verdict:
        """Judge exactly; the opposite sign is named."""
        if answer == reference:
            return RIGHT
        return wrong(Code.OPPOSITE_SIGN if answer == -reference else Code.WRONG)

    def slips(self, answer: int, reference: float) -> Slips:
        """A count is so small a number that slips cannot be told by it."""
        return NONE

    def agrees(self, answer: int, value: float) -> bool:
        """Tell whether it is the value, and long enough to be no chance."""
        return answer == value and abs(answer) >= LONG

    def show(self, reference: float) -> str:
        """Write the number."""
        return str(round(reference))

    def samples(self, reference: float) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        whole = round(reference)
        return Samples((f"{whole}", f" {whole},0 "), (f"{whole + 1}", f"{-whole - 1}"), ("", "2,5", "x", "1/2"))

    def echo(self, answer: int, comma: bool = False) -> Echo:
        """Say which number was read."""
        sign = "<mo>−</mo>" if answer < 0 else ""
        return Echo(f"<math><mrow>{sign}<mn>{abs(answer)}</mn></mrow></math>", str(answer))

    def carried(self, answer: int) -> float:
        """Give the number."""
        return float(answer)

    def apart(self, one: float, other: float) -> float:
        """Two whole numbers are the same or far apart."""
        return 0.0 if round(one) == round(other) else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """A whole number needs no further description."""
        return {}


def _told_once(value: int, text: str) -> int:
    """Give the value; raises AnswerSyntaxError where another whole number stands before it, `w = 3*3 - 2*4 = 2`."""
    *before, last = EQUALS.split(text)
    for side in before:
        with suppress(AnswerSyntaxError):
            other = Rational().parse(side, Symbols(())).value
            if other.denominator == 1 and other != value:
                break
    else:
        return value
    raise AnswerSyntaxError(Reason.TWO_VALUES, len(text) - len(last) - 1, f"{side.strip()[:20]} ≠ {last.strip()[:20]}")
