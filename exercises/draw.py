"""Chance, from one place: a generator over a frozen algorithm (SHA-256 in counter mode), seeded per variant.

The same words give the same draws on every platform and in every later version of Python or NumPy.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import NoReturn, TypeVar

T = TypeVar("T")


class Rejected(Exception):
    """The draw is refused by the exercise; the machinery draws again."""


class Draw:
    """A stream of chance named by its words: exercise, seed, and what it is for."""

    __slots__ = ("_name", "_words")

    def __init__(self, *words: object) -> None:
        self._name = b"\x1f".join(str(word).encode() for word in words)
        self._words = self._generate()

    def _generate(self) -> Iterator[int]:
        counter = 0
        while True:
            block = sha256(self._name + b"\x1e" + counter.to_bytes(8, "big")).digest()
            for at in range(0, 32, 8):
                yield int.from_bytes(block[at : at + 8], "big")
            counter += 1

    def stream(self, name: str) -> Draw:
        """Open a named sub-stream; drawing from it does not shift any other."""
        return Draw(self._name.decode(), name)

    def below(self, count: int) -> int:
        """Draw a whole number from 0 to count - 1, all equally likely."""
        limit = (1 << 64) - (1 << 64) % count
        while True:
            word = next(self._words)
            if word < limit:
                return word % count

    def pick(self, options: Sequence[T]) -> T:
        """Draw one of the options."""
        return options[self.below(len(options))]

    def sample(self, options: Sequence[T], count: int) -> list[T]:
        """Draw some of the options without repetition, in random order."""
        left = list(options)
        return [left.pop(self.below(len(left))) for _ in range(count)]

    def uniform(self, low: float, high: float) -> float:
        """Draw a double from [low, high)."""
        return low + (high - low) * (next(self._words) >> 11) / (1 << 53)

    def reject(self) -> NoReturn:
        """Refuse this draw; the machinery draws again, at most a hundred times."""
        raise Rejected
