"""Judge of differentiated polygon equations: velocities or accelerations, beside the student's own polygon."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graders.judge import Echo, Samples
from graders.language.symbols import Symbols
from graders.polygon.drawn import equation_lines, sheet
from graders.polygon.mechanism import Mechanism
from graders.polygon.rates import Differentiated, read_rates, verdict
from graders.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Rates:
    """The projections of a polygon, differentiated once (velocities) or twice (accelerations).

    Args:
        beside: The answer that holds the polygon; its names are understood here.
        order: 1 for velocities, 2 for accelerations.
        step: The step of the first unknown rate.
        weight: Share in the score.
    """

    beside: str
    order: int
    step: str
    weight: float = 1.0
    kind: ClassVar[str] = "rates"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Differentiated:
        """Read the equations; raises AnswerSyntaxError."""
        return read_rates(text, symbols)

    def check(self, answer: Differentiated, reference: Mechanism) -> Verdict:
        """Judge by the true motion; a slip is named by what the polygon's derivative should hold."""
        return verdict(answer, reference, self.order)

    def show(self, reference: Mechanism) -> str:
        """Write the equations of the polygon that `Polygon` shows."""
        return reference.velocity if self.order == 1 else reference.acceleration

    def samples(self, reference: Mechanism) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        text = self.show(reference)
        backwards = "\n".join(reversed(text.splitlines()))
        first = text.splitlines()[0]
        return Samples((text, backwards), (first, text.replace("cos", "sin")), ("", "x: 1 +", "x: l1", "1 = 2 = 3"))

    def echo(self, answer: Differentiated, comma: bool = False) -> Echo:
        """Show every equation as it was read."""
        said = [(f"{name} = {rate}", f"<mtext>{name} = {rate}</mtext>") for name, rate in answer.said]
        return Echo(*sheet(iter([*equation_lines(answer.equations, comma), *said])))

    def carried(self, answer: Differentiated) -> None:
        """Equations replace no step."""
        return

    def apart(self, one: Mechanism, other: Mechanism) -> float:
        """Two mechanisms are the same or far apart."""
        return 0.0 if self.show(one) == self.show(other) else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give how often the projections are to be differentiated."""
        return {"order": self.order}
