"""The texts of a request read in the answer language; what cannot be read keeps its side and item."""

from __future__ import annotations

from graders.comparison.request import LISTS, Request
from graders.language import AnswerSyntaxError, Symbols, Tree, parse


class Unread(Exception):
    """A text of a request that cannot be read.

    Args:
        error: Why.
        side: Which of the two, `a` or `b`.
        item: Its place in the list, from 0; None where there is no list.
    """

    def __init__(self, error: AnswerSyntaxError, side: str, item: int | None = None) -> None:
        super().__init__(str(error))
        self.error, self.side, self.item = error, side, item


def trees(request: Request) -> tuple[list[Tree], list[Tree]]:
    """Read both sides.

    Raises:
        Unread: The first text that is not in the language.
    """
    symbols = request.symbols
    return _side(request, request.a, "a", symbols), _side(request, request.b, "b", symbols)


def _side(request: Request, texts: tuple[str, ...], side: str, symbols: Symbols) -> list[Tree]:
    found = []
    for item, text in enumerate(texts):
        try:
            found.append(parse(text, symbols))
        except AnswerSyntaxError as error:
            raise Unread(error, side, item if request.kind in LISTS else None) from None
    return found
