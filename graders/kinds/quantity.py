"""Judge of a number with its unit."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

from graders.amounts import ROUNDED, SLACK, Amount, comparable, is_pair, one_value, sides
from graders.angles import is_angle, without_last_degree
from graders.asides import NAMED, refuse_direction, refuse_letters, without_asides
from graders.common_slips import NONE, CommonSlip, Slips, off_by
from graders.judge import Echo, Samples
from graders.language import doubles
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_reader import MAX_LATEX, through
from graders.language.latex_source import is_latex
from graders.language.mathml import mathml_of
from graders.language.parser import parse_tokens
from graders.language.piece import Piece
from graders.language.symbols import Symbols, function_named, key
from graders.language.text import text_of
from graders.language.tokens import MAX_LENGTH, SAME, Token, tokenize
from graders.language.tree import Number, Tree, Unary
from graders.units import Unit, fits, read_unit, readings, tidy
from graders.verdict import RIGHT, Code, Verdict, wrong

GREATEST = 1e99
ANGLE = (0, 0, 0, 1, 0)  # dimension
LONGEST = 200  # characters of an amount that is read at a glance
ANGLES = 4 * math.pi  # beyond it whole turns are no other way to write an angle
PLAIN = re.compile(r"[-−]?[0-9]{1,30}(?:[.,][0-9]{1,30})?(?:[eE][-+]?[0-9]{1,2})?(?=[^\d.,eE^*/°'·×⋅\[(]|$)")
THOUSANDS = re.compile(r"(?<![\d.,])\d{1,3}(?:[ \u00a0\u2009\u202f]\d{3}){1,6}(?!\d| *[/∕÷])")
TIMES_TEN = re.compile(r"(?<=[\d ])[xXхХ](?= ?10 ?(?:\^|\*\*|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]))")  # 1.25 x 10^4
NOTHING = Symbols(())
WORDS = re.compile(r"[^\W\d]\w{0,23}")


@dataclass(frozen=True, slots=True)
class Quantity:
    """A value with a unit, right within a relative tolerance with an absolute floor.

    Args:
        unit: The unit printed at the field; a bare number is read in it.
        rtol: Relative tolerance of the value.
        atol: Absolute floor in SI units, declared where the value can be near zero.
        step: The step asked for; empty for the step named like the answer.
        weight: Share in the score.
        unit_credit: Score for a number that would be right in the printed unit but is typed in another unit of the
            same quantity.
    """

    unit: str
    rtol: float = 0.005
    atol: float = 0.0
    step: str = ""
    weight: float = 1.0
    unit_credit: float = 0.5
    kind: ClassVar[str] = "quantity"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> Amount:
        """Read `12,5 MPa`, `3/8`, `-12°22'`, `0,5 m = 500 mm`; raises AnswerSyntaxError with the place."""
        plain = _plain_amount(text)
        if plain is not None:
            return self._amount(*plain)
        if len(text) > MAX_LATEX:
            raise AnswerSyntaxError(Reason.TOO_LONG, MAX_LENGTH)
        refuse_direction(text)
        try:
            amount = self._read(text, symbols)
        except AnswerSyntaxError as error:
            told = sides(text, lambda side: self.parse(side, symbols))
            if len(told) == 2 and is_pair(text) and all(side.amount.unit for side in told):
                return one_value(told, text)
            refuse_letters(text)
            raise (error.reason is Reason.NEEDS_OPERAND and _formula_typed(text, symbols)) or error from None
        return amount if is_latex(text) else self._as_told(amount, text, symbols)

    def _as_told(self, amount: Amount, text: str, symbols: Symbols) -> Amount:
        """Look whether what stands in front of the amount that was read, `l = 0,5 m = 510 mm`, is the same value."""
        told = [side for side in sides(text, lambda side: self.parse(side, symbols)) if side.literal(symbols)]
        alike = [side for side in told if comparable(side.amount, amount)]
        return one_value(alike, text) if len(alike) > 1 and alike[-1].amount == amount else amount

    def _read(self, text: str, symbols: Symbols) -> Amount:
        text = without_asides(text)
        if is_latex(text):
            amount = through(text, lambda plain: self.parse(plain, symbols))
            return replace(amount, unit_text=tidy(amount.unit_text))
        if len(text) > MAX_LENGTH:
            raise AnswerSyntaxError(Reason.TOO_LONG, MAX_LENGTH)
        tree, number, rest, at = _read_number(TIMES_TEN.sub("*", THOUSANDS.sub(_joined, text)))
        unit_text = _bare(rest)
        unit = Piece(unit_text, at + rest.find(unit_text)).read(read_unit) if unit_text else None
        return (None if unit else self._angle(tree, number)) or self._amount(tree, number, unit_text, unit)

    def _angle(self, tree: Tree, number: float) -> Amount | None:
        """Read a number that names no unit but says that it is an angle; None for any other."""
        asked = read_unit(self.unit).dimension == ANGLE
        degrees = without_last_degree(tree) if asked else None
        if degrees is not None:
            return self._amount(degrees, _computed(degrees, 0, ""), "°", read_unit("°"))
        if not is_angle(tree, asked):
            return None
        return Amount(tree, number, read_unit("rad"), "" if is_angle(tree, False) else "rad", _bounded(number, number))

    def _amount(self, tree: Tree, number: float, unit_text: str, unit: Unit | None) -> Amount:
        expected = read_unit(self.unit)
        factor = readings(unit, expected)[0] if unit else expected.factor
        return Amount(tree, number, unit, unit_text, _bounded(number, number * factor))

    def check(self, answer: Amount, reference: float) -> Verdict:
        """Judge value and unit apart; tell the opposite sign and a factor of ten from other errors."""
        expected = read_unit(self.unit)
        if answer.unit is not None and not fits(answer.unit, expected):
            return wrong(Code.WRONG_DIMENSION)
        if self._close(answer.value, reference):
            return RIGHT
        if answer.unit is not None and any(
            self._close(answer.number * factor, reference) for factor in readings(answer.unit, expected)[1:]
        ):
            return RIGHT
        if answer.unit is not None and self._close(answer.number * expected.factor, reference):
            return Verdict(self.unit_credit, Code.WRONG_UNIT)
        return wrong(self._slip(answer.value, reference))

    def _slip(self, value: float, reference: float) -> Code:
        if value and reference:
            if self._close(-value, reference):
                return Code.OPPOSITE_SIGN
            power = round(math.log10(min(max(abs(value / reference), 1 / GREATEST), GREATEST)))
            if power and abs(power) <= 12 and self._close(value / 10.0**power, reference):
                return Code.FACTOR_OF_TEN
            if abs(value - reference) <= 5 * max(self.rtol * abs(reference), self.atol):
                return Code.NOT_PRECISE
        return Code.WRONG

    def slips(self, answer: Amount, reference: float) -> Slips:
        """Tell which common slips explain a number, to the figures typed."""
        expected = read_unit(self.unit)
        if not answer.value or not reference or (answer.unit is not None and not fits(answer.unit, expected)):
            return NONE
        bound = self._typed_to(answer)
        found = off_by(answer.value / reference, bound, expected.dimension)
        if self._close(-answer.value, reference):
            found |= {CommonSlip.OPPOSITE_SIGN}
        if not any(expected.dimension) and abs(answer.value * reference - 1) <= bound:
            found |= {CommonSlip.INVERTED_RATIO}
        return found

    def agrees(self, answer: Amount, value: float) -> bool:
        """Tell whether a number is the value to the figures typed."""
        expected = read_unit(self.unit)
        if answer.unit is not None and not fits(answer.unit, expected):
            return False
        off = answer.value - value if abs(value) > ANGLES else self._difference(answer.value, value)
        return abs(off) <= self._typed_to(answer) * abs(value)

    def _typed_to(self, answer: Amount) -> float:
        """Give half of the last figure and what earlier rounding may add, as a share of the number."""
        number = answer.tree.operand if isinstance(answer.tree, Unary) else answer.tree
        if not isinstance(number, Number):
            return ROUNDED
        figures = number.digits.replace(".", "").lstrip("0")
        return min(self.rtol / 4, ROUNDED + 0.5 / max(1, int(figures or "1")))

    def apart(self, one: float, other: float) -> float:
        """Give |a - b| over the larger tolerance, an angle modulo a turn."""
        tolerance = max(self.rtol * max(abs(one), abs(other)), self.atol)
        return abs(self._difference(one, other)) / tolerance if tolerance else math.inf

    def _close(self, value: float, reference: float) -> bool:
        tolerance = max(self.rtol * abs(reference), self.atol)
        return abs(self._difference(value, reference)) <= tolerance * (1 + SLACK) + SLACK * abs(reference) * self.rtol

    def _difference(self, value: float, reference: float) -> float:
        if read_unit(self.unit).dimension != ANGLE:
            return value - reference
        return math.remainder(value - reference, 2 * math.pi)

    def show(self, reference: float) -> str:
        """Write a reference in the printed unit, eight figures."""
        return f"{reference / read_unit(self.unit).factor:.8g} {self.unit}".removesuffix(" 1")

    def samples(self, reference: float) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        value = reference / read_unit(self.unit).factor
        right = (f"{value:.8g}", f"{value:.8g} {self.unit}", f"{value:.8e}".replace(".", ","), f"({value:.8g})*2/2")
        far = math.copysign(9 * self.atol / read_unit(self.unit).factor, value)
        return Samples(right, (f"{value * 1.5 + far:.8g}", f"{-value:.8g}"), ("", "abc", "1..2", "5 qq"))

    def echo(self, answer: Amount, comma: bool = False) -> Echo:
        """Say which number was read and in which unit."""
        return Echo(mathml_of(answer.tree, comma), text_of(answer.tree), self._echo_unit(answer))

    def _echo_unit(self, answer: Amount) -> str:
        if answer.unit is None:
            return self.unit
        return answer.unit_text

    def carried(self, answer: Amount) -> float:
        """Give the value in SI units."""
        return answer.value

    def describe(self) -> Mapping[str, Any]:
        """Give unit and tolerance of the field."""
        return {"unit": self.unit, "rtol": self.rtol, "atol": self.atol / read_unit(self.unit).factor}


def _bounded(number: float, value: float) -> float:
    if not max(abs(number), abs(value)) < GREATEST:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, 0)
    return value


def _bare(rest: str) -> str:
    """Take a unit out of the square brackets some students put around it; `[-]` says that there is none."""
    rest = rest.strip()
    if rest[:1] != "[" or rest[-1:] != "]":
        return rest
    return "" if rest[1:-1].strip() in ("-", "–", "—", "−") else rest[1:-1].strip()


def _plain_amount(text: str) -> tuple[Tree, float, str, Unit | None] | None:
    """Read a literal with nothing or a known unit behind it, the usual answer; None for all else."""
    named = NAMED.match(text) if len(text) <= LONGEST and ("=" in text or "≈" in text) else None
    found = PLAIN.match(text, named.end() if named else 0)
    unit = _unit_behind(text[found.end() :]) if found and len(text) <= LONGEST else None
    if found is None or unit is None:
        return None
    literal = found.group().replace("−", "-").replace(",", ".")
    digits, _, power = literal.lstrip("-").lower().partition("e")
    tree: Tree = Number(digits, int(power or "0"))
    return (Unary("-", tree) if literal[0] == "-" else tree), float(literal), *unit


@lru_cache(maxsize=2048)
def _unit_behind(rest: str) -> tuple[str, Unit | None] | None:
    """Read the unit behind a literal, as typed; None where it is no unit."""
    text = _bare(rest)
    try:
        return text, read_unit(text) if text else None
    except AnswerSyntaxError:
        return None


def _joined(grouped: re.Match[str]) -> str:
    """Close the gaps between thousands; the places of what follows stay as typed."""
    return re.sub(r"\D", "", grouped[0]).rjust(len(grouped[0]))


def _read_number(text: str) -> tuple[Tree, float, str, int]:
    """Split a text into a constant expression and the unit behind it: tree, number, unit text and its place."""
    tokens = tokenize(text)
    _refuse_relation(tokens, text)
    start = 0
    behind = _behind_equals(tokens)
    if behind:
        start, tokens = tokens[behind].position, tokens[behind:]
    cut = _unit_starts(tokens, len(text))
    number_text = text[start:cut]
    if not number_text.strip(" +-−–"):
        raise AnswerSyntaxError(Reason.NOT_A_NUMBER, start, text[start : start + 20].strip())
    front = [token for token in tokens[:-1] if token.position < cut]
    tree = parse_tokens([*front, Token("end", "", cut)], NOTHING)
    number = _computed(tree, start, number_text.strip()[:20])
    rest = text[cut:].lstrip()
    if SAME.get(rest[:1], rest[:1]) == "*":
        rest = rest[1:].lstrip()
    cut = len(text) - len(rest)
    if rest.startswith(("/", "∕", "÷")):
        return tree, number, "1" + rest, cut - 1
    return tree, number, rest, cut


def _refuse_relation(tokens: list[Token], text: str) -> None:
    """Ask for the value where a bound is typed: `d ≥ 68,6 mm` names the least of many; raises AnswerSyntaxError."""
    at = next((at for at, token in enumerate(tokens) if token.kind in ("<", ">", "<=", ">=")), None)
    if at is None:
        return
    mark = tokens[at]
    value = (text[tokens[at + 1].position :] if at < 2 else text[: mark.position]).strip(" =")
    proposed = value[:20] if value.lstrip("+-−")[:1].isdecimal() else ""  # never a piece of a formula
    raise AnswerSyntaxError(Reason.NOT_A_NUMBER, mark.position, mark.text, proposed)


def _behind_equals(tokens: list[Token]) -> int:
    """Find the value in `R_A = 12 kN`, `= 12 kN`, `cos(q3) = 0.7`, `R_A = 280/13 = 21.5 kN`, `280/13 = 21.5 kN`.

    0 where none is named: behind another unknown, such as `2*R_A = 12`, stands another value.
    """
    equals = [at for at, token in enumerate(tokens) if token.kind == "="]
    if not equals or not _names_the_value(tokens, equals):
        return 0
    last = equals[-1]
    return last + 1 if last - 1 not in equals else equals[0] + 1


def _names_the_value(tokens: list[Token], equals: list[int]) -> bool:
    first = tokens[0]
    if first.kind not in ("name", "=", "|"):
        return equals[0] > 2 and not any(token.kind == "name" for token in tokens[: equals[-1]])  # a computation
    return equals[0] <= 1 or first.kind == "|" or tokens[1].kind == "(" or bool(function_named(first.text))


def _computed(tree: Tree, place: int, typed: str) -> float:
    try:
        (number,) = doubles.run(doubles.line_runner(tree), [])
    except doubles.UndefinedError:
        raise AnswerSyntaxError(Reason.OUT_OF_RANGE, place, typed) from None
    except ValueError:
        raise AnswerSyntaxError(Reason.NOT_A_NUMBER, place, typed) from None
    if not isinstance(number, float):
        raise AnswerSyntaxError(Reason.NOT_A_NUMBER, place, typed)
    return number


def _unit_starts(tokens: list[Token], end: int) -> int:
    """Find where the unit begins: at the first name that is no function and no pi, its `1/` or `/` included."""
    signs = False  # minutes of arc behind degrees belong to the number
    for at, token in enumerate(tokens):
        if at and (token.kind == "[" or (token.kind in ("'", '"') and tokens[at - 1].kind == "number" and not signs)):
            return token.position
        signs = signs or token.kind == "°"
        if token.kind == "name" and not function_named(token.text) and key(token.text) != "pi":
            break
    else:
        return end
    opened = _opened_before(tokens, at)
    if opened:  # 12 (mm), 12 ((N)/(mm^2)), 12 ((1)/(s))
        at = opened
    elif at and tokens[at - 1].kind == "/":
        at -= 1
        if at > 1 and tokens[at - 1].text == "1" and tokens[at - 2].kind in ("number", ")"):
            at -= 1
    elif at > 1 and tokens[at - 1].kind == "*":  # 12·kN
        at -= 1
    return tokens[at].position


def _opened_before(tokens: list[Token], at: int) -> int:
    """Find the outermost bracket around a name that opens behind a number; 0 where there is none."""
    opened: list[int] = []
    for place, token in enumerate(tokens[:at]):
        if token.kind == "(":
            opened.append(place)
        elif token.kind == ")" and opened:
            opened.pop()
    return next((place for place in opened if place and tokens[place - 1].kind in ("number", ")", "°")), 0)


def _formula_typed(text: str, symbols: Symbols) -> AnswerSyntaxError | None:
    """Ask for the number where a formula over the symbols of the task was typed."""
    named = any(symbols.find(word) for word in WORDS.findall(text[:LONGEST]))
    return AnswerSyntaxError(Reason.NOT_A_NUMBER, 0, text.strip()[:20]) if named else None
