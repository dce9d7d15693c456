"""Known slips in reactions and diagrams; a slip without occasion in a variant gives no lines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from exercises.exercise import Steps, each
from exercises.strength._beam import lines
from exercises.strength._beam.members import OPPOSITE, ClampedLeft, ClampedRight, Load, Uniform, structure
from exercises.strength._beam.profile import moment_rows, shear_rows
from exercises.strength.beam_diagrams.curves import curves, supported, walled
from mechanics import members

if TYPE_CHECKING:
    from exercises.strength.beam_diagrams import Givens

HALF_BEAM: Mapping[type[Load], str] = {Uniform: "q{i}*(c{i} - a{i})*({x} - L/2)"}


def turned(givens: Givens, turns: Mapping[type[Load], str]) -> Steps:
    """Write the moment equation with some kind of load turning in another way."""
    if not any(type(load) in turns for load in givens.loads):
        return {}
    match givens.supports:
        case (ClampedLeft(),):
            return {"M_A": lines.added(each(givens.loads, lambda load: turns.get(type(load), load.turn), "0"))}
        case (ClampedRight(),):
            sum_ = lines.added(each(givens.loads, lambda load: turns.get(type(load), load.turn), "L"))
            return {"M_B": f"-({sum_})"}
        case _:
            return {"R_A": lines.reaction(givens, turns)}


def half_beam(givens: Givens) -> Steps:
    """The resultant of q at half-length of the beam; no occasion where it is nearly there."""
    loads = [load for load in givens.loads if isinstance(load, Uniform)]
    off = all(abs(load.a + load.c - givens.L) > 0.1 * givens.L for load in loads)
    return turned(givens, HALF_BEAM) if off else {}


def couple_sense(givens: Givens) -> Steps:
    """A couple taken in the opposite sense in the moment equation."""
    return turned(givens, OPPOSITE)


def reactions_exchanged(givens: Givens) -> Steps:
    """R_B for R_A; a wall has one reaction only."""
    return lines.other_reaction(givens) if len(givens.supports) == 2 else {}


def resultant_drawn(givens: Givens) -> Steps:
    """The uniform load replaced by its resultant in the diagrams, not only in the reactions."""
    return curves(givens, tuple(_concentrated(load) for load in structure(givens).loads))


def _concentrated(load: members.Load) -> members.Load:
    if isinstance(load, members.Distributed):
        return members.Force((load.x1 + load.x2) / 2, load.w1 * (load.x2 - load.x1))
    return load


def couple_jump_lost(givens: Givens) -> Steps:
    """M drawn without the jumps at couples."""
    loads = structure(givens).loads
    kept = tuple(load for load in loads if not isinstance(load, members.Moment))
    return {"M": curves(givens, kept)["M"]} if len(kept) < len(loads) else {}


def wall_moment_lost(givens: Givens) -> Steps:
    """M begins at zero, though the wall bends the beam."""
    loads = structure(givens).loads
    if not isinstance(givens.supports[0], ClampedLeft):
        return {}
    return {"M": lambda R_A: moment_rows(walled(givens, loads, R_A, 0.0))}


def opposite_shear(givens: Givens) -> Steps:
    """V from the right part with the signs of the left one."""
    loads = tuple(_turned_round(load) for load in structure(givens).loads)
    match givens.supports:
        case (ClampedLeft(),):
            return {"V": lambda R_A: shear_rows(walled(givens, loads, -R_A, 0.0))}
        case (ClampedRight(),):
            return {"V": lambda: shear_rows(walled(givens, loads, 0.0, 0.0))}
        case _:
            return {"V": lambda R_A, R_B: shear_rows(supported(givens, loads, -R_A, -R_B))}


def opposite_moment(givens: Givens) -> Steps:
    """M positive where the upper fibres are stretched."""
    loads = tuple(_turned_round(load) for load in structure(givens).loads)
    match givens.supports:
        case (ClampedLeft(),):
            return {"M": lambda R_A, M_A: moment_rows(walled(givens, loads, -R_A, -M_A))}
        case (ClampedRight(),):
            return {"M": lambda: moment_rows(walled(givens, loads, 0.0, 0.0))}
        case _:
            return {"M": lambda R_A, R_B: moment_rows(supported(givens, loads, -R_A, -R_B))}


def _turned_round(load: members.Load) -> members.Load:
    match load:
        case members.Force(x=x, F=F):
            return members.Force(x, -F)
        case members.Moment(x=x, M=M):
            return members.Moment(x, -M)
        case members.Distributed(x1=start, x2=end, w1=first, w2=last):
            return members.Distributed(start, end, -first, -last)
