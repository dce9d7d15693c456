"""Where a formula turns: the arguments whose sign changes it from one analytic function to another, or ends it."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from typing import TypeAlias

from graders.language.intervals import Interval
from graders.language.program import Builder, Operation, Program
from graders.language.tree import Number

BRANCHES = frozenset(("abs", "sign", "macaulay"))  # the sign of the argument chooses the function
EDGES = frozenset(("sqrt", "root", "ln", "log", "log_base"))  # beyond zero there is no value, at zero a branch point
WRAPPING = frozenset(("atan", "acot"))  # a pole inside is a jump
POLES = frozenset(("/", "tan", "cot"))
SUMS = frozenset(("+", "-", "negate", "degrees"))  # what turns in their parts does not act on one another
MOST_GROUPS, LARGEST = 24, 3  # sets of turns that are kept apart, and the turns of one
TURNING = BRANCHES | EDGES | WRAPPING | {"min", "max", "atan2", "asin", "acos", "^"}
EXPONENTS = frozenset(("exp", "sinh", "cosh", "tanh"))
STEEP = EXPONENTS | {"^"}
HIGH = 12  # powers from which a product of small numbers is nothing
ONE = Number("1")
Groups: TypeAlias = frozenset[frozenset[int]]
Place: TypeAlias = tuple[int, bool]  # a slot whose sign matters, and whether a function ends where it is negative
Places: TypeAlias = Mapping[int, Sequence[Place]]  # by the slots of functions


@lru_cache(maxsize=2048)
def may_be_steep(name: str) -> bool:
    """Tell whether an operation is an exponential or a high power."""
    return name in STEEP or (name[:5] == "power" and int(name[5:]) >= HIGH)


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


def places(builder: Builder) -> Places:
    """Find the functions that turn, and where they do, adding slots for what has none."""
    operations = tuple(builder.operations)
    if not any(name in TURNING for name, _ in operations):
        return {}
    wraps = any(name in WRAPPING for name, _ in operations)
    names = TURNING | POLES if wraps else TURNING
    every = [(at, one) for at, one in enumerate(operations, len(builder.inputs)) if one[0] in names]
    return {at: found for at, one in every if (found := _places(builder, one))}


def turns(where: Places, sides: Sequence[Collection[int]]) -> list[Turn]:
    """Give what turns in a program of two sides.

    Args:
        where: The functions that turn.
        sides: The slots that the reference, with the lines it stands on, and the answer stand on.
    """
    found: dict[int, Turn] = {}
    for at, several in where.items():
        for slot, edge in several:
            old = found.get(slot, Turn(slot, False, False, False))
            one, other = (at in side for side in sides)
            found[slot] = Turn(slot, old.edge or edge, old.right or one, old.typed or other)
    return list(found.values())


def uncut(builder: Builder, where: Places, slots: Sequence[Interval], signed: Collection[int]) -> Places:
    """Leave out the directions that are never cut: those on one side of the first axis, or around it.

    Args:
        builder: Holds the functions.
        where: The functions that turn.
        slots: The ranges of all slots.
        signed: Slots that have one sign.
    """
    start = len(builder.inputs)
    return {
        at: several for at, several in where.items()
        if builder.operations[at - start][0] != "atan2"
        or not (several[0][0] in signed or (several[1][0] in signed and slots[several[1][0]][0] >= 0))
    }  # fmt: skip


@dataclass(frozen=True, slots=True)
class Joint:
    """Turns, by their numbers, whose signs act on one another; whether each stands by itself, in a product."""

    turns: tuple[int, ...]
    apart: bool


def together(builder: Builder, where: Places, found: Sequence[Turn], outputs: Sequence[int]) -> list[Joint]:
    """Give the turns whose signs act on one another: in a product, in an argument that turns, in a direction.

    Edges are left out: beyond them there is no value. Where signs stand in a sum alone, each is told by itself.
    """
    numbers = {turn.slot: number for number, turn in enumerate(found) if not turn.edge}
    if len(numbers) < 2:
        return []
    operations, groups = tuple(builder.operations), dict[int, Groups]()
    inside, directions = dict[int, frozenset[int]](), set[frozenset[int]]()
    for at, operation in enumerate(operations, len(builder.inputs)):
        own = frozenset(numbers[slot] for slot, _ in where.get(at, ()) if slot in numbers)
        parts = [groups[slot] for slot in dict.fromkeys(operation[1]) if groups.get(slot)]
        if operation[0] == "atan2":
            directions |= {own} if len(own) > 1 else set()
            own = frozenset()
        within = frozenset[int]().union(*(group for part in parts for group in part))
        inside |= {number: within for number in own}
        groups[at] = _joined(operation, parts, own)
    every = frozenset[frozenset[int]]().union(*(groups.get(slot, frozenset()) for slot in outputs))
    sets = {part for group in every for part in _small(group) if len(part) > 1} | directions
    kept = sorted(tuple(sorted(one)) for one in sets if not any(one < other for other in sets))
    return [Joint(one, frozenset(one) not in directions and not any(inside[at] & {*one} for at in one)) for one in kept]


def _joined(operation: Operation, parts: Sequence[Groups], own: frozenset[int]) -> Groups:
    name = operation[0]
    if not parts:
        return frozenset((own,)) if own else frozenset()
    if not own and (name in SUMS or (name in ("*", "/") and len(parts) == 1 and len(operation[1]) == 2)):
        return frozenset[frozenset[int]]().union(*parts)
    if name == "*" and len(parts) == 2 and len(parts[0]) * len(parts[1]) <= MOST_GROUPS:
        return frozenset(one | other for one in parts[0] for other in parts[1])
    return frozenset((own.union(*(group for part in parts for group in part)),))


def _small(group: frozenset[int]) -> list[frozenset[int]]:
    return [group] if len(group) <= LARGEST else [frozenset(pair) for pair in combinations(sorted(group), 2)]


def needed(program: Builder | Program, outputs: Sequence[int]) -> set[int]:
    """Find the slots that some slots stand on."""
    found, start = set(outputs), len(program.inputs)
    for slot in range(start + len(program.operations) - 1, start - 1, -1):
        if slot in found:
            found.update(program.operations[slot - start][1])
    return found


def arcs(builder: Builder, where: Places) -> set[int]:
    """Give the slots `1 - u^2` of arcsines and arccosines."""
    start = len(builder.inputs)
    found = {several[0] for at, several in where.items() if builder.operations[at - start][0] in ("asin", "acos")}
    return {slot for slot, edge in found if edge}


def _places(builder: Builder, operation: Operation) -> tuple[Place, ...]:
    name, arguments = operation
    if name == "macaulay" and arguments[1] >= 0:  # there is no value where its order is negative
        return (arguments[0], False), (arguments[1], True)
    if name in BRANCHES or (name == "root" and _odd(builder, arguments[1])):
        return ((arguments[0], False),)
    if name in EDGES or (name == "^" and not _whole(builder, arguments[1])):
        return _edges(builder, arguments[0])
    if name in ("min", "max"):
        return ((builder.apply("-", *arguments), False),)
    if name == "atan2":
        return (arguments[0], False), (arguments[1], False)
    if name in ("asin", "acos"):
        function, angle = _operation(builder, arguments[0])
        if function in ("sin", "cos"):  # acos(cos(x)) turns where cos(x) does
            return ((builder.apply("cos" if function == "sin" else "sin", *angle), False),)
        return ((builder.apply("-", builder.add(ONE), builder.apply("power2", *arguments)), True),)
    if name == "/":
        return ((arguments[1], False),)
    if name in ("tan", "cot"):
        return ((builder.apply("cos" if name == "tan" else "sin", *arguments), False),)
    return ()


def _edges(builder: Builder, slot: int) -> tuple[Place, ...]:
    """Give where a root turns: with an even power, or an absolute value, where the sign of what stands inside changes.

    In a product with one other factor it ends where this is negative.
    """
    name, arguments = _operation(builder, slot)
    if name == "abs" or _is_even(name) or (name == "*" and arguments[0] == arguments[1]):
        return ((arguments[0], False),)
    if name == "*" or name == "/":
        parts = [place for part in arguments if not _positive(builder, part) for place in _edges(builder, part)]
        if sum(edge for _, edge in parts) < 2:
            return tuple(parts)
    return ((slot, True),)


@lru_cache(maxsize=2048)
def _is_even(name: str) -> bool:
    return name[:5] == "power" and name != "power0" and int(name[5:]) % 2 == 0


def _operation(builder: Builder, slot: int) -> Operation:
    """Give what makes a slot; nothing makes a symbol or a literal."""
    start = len(builder.inputs)
    return builder.operations[slot - start] if slot >= start else ("", ())


def _positive(builder: Builder, slot: int) -> bool:
    """Tell a literal that is not zero."""
    return slot < 0 and list(builder.literals)[-1 - slot].digits.strip("0.") != ""


def _odd(builder: Builder, slot: int) -> bool:
    """Tell whether the degree of a root is written as an odd number."""
    number = list(builder.literals)[-1 - slot] if slot < 0 else ONE
    return slot < 0 and number.whole and int(number.digits) % 2 == 1


def _whole(builder: Builder, slot: int) -> bool:
    """Tell whether an exponent is written as a whole number, with or without a sign."""
    if slot < 0:
        return list(builder.literals)[-1 - slot].whole
    operations, start = builder.operations, len(builder.inputs)
    return slot >= start and operations[slot - start][0] == "negate" and _whole(builder, operations[slot - start][1][0])
