"""The figures of the reference solvers that are no times: closure over a full cycle, random machines, worked examples.

The random machines are a thousand of each kind, drawn and checked as in `benchmarks/structures.py`, `linkages.py` and
`machines.py`, where more can be tried; `benchmarks/mechanics.py` prints all of it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from math import pi
from random import Random

from mechanics import four_bar, planar, six_bar, slider_crank, two_loop
from mechanics.cycle import follow
from mechanics.newton_linkages import four_bar_joints
from tests.mechanics import hostile, hostile_linkages, judged_machines
from tests.mechanics.examples.reading import EXAMPLES, inputs, unlike
from tests.mechanics.examples.test_examples import SOLVED
from tests.mechanics.hostile_linkages import Side, back, residual, slid, turned

BARS = (0.1, 0.26, 0.22, 0.3)  # the crank turns fully
RATES = (12.0, -8.0)  # of the crank
POSITIONS = 720
EACH = 1000  # random machines of a kind


def _slider_crank(angle: float) -> float:
    motion = slider_crank.solve(0.1, 0.3, angle, *RATES, 0.02)
    rail = [slid(motion, "slider_x"), Side(0.02, pi / 2)]
    return residual([Side(0.1, angle, *RATES), turned(motion, 0.3, "alpha2"), *map(back, rail)])


def _four_bar(angle: float) -> float:
    l1, l2, l3, l4 = BARS
    motion = four_bar.solve(*BARS, angle, *RATES)
    rocker = back(turned(motion, l3, "alpha3"))
    return residual([Side(l1, angle, *RATES), turned(motion, l2, "alpha2"), rocker, Side(l4, pi)])


def _six_bar(angle: float) -> float:
    motion = six_bar.solve(*BARS, angle, (0.4, 0.2), 0.3, 0.28, *RATES)
    links = [turned(motion, 0.3, "alpha5"), back(turned(motion, 0.28, "alpha6"))]
    return residual([Side(BARS[0], angle, *RATES), *links, Side(0.4, pi), Side(0.2, -pi / 2)])


def _two_loop(angle: float) -> float:
    motion = two_loop.solve(*BARS, 0.35, 0.05, angle, *RATES)
    bars = [turned(motion, BARS[2], "alpha3"), turned(motion, 0.35, "alpha5")]
    return residual([Side(BARS[3]), *bars, back(slid(motion, "s6")), Side(0.05, -pi / 2)])


CYCLES: dict[str, Callable[[float], float]] = {
    "slider-crank": _slider_crank, "four-bar": _four_bar, "six-bar": _six_bar, "two loops": _two_loop
}  # fmt: skip


def _bodies() -> float:
    """Follow the four-bar as bodies; its joints in place, velocity and acceleration."""
    l1, l2, l3, l4 = BARS
    angles = [2 * pi * i / POSITIONS for i in range(POSITIONS + 1)]
    first = four_bar.solve(*BARS, 0.0)
    start = [(0.0, 0.0, 0.0), (l1, 0.0, first.pos["alpha2"]), (l4, 0.0, first.pos["alpha3"])]
    course = follow(lambda angle: four_bar_joints(*BARS, angle, *RATES), angles, start)
    assert course.dead is None
    worst = 0.0
    for motion in course.motions:
        for one, other in ((planar.Marker(1, l1), planar.Marker(2)), (planar.Marker(2, l2), planar.Marker(3, l3))):
            for a, b in zip(motion.point(one), motion.point(other), strict=True):
                worst = max(worst, abs(complex(*a) - complex(*b)) / (abs(complex(*a)) + abs(complex(*b)) or 1.0))
    return worst


def cycles() -> Iterator[str]:
    """Say how well each linkage closes, with its velocities and accelerations, over a full turn of the crank."""
    for name, gap in CYCLES.items():
        worst = max(gap(2 * pi * i / POSITIONS) for i in range(POSITIONS))
        yield f"{name}, closure and its two derivatives over a full cycle: residual {worst:.1e}"
    yield f"four-bar as bodies by Newton's method over a full cycle: residual {_bodies():.1e}"


def random_machines() -> Iterator[str]:
    """Say what came of random machines, many of them nearly singular; anything but a named refusal is raised."""
    structures = ((kind, hostile.attack(1, EACH, kind)) for kind in hostile.KINDS)
    linkages = ((kind, hostile_linkages.attack(1, EACH, kind)) for kind in hostile_linkages.KINDS)
    for source in (structures, linkages):
        for kind, found in source:
            refused = sum(found.refused.values())
            yield f"{EACH} random {kind}: solved {found.solved}, refused {refused}; residual {found.worst:.1e}"
    for judge in (judged_machines.train, judged_machines.structure):
        outcomes = Counter(judge(Random(f"1:{number}")) for number in range(EACH))
        said = ", ".join(f"{name} {count}" for name, count in outcomes.most_common())
        yield f"{EACH} random drawings of a {judge.__name__}: {said}"


def examples() -> str:
    """Say how many worked examples of the domain are reproduced to their printed digits."""
    right = sum(not unlike(name, solve(inputs(name))) for name, solve in SOLVED.items())
    return f"worked examples of the domain reproduced to their printed digits: {right} of {len(EXAMPLES)}"
