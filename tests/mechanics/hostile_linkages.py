"""Random linkages, many of them in or near a dead position, and how well the solvers close them.

A linkage is refused by a named error, for a reason that is checked, or solved; a solved one gives the greatest residual
of its closures and their two derivatives, as a part of the terms that are about. All follows from the seed.
"""

from __future__ import annotations

from cmath import exp, phase
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from math import pi
from random import Random
from typing import NamedTuple

from mechanics import (
    class_iii,
    four_bar,
    inverted_slider,
    manipulator,
    newton_linkages,
    planar,
    six_bar,
    slider_crank,
    two_loop,
    variable_length_link,
)
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import LinkageMotion, principal

NEAR = 1e-6  # measure and relative gap that a refusal may be wrong by


class Side(NamedTuple):
    """A side of a polygon: its length and angle with two rates each."""

    length: float
    angle: float = 0.0
    omega: float = 0.0
    epsilon: float = 0.0
    speed: float = 0.0
    acceleration: float = 0.0

    def terms(self) -> tuple[list[complex], ...]:
        along, across = exp(1j * self.angle), 1j * exp(1j * self.angle)
        coriolis = 2 * self.speed * self.omega * across
        centripetal = -self.length * self.omega**2 * along
        tangential = self.length * self.epsilon * across
        return (
            [self.length * along],
            [self.speed * along, self.length * self.omega * across],
            [self.acceleration * along, coriolis, centripetal, tangential],
        )


def residual(sides: Iterable[Side]) -> float:
    """Give the greatest gap of a polygon and of its derivatives, each as a part of its terms."""
    worst = 0.0
    for terms in zip(*(side.terms() for side in sides), strict=True):
        flat = [term for part in terms for term in part]
        size = sum(abs(term) for term in flat)
        worst = max(worst, abs(sum(flat)) / size if size else 0.0)
    return worst


def turned(motion: LinkageMotion, length: float, name: str) -> Side:
    """Give a side of constant length whose angle the solver found."""
    return Side(length, motion.pos[name], motion.vel[name], motion.acc[name])


def slid(motion: LinkageMotion, name: str, angle: float = 0.0) -> Side:
    """Give a side of constant direction whose length the solver found."""
    return Side(motion.pos[name], angle, speed=motion.vel[name], acceleration=motion.acc[name])


def back(side: Side) -> Side:
    """Give a side that is passed against its sense."""
    return side._replace(angle=side.angle + pi)


class Drive(NamedTuple):
    angle: float
    omega: float
    epsilon: float


def _drive(rng: Random) -> Drive:
    return Drive(rng.uniform(-10, 10), rng.uniform(-30, 30), rng.uniform(-100, 100))


def _length(rng: Random) -> float:
    return float(10 ** rng.uniform(-2, 1))


def _nearly(rng: Random, value: float) -> float:
    """Change a value by a part between one third and less than rounding, either way."""
    return value * (1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-17, -0.5))


def _slider_crank(rng: Random) -> float:
    drive, l1, offset = _drive(rng), _length(rng), rng.uniform(-1, 1)
    climb = abs(offset - l1 * exp(1j * drive.angle).imag)
    l2 = _nearly(rng, climb) if rng.random() < 0.5 else climb + _length(rng)
    branches: tuple[slider_crank.Branch, ...] = ("slider_right", "slider_left")
    branch = rng.choice(branches)
    with Reasons(climb / l2 - 1, (1 - (climb / l2) ** 2) if climb < l2 else 0.0):
        motion = slider_crank.solve(l1, l2, *drive, offset, branch)
    rail = [slid(motion, "slider_x"), Side(offset, pi / 2)]
    return residual([Side(l1, *drive), turned(motion, l2, "alpha2"), *map(back, rail)])


def _reach(drive: Drive, l1: float, l4: float) -> float:
    return abs(l4 - l1 * exp(1j * drive.angle))


def _pair(rng: Random, apart: float) -> tuple[float, float]:
    """Give two bars over a distance, many of them stretched or folded in line, or as good as."""
    first = _length(rng)
    match rng.randrange(4):
        case 0:
            return first, abs(_nearly(rng, abs(apart - first))) or first
        case 1:
            return first, _nearly(rng, apart + first)
        case _:
            return first, abs(apart - first) + rng.random() * (apart + first - abs(apart - first))


def _sine(apart: float, l2: float, l3: float) -> float:
    cosine = (l2 * l2 + l3 * l3 - apart * apart) / (2 * l2 * l3)
    return max(0.0, 1 - cosine * cosine)


def _missing(apart: float, l2: float, l3: float) -> float:
    return max(apart - l2 - l3, abs(l2 - l3) - apart) / max(apart, l2, l3)


class Bars(NamedTuple):
    l1: float
    l2: float
    l3: float
    l4: float
    drive: Drive
    mode: four_bar.Mode


def _bars(rng: Random) -> Bars:
    drive, l1, l4 = _drive(rng), _length(rng), _length(rng)
    l2, l3 = _pair(rng, _reach(drive, l1, l4))
    modes: tuple[four_bar.Mode, ...] = ("C_left_of_BD", "C_right_of_BD")
    return Bars(l1, l2, l3, l4, drive, rng.choice(modes))


def _first_loop(bars: Bars, motion: LinkageMotion) -> float:
    crank, coupler = Side(bars.l1, *bars.drive), turned(motion, bars.l2, "alpha2")
    return residual([crank, coupler, back(turned(motion, bars.l3, "alpha3")), Side(bars.l4, pi)])


def _four_bar(rng: Random) -> float:
    bars = _bars(rng)
    apart = _reach(bars.drive, bars.l1, bars.l4)
    with Reasons(_missing(apart, bars.l2, bars.l3), _sine(apart, bars.l2, bars.l3)):
        motion = four_bar.solve(*bars[:4], *bars.drive, bars.mode, (0.3, -0.2))
    return _first_loop(bars, motion)


def _six_bar(rng: Random) -> float:
    bars = _bars(rng)
    u, v, gx, gy = (rng.uniform(-1, 1) for _ in range(4))
    base = four_bar.solve(*bars[:4], *bars.drive, bars.mode, (u, v))
    apart = abs(complex(gx - base.pos["P_x"], gy - base.pos["P_y"]))
    l5, l6 = _pair(rng, apart)
    with Reasons(_missing(apart, l5, l6), _sine(apart, l5, l6)):
        motion = six_bar.solve(*bars[:4], bars.drive.angle, (gx, gy), l5, l6, *bars.drive[1:], bars.mode, (u, v))
    arm, along = complex(u, v), turned(motion, 1.0, "alpha2")
    to_P = along._replace(length=abs(arm), angle=along.angle + phase(arm))
    links = [turned(motion, l5, "alpha5"), back(turned(motion, l6, "alpha6"))]
    second = [Side(bars.l1, *bars.drive), to_P, *links, Side(gx, pi), Side(gy, -pi / 2)]
    return max(_first_loop(bars, motion), residual(second))


def _two_loop(rng: Random) -> float:
    bars, h6 = _bars(rng), rng.uniform(-1, 1)
    alpha3 = four_bar.solve(*bars[:4], *bars.drive, bars.mode).pos["alpha3"]
    climb = abs(h6 - bars.l3 * exp(1j * alpha3).imag)
    l5 = _nearly(rng, climb) if rng.random() < 0.5 else climb + _length(rng)
    with Reasons(climb / l5 - 1, (1 - (climb / l5) ** 2) if climb < l5 else 0.0):
        motion = two_loop.solve(*bars[:4], l5, h6, *bars.drive, bars.mode)
    rail = [back(slid(motion, "s6")), Side(h6, -pi / 2)]
    second = [Side(bars.l4), turned(motion, bars.l3, "alpha3"), turned(motion, l5, "alpha5"), *rail]
    return max(_first_loop(bars, motion), residual(second))


def _inverted_slider(rng: Random) -> float:
    drive, l1 = _drive(rng), _length(rng)
    pivot = _nearly(rng, l1) * exp(1j * _nearly(rng, drive.angle)) if rng.random() < 0.6 else complex(_length(rng), 0.3)
    with Reasons(0.0, (abs(l1 * exp(1j * drive.angle) - pivot) / (l1 + abs(pivot))) ** 2):
        motion = inverted_slider.solve(l1, *drive, (pivot.real, pivot.imag))
    slide = slid(motion, "s")._replace(angle=motion.pos["phi"], omega=motion.vel["phi"], epsilon=motion.acc["phi"])
    return residual([Side(abs(pivot), phase(pivot)), slide, back(Side(l1, *drive))])


def _variable_length_link(rng: Random) -> float:
    AC, BC = _length(rng), _length(rng)
    low, high = abs(AC - BC), AC + BC
    drive = rng.choice((_nearly(rng, high), _nearly(rng, low) or high, rng.uniform(low, high)))
    rates = rng.uniform(-1, 1), rng.uniform(-1, 1)
    gap = max(low - drive, drive - high) / high
    with Reasons(gap, _sine(drive, AC, BC)):
        motion = variable_length_link.solve(AC, BC, drive, *rates)
    lever = Side(BC, pi - motion.pos["beta"], -motion.vel["beta"], -motion.acc["beta"])
    link = turned(motion, drive, "alpha")._replace(speed=rates[0], acceleration=rates[1])
    return residual([link, back(lever), Side(AC, pi)])


def _manipulator(rng: Random) -> float:
    word = "".join(rng.choice("RP") for _ in range(rng.randint(1, 8)))
    q, qd, qdd = ([rng.uniform(-3, 3) for _ in word] for _ in range(3))
    lengths, delta = [rng.uniform(0, 2) for _ in range(word.count("R"))], rng.uniform(-3, 3)
    motion = manipulator.solve(word, q, lengths, qd, qdd, delta)
    sides, direction = [], (0.0, 0.0, 0.0)
    links = iter(lengths)
    for joint, *values in zip(word, q, qd, qdd, strict=True):
        if joint == "R":
            direction = (direction[0] + values[0], direction[1] + values[1], direction[2] + values[2])
            sides.append(Side(next(links), *direction))
        else:
            sides.append(Side(values[0], direction[0] + delta, *direction[1:], *values[1:]))
    tip = [slid(motion, "p_x", pi), slid(motion, "p_y", -pi / 2)]
    return residual([*sides, *tip])


def nearly_singular_unit(rng: Random) -> tuple[class_iii.Unit, float]:
    """Draw a class III unit that closes; in half of the cases leg CD is nearly normal to the way C can move."""
    A, D, G, K, B, C, E, F, H = (complex(rng.uniform(-1, 1), rng.uniform(-1, 1)) for _ in range(9))
    if rng.random() < 0.5:
        # with CD cut: GF turns by a, link 4 by b, link 2 by c, so that KH and AB keep their lengths
        g, h, e, d = F - G, H - F, E - F, B - E
        r1, r2 = ([_across(leg, arm) for arm in arms] for leg, arms in ((H - K, (g, h, 0j)), (B - A, (g, e, d))))
        turns = [r1[i - 2] * r2[i - 1] - r1[i - 1] * r2[i - 2] for i in range(3)]
        way = 1j * (turns[0] * g + turns[1] * e + turns[2] * (C - E))
        D = C + abs(C - D) * 1j * way / abs(way) * exp(1j * 10 ** rng.uniform(-17, -0.5))
    sigma2, sigma4 = (
        1 if (one.conjugate() * other).imag > 0 else -1 for one, other in ((B - E, C - E), (H - F, E - F))
    )
    side_2, side_4 = (abs(B - C), abs(B - E), abs(C - E)), (abs(E - F), abs(E - H), abs(F - H))
    unit = class_iii.Unit(
        A, D, G, K, abs(A - B), *side_2, abs(C - D), *side_4, abs(F - G), abs(H - K), sigma2, sigma4
    )  # fmt: skip
    return unit, phase(F - G)


def _across(leg: complex, arm: complex) -> float:
    return (leg.conjugate() * 1j * arm).real


def _class_iii(rng: Random) -> float:
    unit, alpha5 = nearly_singular_unit(rng)
    found = class_iii.assemblies(unit)
    nearest = min(found, key=lambda one: abs(principal(one.alpha5 - alpha5)))
    allowed = 1e-8 if nearest.measure > 1e-3 else 1e-3  # where two meet, an angle is the root of a rounding error
    assert abs(principal(nearest.alpha5 - alpha5)) < allowed, f"the drawn position {alpha5} is not among them"
    worst = 0.0
    for one in found:
        H, B = one.F + unit.l_FH * exp(1j * one.alpha4), one.E + unit.l_BE * exp(1j * one.alpha2)
        legs = (
            (one.F - unit.G, unit.l_FG), (H - unit.K, unit.l_HK), (B - unit.A, unit.l_AB), (one.C - unit.D, unit.l_CD),
            (one.E - one.F, unit.l_EF), (one.E - H, unit.l_EH), (one.C - one.E, unit.l_CE), (one.C - B, unit.l_BC),
        )  # fmt: skip
        worst = max(worst, *(abs(abs(leg) - length) / length for leg, length in legs))
    return worst


def _bodies(rng: Random) -> float:
    """Move a four-bar as bodies from the position of its neighbour, which may lie beyond a dead position."""
    bars = _bars(rng)
    joints = newton_linkages.four_bar_joints(*bars[:4], *bars.drive)
    side = 1 if bars.mode == "C_left_of_BD" else -1
    pin = bars.l1 * exp(1j * bars.drive.angle)
    coupler = phase(bars.l4 - pin) + side * rng.uniform(0, 2)
    start = [(0.0, 0.0, bars.drive.angle), (pin.real, pin.imag, coupler), (bars.l4, 0.0, coupler + side)]
    motion = planar.solve(joints, start)
    ends = motion.point(planar.Marker(2, bars.l2)), motion.point(planar.Marker(3, bars.l3))
    worst = 0.0
    for one, other in zip(*ends, strict=True):
        size = abs(complex(*one)) + abs(complex(*other))
        worst = max(worst, abs(complex(*one) - complex(*other)) / (size or 1.0))
    return worst


KINDS: dict[str, Callable[[Random], float]] = {
    "slider_crank": _slider_crank,
    "four_bar": _four_bar,
    "six_bar": _six_bar,
    "two_loop": _two_loop,
    "inverted_slider": _inverted_slider,
    "variable_length_link": _variable_length_link,
    "manipulator": _manipulator,
    "class_iii": _class_iii,
    "bodies": _bodies,
}


class Reasons:
    """Check a refusal inside: a gap that is there, or a square of a sine that is as good as zero."""

    def __init__(self, gap: float, square: float) -> None:
        self.gap, self.square = gap, square

    def __enter__(self) -> None: ...

    def __exit__(self, kind: object, error: object, where: object) -> None:
        if isinstance(error, AssemblyError):
            assert self.gap > -NEAR, f"refused, but {self.gap} is no gap: {error}"
        if isinstance(error, SingularError):
            assert self.square < NEAR, f"refused, but {self.square} is no dead position: {error}"


@dataclass
class Found:
    """What came of many linkages of one kind."""

    solved: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    worst: float = 0.0
    at: str = ""


def attack(seed: int, count: int, kind: str) -> Found:
    """Try linkages of one of `KINDS`; anything but a solution or a named refusal is raised."""
    found = Found()
    for number in range(count):
        name = f"{seed}/{kind}/{number}"
        try:
            worst = KINDS[kind](Random(name))
        except (AssemblyError, SingularError) as refusal:
            found.refused[type(refusal).__name__] += 1
            continue
        found.solved += 1
        if not worst <= found.worst:
            found.worst, found.at = worst, name
    return found
