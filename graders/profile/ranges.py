"""Cutting a text into pieces, each with its range: `0 .. 1,5: 3*x`, a line each or parted by `;`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.parser import parse
from graders.language.piece import Piece, without_bullet
from graders.language.symbols import Symbols
from graders.language.tree import Relation, Tree

LONGEST = 6000
MOST = 40
DOTS = re.compile(r"\.{2,3}|…|‥")
RELATION = re.compile(r"<=|>=|[<>≤≥⩽⩾]")
DASH = re.compile(r"(?<=[ \w])[–—÷-](?= )")
FROM = re.compile(r"(?:(?:for|dla|для) {1,4})?(?:x {0,4}[:=]? {0,4})?(?:(?:from|od|от) {1,4})?", re.IGNORECASE)
TO = re.compile(r" (?:to|do|до) ", re.IGNORECASE)
TIGHT = re.compile(r"(\d{1,6}(?:[.,]\d{1,9})?) {0,3}[–—÷-] {0,3}(\d{1,6}(?:[.,]\d{1,9})?(?: {0,3}m)?)")  # 0-0,5
MEMBER = re.compile(r"^[^\W\d_]\w{0,10} {0,4}(?:∈|in\b) {0,4}")
POINTED = re.compile(r"<([^<>;:\n]{1,40};[^<>;:\n]{1,40})>(?= {0,5}:)")  # <0; 1,5>: a closed interval in Polish books
CLOSED = re.compile(r">(?! {0,5}(?:\^|\*\*|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]|=))")  # a bracket without its power
FRONT = re.compile(r"[^=<>≤≥;:\n]{1,30}=")


def read_formula(piece: Piece, symbols: Symbols) -> Tree:
    """Read a formula; nothing is compared in it, so `<x - a> + 1` is a bracket of the first order.

    Raises:
        AnswerSyntaxError: The formula is not in the language.
    """
    closed = CLOSED.sub(">^1", piece.text)
    try:
        tree = piece.read(lambda text: parse(text, symbols))
    except AnswerSyntaxError as error:
        return _or_raise(closed, symbols, error)
    if isinstance(tree, Relation) and closed != piece.text:
        return Piece(closed, piece.place).read(lambda text: parse(text, symbols))
    return tree


def _or_raise(closed: str, symbols: Symbols, error: AnswerSyntaxError) -> Tree:
    """Read a formula with the powers of its brackets filled in, else tell what was wrong with the one typed."""
    try:
        return parse(closed, symbols)
    except AnswerSyntaxError:
        raise error from None


class Ranged(NamedTuple):
    """A piece of a curve: where it starts and ends (None: the whole span), and what it is there."""

    start: Piece | None
    end: Piece | None
    body: Piece


def read_ranges(text: str, most: int = MOST) -> list[Ranged]:
    """Cut a text into pieces with ranges; a text without any range is one piece over the whole span.

    Raises:
        AnswerSyntaxError: Nothing typed, too much typed, a piece without its range.
    """
    if len(text) > LONGEST:
        raise AnswerSyntaxError(Reason.TOO_LONG, LONGEST)
    pieces = [piece for piece in lines(POINTED.sub(r"(\1)", text)) if piece.text]
    if not pieces:
        raise AnswerSyntaxError(Reason.EMPTY, 0)
    if len(pieces) > most:
        raise AnswerSyntaxError(Reason.TOO_LONG, pieces[most].place)
    if len(pieces) == 1 and _colon(pieces[0]) is None and not DOTS.search(pieces[0].text):
        return [Ranged(None, None, unnamed(pieces[0]))]
    if len(pieces) > 1 and FRONT.fullmatch(pieces[0].text) and _colon(pieces[0]) is None:  # `M =` on a line of its own
        pieces = pieces[1:]
    return [_ranged(piece) for piece in pieces]


def lines(text: str) -> Iterator[Piece]:
    """Cut at the ends of lines, and at `;` outside brackets."""
    depth, start = 0, 0
    for at, char in enumerate(text):
        depth = max(0, depth + (char in "([{") - (char in ")]}"))
        if char == "\n" or (char == ";" and not depth):
            yield Piece(text[start:at], start).bare
            depth, start = 0, at + 1
    yield Piece(text[start:], start).bare


def unnamed(piece: Piece) -> Piece:
    """Take the name of the curve off its front: `M = `, `V(x) = `."""
    found = FRONT.match(piece.text)
    return piece.part(found.end(), len(piece.text)).bare if found else piece


def _colon(piece: Piece) -> int | None:
    """Find the colon behind a range; the colon of a ratio stands between digits and behind no range."""
    for at, char in enumerate(piece.text[:120]):
        ratio = piece.text[at + 1 : at + 2].isdigit() and TIGHT.fullmatch(piece.text[:at])  # 5-3:2
        if char == ":" and not ratio and _ends(piece.part(0, at)) is not None:
            return at
    return None


def _ranged(piece: Piece) -> Ranged:
    piece = without_bullet(piece)
    colon = _colon(piece)
    ends = _ends(piece.part(0, colon)) if colon is not None else None
    if colon is None or ends is None:
        raise AnswerSyntaxError(Reason.NEEDS_RANGE, piece.place, piece.text[:20])
    body = unnamed(piece.part(colon + 1, len(piece.text)).bare)
    if not body.text:
        raise AnswerSyntaxError(Reason.NEEDS_OPERAND, body.place)
    return Ranged(*ends, body)


def _ends(head: Piece) -> tuple[Piece, Piece] | None:
    """Read `0 .. 1,5`, `0 <= x <= 1,5`, `x ∈ (0; 1,5)`, `0 – 1,5`, `0-1,5` or `from 0 to 1.5`."""
    head = head.bare
    marks = list(DOTS.finditer(head.text))
    relations = list(RELATION.finditer(head.text))
    if len(marks) == 1:
        cuts = (marks[0].span(), marks[0].span())
    elif len(relations) == 2:
        cuts = (relations[0].span(), relations[1].span())
    else:
        return _bracketed(head) or _parted(head, DASH) or _worded(head) or _tight(head)
    ends = head.part(0, cuts[0][0]).bare, head.part(cuts[1][1], len(head.text)).bare
    if relations and relations[0][0][0] in ">≥⩾":
        ends = ends[1], ends[0]
    return ends if ends[0].text and ends[1].text else None


def _bracketed(head: Piece) -> tuple[Piece, Piece] | None:
    member = MEMBER.match(head.text)
    rest = head.part(member.end(), len(head.text)) if member else head
    if rest.text[:1] not in ("(", "[") or rest.text[-1:] not in (")", "]") or rest.text.count(";") != 1:
        return None
    cut = rest.text.index(";")
    ends = rest.part(1, cut).bare, rest.part(cut + 1, len(rest.text) - 1).bare
    return ends if ends[0].text and ends[1].text else None


def _tight(head: Piece) -> tuple[Piece, Piece] | None:
    found = TIGHT.fullmatch(head.text)
    return (head.part(*found.span(1)), head.part(*found.span(2))) if found else None


def _worded(head: Piece) -> tuple[Piece, Piece] | None:
    found = FROM.match(head.text)
    return _parted(head.part(found.end(), len(head.text)) if found else head, TO)


def _parted(head: Piece, mark: re.Pattern[str]) -> tuple[Piece, Piece] | None:
    marks = list(mark.finditer(head.text))
    if len(marks) != 1:
        return None
    ends = head.part(0, marks[0].start()).bare, head.part(marks[0].end(), len(head.text)).bare
    return ends if ends[0].text and ends[1].text else None
