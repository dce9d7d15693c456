"""What is written while LaTeX is rewritten: characters with the places they come from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Rewritten:
    """A text in the answer language; `places` gives the place in the LaTeX of each of its characters."""

    text: str
    places: tuple[int, ...]


@dataclass(slots=True)
class Sheet:
    """Characters written so far, each with its place in the LaTeX."""

    out: list[str] = field(default_factory=list)
    places: list[int] = field(default_factory=list)

    @property
    def text(self) -> str:
        """Give all that was written."""
        return "".join(self.out)

    def write(self, text: str, place: int) -> None:
        """Write characters that stand for one command."""
        self.out.extend(text)
        self.places.extend([place] * len(text))

    def write_word(self, word: str, place: int) -> None:
        """Write a name apart from its neighbours."""
        if self.out and (self.out[-1].isalnum() or self.out[-1] in "_'°"):
            self.write(" ", place)
        self.write(word + " ", place)

    def copy(self, text: str, place: int) -> None:
        """Write characters as they stand from a place on."""
        self.out.extend(text)
        self.places.extend(range(place, place + len(text)))

    def put(self, piece: Rewritten) -> None:
        """Write what was captured."""
        self.out.extend(piece.text)
        self.places.extend(piece.places)

    def captured(self, read: Callable[[], None]) -> Rewritten:
        """Let something be read and give what it writes instead of writing it."""
        kept = self.out, self.places
        self.out, self.places = [], []
        try:
            read()
            return Rewritten("".join(self.out), tuple(self.places))
        finally:
            self.out, self.places = kept
