"""The lines of a polygon: cutting a text into labelled lines, and a line into fields and words."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from typing import NamedTuple

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.piece import Piece, without_bullet
from graders.language.symbols import DOTS, Symbols, function_named, key, latin
from graders.language.tokens import Token, tokenize
from graders.polygon import keywords

MAX_TEXT = 4000
MAX_LINES = 30
MAX_NAME = 12


class Line(NamedTuple):
    """A line: what stands before its colon (maybe nothing) and behind."""

    label: Piece
    body: Piece


def lines_of(text: str) -> list[Line]:
    """Cut a text at its line ends, and at a `;` behind which a new label stands.

    Raises:
        AnswerSyntaxError: The text is too long.
    """
    if len(text) > MAX_TEXT:
        raise AnswerSyntaxError(Reason.TOO_LONG, MAX_TEXT)
    found, place = [], 0
    for row in text.splitlines(keepends=True):
        for piece in _statements(Piece(row, place)):
            found.append(_labelled(piece))
        place += len(row)
    if len(found) > MAX_LINES:
        raise found[MAX_LINES].body.error(Reason.TOO_LONG)
    return found


def _statements(row: Piece) -> Iterator[Piece]:
    row = without_bullet(row)
    start = 0
    for at in range(len(row.text)):
        if row.text[at] == ";" and _opens(row.text[at + 1 :]):
            yield from _said(row.part(start, at).bare)
            start = at + 1
    yield from _said(row.part(start).bare)


def _said(piece: Piece) -> Iterator[Piece]:
    text = piece.text.rstrip(";,. ")
    if text:
        yield Piece(text, piece.place)


def _opens(rest: str) -> bool:
    """Tell whether a label stands before the next `;`; `length:` and `angle:` are none."""
    head, colon, _ = rest.partition(";")[0].partition(":")
    return bool(colon) and head.strip().casefold() not in keywords.LENGTH | keywords.ANGLE and "=" not in head


def _labelled(piece: Piece) -> Line:
    at = piece.text.find(":")
    if at < 0 or "=" in piece.text[:at]:
        return Line(Piece("", piece.place), piece)
    return Line(piece.part(0, at).bare, piece.part(at + 1).bare)


def fields_of(body: Piece) -> list[Piece]:
    """Cut a body at `;` and at commas that are not decimal and not inside brackets."""
    found, start, depth = [], 0, 0
    for at, char in enumerate(body.text):
        depth += (char in "([{") - (char in ")]}")
        if depth <= 0 and (char == ";" or (char == "," and not _decimal(body.text, at))):
            found.append(body.part(start, at).bare)
            start = at + 1
    return [field for field in (*found, body.part(start).bare) if field.text]


def _decimal(text: str, at: int) -> bool:
    return text[at - 1 : at].isdigit() and text[at + 1 : at + 2].isdigit()


def words_of(piece: Piece) -> list[Piece]:
    """Cut a piece at its blanks."""
    found, place = [], 0
    for word in piece.text.split():
        place = piece.text.index(word, place)
        found.append(Piece(word, piece.place + place))
        place += len(word)
    return found


def folded(word: str) -> str:
    """Give a word as it stands in the lists of keywords."""
    return word.casefold().strip(".,;:()[]")


def label_of(piece: Piece) -> str:
    """Give the name of a vector in one spelling.

    Raises:
        AnswerSyntaxError: It is not one name.
    """
    words = [word for word in words_of(piece) if folded(word.text) not in keywords.VECTOR_FILLERS]
    name = _plain_name("".join(word.text for word in words))
    if not name:
        raise piece.error(Reason.NOT_A_LINE)
    return name


def _plain_name(spelling: str) -> str:
    name = "_".join(key(part) for part in latin(spelling).split("_") if part)
    bare = name.replace("_", "").replace("'", "")
    return name if bare.isascii() and bare.isalnum() and bare[0].isalpha() and len(bare) <= MAX_NAME else ""


def stem_and_order(spelling: str) -> tuple[str, int]:
    """Split a rate into what it is the rate of and how often: `α̇₂`, `alpha2_d`, `alpha2'` and `alpha2_dot` are one."""
    apart = unicodedata.normalize("NFD", spelling)
    dots = sum(len(DOTS[c]) - 1 for c in apart if c in DOTS)
    stem = unicodedata.normalize("NFC", "".join(c for c in apart if c not in DOTS))
    for ending, order in (("_ddot", 2), ("_dot", 1), ("_dd", 2), ("_d", 1), ("''", 2), ("'", 1)):
        if stem.endswith(ending):
            return stem.removesuffix(ending), dots + order
    return stem, dots


def new_names(piece: Piece, symbols: Symbols, rates: bool = False) -> dict[str, str]:
    """Find the names in a formula that are not declared, in one spelling each.

    Args:
        piece: The formula.
        symbols: The declared names.
        rates: A dot, a prime or `_d` makes a rate, named `…_d` or `…_dd`.

    Raises:
        AnswerSyntaxError: The formula has a character or a name that cannot be read.
    """
    found, first = {}, dict[str, Token]()
    for token in piece.read(tokenize):
        if token.kind == "name":
            first.setdefault(token.text, token)
    for token in first.values():
        if function_named(token.text) or key(token.text) == "pi":
            continue
        if symbols.find(token.text) or symbols.parts(token.text) or token.text in ("deg", "rad"):
            continue
        name = _new_name(token.text, symbols, rates)
        if not name:
            raise AnswerSyntaxError(Reason.UNKNOWN_NAME, piece.place + token.position, token.text)
        found[key(name)] = name
    return found


def _new_name(spelling: str, symbols: Symbols, rates: bool) -> str:
    stem, order = stem_and_order(spelling) if rates else (spelling, 0)
    if order > 2:
        return ""
    name = symbols.find(stem) or _plain_name(stem)
    return name and name + ("", "_d", "_dd")[order]
