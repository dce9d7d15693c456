"""Where a formula without a bracket may hide a difference: an exponential is nothing but near its greatest exponent."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from itertools import product

from graders.equality.probing import look, looks
from graders.equality.rising import Trend, trends
from graders.equality.sides import whole
from graders.equality.turns import EXPONENTS, HIGH, may_be_steep
from graders.judge import Domain
from graders.language.doubles import DOUBLES
from graders.language.intervals import INTERVALS, Interval
from graders.language.program import Program, Runner
from graders.states import Point

WIDE = 30.0  # of an exponent: beyond, a summand may be less than 30 digits of another
MOST = 6  # exponents that are followed
LEAST_STEP, STILL = 1e-12, 12  # of a domain; steps without a gain behind which there is a summit


def steep(program: Program, slots: Sequence[Interval]) -> frozenset[int]:
    """Give the slots of exponentials and high powers that range widely, as far as the ranges of all slots tell."""
    return frozenset(
        slot for slot, (name, arguments) in enumerate(program.operations, len(program.inputs))
        if may_be_steep(name)
        and not (slots and (_gentle(name, slots[arguments[0]], slots[slot]) or _low(name, slots[arguments[-1]])))
    )  # fmt: skip


def _gentle(name: str, exponent: Interval, values: Interval) -> bool:
    """Tell whether no value is less than 30 digits of another: by the exponent, or of a power by the values."""
    if name in EXPONENTS:
        return exponent[1] - exponent[0] < WIDE
    least, greatest = sorted(map(abs, values))
    return values[0] * values[1] > 0 and greatest < math.exp(WIDE) * least


def _low(name: str, exponent: Interval) -> bool:
    """Tell a power whose exponent is one low number, which is no steeper than a low whole power."""
    return name == "^" and exponent[0] == exponent[1] and abs(exponent[0]) < HIGH


def summits(
    program: Program, steep_slots: Collection[int], box: Sequence[Domain], points: Sequence[Point]
) -> list[Point]:
    """Give points where the exponents of steep slots are greatest and least."""
    start, found = len(program.inputs), []
    steep_ones = (program.operations[slot - start] for slot in sorted(steep_slots))
    for argument in [arguments[0] for name, arguments in steep_ones if name in EXPONENTS][:MOST]:
        exponent = program.only(argument)
        ranges = Runner(exponent, INTERVALS).slots(whole(box))
        known = {at: trends(exponent, ranges, at)[exponent.outputs[0]] for at in exponent.moving}
        found += [_summit(exponent, known, box, points, way) for way in (1.0, -1.0)]
    return found


def _summit(
    exponent: Program, known: Mapping[int, Trend], box: Sequence[Domain], points: Sequence[Point], way: float
) -> Point:
    """Climb along the symbols of an exponent from the highest of some points.

    An end of those along which it only rises or falls is the summit.
    """
    runner, moving = Runner(exponent, DOUBLES), [at for at, own in known.items() if own is None]
    rows = zip(looks(runner, points), points, strict=True)
    height, best = max((_number(way * row[0]), point) for row, point in rows)
    ends = {at: box[at].high if own * way > 0 else box[at].low for at, own in known.items() if own}
    best = tuple([ends.get(at, x) for at, x in enumerate(best)])
    height = _number(way * look(runner, best)[0]) if moving else height
    step, still = 0.5, 0
    while moving and step > LEAST_STEP and still < STILL:
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
