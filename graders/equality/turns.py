"""Where a formula turns: the arguments whose sign changes it from one analytic function to another, or ends it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from graders.language.program import Builder, Operation
from graders.language.tree import Number

BRANCHES = frozenset(("abs", "sign", "macaulay"))  # the sign of the argument chooses the function
EDGES = frozenset(("sqrt", "root", "ln", "log", "log_base"))  # beyond zero there is no value, at zero a branch point
WRAPPING = frozenset(("atan", "acot"))  # a pole inside is a jump
TURNING = BRANCHES | EDGES | WRAPPING | {"min", "max", "atan2", "asin", "acos", "^"}
ENDING = EDGES | {"asin", "acos", "^"}
ONE = Number("1")


@dataclass(frozen=True, slots=True)
class Turn:
    """A slot whose sign matters.

    Attributes:
        slot: Where its value stands in the program.
        edge: Whether the formula ends where it is negative, and has a branch point where it is zero; else it goes on
            as another function.
        right: Whether the reference turns there.
        typed: Whether the answer does.
    """

    slot: int
    edge: bool
    right: bool
    typed: bool


def turns(builder: Builder, right: Sequence[int], typed: int) -> list[Turn]:
    """Find what turns in a program of two sides, adding slots for what has none.

    Args:
        builder: Holds both sides.
        right: Slots of the reference and of the lines it stands on.
        typed: Slot of the answer.
    """
    operations = tuple(builder.operations)
    if not any(name in TURNING for name, _ in operations):
        return []
    wraps = any(name in WRAPPING for name, _ in operations)
    sides = [_needed(builder, slots) for slots in (right, (typed,))]
    found: dict[int, Turn] = {}
    for at, operation in enumerate(operations, len(builder.inputs)):
        for slot in _turning(builder, operation, wraps):
            old = found.get(slot, Turn(slot, False, False, False))
            one, other = (at in side for side in sides)
            found[slot] = Turn(slot, old.edge or operation[0] in ENDING, old.right or one, old.typed or other)
    return list(found.values())


def _needed(builder: Builder, outputs: Sequence[int]) -> set[int]:
    """Find the slots that some slots stand on."""
    needed, start = set(outputs), len(builder.inputs)
    for slot in range(start + len(builder.operations) - 1, start - 1, -1):
        if slot in needed:
            needed.update(builder.operations[slot - start][1])
    return needed


def _turning(builder: Builder, operation: Operation, wraps: bool) -> tuple[int, ...]:
    name, arguments = operation
    if name in BRANCHES or name in EDGES:
        return arguments[:1]
    if name in ("min", "max"):
        return (builder.apply("-", *arguments),)
    if name == "atan2":
        return arguments
    if name in ("asin", "acos"):
        return (builder.apply("-", builder.add(ONE), builder.apply("power2", *arguments)),)
    if name == "^":
        return () if _whole(builder, arguments[1]) else arguments[:1]
    if wraps and name == "/":
        return arguments[1:]
    if wraps and name in ("tan", "cot"):
        return (builder.apply("cos" if name == "tan" else "sin", *arguments),)
    return ()


def _whole(builder: Builder, slot: int) -> bool:
    """Tell whether an exponent is written as a whole number, with or without a sign."""
    if slot < 0:
        return list(builder.literals)[-1 - slot].whole
    operations, start = builder.operations, len(builder.inputs)
    return slot >= start and operations[slot - start][0] == "negate" and _whole(builder, operations[slot - start][1][0])
