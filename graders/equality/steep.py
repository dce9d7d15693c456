"""Where a formula without a bracket may hide a difference: an exponential is nothing but near its greatest exponent."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

from graders.equality.probing import look
from graders.equality.sides import whole
from graders.judge import Domain
from graders.language.doubles import DOUBLES
from graders.language.intervals import INTERVALS
from graders.language.program import Program, Runner
from graders.states import Point

EXPONENTS = frozenset(("exp", "sinh", "cosh", "tanh"))
STEEP = EXPONENTS | {"^"}
HIGH = 12  # powers from which a product of small numbers is nothing
WIDE = 30.0  # of an exponent: beyond, a summand may be less than 30 digits of another
MOST = 6  # exponents that are followed
LEAST_STEP, STILL = 1e-12, 12  # of a domain; steps without a gain behind which there is a summit


def steep(program: Program) -> bool:
    """Tell whether a program holds exponentials or high powers."""
    return any(name in STEEP or (name[:5] == "power" and int(name[5:]) >= HIGH) for name, _ in program.operations)


def summits(program: Program, box: Sequence[Domain], points: Sequence[Point]) -> list[Point]:
    """Give points where the exponents of a program are greatest and least, as far as they range widely."""
    slots = Runner(program, INTERVALS).slots(whole(box))
    wide = [
        arguments[0] for name, arguments in program.operations
        if name in EXPONENTS and not slots[arguments[0]][1] - slots[arguments[0]][0] < WIDE
    ]  # fmt: skip
    found = []
    for slot in wide[:MOST]:
        exponent = program.only(slot)
        found += [_summit(exponent, box, points, way) for way in (1.0, -1.0)]
    return found


def _summit(exponent: Program, box: Sequence[Domain], points: Sequence[Point], way: float) -> Point:
    """Climb along the symbols of an exponent from the highest of some points."""
    runner, moving = Runner(exponent, DOUBLES), exponent.moving
    height, best = max((_number(way * look(runner, point)[0]), point) for point in points)
    step, still = 0.5, 0
    while step > LEAST_STEP and still < STILL:
        before = height
        for at, width in product(moving, (-step, step)):
            domain = box[at]
            moved = min(max(best[at] + width * (domain.high - domain.low), domain.low), domain.high)
            moved = float(round(moved)) if domain.integer else moved
            if moved == best[at]:
                continue
            tried = (*best[:at], moved, *best[at + 1 :])
            value = way * look(runner, tried)[0]
            if value > height:
                height, best = value, tried
        step, still = step / 2, still + 1 if height == before else 0
    return best


def _number(value: float) -> float:
    return -math.inf if math.isnan(value) else value
