"""A tree as a flat list of operations, equal subtrees shared, run in doubles or in balls.

A program is made once and run on many points; a run is one loop over the list.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Relation, Tree, Unary

Operation: TypeAlias = tuple[str, tuple[int, ...]]


@dataclass(frozen=True, slots=True)
class Program:
    """Flat operations over slots: first the inputs, then the literals, then one slot an operation."""

    inputs: tuple[str, ...]
    literals: tuple[Number, ...]
    operations: tuple[Operation, ...]
    outputs: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """How one kind of number reads literals and applies the functions of the language."""

    literal: Callable[[Number], Any]
    functions: Mapping[str, Callable[..., Any]]


class Builder:
    """Collects operations; a name defined by `define` is replaced by the slot of its tree."""

    def __init__(self, inputs: Sequence[str]) -> None:
        self.inputs = tuple(inputs)
        self.defined: dict[str, int] = {name: slot for slot, name in enumerate(self.inputs)}
        self.pending: dict[tuple[str, tuple[object, ...]], int] = {}
        self.entries: list[tuple[str, tuple[object, ...]]] = []

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
        match tree:
            case Number():
                return self._slot("literal", (tree,))
            case Name(name="pi") if "pi" not in self.defined:
                return self._slot("pi", ())
            case Name(name=name):
                return self.defined[name]
            case Unary(operator="+", operand=operand):
                return self.add(operand)
            case Unary(operator=operator, operand=operand):
                return self._slot({"-": "negate", "°": "degrees"}[operator], (self.add(operand),))
            case Binary(operator=operator, left=left, right=right):
                return self._binary(operator, left, right)
            case Call(function=function, arguments=arguments):
                return self._call(function, arguments)
            case Angle():
                return self._angle(tree)
            case Grid(rows=rows):
                return self._slot(f"grid{len(rows)}", tuple(self.add(e) for row in rows for e in row))
            case Index(matrix=matrix, row=row, column=column):
                return self._slot(f"entry{row},{column}", (self.add(matrix),))
            case Relation():
                raise ValueError("a relation has no value")

    def _slot(self, name: str, arguments: tuple[object, ...]) -> int:
        entry = (name, arguments)
        slot = self.pending.get(entry)
        if slot is None:
            slot = self.pending[entry] = len(self.inputs) + len(self.entries)
            self.entries.append(entry)
        return slot

    def _binary(self, operator: str, left: Tree, right: Tree) -> int:
        if operator == "^" and isinstance(right, Number) and not right.exponent and right.digits.isdigit():
            power = int(right.digits)
            if power <= 1000:
                return self._slot(f"power{power}", (self.add(left),))
        return self._slot(operator, (self.add(left), self.add(right)))

    def _call(self, function: str, arguments: tuple[Tree, ...]) -> int:
        slots = [self.add(a) for a in arguments]
        if function in ("min", "max"):
            while len(slots) > 1:
                slots[:2] = [self._slot(function, (slots[0], slots[1]))]
            return slots[0]
        name = "log_base" if function == "log" and len(slots) == 2 else function
        return self._slot(name, tuple(slots))

    def _angle(self, angle: Angle) -> int:
        """Degrees, minutes and seconds of arc as one number of degrees, then turned into radians."""
        total: Tree = Binary("+", angle.degrees, Binary("/", angle.minutes, Number("60")))
        if angle.seconds is not None:
            total = Binary("+", total, Binary("/", angle.seconds, Number("3600")))
        return self._slot("degrees", (self.add(total),))

    def program(self, *outputs: int) -> Program:
        """Finish: literals are moved in front of the operations that use them."""
        start = len(self.inputs)
        literals = [(start + i, e) for i, e in enumerate(self.entries) if e[0] == "literal"]
        others = [(start + i, e) for i, e in enumerate(self.entries) if e[0] != "literal"]
        moved = {slot: slot for slot in range(start)}
        moved |= {old: start + new for new, (old, _) in enumerate(literals + others)}
        numbers = tuple(n for _, e in literals for n in e[1] if isinstance(n, Number))
        operations = tuple((e[0], tuple(moved[int(str(a))] for a in e[1])) for _, e in others)
        return Program(self.inputs, numbers, operations, tuple(moved[slot] for slot in outputs))


Code: TypeAlias = list[tuple[Callable[..., Any], int, int, tuple[int, ...]]]


class Runner:
    """A program made ready for one arithmetic."""

    __slots__ = ("code", "inputs", "literals", "outputs")

    def __init__(self, program: Program, arithmetic: Arithmetic) -> None:
        self.inputs = program.inputs
        self.outputs = program.outputs
        self.literals = [arithmetic.literal(number) for number in program.literals]
        self.code: Code = []
        for name, slots in program.operations:
            first, second = (*slots, -1, -1)[:2]
            many = slots if len(slots) > 2 or name.startswith("grid") else ()
            self.code.append((_function(name, arithmetic), first, second, many))

    def run(self, values: Sequence[Any]) -> list[Any]:
        """Compute the outputs for the values of the inputs, in their order."""
        slots = [*values, *self.literals]
        push = slots.append
        for function, first, second, many in self.code:
            if many:
                push(function(*[slots[slot] for slot in many]))
            elif second >= 0:
                push(function(slots[first], slots[second]))
            elif first >= 0:
                push(function(slots[first]))
            else:
                push(function())
        return [slots[slot] for slot in self.outputs]


def _function(name: str, arithmetic: Arithmetic) -> Callable[..., Any]:
    found = arithmetic.functions.get(name)
    if found is not None:
        return found
    if name.startswith("power"):
        power = int(name[5:])
        raise_to = arithmetic.functions["integer_power"]
        return lambda base: raise_to(base, power)
    if name.startswith("grid"):
        rows = int(name[4:])
        return lambda *entries: Table(tuple(_chunks(entries, rows)))
    row, column = (int(part) for part in name.removeprefix("entry").split(","))
    return lambda table: table.rows[row - 1][column - 1]


def _chunks(entries: tuple[Any, ...], rows: int) -> list[tuple[Any, ...]]:
    width = len(entries) // rows
    return [entries[i * width : (i + 1) * width] for i in range(rows)]


class Table:
    """A matrix of doubles or balls; its products never commute, a number scales every entry."""

    __slots__ = ("rows",)

    def __init__(self, rows: tuple[tuple[Any, ...], ...]) -> None:
        self.rows = rows

    def map(self, function: Callable[[Any], Any]) -> Table:
        """Apply a function to every entry."""
        return Table(tuple(tuple(function(e) for e in row) for row in self.rows))

    def combine(self, other: Table, function: Callable[[Any, Any], Any]) -> Table:
        """Apply a function entry by entry; raises ValueError when the shapes differ."""
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
