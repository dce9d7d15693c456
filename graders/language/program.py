"""A tree as a flat list of operations, equal subtrees shared, run in doubles or in balls.

A program is made once and run on many points; a run is one loop over the list.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, TypeAlias

from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Tree, Unary

Operation: TypeAlias = tuple[str, tuple[int, ...]]

UNARY = {"-": "negate", "°": "degrees"}
MOST_POWER = 1000  # written as a whole number, that is a power of its own


@dataclass(frozen=True, slots=True)
class Program:
    """Flat operations over slots: first the inputs, then one slot an operation; literals count from the end: -1, -2."""

    inputs: tuple[str, ...]
    literals: tuple[Number, ...]
    operations: tuple[Operation, ...]
    outputs: tuple[int, ...]

    def only(self, *outputs: int) -> Program:
        """Give the part of the program that some slots need, with these as its outputs; its slots are other ones."""
        start = len(self.inputs)
        needed = set(outputs)
        for slot in range(start + len(self.operations) - 1, start - 1, -1):
            if slot in needed:
                needed.update(self.operations[slot - start][1])
        moved, kept = {slot: slot for slot in range(-len(self.literals), start)}, list[Operation]()
        for slot, (name, arguments) in enumerate(self.operations, start):
            if slot in needed:
                moved[slot] = start + len(kept)
                kept.append((name, tuple([moved[argument] for argument in arguments])))
        return Program(self.inputs, self.literals, tuple(kept), tuple([moved[slot] for slot in outputs]))

    @property
    def moving(self) -> tuple[int, ...]:
        """Give the numbers of the inputs that an operation or an output stands on."""
        needed = {slot for _, arguments in self.operations for slot in arguments} | set(self.outputs)
        return tuple([at for at in range(len(self.inputs)) if at in needed])


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """How one kind of number reads literals and applies the functions of the language.

    Where a product of a value by itself is more than that of two equal ones, `square` gives it.
    """

    literal: Callable[[Number], Any]
    functions: Mapping[str, Callable[..., Any]]
    made: dict[str, Callable[..., Any]] = field(default_factory=dict, compare=False)

    def function(self, name: str) -> Callable[..., Any]:
        """Give the function of an operation; powers, matrices and their entries are made when first met."""
        return self.functions.get(name) or self.made.get(name) or self.made.setdefault(name, self._made(name))

    def _made(self, name: str) -> Callable[..., Any]:
        if name.startswith("power"):
            power, raise_to = int(name[5:]), self.functions["integer_power"]
            return lambda base: raise_to(base, power)
        if name.startswith("grid"):
            rows = int(name[4:])
            return lambda *entries: Table(tuple(_chunks(entries, rows)))
        row, column = (int(part) for part in name.removeprefix("entry").split(","))
        return lambda table: _entry(table, row, column)


@lru_cache(maxsize=2048)
def _power(digits: str, exponent: int) -> str:
    """Name the operation of a power that is written as a whole number; empty where it is not, or too great."""
    number = Number(digits, exponent)
    return f"power{int(digits)}" if number.whole and int(digits) <= MOST_POWER else ""


class Builder:
    """Collects operations; a name defined by `define` is replaced by the slot of its tree."""

    __slots__ = ("defined", "inputs", "literals", "operations", "slots")

    def __init__(self, inputs: Sequence[str]) -> None:
        self.inputs = tuple(inputs)
        self.defined: dict[str, int] = {name: slot for slot, name in enumerate(self.inputs)}
        self.literals: dict[Number, int] = {}
        self.slots: dict[Operation, int] = {}
        self.operations: list[Operation] = []

    def define(self, name: str, tree: Tree) -> int:
        """Give a name the value of a tree for all that is added later."""
        slot = self.add(tree)
        self.defined[name] = slot
        return slot

    def add(self, tree: Tree) -> int:
        """Add a tree and return its slot.

        Raises:
            KeyError: A name is neither an input nor defined.
        """
        if isinstance(tree, Name):
            slot = self.defined.get(tree.name)
            return slot if slot is not None else self._named(tree.name)
        if isinstance(tree, Binary):
            operator, right = tree.operator, tree.right
            if operator == "^" and isinstance(right, Number) and (power := _power(right.digits, right.exponent)):
                return self._slot((power, (self.add(tree.left),)))
            return self._slot((operator, (self.add(tree.left), self.add(right))))
        if isinstance(tree, Number):
            return self.literals.setdefault(tree, -1 - len(self.literals))
        if isinstance(tree, Call):
            arguments = tree.arguments
            if len(arguments) == 1:
                return self._slot((tree.function, (self.add(arguments[0]),)))
            return self._call(tree.function, arguments)
        if isinstance(tree, Unary):
            inside = self.add(tree.operand)
            return inside if tree.operator == "+" else self._slot((UNARY[tree.operator], (inside,)))
        return self._seldom(tree)

    def _slot(self, operation: Operation) -> int:
        slot = self.slots.get(operation)
        if slot is None:
            slot = self.slots[operation] = len(self.inputs) + len(self.operations)
            self.operations.append(operation)
        return slot

    def _named(self, name: str) -> int:
        if name != "pi":
            raise KeyError(name)
        return self.apply("pi")

    def _seldom(self, tree: Tree) -> int:
        match tree:
            case Angle():
                return self._angle(tree)
            case Grid(rows=rows):
                return self.apply(f"grid{len(rows)}", *[self.add(e) for row in rows for e in row])
            case Index(matrix=matrix, row=row, column=column):
                return self.apply(f"entry{row},{column}", self.add(matrix))
        raise ValueError("a relation has no value")

    def apply(self, name: str, *arguments: int) -> int:
        """Add an operation on slots and return its own; equal operations share one."""
        return self._slot((name, arguments))

    def _call(self, function: str, arguments: tuple[Tree, ...]) -> int:
        slots = [self.add(a) for a in arguments]
        if function in ("min", "max"):
            while len(slots) > 1:
                slots[:2] = [self.apply(function, slots[0], slots[1])]
            return slots[0]
        return self.apply("log_base" if function == "log" else function, *slots)

    def _angle(self, angle: Angle) -> int:
        """Degrees, minutes and seconds of arc as one number of degrees, then turned into radians."""
        total: Tree = Binary("+", angle.degrees, Binary("/", angle.minutes, Number("60")))
        if angle.seconds is not None:
            total = Binary("+", total, Binary("/", angle.seconds, Number("3600")))
        return self.apply("degrees", self.add(total))

    def program(self, *outputs: int) -> Program:
        """Finish: what was added, with some slots as outputs."""
        return Program(self.inputs, tuple(self.literals), tuple(self.operations), outputs)


Code: TypeAlias = list[tuple[Callable[..., Any], int, int, Any, int]]
NO_VALUE = (ValueError, ArithmeticError, TypeError)  # what an arithmetic raises where there is none


class Runner:
    """A program made ready for one arithmetic; of a part, `moving` are the numbers of the inputs that it stands on."""

    __slots__ = ("code", "inputs", "moving", "outputs", "tail")

    moving: tuple[int, ...]

    def __init__(self, program: Program, arithmetic: Arithmetic) -> None:
        self.inputs, self.outputs = program.inputs, program.outputs
        known = arithmetic.functions
        self.code: Code = []
        for slot, (name, arguments) in enumerate(program.operations, len(program.inputs)):
            if name == "power2":
                name, arguments = "*", arguments * 2
            function, count = known.get(name) or arithmetic.function(name), len(arguments)
            first, second = arguments if count == 2 else (arguments[0], 0) if count == 1 else (arguments, 0)
            if first == second and name == "*":
                function = known.get("square", function)
            self.code.append((function, slot, count, first, second))
        self.tail = [None] * len(self.code) + [arithmetic.literal(number) for number in reversed(program.literals)]

    def only(self, *outputs: int) -> Runner:
        """Give the part that some slots need, with these as its outputs; its slots are the same ones."""
        found, needed = Runner.__new__(Runner), set(outputs)
        found.inputs, found.tail, found.outputs, found.code = self.inputs, self.tail, outputs, []
        for step in reversed(self.code):
            _, slot, count, first, second = step
            if slot in needed:
                needed.update((first, second) if count == 2 else (first,) if count == 1 else first)
                found.code.append(step)
        found.code.reverse()
        found.moving = tuple([at for at in range(len(self.inputs)) if at in needed])
        return found

    def run(self, values: Sequence[Any], otherwise: Any = None) -> list[Any]:
        """Compute the outputs for the values of the inputs, in their order; as `slots` does."""
        slots = self.slots(values, otherwise)
        return [slots[slot] for slot in self.outputs]

    def columns(self, rows: Sequence[Sequence[Any]], each: Callable[..., Iterable[Any]] = map) -> list[tuple[Any, ...]]:
        """Compute the outputs for many rows of inputs at once; an error of one row is an error of all.

        Args:
            rows: The values of the inputs.
            each: Applies a function to columns of arguments.
        """
        count = len(rows)
        if not count:
            return []
        slots: list[Any] = [*zip(*rows, strict=True), *([value] * count for value in self.tail)]
        for function, slot, arity, first, second in self.code:
            if arity == 2:
                slots[slot] = list(each(function, slots[first], slots[second]))
            elif arity == 1:
                slots[slot] = list(each(function, slots[first]))
            else:
                slots[slot] = list(each(function, *[slots[a] for a in first])) if first else [function()] * count
        return list(zip(*[slots[slot] for slot in self.outputs], strict=True))

    def slots(self, values: Sequence[Any], otherwise: Any = None) -> list[Any]:
        """Compute all slots; `otherwise` stands, if given, in those that have no value, instead of an error."""
        slots: list[Any] = [*values, *self.tail]
        for function, slot, count, first, second in self.code:
            try:
                if count == 2:
                    slots[slot] = function(slots[first], slots[second])
                elif count == 1:
                    slots[slot] = function(slots[first])
                else:
                    slots[slot] = function(*[slots[argument] for argument in first])
            except NO_VALUE:
                if otherwise is None:
                    raise
                slots[slot] = otherwise
        return slots


def _chunks(entries: tuple[Any, ...], rows: int) -> list[tuple[Any, ...]]:
    width = len(entries) // rows
    return [entries[i * width : (i + 1) * width] for i in range(rows)]


def _entry(table: Any, row: int, column: int) -> Any:
    """Give an entry, counted from 1; raises ValueError for one of a number."""
    if not isinstance(table, Table):
        raise ValueError("a number has no entries")
    return table.rows[row - 1][column - 1]


class Table:
    """A matrix of doubles or balls; its products never commute, a number scales every entry."""

    __slots__ = ("rows",)

    def __init__(self, rows: tuple[tuple[Any, ...], ...]) -> None:
        self.rows = rows

    def map(self, function: Callable[[Any], Any]) -> Table:
        """Apply a function to every entry."""
        return Table(tuple(tuple(function(e) for e in row) for row in self.rows))

    def combine(self, other: Table, function: Callable[[Any, Any], Any]) -> Table:
        """Apply a function entry by entry; raises ValueError when the shapes differ, or the other is a number."""
        if not isinstance(other, Table):
            raise ValueError("a matrix and a number have no sum")
        pairs = zip(self.rows, other.rows, strict=True)
        return Table(tuple(tuple(function(a, b) for a, b in zip(x, y, strict=True)) for x, y in pairs))

    def __neg__(self) -> Table:
        return self.map(lambda e: -e)

    def __add__(self, other: Table) -> Table:
        return self.combine(other, lambda a, b: a + b)

    def __sub__(self, other: Table) -> Table:
        return self.combine(other, lambda a, b: a - b)

    def __mul__(self, other: Any) -> Table:
        if not isinstance(other, Table):
            return self.map(lambda e: e * other)
        if len(self.rows[0]) != len(other.rows):
            raise ValueError("the shapes of the matrices do not fit a product")
        columns = list(zip(*other.rows, strict=True))
        return Table(tuple(tuple(_dot(row, column) for column in columns) for row in self.rows))

    def __rmul__(self, other: Any) -> Table:
        return self.map(lambda e: other * e)

    def __truediv__(self, other: Any) -> Table:
        return self.map(lambda e: e / other)


def _dot(row: tuple[Any, ...], column: tuple[Any, ...]) -> Any:
    total = row[0] * column[0]
    for a, b in zip(row[1:], column[1:], strict=True):
        total = total + a * b
    return total
