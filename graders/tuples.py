"""Cutting a set of numbers or of tuples of numbers into its items, however they are bracketed and parted."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.piece import Piece
from graders.language.symbols import key, latin
from graders.language.tokens import MAX_LENGTH

MAX_ITEMS = 24
PAIRS = {"(": ")", "[": "]", "{": "}"}
NAMED = re.compile(r"[^\S\n]{0,20}([^\W\d]\w{0,20}'{0,2})[^\S\n]{0,20}=")
AND = re.compile(r"(?<=[\s)\]}])(?:i|oraz|lub|albo|and|or|и|или)(?=[\s(\[{])")
NUMBER = r"[-+−–]?\d{1,15}(?:[.,]\d{1,15})?°?"
IN_A_ROW = re.compile(rf"{NUMBER}(?:[ \u00a0]{{1,9}}{NUMBER}){{1,11}}")  # -29,98 -14,97 95,06
CELLS = re.compile(  # of a spreadsheet; what stands behind a tab begins a number or is named
    r"(?<![\s=;,(\[{])( {0,9})\t(?=[ \t]{0,9}(?:[-+−–.\d(\[{√π]|pi\b|[^\W\d]\w{0,20}'{0,2} {0,9}=))"
)
COUNTED = re.compile(
    r"(?:^|(?<=[;\n]))[^\S\n]{0,9}(?:\d{1,2}\)|[IVX]{1,4}[.:)]|\d{1,2}\.(?=\s{1,9}[(\[{]))"
)  # 1) (2; 3)
NOTHING = (
    "∅", "{}", "none", "no solution", "no solutions", "brak", "brak rozwiązań", "нет",
    "нет решений", "решений нет",
)  # fmt: skip


def read_items(text: str, width: int, names: Sequence[str] = ()) -> list[list[Piece]]:
    """Cut `(1; 2); (3; 4)`, `(1,5, 2), (3, 4)`, `q1 = 1, q2 = 2; …` or a list by lines into items of `width` numbers.

    Args:
        text: What is typed.
        width: How many numbers an item has.
        names: Names of the numbers, by which they may be typed in any order.

    Returns:
        The items in the order typed; none for a word such as `none` or `∅`.

    Raises:
        AnswerSyntaxError: Nothing typed, an item of another number of components, a name that is none of them.
    """
    if len(text) > MAX_LENGTH:
        raise AnswerSyntaxError(Reason.TOO_LONG, MAX_LENGTH)
    text = _uncounted(CELLS.sub(r"\1;", AND.sub(lambda word: ";".ljust(len(word[0])), text)))
    whole = Piece(text.rstrip().removesuffix("."), 0).bare
    if not whole.text:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    if whole.text.lower().rstrip(".") in NOTHING:
        return []
    pieces = _pieces(_opened(whole, width), width)
    if not pieces:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    if len(pieces) > MAX_ITEMS * width:
        raise AnswerSyntaxError(Reason.TOO_LONG, pieces[MAX_ITEMS].place)
    return [_ordered(item, names) for item in _grouped(pieces, width)]


def _uncounted(text: str) -> str:
    """Blank out the numbers in front of items: `1) (2; 3)`, `II. (2; 3)`."""
    for mark in COUNTED.finditer(text):
        start, end = mark.span()
        inside = text.count("(", 0, start) > text.count(")", 0, start)  # the bracket closes an item
        text = text if inside else text[:start] + " " * (end - start) + text[end:]
    return text


def _pieces(whole: Piece, width: int) -> list[Piece]:
    marks = [at for at, char in _outer(whole) if char in ";\n" or (char == "," and _parts_items(whole.text, at, width))]
    return [piece for piece in _cut(whole, marks) if piece.text]


def _parts_items(text: str, at: int, width: int) -> bool:
    """A comma parts single numbers unless it stands directly between digits; tuples only behind a bracket."""
    return not _decimal(text, at) if width == 1 else text[:at].rstrip()[-1:] in (")", "]", "}")


def _grouped(pieces: list[Piece], width: int) -> list[list[Piece]]:
    """Give the components of each item; single numbers in a row are taken `width` at a time."""
    if width == 1:
        return [[_inside(piece) if piece.text[0] in "[{" else piece] for piece in pieces]
    found = [_components(piece, width) for piece in pieces]
    if all(len(item) == 1 for item in found) and len(found) % width == 0:
        return [[one for (one,) in found[at : at + width]] for at in range(0, len(found), width)]
    for piece, item in zip(pieces, found, strict=True):
        if len(item) != width:
            raise AnswerSyntaxError(Reason.NEEDS_COMPONENTS, piece.place, str(width))
    return found


def _components(piece: Piece, width: int) -> list[Piece]:
    inner = _inside(piece)
    marks = [at for at, char in _outer(inner) if char == ";"]
    if not marks:
        commas = [at for at, char in _outer(inner) if char == ","]
        marks = _separating(inner.text, commas, width if inner is not piece else 0)
    if not marks and len(inner.text.split()) == width and IN_A_ROW.fullmatch(inner.text):
        marks = [at for at, char in enumerate(inner.text) if char.isspace() and not inner.text[at - 1].isspace()]
    return _cut(inner, marks)


def _separating(text: str, commas: list[int], width: int) -> list[int]:
    """Tell which commas part numbers; `(1,2,3)` and `(0,6,0,9,0,7)` are both three numbers."""
    loose = [at for at in commas if not _decimal(text, at)]
    if not width or any(" " in text[at - 1 : at + 2] for at in loose) or len(commas) not in (width - 1, 2 * width - 1):
        return loose
    if len(commas) == width - 1:
        return commas
    return loose or commas[1::2]


def _ordered(item: list[Piece], names: Sequence[str]) -> list[Piece]:
    """Put components that carry names in their order, without the names."""
    found = [NAMED.match(piece.text) for piece in item]
    if not names or len(item) == 1 or not any(found):
        return item
    placed: dict[str, Piece] = {}
    for piece, named in zip(item, found, strict=True):
        if named is None:
            raise AnswerSyntaxError(Reason.NEEDS_COMPONENTS, piece.place, str(len(names)))
        name = _meant(named[1], names)
        if name is None:
            raise AnswerSyntaxError(Reason.UNKNOWN_NAME, piece.place + named.start(1), named[1])
        if name in placed:
            raise AnswerSyntaxError(Reason.REPEATED_ITEM, piece.place + named.start(1), named[1])
        placed[name] = piece.part(named.end(), len(piece.text)).bare
    return [placed[name] for name in names]


def _meant(spelling: str, names: Sequence[str]) -> str | None:
    return next((name for name in names if key(name) in (key(spelling), key(latin(spelling)))), None)


def _opened(whole: Piece, width: int) -> Piece:
    """Take off the brackets around the whole set, and a name in front of them: `q = {(1; 2); (3; 4)}`."""
    named = NAMED.match(whole.text)
    rest = whole.part(named.end(), len(whole.text)).bare if named else whole
    inner = _inside(rest)
    if inner is rest:
        return whole
    several = inner.text[:1] in PAIRS or rest.text[0] == "{"
    return inner if several or (width == 1 and ";" in inner.text) else whole


def _inside(piece: Piece) -> Piece:
    """Give what one pair of brackets around the whole holds, or the piece itself."""
    bare = piece.bare
    closing = PAIRS.get(bare.text[:1])
    if closing is None or bare.text[-1] != closing or len(bare.text) < 2:
        return piece
    inner, depth = bare.part(1, len(bare.text) - 1), 0
    for char in inner.text:
        depth += (char in PAIRS) - (char in ")]}")
        if depth < 0:
            return piece
    return inner.bare


def _outer(piece: Piece) -> Iterator[tuple[int, str]]:
    """Visit the characters that stand outside all brackets."""
    depth = 0
    for at, char in enumerate(piece.text):
        depth += char in PAIRS
        depth -= char in ")]}"
        if depth == 0:
            yield at, char


def _cut(piece: Piece, marks: Sequence[int]) -> list[Piece]:
    borders = [-1, *marks, len(piece.text)]
    return [piece.part(start + 1, end).bare for start, end in pairwise(borders)]


def _decimal(text: str, at: int) -> bool:
    return text[at - 1 : at].isdigit() and text[at + 1 : at + 2].isdigit()
