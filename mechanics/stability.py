"""Whether the supports of a beam hold it, decided from places alone, before any equation is solved (domain SM-11)."""

from __future__ import annotations

from mechanics.errors import UnstableError
from mechanics.members import CLOSE, Beam


def degree(beam: Beam) -> int:
    """Return the degree of static indeterminacy: reactions less equilibrium equations and hinges."""
    moments = [support.type for support in beam.supports].count("fixed")
    return len(beam.supports) + moments - 2 - len(beam.hinges)


def require_stable(beam: Beam) -> None:
    """Follow the rigid-body freedom of the beam from left to right.

    The part under way is held, or can turn about one point (its pole), or can move in both ways. A support takes a
    freedom, unless it stands in the pole; a hinge gives one. What a hinge hides for good is unstable, and so is what
    is left at the right end.

    Raises:
        UnstableError: A part can move; the message names it. A hinge or support that misses the pole by less than
            a millionth of the length counts as being in it.
    """
    freedom, pole, near = 2, 0.0, CLOSE * beam.L
    stations: list[tuple[float, int, str]] = [(support.x, 0, support.type) for support in beam.supports]
    if beam.hinges:
        stations += [(x, 1, "hinge") for x in beam.hinges]
    for x, _, kind in sorted(stations):
        if kind == "hinge":
            _require_held_left(x, freedom, pole if abs(pole - x) >= near else x)
            freedom, pole = (1, x) if freedom == 0 else (2, x)
        elif kind == "fixed":
            freedom = 0
        elif freedom == 2:
            freedom, pole = 1, x
        elif abs(pole - x) >= near:
            freedom = 0
    _require_held_right(beam, freedom, pole)


def _require_held_left(hinge: float, freedom: int, pole: float) -> None:
    if freedom == 2:
        raise UnstableError(f"unstable beam: the part left of the hinge at x = {hinge} m has too few supports")
    if freedom == 1 and pole == hinge:
        raise UnstableError(f"unstable beam: the part left of the hinge at x = {hinge} m can turn about that point")


def _require_held_right(beam: Beam, freedom: int, pole: float) -> None:
    part = f"the part right of the hinge at x = {max(beam.hinges)} m" if beam.hinges else "the beam"
    if freedom == 2:
        raise UnstableError(f"unstable beam: {part} can move up and down and turn, it has too few supports")
    if freedom == 1:
        raise UnstableError(f"unstable beam: {part} can turn about the point x = {pole} m, it has too few supports")
