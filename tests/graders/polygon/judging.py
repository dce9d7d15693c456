"""A polygon and what its judge says of it."""

from __future__ import annotations

from graders import Symbols
from graders.kinds.polygon import Polygon
from graders.polygon.mechanism import Mechanism
from graders.verdict import Verdict
from tests.graders.polygon.mechanisms import FOUR_BAR, OFFSET, ROCKING, SLIDER, TWO_LOOPS

STANDARD = {"slider": SLIDER, "offset": OFFSET, "rocking": ROCKING, "four bar": FOUR_BAR, "two loops": TWO_LOOPS}


def judged(text: str, mechanism: Mechanism = SLIDER) -> Verdict:
    known = list(mechanism.states()[0].names)
    grader = Polygon(mechanism.nodes, "alpha2")
    return grader.check(grader.parse(text, Symbols(known, [*known, "alpha2", "l3"])), mechanism)
