"""Tokens in the order they are read, with the next of them, and the bounds of what is read."""

from __future__ import annotations

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.tokens import CLOSING, Token
from graders.language.tree import Tree

MAX_DEPTH = 60  # brackets, signs and powers within one another
MAX_NODES = 1500
MAX_HEIGHT = 200  # terms and factors beside and within one another: what walks a tree goes as deep


class Cursor:
    """A place among tokens; `at` is the next of them."""

    def __init__(self, tokens: list[Token]) -> None:
        self.tokens = tokens
        self.at = self.depth = self.nodes = self.height = 0

    @property
    def token(self) -> Token:
        return self.tokens[self.at]

    def error(self, reason: Reason, token: Token | None = None, meant: str = "") -> AnswerSyntaxError:
        return AnswerSyntaxError(reason, (token or self.token).position, (token or self.token).text, meant)

    def accept(self, kind: str) -> bool:
        found = self.token.kind == kind
        self.at += found
        return found

    def close(self, opened: Token) -> None:
        kind = CLOSING[opened.kind]
        if self.accept(kind):
            return
        if self.token.kind == "end":
            raise AnswerSyntaxError(Reason.NEEDS_BRACKET, self.token.position, kind)
        other = self.token.kind in CLOSING.values() and self.token.kind != "|"
        raise self.error(Reason.EXTRA_BRACKET if other else Reason.EXTRA_TEXT, None, kind if other else "")

    def enter(self, token: Token) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.error(Reason.TOO_DEEP, token)

    def count(self, tree: Tree) -> Tree:
        self.nodes += 1
        if self.nodes > MAX_NODES:
            raise self.error(Reason.TOO_LONG)
        return tree

    def longer(self) -> None:
        self.height += 1
        if self.height > MAX_HEIGHT:
            raise self.error(Reason.TOO_LONG)
