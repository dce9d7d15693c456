"""Judge of one choice among named options."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols
from graders.options import LONGEST, letter_of, option_named
from graders.verdict import RIGHT, Verdict, wrong


@dataclass(frozen=True, slots=True)
class Choice:
    """One of the options; typed as its letter (a, b, …) or its name."""

    options: tuple[str, ...]
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "choice"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> str:
        """Read a letter or the name of an option, `b`, `b)`, `(b)` or `sense = b`; raises AnswerSyntaxError."""
        if len(text) > LONGEST:
            raise AnswerSyntaxError(Reason.TOO_LONG, LONGEST)
        typed = text.rpartition("=")[2].strip().strip("().").strip()
        if not typed:
            raise AnswerSyntaxError(Reason.EMPTY, 0)
        option = option_named(typed, self.options)
        if option is None:
            raise AnswerSyntaxError(Reason.NOT_A_CHOICE, max(0, text.rfind(typed)), typed[:20])
        return option

    def check(self, answer: str, reference: str) -> Verdict:
        """Judge exactly."""
        return RIGHT if answer == reference else wrong()

    def show(self, reference: str) -> str:
        """Write the option's name."""
        return reference

    def samples(self, reference: str) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        letter = letter_of(reference, self.options)
        return Samples(
            (reference, letter, f" {letter}) "), tuple(o for o in self.options if o != reference), ("", "?", "zz")
        )

    def echo(self, answer: str, comma: bool = False) -> Echo:
        """Say which option was read."""
        return Echo("", answer)

    def carried(self, answer: str) -> str:
        """Give the option."""
        return answer

    def apart(self, one: str, other: str) -> float:
        """Two options are the same or far apart."""
        return 0.0 if one == other else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the options in their order."""
        return {"options": list(self.options)}
