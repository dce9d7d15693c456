"""Which task of a form is which task of a set that was stored since: tasks carry no name, so they are told by their
exercises and their places."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

SLOT = "slot."
POOL = ".pool"
Fields = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Aligned:
    """A form with its tasks numbered as those of another one.

    Attributes:
        places: The new number of each task; those that the other one has not stand behind.
        gone: The new numbers of the tasks that the other one has not.
        new: The numbers of the tasks that only the other one has.
        moved: Whether the other one has other tasks, or the same in another order.
    """

    places: Mapping[int, int]
    gone: frozenset[int]
    new: frozenset[int]
    moved: bool

    def renumbered(self, fields: Fields) -> dict[str, str]:
        """Give the fields of a form with its tasks under their new numbers."""
        return {self._named(name): text for name, text in fields.items()}

    def _named(self, name: str) -> str:
        number = task_of(name)
        if number not in self.places:
            return name
        return ".".join((SLOT + str(self.places[number]), name.rpartition(".")[2]))


def task_of(name: str) -> int:
    """Give the number of the task that a field belongs to; 0 where it belongs to none."""
    number = name.removeprefix(SLOT).partition(".")[0]
    known = name.startswith(SLOT) and number.isascii() and number.isdecimal() and len(number) < 4
    return int(number) if known else 0


def aligned(loaded: Fields, stored: Fields) -> Aligned:
    """Find the tasks of a form among those of a set as it is stored now.

    Args:
        loaded: The form as it was loaded.
        stored: The form of the set as it is stored.
    """
    here, there = pools(loaded), pools(stored)
    places: dict[int, int] = {}
    for number, place in _pairs(here, there):
        if number not in places and place not in places.values():
            places[number] = place
    left = [number for number in here if number not in places]
    behind = {number: max(there, default=0) + at for at, number in enumerate(left, 1)}
    new = frozenset(there) - frozenset(places.values())
    moved = bool(left or new or any(number != place for number, place in places.items()))
    return Aligned({**places, **behind}, frozenset(behind.values()), new, moved)


def pools(fields: Fields) -> dict[int, str]:
    """Give the exercises of each task."""
    return {task_of(name): text for name, text in fields.items() if name.endswith(POOL) and task_of(name)}


def _pairs(here: Mapping[int, str], there: Mapping[int, str]) -> Iterator[tuple[int, int]]:
    """Give what may be the same task, the likeliest first: same exercises and place, same exercises, same place."""
    yield from ((number, number) for number, pool in here.items() if there.get(number) == pool)
    yield from ((number, place) for number, pool in here.items() for place, other in there.items() if pool == other)
    if len(here) == len(there):
        yield from ((number, number) for number in here if number in there)
