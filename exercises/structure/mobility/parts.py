"""The parts of a drawn mechanism; each owns what it adds to the counts (domain STR-3, STR-4)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from exercises.exercise import option

Place: TypeAlias = Literal["joint", "link"]
DyadType: TypeAlias = Literal["rocker_down", "rocker_up", "slider_level", "slider_upright", "swing"]


@dataclass(frozen=True, slots=True)
class Counts:
    """What a part adds: moving links, revolute pairs besides that of its attachment, guides, contacts, free spins."""

    links: int
    revolutes: int
    guides: int = 0
    contacts: int = 0
    spins: int = 0

    @property
    def p5(self) -> int:
        """Pairs of class 5, the attachment not counted."""
        return self.revolutes + self.guides


@dataclass(frozen=True, slots=True)
class Start:
    """What turns first: a crank, a cam with a lever (with a roller or without), or two gears."""

    type: Literal["crank", "cam", "roller", "gears"] = option("crank", "cam", "roller", "gears")


@dataclass(frozen=True, slots=True)
class Dyad:
    """Two links: a rocker on its rod, a slider on its rod, or a block that slides along a rocker."""

    type: DyadType = option("rocker_down", "rocker_up", "slider_level", "slider_upright", "swing")
    place: Place = option("joint", "link")  # attached at the last joint, or at a joint of its own on the last link


@dataclass(frozen=True, slots=True)
class Triad:
    """Three links in a row to a pivot of the frame: one freedom more."""

    type: Literal["down", "up"] = option("down", "up")
    place: Place = option("joint", "link")


@dataclass(frozen=True, slots=True)
class Strut:
    """A single bar to a pivot of the frame: one freedom less."""

    place: Place = option("joint", "link")


Part: TypeAlias = Start | Dyad | Triad | Strut

STARTS = {
    "crank": Counts(1, 1),
    "cam": Counts(2, 2, contacts=1),
    "roller": Counts(3, 3, contacts=1, spins=1),
    "gears": Counts(2, 2, contacts=1),
}
DYADS = {
    "rocker_down": Counts(2, 2),
    "rocker_up": Counts(2, 2),
    "slider_level": Counts(2, 1, guides=1),
    "slider_upright": Counts(2, 1, guides=1),
    "swing": Counts(2, 1, guides=1),
}


def counts(part: Part) -> Counts:
    """Give what a part adds."""
    match part:
        case Start(type=kind):
            return STARTS[kind]
        case Dyad(type=kind):
            return DYADS[kind]
        case Triad():
            return Counts(3, 3)
        case Strut():
            return Counts(1, 1)


def attached(parts: Sequence[Part]) -> Sequence[Dyad | Triad | Strut]:
    """Give the parts that hang on others: all but the first."""
    return [part for part in parts if not isinstance(part, Start)]


def double_joints(parts: Sequence[Part]) -> int:
    """Count the attachments at a joint that is there already: each makes it a joint of one link more."""
    return sum(part.place == "joint" for part in attached(parts))


def summed(parts: Sequence[Part], what: str) -> str:
    """Write the sum of what the parts add, as a student writes it."""
    return " + ".join(str(number) for number in _numbers(parts, what)) or "0"


def _numbers(parts: Sequence[Part], what: str) -> Iterator[int]:
    for part in parts:
        number = getattr(counts(part), what)
        if what in ("p5", "revolutes"):
            number += not isinstance(part, Start)  # its attachment
        if number:
            yield number
