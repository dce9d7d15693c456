"""The elastic line of the beam, joined from the lines of its supports and loads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exercises.exercise import Steps, each
from exercises.strength._beam.lines import added, supported

if TYPE_CHECKING:
    from exercises.strength.simple_beam import Givens


def elastic_line(givens: Givens) -> Steps:
    """E I v = f(x) + C x + D, with f from M integrated twice; v = 0 at A and at B gives C and D (SM-14)."""
    A, B, span = supported(givens)
    f_B = added(each(givens.supports[:1], lambda s: s.sag, B) + each(givens.loads, lambda load: load.sag, B))
    f_K = added(each(givens, lambda member: member.sag, "x_K"))
    if A == "0":
        return {"f_B": f_B, "C": f"-f_B/{B}", "v_K": f"({f_K} + C*x_K)/(E*I)"}
    f_A = added(each(givens.loads, lambda load: load.sag, A))
    return {
        "f_A": f_A,
        "f_B": f_B,
        "C": f"(f_A - f_B)/{span}",
        "D": f"-f_A - C*{A}",
        "v_K": f"({f_K} + C*x_K + D)/(E*I)",
    }
