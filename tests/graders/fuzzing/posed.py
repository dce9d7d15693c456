"""Judges of kinds that no exercise of the catalogue asks for yet, with their references and symbols."""

from __future__ import annotations

from math import pi
from typing import Any

from graders import Domain, Equation, Formula, Grader, Inequality, SymbolicMatrix, Symbols, System
from graders.language import parse_line
from graders.states import drawn, spread

LENGTHS = {"l1": Domain(0.04, 0.12), "l2": Domain(0.2, 0.6), "h": Domain(0.01, 0.05)}
CRANK = {**LENGTHS, "alpha1": Domain(0.0, 2 * pi)}
ROD = parse_line("asin((h - l1*sin(alpha1))/l2)")
SLIDER = parse_line("l1*cos(alpha1) + l2*cos(alpha2)")
CLOSURE = ("l1*cos(alpha1) + l2*cos(alpha2) = l3", "l1*sin(alpha1) + l2*sin(alpha2) = h")
ARM = {"q1": Domain(-3, 3), "q2": Domain(-3, 3), "a1": Domain(0.2, 0.6)}
TURN = "[[cos(q1 + q2); -sin(q1 + q2); a1*cos(q1)], [sin(q1 + q2); cos(q1 + q2); a1*sin(q1)], [0; 0; 1]]"


def posed() -> list[tuple[Grader, Any, Symbols]]:
    """Give an equation, a system, an inequality and a matrix of formulas."""
    given, with_rod = drawn(CRANK, b"crank", _any), drawn(CRANK, b"crank", _any, (("alpha2", ROD),))
    asked = Symbols(CRANK, ("alpha2", "l3"))
    return [
        (Equation("alpha2", (-1.2, 1.2), CLOSURE[1]), Formula(ROD, given), asked),
        (Equation("alpha2", (-pi, pi), CLOSURE[1]), Formula(ROD, given), asked),
        (System(("alpha2", "l3"), ((-1.2, 1.2), (0.0, 0.8)), CLOSURE), Formula(SLIDER, with_rod), asked),
        (
            Inequality("l1 + h <= l2", "margin"),
            Formula(parse_line("l2 - l1 - h"), drawn(LENGTHS, b"turning", _any)),
            Symbols(LENGTHS, ("margin",)),
        ),
        (SymbolicMatrix("T", 3, 3), Formula(parse_line(TURN), spread(ARM, b"matrix")), Symbols(ARM, ("T",))),
    ]


def _any(_: object) -> bool:
    return True
