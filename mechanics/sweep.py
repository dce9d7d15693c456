"""Initial parameters carried along a beam: the state on the left of each stretch from the conditions on the whole
(domain SM-11).

The state (v EI/L^3, theta EI/L^2, M/L, V) is in newtons and lengths are in parts of L. On the way it is
base + p1 c1 + p2 c2 with two unknown parameters: the left end leaves two quantities free, every condition on the way
settles one parameter and frees the quantity that jumps there instead, the right end settles both. The parameter that
stays is rewritten as a quantity of the state at that place. So no more than two unknowns live at once, and they never
grow along many spans.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.errors import SingularError

State = tuple[float, float, float, float]
# Between two stations: length h over L, load w at the left end times L and its growth k times L^2, both in newtons.
Stretch = tuple[float, float, float]

DEFLECTION, SLOPE, MOMENT, SHEAR = range(4)
# How the parameters before a condition follow from those after it: which one was settled (the second, if true),
# settled = constant + factor * kept, kept before = (kept after - shift)/scale.
_Settled = tuple[bool, float, float, float, float]

_Condition = tuple[int, float]  # a quantity of the state and its value

_UNITS: tuple[State, ...] = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))


@dataclass(slots=True)
class Station:
    """A place where the state may jump: loads, then the support, then the hinge."""

    x: float  # place, m
    force: float = 0.0  # up, N
    couple: float = 0.0  # counter-clockwise, over L, N
    held: bool = False  # v is given
    fixed: bool = False  # the slope is zero
    settlement: float = 0.0  # given v, in the scale of the state, N
    hinge: bool = False  # M is zero


def carry(state: State, h: float, w: float, k: float) -> State:
    """Integrate v' = theta, theta' = M, M' = V, V' = w + k t over a stretch h, exactly."""
    v, theta, M, V = state
    return (
        v + h * (theta + h * (M / 2 + h * (V / 6 + h * (w / 24 + h * k / 120)))),
        theta + h * (M + h * (V / 2 + h * (w / 6 + h * k / 24))),
        M + h * (V + h * (w / 2 + h * k / 6)),
        V + h * (w + h * k / 2),
    )


def sweep(stations: list[Station], stretches: list[Stretch]) -> list[State]:
    """Find the state at the left end of every stretch; there is no hinge at either end.

    Raises:
        SingularError: A condition cannot settle any parameter.
    """
    line = _begun(stations[0])
    try:
        for stretch, station in zip(stretches, stations[1:], strict=True):
            line.advance(*stretch)
            if station is not stations[-1]:
                _jump(line, station)
        return line.trace_back(_conditions(stations[-1]))
    except ZeroDivisionError:
        raise SingularError("a condition at a support, a hinge or the end of the beam settles nothing") from None


def _begun(station: Station) -> _Line:
    """At the left end the parameters are what it leaves free."""
    if station.fixed:
        return _Line((station.settlement, 0.0, 0.0, 0.0), _UNITS[MOMENT], _UNITS[SHEAR], [], [])
    if station.held:
        return _Line((station.settlement, 0.0, -station.couple, 0.0), _UNITS[SLOPE], _UNITS[SHEAR], [], [])
    return _Line((0.0, 0.0, -station.couple, station.force), _UNITS[DEFLECTION], _UNITS[SLOPE], [], [])


def _conditions(station: Station) -> tuple[_Condition, _Condition]:
    """What the right end holds, or the loads that stand there."""
    if station.fixed:
        return (DEFLECTION, station.settlement), (SLOPE, 0.0)
    if station.held:
        return (DEFLECTION, station.settlement), (MOMENT, station.couple)
    return (MOMENT, station.couple), (SHEAR, -station.force)


def _jump(line: _Line, station: Station) -> None:
    if station.force or station.couple:
        v, theta, M, V = line.base
        line.base = (v, theta, M - station.couple, V + station.force)
    if station.held:
        line.impose(DEFLECTION, station.settlement, SHEAR)
    if station.fixed:
        line.impose(SLOPE, 0.0, MOMENT)
    if station.hinge:
        line.impose(MOMENT, 0.0, SLOPE)


@dataclass(slots=True)
class _Line:
    """The sweep under way; it notes what it passes, so that it can be traced back."""

    base: State
    first: State
    second: State
    settled: list[_Settled]
    starts: list[tuple[int, State, State, State]]

    def advance(self, h: float, w: float, k: float) -> None:
        self.starts.append((len(self.settled), self.base, self.first, self.second))
        self.base = carry(self.base, h, w, k)
        v, theta, M, V = self.first
        self.first = (v + h * (theta + h * (M / 2 + h * V / 6)), theta + h * (M + h * V / 2), M + h * V, V)
        v, theta, M, V = self.second
        self.second = (v + h * (theta + h * (M / 2 + h * V / 6)), theta + h * (M + h * V / 2), M + h * V, V)

    def impose(self, quantity: int, value: float, released: int) -> None:
        """Settle one parameter by state[quantity] = value; state[released] becomes a parameter in its place."""
        swapped = abs(self.first[quantity]) < abs(self.second[quantity])
        pivot, kept = (self.second, self.first) if swapped else (self.first, self.second)
        divisor = pivot[quantity]
        constant = (value - self.base[quantity]) / divisor
        factor = -kept[quantity] / divisor
        base, column = _added(self.base, constant, pivot), _added(kept, factor, pivot)
        base[quantity], column[quantity] = value, 0.0
        base[released] = column[released] = 0.0
        largest = _largest(column)
        scale, shift = column[largest], base[largest]
        a, b, c, d = column
        kept = (a / scale, b / scale, c / scale, d / scale)
        a, b, c, d = _added(base, -shift, kept)
        self.base = (a, b, c, d)
        self.settled.append((swapped, constant, factor, shift, scale))
        self.first, self.second = (kept, _UNITS[released]) if swapped else (_UNITS[released], kept)

    def closed(self, conditions: tuple[_Condition, _Condition]) -> tuple[float, float]:
        """Solve the conditions at the right end for the two parameters."""
        (i, value), (j, target) = conditions
        value, target = value - self.base[i], target - self.base[j]
        a, b, c, d = self.first[i], self.second[i], self.first[j], self.second[j]
        determinant = a * d - b * c
        return (value * d - b * target) / determinant, (a * target - value * c) / determinant

    def trace_back(self, conditions: tuple[_Condition, _Condition]) -> list[State]:
        """Go back to the left end with the parameters known."""
        first, second = self.closed(conditions)
        found: list[State] = []
        for count, base, one, two in reversed(self.starts):
            while len(self.settled) > count:
                swapped, constant, factor, shift, scale = self.settled.pop()
                kept = ((first if swapped else second) - shift) / scale
                gone = constant + factor * kept
                first, second = (kept, gone) if swapped else (gone, kept)
            a, b, c, d = base
            e, f, g, h = one
            i, j, k, l = two
            found.append(
                (
                    a + first * e + second * i,
                    b + first * f + second * j,
                    c + first * g + second * k,
                    d + first * h + second * l,
                )
            )
        found.reverse()
        return found


def _largest(column: list[float]) -> int:
    """Where the entry of the largest magnitude stands."""
    sizes = [abs(column[0]), abs(column[1]), abs(column[2]), abs(column[3])]
    return sizes.index(max(sizes))


def _added(state: Sequence[float], factor: float, other: State) -> list[float]:
    a, b, c, d = state
    e, f, g, h = other
    return [a + factor * e, b + factor * f, c + factor * g, d + factor * h]
