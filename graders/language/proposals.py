"""What may have been meant by a name, a product or a unit that is not known here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import ALIASES, FUNCTIONS, LOOK_ALIKES, Symbols, function_named, key
from graders.language.tokens import Token

INSTEAD = {
    "sec": "1/cos()", "csc": "1/sin()", "cosec": "1/sin()", "½": "1/2", "⅓": "1/3", "⅔": "2/3", "¼": "1/4", "¾": "3/4",
    "⅙": "1/6", "⅛": "1/8",
}  # fmt: skip
SOUNDS = {"eps": "epsilon", "w": "omega", "W": "omega", "al": "alpha", "th": "theta", "f": "phi", "e": "epsilon"}
LONGEST = 24  # letters of a name for which a neighbour is looked for
MOST = 400  # names looked at
BITS = 61  # of a set of letters: two letters may share one, then a spelling is looked at in vain


def not_known(token: Token, following: Sequence[Token], symbols: Symbols) -> AnswerSyntaxError:
    """Refuse a name, and propose what may be meant: a product, another spelling, a letter of another alphabet."""
    name = token.text
    pieces = symbols.split(name.rstrip("'"))
    if pieces:
        return AnswerSyntaxError(Reason.UNKNOWN_NAME, token.position, name, product(pieces, following))
    if name == "e" and following[0].kind == "^":
        return AnswerSyntaxError(Reason.UNKNOWN_NAME, token.position, name, "exp()")
    if name in INSTEAD:
        return AnswerSyntaxError(Reason.UNKNOWN_NAME, token.position, name, INSTEAD[name])
    for place, char in enumerate(name):
        if char in LOOK_ALIKES and any(c.isascii() and c.isalpha() for c in name):
            return AnswerSyntaxError(Reason.LOOK_ALIKE, token.position + place, char, LOOK_ALIKES[char])
    return AnswerSyntaxError(Reason.UNKNOWN_NAME, token.position, name, nearest_name(name, symbols))


def product(pieces: Sequence[str], following: Sequence[Token]) -> str:
    """Write pieces of a run as a product, a function with its argument, and the bracket that follows: `a·c·(x+1)`."""
    bracket = _bracket(following)
    text = ""
    for at, piece in enumerate(pieces):
        function = function_named(piece)
        rest = "·".join(pieces[at + 1 :])
        if function:
            return text + (f"{function}({rest})" + "·" * bool(bracket) if rest else function) + bracket
        text += piece + "·" * bool(rest)
    return text + ("·" + bracket if bracket else "")


def _bracket(tokens: Sequence[Token]) -> str:
    """Give the bracket that opens at once, as typed without its spaces; empty where none does or none closes."""
    depth = 0
    for at, token in enumerate(tokens):
        depth += (token.kind == "(") - (token.kind == ")")
        if depth <= 0:
            return "".join(t.text for t in tokens[: at + 1]) if at and depth == 0 else ""
    return ""


def nearest_name(spelling: str, symbols: Symbols) -> str:
    """Give the usable symbol or function whose name is nearest, or nothing: another case, or one or two slips."""
    folded = key(spelling)
    if len(folded) > LONGEST:
        return ""
    letter = next((letter for letter in SOUNDS if folded.startswith(letter)), "")
    if letter and symbols.find(SOUNDS[letter] + folded[len(letter) :]) in symbols.names:
        return symbols.find(SOUNDS[letter] + folded[len(letter) :]) or ""
    found = nearest(folded, spellings({key(name): name for name in sorted(symbols.names)[:MOST]}))
    return found or (nearest(folded, CALLED) if len(folded) > 2 else "")


class Spelling(NamedTuple):
    """A spelling that may have been meant: as it is, in small letters, the letters in it as bits, and its meaning."""

    text: str
    small: str
    letters: int
    meaning: str


def spellings(meanings: Mapping[str, str]) -> tuple[Spelling, ...]:
    """Prepare spellings to be looked through."""
    return tuple(Spelling(text, text.lower(), _letters(text.lower()), meaning) for text, meaning in meanings.items())


def _letters(text: str) -> int:
    found = 0
    for char in text:
        found |= 1 << ord(char) % BITS
    return found


CALLED = spellings({name: name for name in (*FUNCTIONS, *ALIASES)})


def nearest(spelling: str, known: Iterable[Spelling]) -> str:
    """Give the meaning of the nearest of some spellings, or nothing."""
    slips = 0 if len(spelling) < 2 else 1 if len(spelling) < 5 else 2
    near = min(_distances(spelling, known, slips), default=None)
    return near[3] if near else ""


def _distances(spelling: str, known: Iterable[Spelling], slips: int) -> Iterable[tuple[int, int, str, str]]:
    """Give slips, letters shared in front (less is more), spelling and meaning, of those that are near."""
    small = spelling.lower()
    letters = _letters(small)
    for text, other, bits, meaning in known:
        strange, lost = letters & ~bits, bits & ~letters
        if strange.bit_count() > slips or lost.bit_count() > slips or abs(len(text) - len(spelling)) > slips:
            continue
        if small == other:
            yield 0, 0, text, meaning
        elif 0 < (distance := slips_between(spelling, text, slips)) <= slips and distance < len(text):
            yield distance, -_shared(spelling, text), text, meaning


def slips_between(one: str, other: str, most: int) -> int:
    """Count letters put in, left out, changed or exchanged with a neighbour, each once (optimal string alignment).

    Only up to `most`: where there are more, any greater number is given.
    """
    if not most:
        return int(one != other)
    same, fewer = _shared(one, other), most - 1
    one, other = one[same:], other[same:]
    if not one or not other or abs(len(one) - len(other)) > most:
        return max(len(one), len(other))
    left, right = one[1:], other[1:]
    least = min(slips_between(left, right, fewer), slips_between(left, other, fewer), slips_between(one, right, fewer))
    if one[:2] == other[1::-1]:
        least = min(least, slips_between(one[2:], other[2:], fewer))
    return 1 + least


def _shared(one: str, other: str) -> int:
    """Count the letters shared in front."""
    for at, (a, b) in enumerate(zip(one, other, strict=False)):
        if a != b:
            return at
    return min(len(one), len(other))


def figure_behind(tokens: Sequence[Token], at: int) -> AnswerSyntaxError:
    """Ask what a figure behind a factor is: part of a mixed number, or a factor whose sign is missing."""
    before, token, following = tokens[at - 1], tokens[at], tokens[at + 1 : at + 3]
    if before.kind == "number" and [t.kind for t in following] == ["/", "number"]:
        part = f"{token.text}/{following[1].text}"
        return AnswerSyntaxError(Reason.MIXED_NUMBER, token.position, part, f"{before.text}+{part}")
    return AnswerSyntaxError(Reason.NEEDS_OPERATOR, token.position, token.text, f"{before.text}·{token.text}")
