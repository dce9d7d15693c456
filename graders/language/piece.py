"""A part of a text that knows where it stands, so that an error is shown where it was typed."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple, TypeVar

from graders.language.errors import AnswerSyntaxError, Reason

Read = TypeVar("Read")
BULLET = re.compile(r"\s{0,20}(?:[•‣▪◦]\s{0,20}|[-–—*]\s{1,20}(?=(?:[<>]=|[^:=\n]){1,40}:))")  # a dash: before a label


class Piece(NamedTuple):
    """A part of a text and its place in it, in code points from 0."""

    text: str
    place: int

    def part(self, start: int, end: int | None = None) -> Piece:
        """Cut a part out of this one."""
        return Piece(self.text[start:end], self.place + start)

    @property
    def bare(self) -> Piece:
        """Give the part without the blanks around it."""
        left = len(self.text) - len(self.text.lstrip())
        return self.part(left, max(left, len(self.text.rstrip())))

    def error(self, reason: Reason, meant: str = "") -> AnswerSyntaxError:
        """Refuse this part."""
        return AnswerSyntaxError(reason, self.place, self.text[:20], meant)

    def read(self, reader: Callable[[str], Read]) -> Read:
        """Read the part; raises AnswerSyntaxError with the place in the whole text."""
        try:
            return reader(self.text)
        except AnswerSyntaxError as error:
            raise error.moved(self.place + error.position) from None


def without_bullet(piece: Piece) -> Piece:
    """Leave out the mark of an item of a list, as copied from a document: `• l1: A > B`, `- 0 .. 1,5: 14`."""
    found = BULLET.match(piece.text)
    return piece.part(found.end()) if found else piece
