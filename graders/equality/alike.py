"""What turns on both sides of a pair: numbers drawn for it tell that the two agree, whichever way it turns."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from graders.equality.multiples import kind_of
from graders.equality.probing import Row, proportional
from graders.equality.turns import Places
from graders.language.program import Program


def alike(
    program: Program, where: Places, functions: Collection[int], sides: Sequence[set[int]], columns: Mapping[int, Row]
) -> bool:
    """Tell whether doubles see for all that turns on one side alone something like it on the other side.

    Args:
        program: The two sides.
        where: The functions that turn, and where they do.
        functions: Slots of those that turn in the box.
        sides: The slots that either side stands on.
        columns: Values at some points of the places at which they turn, by their slots.
    """
    one, other = (side.intersection(functions) for side in sides)
    kinds = {slot: kind_of(program.operations[slot - len(program.inputs)][0]) for slot in functions}

    def together(slot: int, like: int) -> bool:
        if kinds[slot] != kinds[like]:
            return False
        both = zip(where[slot], where[like], strict=False)
        return all(proportional(columns[a], columns[b]) for (a, _), (b, _) in both if a in columns and b in columns)

    pairs = [(slot, two) for alone, two in ((one - other, other), (other - one, one)) for slot in alone]
    return bool(one) and all(any(together(slot, like) for like in two) for slot, two in pairs)
