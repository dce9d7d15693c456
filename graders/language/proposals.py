"""What may have been meant by a name, a product or a unit that is not known here."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import takewhile

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import ALIASES, FUNCTIONS, Symbols, function_named, key
from graders.language.tokens import Token

INSTEAD = {
    "sec": "1/cos()", "csc": "1/sin()", "cosec": "1/sin()", "½": "1/2", "⅓": "1/3", "⅔": "2/3", "¼": "1/4", "¾": "3/4",
    "⅙": "1/6", "⅛": "1/8",
}  # fmt: skip
SOUNDS = {"eps": "epsilon", "w": "omega", "W": "omega", "al": "alpha", "th": "theta", "f": "phi", "e": "epsilon"}
LONGEST = 24  # letters of a name for which a neighbour is looked for
MOST = 400  # names looked at


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
    found = nearest(folded, {key(name): name for name in sorted(symbols.names)[:MOST]})
    return found or (nearest(folded, {name: name for name in (*FUNCTIONS, *ALIASES)}) if len(folded) > 2 else "")


def nearest(spelling: str, meanings: dict[str, str]) -> str:
    """Give the meaning of the nearest of some spellings, or nothing."""
    slips = 0 if len(spelling) < 2 else 1 if len(spelling) < 5 else 2
    near = min(_distances(spelling, meanings, slips), default=None)
    return meanings[near[2]] if near else ""


def _distances(spelling: str, others: Iterable[str], slips: int) -> Iterable[tuple[int, int, str]]:
    """Give slips, letters shared in front (less is more), and spelling, of those that are near."""
    folded = spelling.lower()
    for other in others:
        if folded == other.lower():
            yield 0, 0, other
        elif abs(len(other) - len(spelling)) <= slips:
            distance = slips_between(spelling, other)
            if 0 < distance <= slips and distance < len(other):
                shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(spelling, other, strict=False)))
                yield distance, -shared, other


def slips_between(one: str, other: str) -> int:
    """Count letters put in, left out, changed or exchanged with a neighbour (optimal string alignment)."""
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, a in enumerate(one, 1):
        older, before, row = before, row, [i]
        for j, b in enumerate(other, 1):
            least = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == other[j - 2] and one[i - 2] == b:
                least = min(least, older[j - 2] + 1)
            row.append(least)
    return row[-1]


def figure_behind(tokens: Sequence[Token], at: int) -> AnswerSyntaxError:
    """Ask what a figure behind a factor is: part of a mixed number, or a factor whose sign is missing."""
    before, token, following = tokens[at - 1], tokens[at], tokens[at + 1 : at + 3]
    if before.kind == "number" and [t.kind for t in following] == ["/", "number"]:
        part = f"{token.text}/{following[1].text}"
        return AnswerSyntaxError(Reason.MIXED_NUMBER, token.position, part, f"{before.text}+{part}")
    return AnswerSyntaxError(Reason.NEEDS_OPERATOR, token.position, token.text, f"{before.text}·{token.text}")
