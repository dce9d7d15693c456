"""Known slips in M(x) and v(x); a slip without occasion in a variant gives no lines."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from exercises.exercise import Steps, each
from exercises.strength._beam.lines import added
from exercises.strength._beam.members import InsetB, Uniform
from exercises.strength.beam_deflection.lines import bending, deflection

if TYPE_CHECKING:
    from exercises.strength.beam_deflection import Givens

BRACKET = re.compile(r"macaulay\(([^;]+); (\d)\)")
END_OF_LOAD = re.compile(r"\((macaulay\([^;]+; \d\)) - macaulay\([^;]+; \d\)\)")


def open_brackets(givens: Givens) -> Steps:
    """Brackets multiplied out as if they were open from the start."""
    v = {name: BRACKET.sub(r"(\1)^\2", deflection(givens, x)) for name, x in (("v", "x"), ("v_m", "x_m"))}
    return {"M": BRACKET.sub(r"(\1)^\2", bending(givens)), **v}


def load_not_ended(givens: Givens) -> Steps:
    """The uniform load runs on to the end of the beam: its second bracket is lost."""
    if not any(isinstance(load, Uniform) for load in givens.loads):
        return {}
    v = {name: END_OF_LOAD.sub(r"\1", deflection(givens, x)) for name, x in (("v", "x"), ("v_m", "x_m"))}
    return {"M": END_OF_LOAD.sub(r"\1", bending(givens)), **v}


def constant_from_the_end(givens: Givens) -> Steps:
    """C from v = 0 at the free end; no occasion where B stands there."""
    if not isinstance(givens.supports[1], InsetB):
        return {}
    return {"f_B": added(each(givens, lambda member: member.sag, "L")), "C": "-f_B/L"}


def middle(givens: Givens) -> Steps:
    """The largest deflection taken half-way between the supports."""
    return {"x_m": givens.supports[1].place.replace("{i}", "2") + "/2"}


def positive_down(givens: Givens) -> Steps:
    """Deflection counted positive downwards."""
    return {"v": f"-{deflection(givens, 'x')}", "v_m": f"-{deflection(givens, 'x_m')}"}
