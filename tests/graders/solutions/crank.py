"""The offset slider-crank as the judges of equations see it (domain VP-3)."""

from __future__ import annotations

from math import pi
from typing import Any

import pytest

from graders import AnswerSyntaxError, Code, Domain, Formula, Grader, States, Symbols, Verdict
from graders.language import parse_line
from graders.states import drawn

BOX = {"l1": Domain(0.04, 0.12), "l2": Domain(0.2, 0.6), "h": Domain(0.01, 0.05), "alpha1": Domain(0.0, 2 * pi)}
ROD = ("alpha2", parse_line("asin((h - l1*sin(alpha1))/l2)"))
STATES: States = drawn(BOX, b"crank", lambda point: True)
ALPHA2 = Formula(ROD[1], STATES)
L3 = Formula(parse_line("l1*cos(alpha1) + l2*cos(alpha2)"), drawn(BOX, b"crank", lambda point: True, (ROD,)))
GIVEN = Symbols(tuple(BOX), ("alpha2", "l3"))
WITH_ROD = Symbols((*BOX, "alpha2"), ("l3",))


def verdict(judge: Grader, text: str, reference: Formula, symbols: Symbols) -> Verdict:
    found: Verdict = judge.check(judge.parse(text, symbols), reference)
    return found


def passes_its_samples(judge: Grader, reference: Any, symbols: Symbols) -> None:
    """Hold a judge to its own samples, its echo and its description."""
    samples = judge.samples(reference)
    for text in (*samples.right, judge.show(reference)):
        assert verdict(judge, text, reference, symbols).code is Code.RIGHT, text
    for text in samples.wrong:
        assert verdict(judge, text, reference, symbols).code is not Code.RIGHT, text
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            judge.parse(text, symbols)
    echo = judge.echo(judge.parse(judge.show(reference), symbols))
    assert echo.mathml.startswith("<math>") and judge.parse(echo.text, symbols)
    assert judge.apart(reference, reference) == 0
    assert judge.carried(judge.parse(judge.show(reference), symbols)) is None
