"""Lines of the solution of a beam, joined from the lines of its supports and loads, and the slips made in them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from exercises.exercise import Steps, each
from exercises.strength._beam.members import Load, Loaded, Uniform

NO_SLIP: Mapping[type[Load], str] = {}


def supported(givens: Loaded) -> tuple[str, str, str]:
    """Write the places of A and B and the distance between them."""
    A, B = each(givens.supports, lambda support: support.place)
    return A, B, B if A == "0" else f"({B} - {A})"


def added(lines: Iterable[str]) -> str:
    """Write the sum of the lines that are not empty."""
    return " + ".join(line for line in lines if line).replace("+ -", "- ")


def reaction(givens: Loaded, turns: Mapping[type[Load], str] = NO_SLIP) -> str:
    """Write R_A from the sum of moments about B; a slip turns some kind of load in another way."""
    _, B, span = supported(givens)
    return f"({added(each(givens.loads, lambda load: turns.get(type(load), load.turn), B))})/{span}"


def other_reaction(givens: Loaded) -> Steps:
    """R_B from the sum of moments about A, written for R_A."""
    A, _, span = supported(givens)
    return {"R_A": f"-({added(each(givens.loads, lambda load: load.turn, A))})/{span}"}


def slipped(givens: Loaded, turns: Mapping[type[Load], str]) -> Steps:
    """The slip has no occasion where no such load acts."""
    return {"R_A": reaction(givens, turns)} if any(type(load) in turns for load in givens.loads) else {}


def half_beam(givens: Loaded) -> Steps:
    """The resultant of q at half-length of the beam; no occasion where it is nearly there."""
    (load,) = (load for load in givens.loads if isinstance(load, Uniform))
    if abs(load.a + load.c - givens.L) < 0.1 * givens.L:
        return {}
    return slipped(givens, {Uniform: "q{i}*(c{i} - a{i})*({x} - L/2)"})


def whole_length(givens: Loaded) -> Steps:
    """The length of the beam for the distance of the supports; no occasion without an overhang."""
    span = supported(givens)[2]
    return {"R_A": reaction(givens).removesuffix(span) + "L"} if span != "L" else {}
