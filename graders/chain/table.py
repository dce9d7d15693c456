"""A table as typed: four entries a row, evaluated at the states of a motion; other readings of the same entries."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isfinite, pi

from flint import arb

from graders.equality.turns import BRANCHES
from graders.language.balls import BALLS, precision
from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.program import Builder, Runner
from graders.language.tree import Angle, Binary, Call, Grid, Name, Number, Tree, Unary, names, walk

THETA, D, A, ALPHA = range(4)
STEPS = 24  # exact angles stand at steps of 15 degrees
FINE, COARSE = 1e-4, 6e-3  # a rounded angle: pi/2 as 1.5708, as 1.57
WHIRL = 20.0  # rad: beyond it nobody rounds an angle
TURNING = BRANCHES | {"min", "max"}
BITS, SURE = 256, 1e-30  # a value of 256 bits that is as wide hangs on rounding
PI = Name("pi")


@dataclass(frozen=True, slots=True)
class Table:
    """A table as typed, rows of theta, d, a, alpha."""

    tree: Grid

    @property
    def rows(self) -> tuple[tuple[Tree, ...], ...]:
        """Give the entries row by row."""
        return self.tree.rows

    def at(self, symbols: Sequence[str], points: Sequence[Sequence[float]]) -> list[list[tuple[float, ...]]]:
        """Evaluate the rows at points of the symbols.

        Raises:
            UndefinedError: An entry has no finite value at some point.
        """
        builder = Builder(symbols)
        runner = Runner(builder.program(*[builder.add(entry) for row in self.rows for entry in row]), DOUBLES)
        return [_rows(run(runner, list(point))) for point in points]

    def angles(self, change: Callable[[Tree], Tree]) -> Table:
        """Give the table with its angles read otherwise."""
        rows = [(change(theta), d, a, change(alpha)) for theta, d, a, alpha in self.rows]
        return Table(Grid(tuple(rows)))

    @property
    def turning(self) -> list[Call]:
        """Give what is another formula elsewhere."""
        nodes = (node for row in self.rows for entry in row for node in walk(entry))
        return [node for node in nodes if isinstance(node, Call) and node.function in TURNING]

    def unsure(self, symbols: Sequence[str], points: Sequence[Sequence[float]]) -> bool:
        """Tell whether rounding alone decides a sign at some point."""
        builder = Builder(symbols)
        program = builder.program(*[builder.add(node) for node in self.turning])
        if not program.outputs:
            return False
        with precision(BITS):
            runner = Runner(program, BALLS)
            return any(not value.rad() < SURE for point in points for value in runner.run([arb(x) for x in point]))


def _rows(entries: Sequence[float]) -> list[tuple[float, ...]]:
    if not all(isinstance(entry, float) and isfinite(entry) for entry in entries):
        raise UndefinedError("an entry of the table is not a finite number")
    return [tuple(entries[at : at + 4]) for at in range(0, len(entries), 4)]


def in_degrees(tree: Tree) -> Tree:
    """Read the plain numbers among the terms of an angle as degrees: `q1 + 90` as `q1 + 90°`."""
    match tree:
        case Binary(operator="+" | "-" as operator, left=left, right=right):
            return Binary(operator, in_degrees(left), in_degrees(right))
        case Unary(operator="+" | "-" as operator, operand=operand):
            return Unary(operator, in_degrees(operand))
    return tree if _measured(tree) else Unary("°", tree)


def _measured(tree: Tree) -> bool:
    """Tell whether a term holds a symbol, pi or an angle that is already in degrees."""
    return any(isinstance(n, Name | Angle) or (isinstance(n, Unary) and n.operator == "°") for n in walk(tree))


def rounded(slack: float) -> Callable[[Tree], Tree]:
    """Make a reading in which decimals near a multiple of 15° stand for it: 1.5708 for pi/2."""

    def exact(tree: Tree) -> Tree:
        match tree:
            case Number():
                return _nearest(tree, slack)
            case Binary(operator="+" | "-" as operator, left=left, right=right):
                return Binary(operator, exact(left), exact(right))
            case Unary(operator="+" | "-" as operator, operand=operand):
                return Unary(operator, exact(operand))
        return tree

    return exact


def _nearest(number: Number, slack: float) -> Tree:
    value, part = float(f"{number.digits}e{number.exponent}"), 2 * pi / STEPS
    steps = round(value / part) if value < WHIRL else 0
    if not steps or abs(value - steps * part) > slack:
        return number
    return Binary("/", Binary("*", Number(str(steps)), PI), Number(str(STEPS // 2)))


def holds(row: Sequence[Tree], symbol: str, *columns: int) -> bool:
    """Tell whether a symbol stands in one of the columns of a row."""
    return any(symbol in names(row[column]) for column in columns)
