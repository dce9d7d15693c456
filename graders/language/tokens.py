"""Text to tokens: one master pattern without backtracking, positions kept in the text as typed."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from typing import NamedTuple

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_reader import kept, rewritten
from graders.language.latex_source import is_latex
from graders.language.symbols import LOOK_ALIKES, SUPERSCRIPTS

MAX_LENGTH = 2000
MAX_DIGITS = 60
MAX_NAME = 64  # letters of a word, a run of names included
MAX_EXPONENT = 999  # of a power of ten in a literal

SAME = {
    "·": "*", "⋅": "*", "∙": "*", "•": "*", "×": "*", "✕": "*", "∗": "*", "−": "-", "–": "-", "—": "-", "‐": "-",
    "‑": "-", "÷": "/", "∕": "/", "⁄": "/", ":": "/", "≤": "<=", "≥": ">=", "⩽": "<=", "⩾": ">=", "’": "'", "′": "'",
    "ʹ": "'", "″": '"', "”": '"', "º": "°", "˚": "°", "≈": "=", "≅": "=", "≃": "=", "⟨": "<", "⟩": ">",
}  # fmt: skip
SPACES = " \t\r\n\u00a0\u2009\u202f\u2002\u2003\u2007"
REFUSED = "\0"
MOST_MAPPED = 4096  # characters
POWER_OF_TEN = str.maketrans("еЕ", "eE")  # the Cyrillic letter in 1,2е4
LETTER = r"[^\W\d_²³¹⁰ⁱ-₉ₐ-ₜªº]"  # a letter of any script; digits and raised or lowered figures are not letters
TOKEN = re.compile(
    r" *(?:"
    r"(?P<number>(?:\d+(?:[.,]\d+)?|\.\d+)(?:[eEеЕ][-+]?[0-9]+)?)"
    r"|(?P<of_degrees>(?:sin|cos|tan|tg|ctg|cot)(?=\d{1,6}(?:[.,]\d{1,12})? ?°))"  # sin105°
    rf"|(?P<name>{LETTER}(?:{LETTER}|[\d_₀-₉\u0307\u0308])*'*)"
    r"|(?P<raised>[⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<operator>\*\*|<=|>=|[-+*/^()\[\]<>=,;|!√∛∜°'\"%≤≥⩽⩾]))"
)
SPELLED = {"**": "^", "≤": "<=", "≥": ">=", "⩽": "<=", "⩾": ">="}  # operators of one kind
CLOSING = {"(": ")", "[": "]", "|": "|", "<": ">"}
TWO_ARGUMENTS = ("atan2", "arctg2", "arctan2", "root", "macaulay", "min", "max", "log", "pierw")


class Token(NamedTuple):
    """A piece of text: its kind (number, name, raised, an operator itself, or end), text and place."""

    kind: str
    text: str
    position: int


def tokenize(text: str) -> list[Token]:
    """Cut a text into tokens, the last of kind `end`; LaTeX is rewritten first, its places kept.

    Raises:
        AnswerSyntaxError: Empty or too long text, a character that is not in the language, a number that is too long.
    """
    return _of_latex(text) if is_latex(text) else _tokens(text)


def _of_latex(latex: str) -> list[Token]:
    plain = rewritten(latex)
    return [Token(token.kind, token.text, plain.places[token.position]) for token in kept(plain, _tokens)]


def _tokens(text: str) -> list[Token]:
    if len(text) > MAX_LENGTH:
        raise AnswerSyntaxError(Reason.TOO_LONG, MAX_LENGTH)
    plain = _plain(text)
    tokens = list(_cut(plain, _separating_commas(plain) if "," in plain else frozenset()))
    if not tokens:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    tokens.append(Token("end", "", len(text)))
    return tokens


def _plain(text: str) -> str:
    """Map each character to one character of the language, so that places stay as typed."""
    if text.isascii() and text.isprintable() and ":" not in text:
        return text
    mapped = text.translate(MAPPED)
    place = mapped.find(REFUSED)
    if place >= 0:
        raise AnswerSyntaxError(Reason.BAD_CHARACTER, place, f"U+{ord(text[place]):04X}")
    return mapped


class _Mapped(dict[int, str]):
    """What characters mean, by their code; so many are remembered."""

    def __missing__(self, code: int) -> str:
        char = _mapped(chr(code))
        return self.setdefault(code, char) if len(self) < MOST_MAPPED else char


def _mapped(char: str) -> str:
    """Give the character of the language that a character means; REFUSED if it is invisible or a foreign figure."""
    if char in SPACES:
        return " "
    if "\uff01" <= char <= "\uff5e":  # full-width forms
        return chr(ord(char) - 0xFEE0)
    if unicodedata.category(char) in ("Cc", "Cf", "Cs", "Co", "Cn") or (char.isdigit() and not _figure(char)):
        return REFUSED
    same = SAME.get(char, char)
    return same if len(same) == 1 else char


def _figure(char: str) -> bool:
    return char.isascii() or char in SUPERSCRIPTS or "₀" <= char <= "₉"


MAPPED = _Mapped()


def _cut(plain: str, separating: frozenset[int]) -> Iterator[Token]:
    place, end = 0, len(plain.rstrip(" ").removesuffix(".").rstrip(" "))  # a full stop behind the last formula
    while place < end:
        found = TOKEN.match(plain, place)
        if found is None:
            raise _strange(plain, place)
        kind, place = found.lastgroup or "", found.end()
        text = found[kind]
        if kind == "operator":
            yield Token(SPELLED.get(text, text), text, place - len(text))
        elif kind == "number":
            token = _number(text, place - len(text), separating)
            place = token.position + len(token.text)
            yield token
        elif len(text) > MAX_NAME:
            raise AnswerSyntaxError(Reason.UNKNOWN_NAME, place - len(text), text[:12] + "…")
        else:
            yield Token("name" if kind == "of_degrees" else kind, text, place - len(text))


def _strange(plain: str, place: int) -> AnswerSyntaxError:
    place += len(plain[place:]) - len(plain[place:].lstrip(" "))
    reason = Reason.LOOK_ALIKE if plain[place] in LOOK_ALIKES else Reason.BAD_CHARACTER
    return AnswerSyntaxError(reason, place, plain[place])


def _number(literal: str, place: int, separating: frozenset[int]) -> Token:
    """Read a literal; a comma is decimal directly between digits unless its bracket makes it a separator."""
    comma = literal.find(",")
    if comma >= 0 and place + comma in separating:
        literal = literal[:comma]
    literal = literal.translate(POWER_OF_TEN)
    if len(literal.lower().partition("e")[0]) > MAX_DIGITS:
        raise AnswerSyntaxError(Reason.TOO_LARGE, place, literal[:12] + "…")
    return Token("number", literal, place)


def exponent_of(literal: str) -> tuple[str, int]:
    """Split a literal into digits with a point and the power of ten; raises OverflowError beyond the bound."""
    digits, _, power = literal.replace("E", "e").replace(",", ".").partition("e")
    if len(power.lstrip("+-0")) > 4 or abs(int(power or "0")) > MAX_EXPONENT:
        raise OverflowError(literal)
    digits = "0" + digits if digits.startswith(".") else digits
    return digits, int(power or "0")


def _separating_commas(plain: str) -> frozenset[int]:
    """Find the commas that separate: inside a matrix row or a two-argument call, unless that bracket also holds `;`."""
    found: list[int] = []
    stack: list[tuple[bool, list[int], list[bool]]] = []
    for place, char in enumerate(plain):
        if char in "([":
            stack.append((char == "[" or _calls_two(plain, place), [], [False]))
        elif char in ")]" and stack:
            separates, commas, semicolon = stack.pop()
            if separates and not semicolon[0]:
                found.extend(commas)
        elif stack and char == ",":
            stack[-1][1].append(place)
        elif stack and char == ";":
            stack[-1][2][0] = True
    return frozenset(found)


def _calls_two(plain: str, place: int) -> bool:
    head = plain[max(0, place - 8) : place].rstrip()
    return head.endswith(TWO_ARGUMENTS)


def after_name(text: str) -> int:
    """Give the place behind a name with `=` in front of a number (`i = -4`, `= 12`), or 0.

    Raises:
        AnswerSyntaxError: The text cannot be cut into tokens.
    """
    tokens = tokenize(text)
    front = [token.kind for token in tokens[:2]]
    named = "=" in front and front[0] in ("name", "=")
    return tokens[front.index("=") + 1].position if named else 0


def partners(tokens: list[Token]) -> dict[int, int]:
    """Pair each `<` with the `>` that would close it, brackets between them balanced; both are counted from the end.

    What is put in the place of a token in front of them, as the names of a run, does not shift them.
    """
    opened: list[int] = []
    found: dict[int, int] = {}
    for at, token in enumerate(tokens, -len(tokens)):
        if token.kind in ("(", "[", "<"):
            opened.append(at)
        elif token.kind == ">" and opened and tokens[opened[-1]].kind == "<":
            found[opened.pop()] = at
        elif token.kind in (")", "]"):
            while opened and tokens[opened.pop()].kind == "<":
                pass
    return found
