"""Judge of a vector polygon: any valid choice of vectors, signs and order is right; there is no key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.symbols import Symbols
from graders.polygon.checking import verdict
from graders.polygon.drawn import Drawn, sheet
from graders.polygon.mechanism import Mechanism
from graders.polygon.reading import read_polygon
from graders.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Polygon:
    """A polygon between the nodes of a mechanism, with closure, projections and unknowns.

    Its reference is a `Mechanism`, made by the exercise in `references`.

    Args:
        nodes: The letters of the nodes in the figure.
        step: The step of the first unknown; givens and the steps before it keep their names.
        weight: Share in the score.
    """

    nodes: tuple[str, ...]
    step: str
    weight: float = 1.0
    kind: ClassVar[str] = "polygon"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Drawn:
        """Read the lines of a polygon; raises AnswerSyntaxError."""
        return read_polygon(text, symbols, self.nodes)

    def check(self, answer: Drawn, reference: Mechanism) -> Verdict:
        """Judge vectors, closure, projections and unknowns by the true motion of the mechanism."""
        return verdict(answer, reference)

    def show(self, reference: Mechanism) -> str:
        """Write a polygon that is right."""
        return reference.polygon

    def samples(self, reference: Mechanism) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        text = reference.polygon
        backwards = "\n".join(reversed(text.splitlines()))
        right = (text, backwards, text.replace(" > ", " → "), "; ".join(text.splitlines()))
        rest = "\n".join(line for line in text.splitlines() if not line.startswith("unknowns"))
        return Samples(right, (rest, text.replace("cos", "sin")), ("", "a: A > ?, length 1, angle 0", "x: 1 = 1"))

    def echo(self, answer: Drawn, comma: bool = False) -> Echo:
        """Show every line as it was read."""
        return Echo(*sheet(answer.lines(comma)))

    def carried(self, answer: Drawn) -> None:
        """A polygon replaces no step; a judge of its derivatives is handed it whole."""
        return

    def apart(self, one: Mechanism, other: Mechanism) -> float:
        """Two mechanisms are the same or far apart."""
        return 0.0 if one.polygon == other.polygon else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give the nodes between which vectors may be drawn."""
        return {"nodes": list(self.nodes)}
