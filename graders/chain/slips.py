"""What is off in a table: one slip after another is taken back until the table is right."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import pi

from graders.chain.frames import Convention
from graders.chain.motion import Agreement, Motion, Rows, agreement
from graders.chain.table import ALPHA, COARSE, THETA, A, D, Table, holds, in_degrees, rounded
from graders.language.doubles import UndefinedError
from graders.verdict import Code, Flaw

OTHER: dict[Convention, Convention] = {"standard": "modified", "modified": "standard"}
STATES = 8  # at which slips are tried; the verdict itself stands on all of them
MOST_ROWS = 4  # of which all orders are tried
Change = Callable[[Sequence[float]], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class Judged:
    """A table beside the motion it should describe, with its numbers at the states."""

    table: Table
    rows: list[list[tuple[float, ...]]]
    motion: Motion
    joints: str
    convention: Convention
    variables: tuple[str, ...]

    def right(self, rows: Sequence[Rows], convention: Convention | None = None) -> bool:
        """Tell whether rows are right, as those of another convention up to the last frame."""
        found = agreement(rows, self.motion, self.joints, convention or self.convention)
        return found.rows == len(self.joints) and (found.tool or convention is not None)

    def read_as(self, change: Callable[[Table], Table]) -> bool:
        """Tell whether another reading of the same text is right."""
        try:
            return self.right(change(self.table).at(self.motion.names, self.motion.points))
        except UndefinedError:
            return False

    def with_row(self, at: int, change: Change) -> list[list[tuple[float, ...]]]:
        """Give the numbers with one row changed."""
        return [[*rows[:at], change(rows[at]), *rows[at + 1 :]] for rows in self.rows]


def judged(table: Table, motion: Motion, joints: str, convention: Convention, variables: tuple[str, ...]) -> Judged:
    """Put a table beside the first states of a motion; raises UndefinedError."""
    few = motion.first(STATES)
    return Judged(table, table.at(few.names, few.points), few, joints, convention, variables)


def flaw(judged: Judged, agreed: Agreement) -> Flaw:
    """Name what is off in a table that is not right."""
    found = next(_whole(judged), None) or next(_variables(judged), None) or next(_entries(judged), None)
    if found:
        return found
    if agreed.rows == len(judged.joints):
        return Flaw(Code.TABLE_TOOL)
    return Flaw(Code.TABLE_ROW, str(agreed.rows + 1))


def _whole(judged: Judged) -> Iterator[Flaw]:
    """Slips in how the whole table is written."""
    if judged.read_as(lambda table: table.angles(in_degrees)):
        yield Flaw(Code.TABLE_DEGREES)
    if judged.read_as(lambda table: table.angles(rounded(COARSE))):
        yield Flaw(Code.TABLE_ROUNDED)
    if _of_other_convention(judged):
        yield Flaw(Code.TABLE_CONVENTION)
    if judged.right(_each(judged.rows, _swapped)):
        yield Flaw(Code.TABLE_SWAPPED, "1–" + str(len(judged.joints)))
    for order in (_reversed, _angles_last, _ends_swapped):
        if judged.right(_each(judged.rows, order)):
            yield Flaw(Code.TABLE_COLUMNS)
    if _in_another_order(judged):
        yield Flaw(Code.TABLE_ROWS)


def _each(rows: Sequence[Rows], change: Change) -> list[list[tuple[float, ...]]]:
    return [[change(row) for row in state] for state in rows]


def _swapped(row: Sequence[float]) -> tuple[float, ...]:
    return (row[THETA], row[A], row[D], row[ALPHA])


def _reversed(row: Sequence[float]) -> tuple[float, ...]:
    return tuple(row[::-1])


def _angles_last(row: Sequence[float]) -> tuple[float, ...]:
    """Read columns a, alpha, d, theta, a usual order of books."""
    a, alpha, d, theta = row
    return (theta, d, a, alpha)


def _ends_swapped(row: Sequence[float]) -> tuple[float, ...]:
    return (row[ALPHA], row[D], row[A], row[THETA])


def _of_other_convention(judged: Judged) -> bool:
    other = OTHER[judged.convention]
    orders = (judged.rows, _each(judged.rows, _reversed), _each(judged.rows, _angles_last))
    return any(judged.right(rows, other) for rows in orders)


def _in_another_order(judged: Judged) -> bool:
    count = len(judged.joints)
    if not 1 < count <= MOST_ROWS:
        return False
    orders = [order for order in permutations(range(count)) if order != tuple(range(count))]
    return any(judged.right([[rows[at] for at in order] for rows in judged.rows]) for order in orders)


def _variables(judged: Judged) -> Iterator[Flaw]:
    """Joint variables that are missing or stand elsewhere."""
    for at, (row, variable) in enumerate(zip(judged.table.rows, judged.variables, strict=True)):
        own = THETA if judged.joints[at] == "R" else D
        if holds(row, variable, own):
            continue
        if judged.right(judged.with_row(at, _swapped)):
            yield Flaw(Code.TABLE_SWAPPED, str(at + 1))
        elif any(holds(other, variable, THETA, D, A, ALPHA) for other in judged.table.rows):
            yield Flaw(Code.TABLE_PLACE, str(at + 1), variable)
        else:
            yield Flaw(Code.TABLE_VARIABLE, str(at + 1), variable)


def _entries(judged: Judged) -> Iterator[Flaw]:
    """One entry, or the same entry of every row, that makes the table right when it is mended."""
    if judged.right(_each(judged.rows, _negative(ALPHA))):
        yield Flaw(Code.TABLE_ALPHA_SIGN, "1–" + str(len(judged.joints)))
    for at, variable in enumerate(judged.variables):
        if _turned(judged, at):
            yield Flaw(Code.TABLE_VARIABLE_SIGN, str(at + 1), variable)
    for code, changes in _mended():
        for at in range(len(judged.joints)):
            if any(judged.right(judged.with_row(at, change)) for change in changes):
                yield Flaw(code, str(at + 1))
    yield from _lengths(judged)


def _mended() -> Iterator[tuple[Code, tuple[Change, ...]]]:
    """Changes of one entry, the likelier slips first."""
    turns = (pi / 2, pi, -pi / 2)
    yield Code.TABLE_ALPHA_SIGN, (_negative(ALPHA),)
    yield Code.TABLE_SWAPPED, (_swapped,)
    yield Code.TABLE_LENGTH_SIGN, (_negative(D), _negative(A))
    yield Code.TABLE_OFFSET, tuple(_moved(THETA, turn) for turn in turns)
    yield Code.TABLE_ALPHA, tuple(_moved(ALPHA, turn) for turn in turns)


def _negative(column: int) -> Change:
    return lambda row: (*row[:column], -row[column], *row[column + 1 :])


def _moved(column: int, by: float) -> Change:
    return lambda row: (*row[:column], row[column] + by, *row[column + 1 :])


def _turned(judged: Judged, at: int) -> bool:
    """Tell whether the table is right with the opposite sign of a joint variable in its row."""
    place = judged.motion.names.index(judged.variables[at])
    opposite = [(*p[:place], -p[place], *p[place + 1 :]) for p in judged.motion.points]
    try:
        other = judged.table.at(judged.motion.names, opposite)
    except UndefinedError:
        return False
    return judged.right([[*r[:at], o[at], *r[at + 1 :]] for r, o in zip(judged.rows, other, strict=True)])


def _lengths(judged: Judged) -> Iterator[Flaw]:
    """A constant length that is missing or of another size: the links turn as they should, one is off its place."""
    for at in range(len(judged.joints)):
        for column in (D, A):
            if any(judged.right(judged.with_row(at, _moved(column, by))) for by in _missing(judged)):
                yield Flaw(Code.TABLE_LENGTH, str(at + 1))


def _missing(judged: Judged) -> list[float]:
    """Give the lengths of the task with both signs; they are the same at every state."""
    first, other = judged.motion.points[:2]
    names = zip(judged.motion.names, first, other, strict=True)
    lengths = [a for name, a, b in names if a == b and name not in judged.variables]
    return [sign * length for length in lengths for sign in (1.0, -1.0)]
