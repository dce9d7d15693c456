"""Judge of an exact ratio, such as a gear ratio."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from graders.common_slips import NONE, CommonSlip, Slips, off_by
from graders.judge import Echo, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_reader import through
from graders.language.latex_source import is_latex
from graders.language.mathml import mathml_of
from graders.language.parser import parse
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tokens import after_name
from graders.language.tree import Binary, Number, Tree, Unary
from graders.verdict import RIGHT, Code, Verdict, wrong

LONGEST = 200
GREATEST = 10**9
FINEST = 10**30
LARGEST_POWER = 12
DENOMINATOR = 10**6  # of a reference, which reaches a judge as a double
NEAR = Fraction(1, 100)  # a rounded value within this share is told to be exact
EXACTLY = 1e-12
PURE = (0, 0, 0, 0, 0)
NOTHING = Symbols(())


@dataclass(frozen=True, slots=True)
class Ratio:
    """A ratio as typed and its exact value."""

    tree: Tree
    value: Fraction


@dataclass(frozen=True, slots=True)
class Rational:
    """A whole number, a fraction, a ratio or an exact decimal: `-4`, `-8/3`, `-4:1`, `2,5`, `(60/20)*(45/15)`.

    Args:
        rtol: Relative tolerance for rounded decimals; 0 asks for the exact value.
        either: The direction is not declared: a ratio and its reciprocal are both right.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
    """

    rtol: float = 0.0
    either: bool = False
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "rational"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> Ratio:
        """Read a constant of whole numbers, decimals, `+ - * / :` and small powers; raises AnswerSyntaxError."""
        if len(text) > LONGEST:
            raise AnswerSyntaxError(Reason.TOO_LONG, LONGEST)
        return through(text, _read) if is_latex(text) else _read(text)

    def check(self, answer: Ratio, reference: float) -> Verdict:
        """Judge exactly; the opposite sign, the reciprocal and a rounded value are named."""
        value, expected = answer.value, exact(reference)
        if self._same(value, expected) or (self.either and value and self._same(1 / value, expected)):
            return RIGHT
        if self._same(-value, expected):
            return wrong(Code.OPPOSITE_SIGN)
        if value and expected and self._same(1 / value, expected):
            return wrong(Code.INVERTED_RATIO)
        if abs(value - expected) <= NEAR * abs(expected):
            return wrong(Code.NOT_PRECISE if self.rtol else Code.NOT_EXACT)
        return wrong()

    def _same(self, value: Fraction, expected: Fraction) -> bool:
        return value == expected or abs(value - expected) <= Fraction(self.rtol) * abs(expected)

    def show(self, reference: float) -> str:
        """Write a whole number or a fraction in lowest terms."""
        return str(exact(reference))

    def samples(self, reference: float) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        value = exact(reference)
        over, under = value.numerator, value.denominator
        right = (
            self.show(reference),
            f"{over}:{under}",
            f" {2 * over} / {2 * under} ",
            rf"\frac{{{3 * over}}}{{{3 * under}}}",
        )
        return Samples(right, (str(2 * value + 1), str(-value - 1)), ("", "x", "1/0", "2 kN", "3; 4", "1e5"))

    def echo(self, answer: Ratio, comma: bool = False) -> Echo:
        """Say which ratio was read."""
        return Echo(mathml_of(answer.tree, comma), text_of(answer.tree))

    def carried(self, answer: Ratio) -> float:
        """Give the value."""
        return float(answer.value)

    def slips(self, answer: Ratio, reference: float) -> Slips:
        """Tell the opposite sign, the reciprocal and a factor of two or of ten."""
        value, expected = answer.value, exact(reference)
        if not value or not expected:
            return NONE
        found = off_by(float(value / expected), max(self.rtol / 2, EXACTLY), PURE)
        return found | {CommonSlip.INVERTED_RATIO} if self._same(1 / value, expected) else found

    def apart(self, one: float, other: float) -> float:
        """Two ratios are the same or far apart; with a tolerance, their distance in tolerances."""
        a, b = exact(one), exact(other)
        if a == b or (self.either and a * b == 1):
            return 0.0
        return float(abs(a - b) / (Fraction(self.rtol) * max(abs(a), abs(b)))) if self.rtol else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the tolerance, or say that the value is exact."""
        return {"rtol": self.rtol} if self.rtol else {"exact": True}


def exact(reference: float) -> Fraction:
    """Give the ratio of small whole numbers that a double stands for."""
    return Fraction(reference).limit_denominator(DENOMINATOR)


def _read(text: str) -> Ratio:
    if not text.strip():
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    start = after_name(text)
    tree = parse(" " * start + text[start:], NOTHING)
    try:
        value = _value(tree)
    except ZeroDivisionError:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, start) from None
    if value is None:
        raise AnswerSyntaxError(Reason.NOT_A_FRACTION, start, text.strip()[:20])
    if abs(value.numerator) > GREATEST * value.denominator or value.denominator > FINEST:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, start)
    return Ratio(tree, value)


def _value(tree: Tree) -> Fraction | None:
    """Compute a constant exactly; None where it is more than the four operations and a small power."""
    match tree:
        case Number(exponent=0):
            return tree.exact
        case Unary(operator="+" | "-" as sign, operand=operand):
            value = _value(operand)
            return -value if value is not None and sign == "-" else value
        case Binary(operator="^", left=left, right=Number() as power) if power.whole:
            value = _value(left)
            return value ** int(power.digits) if value is not None and int(power.digits) <= LARGEST_POWER else None
        case Binary(operator="+" | "-" | "*" | "/" as operator, left=left, right=right):
            one, other = _value(left), _value(right)
            return None if one is None or other is None else _joined(operator, one, other)
        case _:
            return None


def _joined(operator: str, one: Fraction, other: Fraction) -> Fraction:
    if operator in "+-":
        return one + other if operator == "+" else one - other
    return one * other if operator == "*" else one / other
