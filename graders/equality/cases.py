"""Whether two formulas agree however signs go: what is equal in every case needs no search for the cases there are.

A bracket, an absolute value, a greatest or a least value, the root of a square is one of two functions, and each stands
in its place in turn. Another root, a logarithm, an angle, a steep exponent becomes a number drawn for it, the same
number wherever the arguments are the same. Two sides that then agree at a few points, in every case, and end at the
same places, agree on all of a box, whichever cases it holds. Where they do not agree nothing is shown: a case may be
nowhere, and the sine of an arc is more than a number. This settles most right answers that turn several times faster
than a search.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from operator import mul, sub
from typing import Any, NamedTuple

from flint import arb

from graders.equality.deciding import PRECISIONS, Finding, exactly, same, share_of, zero
from graders.equality.multiples import SHIFTED, Known, at_edge, kind_of, multiple, number_for
from graders.equality.signs import Column, Screened, Signed, implied, screened
from graders.equality.turns import EXPONENTS, POLES
from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.intervals import ALL, INTERVALS, Interval, side_of_zero
from graders.language.program import Operation, Program, Runner
from graders.states import Point

WORK = 1200  # operations and comparisons of all cases together
CHOOSING = frozenset(("abs", "macaulay", "min", "max", "sign"))
ALWAYS = frozenset(("root", "sign", "atan2", "macaulay", "atan", "acot"))  # drawn also where they do not turn
EXPONENTIAL = EXPONENTS | {"^"}
ENDING = frozenset(("/", "tan", "cot", "macaulay", "log_base"))  # these may end where nothing turns
UNENDED = CHOOSING | EXPONENTS | {"atan", "acot"}  # these have a value everywhere
BEYOND = frozenset(("sqrt", "ln", "log"))  # these have none below zero
OWN = ("exponent", "bracket")  # the numbers drawn for these stand for something else than their values
AROUND_ONE: Interval = (0.5, 1.5)
NOTHING = 1e-6  # of a product: a greater difference is one in doubles


class Unsettled(ArithmeticError):
    """The cases would take longer than a search, or say nothing."""


class Choice(NamedTuple):
    """An argument whose sign chooses, its values on the box, the functions above and below zero.

    Without functions its sign is chosen first, for it is a factor of what chooses.
    """

    inside: Column
    ends: Interval
    values: tuple[Column, Column] | None


class Case(NamedTuple):
    """What was chosen so far: values of all slots, signs of arguments, numbers drawn, slots of roots of squares."""

    slots: list[Column]
    signs: list[Signed]
    known: list[Known]
    squares: list[int]

    def where(self, chosen: Choice, below: bool, slot: int) -> Case:
        """Give the case in which one more argument has a sign."""
        signs = [*self.signs, Signed(chosen.inside, below)]
        found = Case(list(self.slots), signs, list(self.known), list(self.squares))
        if chosen.values is not None:
            found.slots[slot] = chosen.values[below]
        return found


class Cases:
    """All cases of a program of two outputs, right and typed.

    Args:
        program: The two.
        sides: Slots that the reference, with the earlier names, and the answer stand on.
        points: Points of the box.
        ranges: The values of all slots on the box; empty where no box is known.
        signed: Slots that have one sign inside the box.
        turning: Slots of the functions whose arguments may turn in the box, and of those that are steep.
        mutual: Whether the two differ also where only the reference has no value.
        fine: Bits beyond 30 digits by which two sides are told apart.
        parted: Whether a function that chooses is each of its two in turn; else it is drawn as well, which is enough
            where the same ones stand on both sides.
    """

    def __init__(
        self, program: Program, sides: Sequence[set[int]], points: Sequence[Point], ranges: Sequence[Interval],
        signed: frozenset[int], turning: frozenset[int], mutual: bool, fine: int, parted: bool = True,
    ) -> None:  # fmt: skip
        self.signed, self.parted, self.fine, self.share = signed, parted, fine, share_of(fine)
        self.program, self.sides, self.points, self.mutual = program, sides, points, mutual
        self.turning, self.left = turning, WORK
        self.ranges = ranges or [ALL] * (len(program.inputs) + len(program.operations) + len(program.literals))
        operations, first = program.operations, len(program.inputs)
        self.steep = any(operations[slot - first][0] in EXPONENTIAL for slot in turning)
        self.loose: set[int] = set()  # slots that stand on drawn numbers
        self.chosen: set[int] = set()  # slots that stand on these or on what was chosen
        self.special: set[int] = set()  # slots of functions that choose or are drawn
        self.steady: list[Screened] = []
        ordered: list[list[tuple[int, Operation]]] = [[], [], []]  # what stands on what is drawn or chosen comes last
        for slot, (name, arguments) in enumerate(operations, first):
            drawn, chooses = self._is_drawn(name, slot), parted and name in CHOOSING
            if drawn or chooses:
                self.special.add(slot)
            if not self.loose.isdisjoint(arguments) or (drawn and not chooses):
                self.loose.add(slot)
            if chooses or slot in self.loose or not self.chosen.isdisjoint(arguments):
                self.chosen.add(slot)
            ordered[(slot in self.loose) + (slot in self.chosen)].append((slot, (name, arguments)))
        self.operations = [*ordered[0], *ordered[1], *ordered[2]]
        self.plain = {slot: BALLS.function(name) for slot, (name, _) in self.operations if slot not in self.special}
        self.heads = {arguments[0] for name, arguments in program.operations if name in CHOOSING}

    def agree(self, runner: Runner) -> bool:
        """Tell whether the two agree in every case; False where this is not shown.

        Args:
            runner: The program in balls of the first precision.
        """
        with precision(PRECISIONS[0] + self.fine):
            tail = [[value] * len(self.points) for value in runner.tail]
            case = Case([*zip(*map(exactly, self.points), strict=True), *tail], [], [], [])
            try:
                return self._agree(0, case)
            except (Unsettled, UndefinedError):
                return False

    def _agree(self, start: int, case: Case) -> bool:
        """Go on with a case from an operation on, parted where a sign is open."""
        slots, plain = case.slots, self.plain
        for at in range(start, len(self.operations)):
            slot, (name, arguments) = self.operations[at]
            self._spend()
            columns = [slots[argument] for argument in arguments]
            if slot in plain:
                slots[slot] = list(map(plain[slot], *columns)) if columns else [plain[slot]()] * len(self.points)
                continue
            chosen = self._choice(name, slot, arguments, case) if self.parted else None
            if chosen is not None:
                below = self._below(chosen, case, name == "macaulay" and columns[1][0].is_zero())
                if below is None or chosen.values is None:
                    after = at + (chosen.values is not None)
                    return all(self._agree(after, case.where(chosen, way, slot)) for way in (False, True))
                slots[slot] = chosen.values[below]
            else:
                slots[slot] = self._value(name, slot, arguments, columns, case)
        return self._equal(case)

    def _value(self, name: str, slot: int, arguments: Sequence[int], columns: Sequence[Column], case: Case) -> Column:
        """Give the values of a function that chooses nothing now."""
        edge = at_edge(name, columns[0]) if slot in self.turning else None
        if edge is not None:
            case.squares.append(slot)
            return [edge] * len(self.points)
        if self._is_drawn(name, slot):
            return self._drawn(name, slot, arguments, case)
        return list(map(BALLS.function(name), *columns))

    def _spend(self) -> None:
        self.left -= 1
        if self.left < 0:
            raise Unsettled

    def _choice(self, name: str, slot: int, arguments: Sequence[int], case: Case) -> Choice | None:
        """Give the two functions between which a function chooses; None where it does not."""
        if name == "sqrt" and slot in self.turning:
            return self._square(slot, case.slots[arguments[0]], case)
        if name not in CHOOSING:
            return None
        one, ends = case.slots[arguments[0]], self.ranges[arguments[0]]
        if name == "abs":
            return self._signed(arguments[0], (one, [-x for x in one]), case)
        if name == "sign":
            values = [arb(1)] * len(one), [arb(-1)] * len(one)
            return self._signed(arguments[0], values, case) if self._thin(arguments[0], case) else None
        other = case.slots[arguments[1]]
        if name == "macaulay":
            powers = list(map(pow, one, other)), [arb(0)] * len(one)
            found = Choice(one, ends, powers) if other[0].is_zero() else self._signed(arguments[0], powers, case)
            return found if arguments[1] < 0 else None
        inside = list(map(sub, one, other))
        ends = INTERVALS.functions["-"](ends, self.ranges[arguments[1]])
        return Choice(inside, ends, (one, other) if name == "max" else (other, one))

    def _signed(self, slot: int, values: tuple[Column, Column], case: Case) -> Choice:
        """Choose by the sign of a slot: of a product by that of its only factor whose sign is open.

        Where the signs of both factors are open and one of them chooses elsewhere, this one is chosen first.
        """
        first = len(self.program.inputs)
        while slot >= first and self._operation(slot)[0] in ("*", "/"):
            parts = self._operation(slot)[1]
            sides = [self._side(part, case) for part in parts]
            if sides.count(0) == 2 and not self.heads.isdisjoint(parts):
                part = parts[0] if parts[0] in self.heads else parts[1]
                return Choice(case.slots[part], self.ranges[part], None)
            if 0 not in sides:
                return Choice(case.slots[slot], (-math.inf, 0.0) if sides[0] != sides[1] else (0.0, math.inf), values)
            if sides.count(0) != 1:
                break
            slot, values = parts[sides.index(0)], values if sum(sides) > 0 else (values[1], values[0])
        return Choice(case.slots[slot], self.ranges[slot], values)

    def _side(self, slot: int, case: Case) -> int:
        """Give the sign of a slot on the box or in a case; 0 where it is open."""
        low, high = self.ranges[slot]
        if slot in self.signed:
            return 1 if low >= 0 else -1
        side = side_of_zero((low, high))
        if not side and slot in self.heads:
            below = self._below(Choice(case.slots[slot], (low, high), None), case, False)
            side = 0 if below is None else -1 if below else 1
        return side

    def _square(self, slot: int, radicand: Column, case: Case) -> Choice | None:
        """Give the root of a multiple of a square as one of two functions."""
        one, two = float(radicand[0]), float(radicand[1])
        for at, column in enumerate(case.slots[: len(self.program.inputs) + len(self.operations)]):
            if column[0] is None or column is radicand:
                continue
            first, second = float(column[0]), float(column[1])
            if abs(one * second * second - two * first * first) > NOTHING * abs(two) * first * first:
                continue
            factor = self._ratio(radicand, [x * x for x in column])
            if factor is not None and factor > 0:
                case.squares.append(slot)
                root = [factor.sqrt() * x for x in column]
                return self._signed(at, (root, [-x for x in root]), case)
        return None

    def _below(self, chosen: Choice, case: Case, is_step: bool) -> bool | None:
        """Tell whether what chooses is below zero, by its values on the box or by the case; None where both may be."""
        if chosen.ends[0] >= 0 or chosen.ends[1] <= 0:
            return chosen.ends[0] < 0
        for known, below in case.signs:
            factor = self._ratio(chosen.inside, known)
            if factor is not None and factor > 0:
                return below
            if factor is not None and factor < 0:
                if is_step and any(x.contains(0) for x in known):  # both steps are one where their argument vanishes
                    raise Unsettled
                return not below
        if not case.signs:
            return None
        self._spend()
        return implied(chosen.inside, case.signs, self._of_one_sign(case))

    def _of_one_sign(self, case: Case) -> list[Screened]:
        """Give one, and the symbols and sums of one sign that hang on no choice: they are the same in every case."""
        if not self.steady:
            self.steady.append(screened(Signed([arb(1)] * len(self.points), False)))
            first = len(self.program.inputs)
            sums = {slot for slot, (name, _) in self.operations if name in ("+", "-")}
            for slot in sorted(self.signed & {*range(first), *sums} - self.chosen):
                self.steady.append(screened(Signed(case.slots[slot], not self.ranges[slot][0] >= 0)))
        return self.steady

    def _is_drawn(self, name: str, slot: int) -> bool:
        always = name in ALWAYS and (self.parted or name not in CHOOSING)
        return always or (slot in self.turning and name not in POLES) or (self.steep and name in EXPONENTS)

    def _drawn(self, name: str, slot: int, arguments: Sequence[int], case: Case) -> Column:
        """Give the value of a function by a number that is drawn where it is met first."""
        columns, kind = [case.slots[argument] for argument in arguments], kind_of(name)
        if name == "^" and arguments[0] in self.signed and self.ranges[arguments[0]][0] >= 0:
            columns, kind, name = [list(map(mul, self._logarithms(arguments[0], case), columns[1]))], "exponent", "exp"
        elif name in EXPONENTS:
            kind = "exponent"
        elif name == "macaulay" and arguments[1] < 0:
            columns, kind, orders = columns[:1], "step" if columns[1][0].is_zero() else "bracket", columns[1]
        found = self._known(kind, columns, case)
        if found is None:
            values = AROUND_ONE if kind in OWN or name in SHIFTED else self.ranges[slot]
            found = number_for(slot, values, self.points)
            case.known.append(Known(kind, columns, found))
            case.signs.extend([Signed(found, False)] if name == "sqrt" else ())
        if name in SHIFTED:
            return [arb.pi() / 2 - x for x in found]
        if kind == "bracket":
            return list(map(pow, found, orders))
        return [BALLS.function(name)(x) for x in found] if kind == "exponent" else found

    def _logarithms(self, slot: int, case: Case) -> Column:
        """Give the logarithms of a slot above zero: of an exponential its exponent."""
        name, arguments = self._operation(slot) if slot >= len(self.program.inputs) else ("", ())
        return case.slots[arguments[0]] if name == "exp" else [x.log() for x in case.slots[slot]]

    def _known(self, kind: str, columns: Sequence[Column], case: Case) -> Column | None:
        """Give the number of a function from that of another of its kind, if its arguments are multiples of those."""
        for other, arguments, value in case.known:
            if other == kind:
                factors = [self._ratio(one, two) for one, two in zip(columns, arguments, strict=True)]
                again = None if None in factors else multiple(kind, factors, value)
                if again is None and kind == "sqrt":
                    again = self._scaled(columns[0], arguments[0], value, case)
                if again is not None:
                    return again
        return None

    def _scaled(self, one: Column, other: Column, root: Column, case: Case) -> Column | None:
        """Give the root of an argument from that of another one that is its multiple by the square of a symbol."""
        for at, column in enumerate(case.slots[: len(self.program.inputs)]):
            if at in self.signed:
                squares = [x * x for x in column]
                factor = self._ratio(one, [x * square for x, square in zip(other, squares, strict=True)])
                if factor is not None and factor > 0:
                    return [factor.sqrt() * abs(x) * y for x, y in zip(column, root, strict=True)]
                factor = self._ratio([x * square for x, square in zip(one, squares, strict=True)], other)
                if factor is not None and factor > 0:
                    return [factor.sqrt() * y / abs(x) for x, y in zip(column, root, strict=True)]
        return None

    def _ratio(self, one: Column, other: Column) -> Any:
        """Give the factor by which an argument is a multiple of another one; None where it is none."""
        if one is other:
            return arb(1)
        self._spend()
        if not (one[0] * other[1]).overlaps(one[1] * other[0]):
            return None
        factor = one[0] / other[0]
        same = all(
            zero(a, factor * b, PRECISIONS[0], self.share) is Finding.EQUAL
            for a, b in zip(one[1:], other[1:], strict=True)
        )
        return factor if same else None

    def _equal(self, case: Case) -> bool:
        """Tell whether the two agree where all is chosen, and end at the same places."""
        right, typed = self.program.outputs
        pairs = zip(case.slots[right], case.slots[typed], strict=True)
        if right != typed and not all(same(a, b, self.share) for a, b in pairs):
            return False
        one, other = self._sides
        return self._end_too(other - one, one, case) and (not self.mutual or self._end_too(one - other, other, case))

    @cached_property
    def _sides(self) -> tuple[set[int], set[int]]:
        """Give the slots of either side whose functions may end."""
        ending = {slot for slot, (name, _) in self.operations if name in ENDING or slot in self.turning}
        one, other = self.sides
        return ending & one, ending & other

    def _end_too(self, alone: set[int], others: set[int], case: Case) -> bool:
        """Tell whether one side ends wherever the other does because of what stands in that alone."""
        places = [slot for slot in alone if slot not in case.squares and self._ends(slot, case)]
        return all(any(self._ends_alike(slot, other, case) for other in others) for slot in places)

    def _ends(self, slot: int, case: Case) -> bool:
        """Tell whether a slot may have no value on a stretch."""
        name, arguments = self._operation(slot)
        if name in POLES:
            inside = arguments[-1]
            if inside not in self.loose or (name == "/" and self._positive(inside)):
                return False
            return name != "/" or inside not in self.signed
        if name in ("macaulay", "log_base"):
            return arguments[1] >= 0 or (name == "log_base" and slot in self.turning)
        if slot not in self.turning or name in UNENDED or name.startswith("power"):
            return False
        if name == "atan2":
            return not any(self._thin(argument, case) for argument in arguments)
        low, high = self.ranges[arguments[0]]
        if name in ("asin", "acos"):
            return not -1 <= low <= high <= 1
        return not (low >= 0 and (name == "sqrt" or self._positive(arguments[0]) or self._thin(arguments[0], case)))

    def _thin(self, slot: int, case: Case) -> bool:
        """Tell whether a slot is zero nowhere but at single places."""
        return slot not in self.loose and not all(x.contains(0) for x in case.slots[slot])

    def _positive(self, slot: int) -> bool:
        return slot >= len(self.program.inputs) and self._operation(slot)[0] in ("exp", "cosh")

    def _operation(self, slot: int) -> Operation:
        return self.program.operations[slot - len(self.program.inputs)]

    def _ends_alike(self, slot: int, other: int, case: Case) -> bool:
        """Tell whether two slots have no value at the same places."""
        (name, one), (second, two) = self._operation(slot), self._operation(other)
        kind = kind_of(name)
        if kind_of(second) != kind and not (name in BEYOND and second in BEYOND):
            return False
        first = 1 if name == "/" else 0
        factors = [self._ratio(case.slots[a], case.slots[b]) for a, b in zip(one[first:], two[first:], strict=True)]
        if None in factors:
            return False
        return name == "/" or (factors[0] > 0 if name in BEYOND else multiple(kind, factors, (arb(1),)) is not None)
