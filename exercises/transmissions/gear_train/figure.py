"""The train from the side: axes, wheels and meshes; the size of a sought wheel is not shown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from exercises.transmissions.gear_train.wheels import Coaxial, Coupled, Input, Mesh, Wheel
from figures import gear_train
from figures.picture import Picture, Table, Words

if TYPE_CHECKING:
    from exercises.transmissions.gear_train import Givens

SHAFTS = ("I", "II", "III", "IV", "V")
SCHEMATIC = {"external": (22, 38, 20, 40), "internal": (22, 38, 20, 80)}  # coaxial, whatever the teeth


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the train, wheels in the proportion of their given teeth, a coaxial train in fixed proportions."""
    drawn = [gear_train.Wheel(f"z{i}", size) for i, size in enumerate(_sizes(givens.wheels), 1)]
    meshes = [
        gear_train.Mesh(drawn[at - 1], drawn[at], wheel.type)
        for at, wheel in enumerate(givens.wheels)
        if isinstance(wheel, Mesh | Coaxial)
    ]
    table = Table(tuple(words["header"]), tuple(_rows(givens.wheels, words)))
    said = Words(words["title"], words["description"], table)
    return gear_train.draw("gear-train", said, meshes, SHAFTS[: len(meshes) + 1], ("n_in", "n_out"), "+")


def _sizes(wheels: Sequence[Wheel]) -> Sequence[int]:
    last = wheels[-1]
    if isinstance(last, Coaxial):
        return SCHEMATIC[last.type]
    return [wheel.z for wheel in wheels if not isinstance(wheel, Coaxial)]


def _rows(wheels: Sequence[Wheel], words: Mapping[str, Any]) -> Iterator[tuple[str, ...]]:
    """Wheel, its teeth, its shaft, and the wheel it is driven by."""
    shaft = -1
    for number, wheel in enumerate(wheels, 1):
        shaft += not isinstance(wheel, Coupled)
        mesh = "–" if isinstance(wheel, Input | Coupled) else f"z{number - 1}, {words['kinds'][wheel.type]}"
        size = words["sought"] if isinstance(wheel, Coaxial) else f"{wheel.z}"
        yield f"z{number}", size, SHAFTS[shaft], mesh
