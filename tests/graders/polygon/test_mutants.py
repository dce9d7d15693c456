"""Right texts with pieces lost, doubled and exchanged: read or refused, judged, and never right by accident."""

from __future__ import annotations

from random import Random

import pytest

from graders import AnswerSyntaxError, Code, Symbols
from graders.kinds.polygon import Polygon
from graders.kinds.rates import Rates
from graders.polygon.mechanism import Mechanism
from graders.verdict import Flaws
from graders.words import LANGUAGES, message
from tests.depth import amount
from tests.graders.polygon.mechanisms import FOUR_BAR, ROCKING, SLIDER, TWO_LOOPS

PIECES = ["+", "-", "*", "=", "0", "2", "l1", "l2", "alpha1", "alpha2", "cos(", "sin(", ")", ",", ";", ":", "A", "B",
          ">", "\n", "pi", "length", "angle", "x", "closure", "1/0", "^", "omega2", "_d"]  # fmt: skip


def mutant(text: str, rng: Random) -> str:
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(text))
        to = min(len(text), at + rng.randint(0, 6))
        text = text[:at] + rng.choice(["", "", text[at:to] * 2, rng.choice(PIECES)]) + text[to:]
    return text


@pytest.mark.parametrize("mechanism", [SLIDER, ROCKING, FOUR_BAR, TWO_LOOPS])
def test_every_mutant_is_judged_or_refused(mechanism: Mechanism) -> None:
    rng, symbols = Random(7), Symbols(mechanism.states()[0].names)
    grader, judged = Polygon(mechanism.nodes, "alpha2"), 0
    for _ in range(amount(50, 150)):
        try:
            drawn = grader.parse(mutant(mechanism.polygon, rng), symbols)
        except AnswerSyntaxError:
            continue
        verdict = grader.check(drawn, mechanism)
        judged += 1
        assert 0 <= verdict.score <= 1
        assert (verdict.code is Code.RIGHT) == (verdict.score == 1)
        assert verdict.details is None or (
            isinstance(verdict.details, Flaws) and message(verdict, LANGUAGES[judged % 3])
        )
        for order in (1, 2):
            rates = Rates("polygon", order, "omega2")
            if rates.show(mechanism):
                typed = rates.parse(rates.show(mechanism), symbols)
                assert 0 <= rates.check(typed, mechanism.beside(drawn)).score <= 1
    assert judged > amount(6, 20)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("mechanism", [SLIDER, ROCKING])
def test_every_mutant_of_a_derivative_is_judged_or_refused(mechanism: Mechanism, order: int) -> None:
    rng, symbols = Random(11), Symbols(mechanism.states()[0].names)
    rates, judged = Rates("polygon", order, "omega2"), 0
    for _ in range(amount(50, 150)):
        try:
            typed = rates.parse(mutant(rates.show(mechanism), rng), symbols)
        except AnswerSyntaxError:
            continue
        verdict = rates.check(typed, mechanism)
        judged += 1
        assert 0 <= verdict.score <= 1
        assert (verdict.code is Code.RIGHT) == (verdict.score == 1)
    assert judged > amount(6, 20)
