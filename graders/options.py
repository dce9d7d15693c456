"""Named options as students type them: by letter or by name, one or several."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import latin

LETTERS = "abcdefghijkl"
LONGEST = 400
ITEM = re.compile(r"[^;,\s→]+")
NONE = ("-", "−", "–", "∅", "0", "none", "brak", "żadna", "żadne", "żaden", "нет")


def option_named(typed: str, options: Sequence[str]) -> str | None:
    """Give the option a spelling means: its name, or its letter with or without a bracket, in any case."""
    letters = dict(zip(LETTERS, options, strict=False))
    plain = typed.strip().strip("().").strip()
    for spelling in (plain, plain.lower(), latin(plain).lower()):
        if spelling in options:
            return spelling
        if spelling in letters:
            return letters[spelling]
    return None


def letter_of(option: str, options: Sequence[str]) -> str:
    """Give the letter of an option."""
    return LETTERS[list(options).index(option)]


def items(text: str, options: Sequence[str]) -> list[str]:
    """Read several options, parted by `;`, a comma, blanks or arrows, or a run of letters; each once.

    Raises:
        AnswerSyntaxError: Nothing typed, an item that is no option, an item typed twice.
    """
    if len(text) > LONGEST:
        raise AnswerSyntaxError(Reason.TOO_LONG, LONGEST)
    front = text.rfind("=") + 1
    plain = " " * front + text[front:].replace("->", "→ ")
    found: list[str] = []
    for place, option, typed in _named(plain, options):
        if option is None:
            raise AnswerSyntaxError(Reason.NOT_A_CHOICE, place, typed[:20])
        if option in found:
            raise AnswerSyntaxError(Reason.REPEATED_ITEM, place, typed)
        found.append(option)
    if not found:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    return found


def _named(plain: str, options: Sequence[str]) -> Iterator[tuple[int, str | None, str]]:
    for item in ITEM.finditer(plain):
        option, typed = option_named(item[0], options), item[0]
        run = typed if option is None and len(typed) <= len(options) else ""
        each = [option_named(letter, options) for letter in run]
        if run and all(each):  # acd: a run of letters
            yield from ((item.start() + at, one, run[at]) for at, one in enumerate(each))
        else:
            yield item.start(), option, typed


def listed(reference: str) -> list[str]:
    """Give the options of a reference, in which they are parted by `;`."""
    return [part.strip() for part in reference.split(";") if part.strip()]
