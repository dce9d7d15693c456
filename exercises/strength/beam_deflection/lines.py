"""The lines of M(x) and v(x), joined from the lines of the supports and loads."""

from __future__ import annotations

from exercises.exercise import each
from exercises.strength._beam.lines import added
from exercises.strength._beam.members import Loaded


def bending(givens: Loaded) -> str:
    """M from the left part, with brackets."""
    return added(each(givens, lambda member: member.moment))


def deflection(givens: Loaded, x: str) -> str:
    """v from EI v'' = M, with the constant C (SM-14)."""
    return f"({added(each(givens, lambda member: member.sag, x))} + C*{x})/EI"
