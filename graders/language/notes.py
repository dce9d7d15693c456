"""What was read otherwise than it was typed: another name of a function, a letter of another alphabet."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from graders.language.errors import AnswerSyntaxError
from graders.language.symbols import ALIASES, LOOK_ALIKES, Symbols, function_named, latin
from graders.language.tokens import Token, tokenize

MOST = 3


@dataclass(frozen=True, slots=True)
class Note:
    """One reading: its kind (`function`, `letter`), what was typed and what it was read as."""

    kind: str
    found: str
    meant: str


def notes_of(text: str, symbols: Symbols) -> tuple[Note, ...]:
    """Give what was read otherwise than typed, at most three notes, each once; none of a text that cannot be cut."""
    try:
        tokens = tokenize(text)
    except AnswerSyntaxError:
        return ()
    found: dict[Note, None] = {}
    for token, following in pairwise(tokens):
        if token.kind == "name":
            for note in _notes(token, following, symbols):
                found[note] = None
    return tuple(found)[:MOST]


def _notes(token: Token, following: Token, symbols: Symbols) -> list[Note]:
    spelling = token.text
    if symbols.find(spelling) is None:
        called = following.kind in ("(", "name", "number", "^", "raised", "√")
        if called and spelling in ALIASES:
            return [Note("function", spelling, ALIASES[spelling])]
        if not called or function_named(spelling) or not function_named(latin(spelling)):
            return []
    elif symbols.typed(spelling):
        return []
    return [Note("letter", char, LOOK_ALIKES[char]) for char in spelling if char in LOOK_ALIKES]
