"""Judge of several choices among named options."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.symbols import Symbols
from graders.options import NONE, items, letter_of, listed, option_named
from graders.verdict import RIGHT, Code, Verdict, wrong


@dataclass(frozen=True, slots=True)
class Choices:
    """All options that apply, in any order: `a; c`. The reference names them, parted by `;`, and may be empty.

    The score is the share of the right options that are named less the share of the wrong ones that are, at least 0:
    naming all, or any at random, earns nothing.
    """

    options: tuple[str, ...]
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "choices"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> frozenset[str]:
        """Read `a; c`, `a, c`, `ac`, names of options, or `-` where none applies; raises AnswerSyntaxError."""
        typed = text[:40].rpartition("=")[2].strip()
        if typed.lower() in NONE and option_named(typed, self.options) is None:
            return frozenset()
        return frozenset(items(text, self.options))

    def check(self, answer: frozenset[str], reference: str) -> Verdict:
        """Judge each option; what is named without reason takes away."""
        expected = frozenset(listed(reference))
        if answer == expected:
            return RIGHT
        others = len(self.options) - len(expected)
        score = len(answer & expected) / (len(expected) or 1) - len(answer - expected) / (others or 1)
        return Verdict(score, Code.SOME_ITEMS) if score > 1e-9 else wrong()

    def show(self, reference: str) -> str:
        """Write the names of the options that apply."""
        return "; ".join(self._in_order(listed(reference))) or NONE[0]

    def _in_order(self, chosen: frozenset[str] | list[str]) -> list[str]:
        return [option for option in self.options if option in chosen]

    def samples(self, reference: str) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        chosen = self._in_order(listed(reference))
        letters = [letter_of(option, self.options) for option in chosen]
        right = (self.show(reference), ", ".join(reversed(letters)), "".join(letters)) if chosen else ("-", " none ")
        others = [option for option in self.options if option not in chosen]
        wrong_ones = ("; ".join(others) or "-", "; ".join(self.options) if others else "-")
        return Samples(right, wrong_ones, ("", "?", f"{self.options[0]}; zz", "a; a"))

    def echo(self, answer: frozenset[str], comma: bool = False) -> Echo:
        """Say which options were read."""
        return Echo("", "; ".join(self._in_order(answer)) or NONE[0])

    def carried(self, answer: frozenset[str]) -> str:
        """Give the options, parted by `;`."""
        return "; ".join(self._in_order(answer))

    def apart(self, one: str, other: str) -> float:
        """Two selections are the same or far apart."""
        return 0.0 if set(listed(one)) == set(listed(other)) else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the options in their order."""
        return {"options": list(self.options), "several": True}
