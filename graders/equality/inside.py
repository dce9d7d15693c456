"""Which parts of a formula keep one sign inside a box although they vanish at an end of it, as `x` does from 0 to 1."""

from __future__ import annotations

import math
from collections.abc import Sequence

from graders.judge import Domain
from graders.language.intervals import MARGIN, Interval
from graders.language.program import Program

KEEPING = frozenset(("sqrt", "negate", "degrees", "abs", "sinh", "tanh", "atan", "asin", "*", "/"))  # sign or zero
RISING = {  # and between which values of the argument they do
    **dict.fromkeys(("degrees", "sinh", "tanh", "atan", "exp"), (-math.inf, math.inf)),
    **dict.fromkeys(("sqrt", "ln", "log"), (0.0, math.inf)),
    "asin": (-1.0, 1.0),
}
POSITIVE = frozenset(("exp", "cosh"))


def one_signed(program: Program, slots: Sequence[Interval], box: Sequence[Domain]) -> frozenset[int]:
    """Give the slots that have one sign, and are zero nowhere, strictly inside a box.

    Args:
        program: Its operations.
        slots: The ranges of all slots on the box.
        box: The domains of the inputs.
    """
    first = len(box)
    found: set[int] = set()
    signs = Signs(program, slots, box, found)
    for slot in range(-len(program.literals), first + len(program.operations)):
        low, high = slots[slot]
        if low > 0:
            apart = low > MARGIN * high or high == math.inf
        elif high < 0:
            apart = high < MARGIN * low or low == -math.inf
        else:
            apart = False
        if apart or ((low >= 0 or high <= 0) and signs.kept(slot)):
            found.add(slot)
    return frozenset(found)


class Signs:
    """What is known of slots whose range ends at zero."""

    __slots__ = ("box", "found", "program", "slots")

    def __init__(self, program: Program, slots: Sequence[Interval], box: Sequence[Domain], found: set[int]) -> None:
        self.program, self.slots, self.box, self.found = program, slots, box, found

    def kept(self, slot: int) -> bool:
        """Tell whether a slot is zero nowhere inside: an end that is never taken, or a function that keeps a sign."""
        low, high = self.slots[slot]
        if (low == 0 and self.unreached(slot, 0)) or (high == 0 and self.unreached(slot, 1)):
            return True
        return slot >= len(self.box) and self._keeps(*self.program.operations[slot - len(self.box)])

    def unreached(self, slot: int, end: int) -> bool:
        """Tell whether the least (0) or the greatest value (1) is taken at the border of the box alone."""
        if slot < len(self.box):
            return slot >= 0 and not self.box[slot].integer
        name, arguments = self.program.operations[slot - len(self.box)]
        if name in ("+", "-", "negate"):
            last = end if name == "+" else 1 - end
            return self.unreached(arguments[-1], last) or (name != "negate" and self.unreached(arguments[0], end))
        if name in RISING:
            low, high = self.slots[arguments[0]]
            least, most = RISING[name]
            return least <= low and high <= most and self.unreached(arguments[0], end)
        return name[:5] == "power" and self._of_power(int(name[5:]), arguments[0], end)

    def _of_power(self, power: int, base: int, end: int) -> bool:
        """Tell whether an end of a power is taken at the border alone: the greatest of an even one is at either end."""
        low, high = self.slots[base]
        if power % 2 or low >= 0:
            return power > 0 and self.unreached(base, end)
        if high <= 0:
            return power > 0 and self.unreached(base, 1 - end)
        return power > 0 and end == 1 and self.unreached(base, 0) and self.unreached(base, 1)

    def _keeps(self, name: str, arguments: Sequence[int]) -> bool:
        """Tell whether a function has one sign because its arguments have."""
        if name in KEEPING or name[:5] == "power":
            return self.found.issuperset(arguments)
        if name == "^" or name == "root":
            return arguments[0] in self.found and self.slots[arguments[0]][0] >= 0
        if name == "+" or name == "-":
            (low, high), other = self.slots[arguments[0]], self.slots[arguments[1]]
            least, most = other if name == "+" else (-other[1], -other[0])
            return not self.found.isdisjoint(arguments) and ((low >= 0 and least >= 0) or (high <= 0 and most <= 0))
        return name in POSITIVE
