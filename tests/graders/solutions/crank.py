"""The offset slider-crank as the judges of equations see it (domain VP-3)."""

from __future__ import annotations

from math import pi
from typing import Any

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


def surprises(judge: Grader, reference: Any, symbols: Symbols) -> list[str]:
    """Give what a judge says otherwise than it promises of its own samples, its echo and its description."""
    samples, shown = judge.samples(reference), judge.show(reference)
    echo = judge.echo(judge.parse(shown, symbols))
    return [
        *(f"wrong: {text}" for text in (*samples.right, shown) if not _right(judge, text, reference, symbols)),
        *(f"right: {text}" for text in samples.wrong if _right(judge, text, reference, symbols)),
        *(f"readable: {text}" for text in samples.unreadable if _readable(judge, text, symbols)),
        *([] if echo.mathml.startswith("<math>") and judge.parse(echo.text, symbols) else [f"echo: {echo}"]),
        *([] if judge.apart(reference, reference) == 0 else [f"apart from itself: {shown}"]),
        *([] if judge.carried(judge.parse(shown, symbols)) is None else [f"carried: {shown}"]),
    ]


def _right(judge: Grader, text: str, reference: Any, symbols: Symbols) -> bool:
    return verdict(judge, text, reference, symbols).code is Code.RIGHT


def _readable(judge: Grader, text: str, symbols: Symbols) -> bool:
    try:
        judge.parse(text, symbols)
    except AnswerSyntaxError:
        return False
    return True
