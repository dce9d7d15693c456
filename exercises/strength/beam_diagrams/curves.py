"""V and M of the beam from its reactions: what the supports change, and the curves of some loads."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from exercises.exercise import Steps
from exercises.strength._beam.members import ClampedLeft, ClampedRight, places
from exercises.strength._beam.profile import Stretch, moment_rows, shear_rows, stretches
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.beam_diagrams import Givens

Loads = Sequence[members.Load]


def curves(givens: Givens, loads: Loads) -> Steps:
    """Give the lines of V and M under some loads; a wall at the right end is not needed for them."""
    match givens.supports:
        case (ClampedLeft(),):
            return {
                "V": lambda R_A, M_A: shear_rows(walled(givens, loads, R_A, M_A)),
                "M": lambda R_A, M_A: moment_rows(walled(givens, loads, R_A, M_A)),
            }
        case (ClampedRight(),):
            return {
                "V": lambda: shear_rows(walled(givens, loads, 0.0, 0.0)),
                "M": lambda: moment_rows(walled(givens, loads, 0.0, 0.0)),
            }
        case _:
            return {
                "V": lambda R_A, R_B: shear_rows(supported(givens, loads, R_A, R_B)),
                "M": lambda R_A, R_B: moment_rows(supported(givens, loads, R_A, R_B)),
            }


def walled(givens: Givens, loads: Loads, R_A: float, M_A: float) -> list[Stretch]:
    """Carry V and M from the left end, where a wall may hold the beam."""
    return stretches(givens.L, [(0.0, R_A, M_A, 0.0)], loads)


def supported(givens: Givens, loads: Loads, R_A: float, R_B: float) -> list[Stretch]:
    """Carry V and M over both supports."""
    A, B = places(givens)
    return stretches(givens.L, [(A, R_A, 0.0, 0.0), (B, R_B, 0.0, 0.0)], loads)
