"""Judge of free text: it is kept for the lecturer."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols
from graders.verdict import KEPT, Verdict

REFUSED = ("Cc", "Cf", "Cs", "Co", "Cn")  # what nobody sees or types
ALLOWED = "\t\n\r\u200c\u200d\u00ad"


@dataclass(frozen=True, slots=True)
class Text:
    """Sentences such as the conclusions of a report. They have no reference; a lecturer reads and marks them.

    Args:
        longest: Greatest number of characters.
        step: The step it belongs to; empty for none.
        weight: Share in the score.
    """

    longest: int = 4000
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "text"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> str:
        """Read any text without invisible characters; raises AnswerSyntaxError."""
        if len(text) > self.longest:
            raise AnswerSyntaxError(Reason.TOO_LONG, self.longest)
        if not text.strip():
            raise AnswerSyntaxError(Reason.EMPTY, 0)
        for place, char in enumerate(text):
            if unicodedata.category(char) in REFUSED and char not in ALLOWED:
                raise AnswerSyntaxError(Reason.BAD_CHARACTER, place, f"U+{ord(char):04X}")
        return text.strip().replace("\r\n", "\n")

    def check(self, answer: str, reference: object) -> Verdict:
        """Keep it: no program judges sentences."""
        return KEPT

    def show(self, reference: object) -> str:
        """Write what stands for a text in a sample."""
        return str(reference or "…")

    def samples(self, reference: object) -> Samples:
        """Give texts that are kept and texts that are unreadable."""
        return Samples((), (), ("", "  \n ", "a\u0000b", "a\u202eb", "x" * (self.longest + 1)))

    def echo(self, answer: str, comma: bool = False) -> Echo:
        """Say what was read."""
        return Echo("", answer)

    def carried(self, answer: str) -> None:
        """Nothing is solved from a text."""

    def apart(self, one: object, other: object) -> float:
        """Two texts are not compared."""
        return 0.0

    def describe(self) -> Mapping[str, Any]:
        """Give the greatest length."""
        return {"longest": self.longest}
