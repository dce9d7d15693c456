"""Judge of items put in order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.symbols import Symbols
from graders.options import items, letter_of, listed
from graders.verdict import RIGHT, Code, Verdict, wrong


@dataclass(frozen=True, slots=True)
class Ordering:
    """All options in the right order: `c; a; b`. The reference names them in order, parted by `;`.

    The score counts pairs in the right order less pairs in the wrong one, at least 0: an order at random earns
    nothing on the average.
    """

    options: tuple[str, ...]
    step: str = ""
    weight: float = 1.0
    kind: ClassVar[str] = "ordering"
    symbolic: ClassVar[bool] = False

    def parse(self, text: str, symbols: Symbols) -> tuple[str, ...]:
        """Read `c; a; b`, `c, a, b`, `c → a → b` or names of items, each once; raises AnswerSyntaxError."""
        found = items(text, self.options)
        for option in self.options:
            if option not in found:
                raise AnswerSyntaxError(Reason.MISSING_ITEM, len(text), letter_of(option, self.options))
        return tuple(found)

    def check(self, answer: tuple[str, ...], reference: str) -> Verdict:
        """Judge by pairs in order."""
        place = {option: at for at, option in enumerate(listed(reference))}
        pairs = [place[one] < place[other] for one, other in combinations(answer, 2)]
        if all(pairs):
            return RIGHT
        score = 2 * sum(pairs) / len(pairs) - 1
        return Verdict(score, Code.SOME_ITEMS) if score > 1e-9 else wrong()

    def show(self, reference: str) -> str:
        """Write the items in order."""
        return "; ".join(listed(reference))

    def samples(self, reference: str) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        order = listed(reference)
        letters = [letter_of(option, self.options) for option in order]
        right = (self.show(reference), ", ".join(letters), " -> ".join(letters))
        swapped = [*order[1::-1], *order[2:]]
        wrong_ones = ("; ".join(reversed(order)), "; ".join(swapped))
        return Samples(right, wrong_ones, ("", "?", order[0], f"{self.show(reference)}; {order[0]}"))

    def echo(self, answer: tuple[str, ...], comma: bool = False) -> Echo:
        """Say which order was read."""
        return Echo("", "; ".join(answer))

    def carried(self, answer: tuple[str, ...]) -> str:
        """Give the items in the order typed, parted by `;`."""
        return "; ".join(answer)

    def apart(self, one: str, other: str) -> float:
        """Two orders are the same or far apart."""
        return 0.0 if listed(one) == listed(other) else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the items in the order they are shown."""
        return {"options": list(self.options), "ordered": True}
