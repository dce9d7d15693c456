"""The train from the side, in the proportion of its teeth."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from exercises.transmissions.planetary.wheels import Ring
from figures import planetary
from figures.picture import Picture, Table, Words

if TYPE_CHECKING:
    from exercises.transmissions.planetary import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the wheels, the carrier, the held wheel and the names of the speeds of driver and driven."""
    z = [wheel.z for wheel in givens.wheels]
    names = tuple(f"z{number}" for number in range(1, len(z) + 1))
    wheels = planetary.Wheels(
        names, z[0], z[1], z[2] if len(z) == 4 else None, z[-1], isinstance(givens.wheels[-1], Ring)
    )
    rows = tuple(
        (name, str(wheel.z), words["kinds"][type(wheel).__name__])
        for name, wheel in zip(names, givens.wheels, strict=True)
    )
    said = Words(words["title"], words["description"], Table(tuple(words["header"]), rows))
    free = "n_in" if givens.driver == "wheel" else "n_out"
    carrier = "n_out" if givens.driver == "wheel" else "n_in"
    speeds = ("", free, carrier) if givens.held == "first" else (free, "", carrier)
    return planetary.draw("planetary", said, wheels, givens.held, speeds)
