"""What is off in a table of a cycle: a delay, the opposite direction, degrees for radians, a column of its own."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from graders.cycle.curve import Cycle
from graders.cycle.table import Column, Table
from graders.remarks import Remark, Slip
from graders.units import read_unit

JUDGED = 1000  # rows that are judged of a long table, evenly spread
TRIED = 16  # rows on which shifts are tried
SHIFTS = 36
HALVINGS = 20
HOPELESS = 0.6  # of an amplitude: no shift in reach of the grid has so great an error
WIDEST = 0.1  # gap between phases, of a cycle
LOOSE = 2.0  # tolerances within which a slip is recognised
ALIKE = 2e-3  # of the largest: a difference quotient printed with few figures
ROUNDED = 0.005  # of a cycle: an abscissa of three figures, 0.101 s for 0.1005 s


@dataclass(frozen=True, slots=True)
class Rule:
    """What is asked for: the columns, how many are abscissae, the tolerance, the least number of rows."""

    columns: tuple[Column, ...]
    abscissae: int
    rtol: float
    least: int

    @property
    def ordinates(self) -> tuple[Column, ...]:
        """Give the columns that are judged."""
        return self.columns[self.abscissae :]

    def order(self, column: Column) -> int:
        """Tell how many times a column is differentiated by time."""
        names = {one.name: one for one in self.columns}
        found = 0
        while column.rate_of:
            column, found = names[column.rate_of], found + 1
        return found


@dataclass(frozen=True, slots=True)
class Beside:
    """A typed table beside the true cycle: phases and ordinates of the judged rows."""

    rule: Rule
    cycle: Cycle
    phases: tuple[float, ...]  # whole cycles not taken off
    typed: dict[int, tuple[float, ...]]  # by number of the ordinate

    def within(self, bound: float, number: int, warp: Callable[[float], float], sign: float = 1.0) -> bool:
        """Tell whether a column keeps to a number of tolerances, against the cycle at warped phases."""
        most = bound * self.rule.rtol * self.cycle.scales[number]
        pairs = zip(self.phases, self.typed[number], strict=True)
        return all(abs(y - sign * self.cycle.at(number, self.cycle.knot(warp(u)))) <= most for u, y in pairs)

    def true(self, number: int) -> list[float]:
        """Give the true ordinates at the judged rows."""
        return [self.cycle.at(number, self.cycle.knot(u)) for u in self.phases]


def beside(table: Table, cycle: Cycle, rule: Rule) -> Beside:
    """Put a table beside the cycle, by the abscissa that leaves most columns right."""
    first, *others = (
        _beside(table, cycle, rule, at)
        for at, column in enumerate(rule.columns[: rule.abscissae])
        if column.name in table.columns
    )
    return first if not off(first) else min((first, *others, *_evened(first)), key=lambda seen: len(off(seen)))


def _evened(seen: Beside) -> Iterator[Beside]:
    """Put a table at equal steps of a whole cycle, where its abscissae are that but for their rounding."""
    phases = seen.phases
    step = (phases[-1] - phases[0]) / max(1, len(phases) - 1)
    steps = round(1 / step) if step else 0
    even = tuple(phases[0] + at / steps for at in range(len(phases))) if steps else ()
    if even and all(abs(one - other) <= ROUNDED for one, other in zip(even, phases, strict=True)):
        yield replace(seen, phases=even)


def _beside(table: Table, cycle: Cycle, rule: Rule, number: int) -> Beside:
    """Put a table beside the cycle by one abscissa; of a long one evenly spread rows are judged."""
    every = max(1, math.ceil(table.rows / JUDGED))
    abscissa = table.columns[rule.columns[number].name]
    return Beside(
        rule,
        cycle,
        tuple((value - cycle.starts[number]) / cycle.turns[number] for value in abscissa[::every]),
        {
            at: tuple(table.columns[column.name][::every])
            for at, column in enumerate(rule.ordinates)
            if column.name in table.columns
        },
    )


def coverage(seen: Beside, rows: int) -> Remark | None:
    """Tell whether there are enough rows, and no wide gap between them."""
    if rows < seen.rule.least:
        return Remark(Slip.FEW_ROWS)
    held = sorted(phase % 1.0 for phase in seen.phases)
    gaps = [*((b - a, a) for a, b in pairwise(held)), (held[0] + 1 - held[-1], held[-1])]
    width, start = max(gaps)
    return _placed(Slip.NOT_A_CYCLE, start, seen, True) if width > WIDEST else None


def _placed(slip: Slip, phase: float, seen: Beside, absolute: bool) -> Remark:
    """Say a phase, or a difference of phases, in the last abscissa: the angle where there is one."""
    number = seen.rule.abscissae - 1
    unit = seen.rule.columns[number].unit
    value = phase * seen.cycle.turns[number] + (seen.cycle.starts[number] if absolute else 0.0)
    return Remark(slip, value / read_unit(unit).factor, unit=unit)


def off(seen: Beside) -> list[int]:
    """Give the columns that are not within the tolerance."""
    return [number for number in seen.typed if not seen.within(1 + 1e-9, number, _same)]


def remarks(seen: Beside, table: Table, wrong: Sequence[int]) -> Iterator[Remark]:
    """Name what is off: for the whole table where one slip explains all of it, else column by column."""
    missing = [Remark(Slip.NO_COLUMN, name=c.name) for i, c in enumerate(seen.rule.ordinates) if i not in seen.typed]
    yield from missing
    whole = _whole(seen) if len(wrong) == len(seen.typed) > 1 else None
    if whole is not None:
        yield whole
        return
    for number in wrong:
        yield Remark(_column(seen, table, number, wrong), name=seen.rule.ordinates[number].name)


def _whole(seen: Beside) -> Remark | None:
    """Try the slips of the abscissa, which leave no column right; a column alone has its own names for them."""
    signs = {number: (-1.0) ** seen.rule.order(seen.rule.ordinates[number]) for number in seen.typed}
    if all(seen.within(LOOSE, number, lambda u: -u, signs[number]) for number in seen.typed):
        return Remark(Slip.REVERSED)
    if seen.rule.abscissae > 1 and all(seen.within(LOOSE, number, _degrees(seen.cycle)) for number in seen.typed):
        return Remark(Slip.DEGREES)
    shift = _shift(seen)
    if all(seen.within(LOOSE, number, lambda u: u + shift) for number in seen.typed):
        return _placed(Slip.DELAYED, (shift + 0.5) % 1.0 - 0.5, seen, False)
    return None


def _same(phase: float) -> float:
    return phase


def _degrees(cycle: Cycle) -> Callable[[float], float]:
    """Give the phase that a sine sees when the number of degrees goes in for radians."""
    start, turn = cycle.starts[-1], cycle.turns[-1]
    return lambda u: (math.degrees(start + u * turn) - start) / turn


def _shift(seen: Beside) -> float:
    """Find the shift of phase with the least error: on a grid, then by ternary search."""
    every = max(1, len(seen.phases) // TRIED)
    phases = seen.phases[::every]
    typed = [(number, y[::every], seen.cycle.scales[number]) for number, y in seen.typed.items()]

    def error(shift: float) -> float:
        knots = [seen.cycle.knot(phase + shift) for phase in phases]
        return max(
            abs(value - seen.cycle.at(number, knot)) / scale
            for number, y, scale in typed
            for knot, value in zip(knots, y, strict=True)
        )

    best = min((k / SHIFTS for k in range(SHIFTS)), key=error)
    if error(best) > HOPELESS:
        return best
    low, high = best - 1 / SHIFTS, best + 1 / SHIFTS
    for _ in range(HALVINGS):
        third = (high - low) / 3
        if error(low + third) < error(high - third):
            high -= third
        else:
            low += third
    return (low + high) / 2


def _column(seen: Beside, table: Table, number: int, wrong: Sequence[int]) -> Slip:
    """Name what is off in one column."""
    if seen.within(LOOSE, number, _same, -1.0):
        return Slip.COLUMN_SIGN
    y, r = seen.typed[number], seen.true(number)
    tolerance = LOOSE * seen.rule.rtol * seen.cycle.scales[number]
    factor = sum(a * b for a, b in zip(y, r, strict=True)) / sum(b * b for b in r)
    if (
        factor
        and abs(factor - 1) > LOOSE * seen.rule.rtol
        and all(abs(a - factor * b) <= tolerance * abs(factor) for a, b in zip(y, r, strict=True))
    ):
        return _factor(seen, number, factor)
    mean = sum(a - b for a, b in zip(y, r, strict=True)) / len(y)
    if all(abs(a - b - mean) <= tolerance for a, b in zip(y, r, strict=True)):
        return Slip.COLUMN_SHIFT
    return _rate(seen, table, number, wrong)


def _factor(seen: Beside, number: int, factor: float) -> Slip:
    power = math.log10(abs(factor))
    near = LOOSE * seen.rule.rtol
    if round(power) and abs(10 ** (power - round(power)) - 1) <= seen.rule.rtol:
        return Slip.COLUMN_UNIT
    rate = (2 * math.pi / abs(seen.cycle.turns[0])) ** seen.rule.order(seen.rule.ordinates[number])
    if rate != 1 and abs(abs(factor) * rate - 1) <= near:
        return Slip.PER_ANGLE
    return Slip.COLUMN_SCALE


def _rate(seen: Beside, table: Table, number: int, wrong: Sequence[int]) -> Slip:
    """Name what is off in a derivative: quotients of differences, or no derivative at all."""
    column = seen.rule.ordinates[number]
    names = [one.name for one in seen.rule.ordinates]
    if column.rate_of not in table.columns:
        return Slip.COLUMN
    if _quotients(seen, table, column):
        return Slip.QUOTIENTS
    return Slip.COLUMN if names.index(column.rate_of) in wrong else Slip.NOT_THE_RATE


def _quotients(seen: Beside, table: Table, column: Column) -> bool:
    """Tell whether a column holds quotients of differences with the row behind or before."""
    at = next(i for i, one in enumerate(seen.rule.columns) if one.name in table.columns)
    turn = seen.cycle.turns[0] / seen.cycle.turns[at]  # seconds in a unit of the abscissa
    times = [turn * value for value in table.columns[seen.rule.columns[at].name][:JUDGED]]
    before = table.columns[column.rate_of][:JUDGED]
    typed = table.columns[column.name][:JUDGED]
    steps = list(zip(pairwise(times), pairwise(before), strict=True))
    if any(b == a for (a, b), _ in steps):
        return False
    quotients = [(q - p) / (b - a) for (a, b), (p, q) in steps]
    near = ALIKE * max(map(abs, typed))
    return near > 0 and any(
        all(abs(y - q) <= near for y, q in zip(part, quotients, strict=True)) for part in (typed[:-1], typed[1:])
    )
