"""A judge and what it says of a text; the speed of a rod as the formula to be found."""

from __future__ import annotations

from typing import Any

from graders import Code, Formula, Grader, States, Symbols
from graders.language import parse_line

NOTHING = Symbols(())
NAMES = ("l1", "l2", "alpha1", "omega1")
POINTS = tuple((0.04 + 0.01 * (k % 7), 0.2 + 0.02 * (k % 11), 0.37 + 0.383 * k, 5 + 2.1 * (k % 13)) for k in range(16))
STATES = States(NAMES, POINTS, (("alpha2", parse_line("-asin(l1*sin(alpha1)/l2)")),))
OMEGA2 = Formula(parse_line("-l1*omega1*cos(alpha1)/(l2*cos(alpha2))"), STATES)
SYMBOLS = Symbols([*NAMES, "alpha2"], ["omega2"])


def judged(grader: Grader, text: str, reference: Any, symbols: Symbols = NOTHING) -> Code:
    return grader.check(grader.parse(text, symbols), reference).code
