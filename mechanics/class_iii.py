"""The class III unit of two ternary links by the modification method (domain HC-1 to HC-4).

Ternary links 2 (B, C, E) and 4 (E, F, H) are hinged at E; legs AB, DC, GF, KH hold them to the frame pivots A, D, G, K.
Leg DC is cut: for a given alpha5 (angle of GF) the rest is a chain of class II with two branches for each link, and the
cut leg gives one equation Phi(alpha5) = |C - D|^2 - l_CD^2 = 0. Angles counter-clockwise from +X, in [0, 2 pi); alpha4
is that of FH, alpha2 that of EB. A branch is two signs: the first for link 4, the second for link 2. Points are complex
numbers x + i y in one unit of length, metres or any other.
"""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from math import atan2, cos, hypot, pi, sin, sqrt
from typing import NamedTuple

from mechanics import linear, loop
from mechanics.checks import finite, positive
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import principal

BRANCHES = {"++": (1, 1), "+-": (1, -1), "-+": (-1, 1), "--": (-1, -1)}
DEAD_NAME = "two assemblies meet: the closure equations are singular"
LENGTHS = ("l_AB", "l_BC", "l_BE", "l_CE", "l_CD", "l_EF", "l_EH", "l_FH", "l_FG", "l_HK")
REACH = 1e-12  # a gap below this part of the side is rounding, not distance
ROUNDING = 1e-13  # of a point's place over the longest length before it
SAME = 1e-6  # rad: two zeros as near, with the same signs, are one
ROUNDS, SETTLED = 30, 1e-13  # of Newton's method; its last step, rad

NARROW = 1e-3  # of the range: then the two assemblies that meet are neighbours
DIFFERENCE = 1e-5

Angles = tuple[float, float, float]  # alpha5, alpha4, alpha2


@dataclass(frozen=True, slots=True)
class Unit:
    """Pivots and lengths of the unit; sigma is +1 where C is counter-clockwise from EB (E from FH), -1 otherwise."""

    A: complex
    D: complex
    G: complex
    K: complex
    l_AB: float
    l_BC: float
    l_BE: float
    l_CE: float
    l_CD: float
    l_EF: float
    l_EH: float
    l_FH: float
    l_FG: float
    l_HK: float
    sigma2: int = 1
    sigma4: int = 1
    arm_C: complex = field(init=False, repr=False)  # EC in the axis EB
    arm_E: complex = field(init=False, repr=False)  # FE in the axis FH
    size: float = field(init=False, repr=False)  # the longest length on the way to C

    def __post_init__(self) -> None:
        for name in ("A", "D", "G", "K"):
            finite(f"{name} x", getattr(self, name).real, "m")
            finite(f"{name} y", getattr(self, name).imag, "m")
        for name in LENGTHS:
            positive(name, getattr(self, name), "m")
        for name in ("sigma2", "sigma4"):
            if getattr(self, name) not in (1, -1):
                raise ValueError(f"{name} must be 1 or -1, not {getattr(self, name)!r}")
        chi2 = self.sigma2 * _corner("B-C-E", self.l_BE, self.l_CE, self.l_BC)
        chi4 = self.sigma4 * _corner("E-F-H", self.l_FH, self.l_EF, self.l_EH)
        lengths = [getattr(self, name) for name in LENGTHS if name != "l_CD"]
        object.__setattr__(self, "size", max(*lengths, abs(self.G - self.K), abs(self.A - self.G)))
        object.__setattr__(self, "arm_C", self.l_CE * exp(1j * chi2))
        object.__setattr__(self, "arm_E", self.l_EF * exp(1j * chi4))


def _corner(name: str, one: float, other: float, opposite: float) -> float:
    """The angle between two sides by its half, which keeps its digits where the three joints are in line."""
    longest, shortest = one + other, abs(one - other)
    gap = max(opposite - longest, shortest - opposite)
    if gap > REACH * max(longest, opposite):
        raise AssemblyError(f"the sides of the ternary link {name} make no triangle: {gap:.4g} do not fit")
    above = sqrt(max(0.0, opposite - shortest)) * sqrt(opposite + shortest)
    below = sqrt(max(0.0, longest - opposite)) * sqrt(longest + opposite)
    return 2 * atan2(above, below)


class Assembly(NamedTuple):
    alpha5: float
    alpha4: float
    alpha2: float
    branch: str
    F: complex
    E: complex
    C: complex
    measure: float  # 0 where two assemblies meet, 1 farthest from it


@dataclass(frozen=True, slots=True)
class _Around:
    """A closed loop s in [0, 2 pi) over a parameter t: out with one sign and back with the other, or one sign only."""

    middle: float = 0.0
    half: float = 0.0
    sign: int = 0

    def at(self, s: float) -> tuple[float, int]:
        if self.sign:
            return s, self.sign
        return self.middle - self.half * cos(s), 1 if s % (2 * pi) <= pi else -1


def constraint(unit: Unit, alpha5: float, branch: str) -> float | None:
    """Give Phi, in squares of the unit's length; None where the branch does not exist.

    Args:
        unit: The unit.
        alpha5: Angle of GF, in radians.
        branch: One of `BRANCHES`.

    Raises:
        ValueError: The angle is not finite, or the branch unknown.

    Source:
        Domain HC-1 (1)-(8).
    """
    finite("alpha5", alpha5, "rad")
    if branch not in BRANCHES:
        raise ValueError(f"branch must be one of {', '.join(BRANCHES)}, not {branch!r}")
    e4, e2 = BRANCHES[branch]
    F = _end_of_leg(unit, alpha5)
    if _room(unit.K - F, unit.l_FH, unit.l_HK) < 0:
        return None
    E = F + unit.arm_E * _direction(unit.K - F, unit.l_FH, unit.l_HK, e4)
    if _room(unit.A - E, unit.l_BE, unit.l_AB) < 0:
        return None
    return _phi(unit, E, e2)


def _end_of_leg(unit: Unit, alpha5: float) -> complex:
    return unit.G + unit.l_FG * complex(cos(alpha5), sin(alpha5))  # (1)


def _room(way: complex, arm: float, leg: float) -> float:
    """The square of the triangle's height over the way, times that of the way; negative where it does not close.

    By Heron's formula, in which nothing cancels when arm and leg are unlike.
    """
    d = abs(way)
    return (leg - arm + d) * (leg + arm - d) * (arm + d - leg) * (arm + d + leg) / 4


def _room_rounding(unit: Unit, arm: float, leg: float) -> float:
    """What rounding of the way makes of the room where it is zero: there the way is no longer than arm and leg."""
    return ROUNDING * unit.size * (arm + leg) ** 2 * min(arm, leg)


def _direction(way: complex, arm: float, leg: float, sign: int) -> complex:
    """Direction of the arm whose end a leg ties to the end of the way: (2) and (5) without their arccos."""
    d = abs(way)
    if not d:
        return complex(1.0)  # arm and leg are equal and lie on one another: any direction closes
    along, room = (arm * arm + (d - leg) * (d + leg)) / 2, _room(way, arm, leg)
    return way * complex(along, sign * sqrt(room) if room > 0 else 0.0) / (d * d * arm)


def _phi(unit: Unit, E: complex, e2: int) -> float:
    cut = E + unit.arm_C * _direction(unit.A - E, unit.l_BE, unit.l_AB, e2) - unit.D  # (7)
    return (abs(cut) - unit.l_CD) * (abs(cut) + unit.l_CD)  # (8)


def assemblies(unit: Unit) -> tuple[Assembly, ...]:
    """Find all real assemblies, sorted by alpha5.

    Where the two signs of a link meet they are halves of one closed loop, and Phi is smooth along the loop: none hides
    at the end of a branch. A tangency is one assembly of measure zero.

    Raises:
        SingularError: The unit moves: Phi is zero along a whole branch (passive constraints).
    """
    found: list[Assembly] = []
    rounding = _room_rounding(unit, unit.l_FH, unit.l_HK)
    for outer in _loops(lambda alpha5: _room(unit.K - _end_of_leg(unit, alpha5), unit.l_FH, unit.l_HK), rounding):

        def joint_E(t: float, outer: _Around = outer) -> tuple[float, complex]:
            alpha5, e4 = outer.at(t)
            F = _end_of_leg(unit, alpha5)
            return alpha5, F + unit.arm_E * _direction(unit.K - F, unit.l_FH, unit.l_HK, e4)

        limit = _room_rounding(unit, unit.l_BE, unit.l_AB)
        for inner in _loops(lambda t: _room(unit.A - joint_E(t)[1], unit.l_BE, unit.l_AB), limit):
            found += _on_loop(unit, joint_E, inner)
    return tuple(sorted(found, key=lambda one: one.alpha5))


def _zeros(closure: Callable[[float], float], rounding: float) -> list[loop.Zero]:
    try:
        return loop.zeros(closure, rounding)
    except SingularError:
        raise SingularError("the unit moves, or as good as: a closure is zero along a whole branch") from None


def _loops(room: Callable[[float], float], rounding: float) -> list[_Around]:
    """Divide a loop into the loops of both signs of the next link, which lives where its room is positive."""
    ends = [zero.at for zero in _zeros(room, rounding) if not zero.double]
    if not ends:
        return [_Around(sign=1), _Around(sign=-1)] if room(0.0) > 0 else []
    stretches = zip(ends, [*ends[1:], ends[0] + 2 * pi], strict=True)
    return [_Around((a + b) / 2, (b - a) / 2) for a, b in stretches if room((a + b) / 2) > 0]


def _on_loop(unit: Unit, joint_E: Callable[[float], tuple[float, complex]], around: _Around) -> Iterator[Assembly]:
    def phi(s: float) -> float:
        t, e2 = around.at(s)
        return _phi(unit, joint_E(t)[1], e2)

    lever = max(1.0, unit.l_CE / unit.l_BE)  # by which link 2 moves C farther than rounding moves its side EB
    for zero in _zeros(phi, ROUNDING * max(unit.size * lever, unit.l_CD) * unit.l_CD):
        t, e2 = around.at(zero.at)
        alpha5, E = joint_E(t)
        F = _end_of_leg(unit, alpha5)
        alpha4 = phase((E - F) / unit.arm_E)
        alpha2 = phase(_direction(unit.A - E, unit.l_BE, unit.l_AB, e2))
        yield assembly(unit, _settled(unit, (alpha5, alpha4, alpha2)))


def _settled(unit: Unit, start: Angles) -> Angles:
    """Take the last digits from Newton's method, which knows no branches; a tangency keeps what the scan found."""
    try:
        angles = newton(unit, start)[-1]
    except (AssemblyError, SingularError):
        return start
    near = all(abs(one - other) < SAME for one, other in zip(angles, start, strict=True))
    return angles if near else start


def assembly(unit: Unit, angles: Angles) -> Assembly:
    """Place the joints for the three angles of an assembly, in radians, and name its branch."""
    alpha5, alpha4, alpha2 = (angle % (2 * pi) for angle in angles)
    F = _end_of_leg(unit, alpha5)
    E = F + unit.arm_E * exp(1j * alpha4)
    along4, along2 = unit.K - F, unit.A - E
    signs = ((along.conjugate() * exp(1j * angle)).imag for along, angle in ((along4, alpha4), (along2, alpha2)))
    branch = "".join("-" if sign < 0 else "+" for sign in signs)
    C = E + unit.arm_C * exp(1j * alpha2)
    return Assembly(alpha5, alpha4, alpha2, branch, F, E, C, abs(_determinant(unit, angles)))


def newton(unit: Unit, start: Angles) -> list[Angles]:
    """Iterate on the three closures of the uncut unit: the start, every step, and last the assembly reached.

    Args:
        unit: The unit.
        start: alpha5, alpha4, alpha2, in radians.

    Raises:
        ValueError: An angle of the start is not finite.
        AssemblyError: The iteration does not settle; the message has the gap.
        SingularError: The closure equations are singular on the way.

    Source:
        Domain HC-4: f = |H-K|^2 - l_HK^2, |B-A|^2 - l_AB^2, |C-D|^2 - l_CD^2.
    """
    for name, angle in zip(("alpha5", "alpha4", "alpha2"), start, strict=True):
        finite(name, angle, "rad")
    found = [start]
    for _ in range(ROUNDS):
        gaps, slopes = _closures(unit, found[-1])
        step = linear.solve(slopes, [-gap for gap in gaps])
        a, b, c = (angle + turn for angle, turn in zip(found[-1], step, strict=True))
        found.append((a, b, c))
        if max(abs(turn) for turn in step) < SETTLED:
            return found
    gap = max(abs(gap) for gap in gaps)
    raise AssemblyError(
        f"no assembly is reached from this start: the closures stay {gap:.4g} (squares of length) apart"
    )


def _closures(unit: Unit, angles: Sequence[float]) -> tuple[list[float], list[list[float]]]:
    alpha5, alpha4, alpha2 = (exp(1j * angle) for angle in angles)
    GF, FH, FE, EB = unit.l_FG * alpha5, unit.l_FH * alpha4, unit.arm_E * alpha4, unit.l_BE * alpha2
    EC = unit.arm_C * alpha2
    F = unit.G + GF
    legs = (
        (F + FH - unit.K, unit.l_HK, (GF, FH, 0j)),
        (F + FE + EB - unit.A, unit.l_AB, (GF, FE, EB)),
        (F + FE + EC - unit.D, unit.l_CD, (GF, FE, EC)),
    )
    gaps = [leg.real**2 + leg.imag**2 - length**2 for leg, length, _ in legs]
    slopes = [[2 * (leg.conjugate() * 1j * arm).real for arm in arms] for leg, _, arms in legs]
    return gaps, slopes


def _determinant(unit: Unit, angles: Sequence[float]) -> float:
    """The determinant of the closures with rows of length one."""
    _, slopes = _closures(unit, angles)
    (a, b, c), (d, e, f), (g, h, i) = ([entry / (hypot(*row) or 1.0) for entry in row] for row in slopes)
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


class Critical(NamedTuple):
    parameter: float
    angles: Angles  # where two assemblies meet, rad
    below: int  # assemblies just below this parameter
    above: int


def critical(unit_at: Callable[[float], Unit], low: float, high: float) -> list[Critical]:
    """Find where two assemblies meet while one parameter of the unit runs from low to high.

    Args:
        unit_at: Gives the unit for a value of the parameter.
        low: Start of the range.
        high: End of the range.

    Returns:
        The singular positions, rising by the parameter; two that cancel each other inside the range are not seen.

    Raises:
        SingularError: More than two assemblies meet at once.

    Source:
        Domain HC-3: Phi = 0 and dPhi/dalpha5 = 0; here the closures and their determinant are zero.
    """
    return _critical(unit_at, (low, assemblies(unit_at(low))), (high, assemblies(unit_at(high))), high - low)


_Counted = tuple[float, tuple[Assembly, ...]]


def _critical(unit_at: Callable[[float], Unit], low: _Counted, high: _Counted, whole: float) -> list[Critical]:
    """Halve the range until the two assemblies are near each other, then take the last digits by Newton's method."""
    (start, first), (end, last) = low, high
    if len(first) == len(last):
        return []
    if abs(len(first) - len(last)) == 2 and end - start < NARROW * whole:
        parameter, angles = _meeting(unit_at, start, end, _lost(first, last))
        return [Critical(parameter, angles, len(first), len(last))]
    middle = (start + end) / 2
    if not start < middle < end:
        raise SingularError(f"more than two assemblies meet at {middle:g}")
    half = (middle, assemblies(unit_at(middle)))
    return _critical(unit_at, low, half, whole) + _critical(unit_at, half, high, whole)


def _lost(first: tuple[Assembly, ...], last: tuple[Assembly, ...]) -> Angles:
    """Give the mean angles of the two assemblies that only one side has: the nearest pair of neighbours."""
    more = max(first, last, key=len)
    pairs = zip(more, [*more[1:], more[0]], strict=True)
    one, other = min(pairs, key=lambda pair: abs(pair[0].E - pair[1].E) + abs(pair[0].C - pair[1].C))
    a, b, c = (x + principal(y - x) / 2 for x, y in zip(one[:3], other[:3], strict=True))
    return a, b, c


def _meeting(unit_at: Callable[[float], Unit], start: float, end: float, angles: Angles) -> tuple[float, Angles]:
    def gaps(at: Sequence[float]) -> list[float]:
        unit = unit_at(at[3])
        return [*_closures(unit, at[:3])[0], _determinant(unit, at[:3])]

    at = [*angles, (start + end) / 2]
    steps = [DIFFERENCE, DIFFERENCE, DIFFERENCE, DIFFERENCE * (end - start)]
    for _ in range(ROUNDS):
        columns = []
        for place, step in enumerate(steps):
            ahead, behind = ([x + sign * step * (i == place) for i, x in enumerate(at)] for sign in (1, -1))
            columns.append([(a - b) / (2 * step) for a, b in zip(gaps(ahead), gaps(behind), strict=True)])
        move = linear.solve(list(zip(*columns, strict=True)), [-gap for gap in gaps(at)])
        at = [x + dx for x, dx in zip(at, move, strict=True)]
        if max(abs(turn) for turn in move[:3]) < SETTLED:
            break
    a, b, c, parameter = at
    return parameter, (a % (2 * pi), b % (2 * pi), c % (2 * pi))
