"""The motion that follows from a student's own projections: position, velocity and acceleration of what is plotted.

The driven coordinates move by constant acceleration. The sought names are found by Newton's method, their rates from
the same equations, differentiated by the arithmetic of jets. Of the reference only the start of the search enters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from exercises import catalogue, solving
from exercises.exercise import Variant
from exercises.givens import numbers
from exercises.words import with_unit
from figures import plot
from figures.machine import Machine
from figures.picture import Picture, Table, Words
from graders.language import Tree, parse_line
from graders.language.doubles import UndefinedError
from graders.polygon.drawn import Drawn
from graders.polygon.jets import Trio, jet
from graders.words import decimal, printed_unit

POINTS = 41
TURNS = 30  # of Newton's method
SMALL = 1e-12
UNITS = (("m", "f-pos"), ("m/s", "f-vel"), ("m/s^2", "f-acc"))  # with the style of the line
Pair = tuple[float, float]


def own_motion(variant: Variant, drawn: Drawn) -> dict[str, tuple[Trio, ...]]:
    """Give what is plotted at equal steps of time, with its rates; empty where two projections do not lead to it."""
    exercise, solved = catalogue.load(variant.exercise).exercise, solving.solved(variant)
    sought, trees = drawn.unknowns or (), [equation.difference for equation in drawn.equations]
    if exercise.machine is None or len(sought) != 2 or len(trees) != 2:
        return {}
    machine, values = exercise.machine(variant.givens), numbers(variant.givens)
    derived = [(name, parse_line(line)) for name, line in solved.reference("polygon").derived]
    found: list[dict[str, Trio]] = []
    at = _start(solved.values, sought)
    try:
        for k in range(POINTS):
            known = _known(machine, values, derived, machine.span * k / (POINTS - 1))
            at = _placed(trees, sought, known, at)
            found.append(known | _moving(trees, sought, known, at))
        return {one.name: tuple(row[one.name] for row in found) for one in machine.plotted}
    except (UndefinedError, KeyError, ZeroDivisionError):
        return {}


def _start(values: Mapping[str, object], sought: Sequence[str]) -> Pair:
    first, second = (value if isinstance(value := values.get(name), float) else 0.1 for name in sought)
    return first, second


def _known(
    machine: Machine, values: Mapping[str, float], derived: Sequence[tuple[str, Tree]], t: float
) -> dict[str, Trio]:
    """Give all names but the sought ones with their rates at a moment."""
    found: dict[str, Trio] = {name: (value, 0.0, 0.0) for name, value in values.items()}
    for drive in machine.drives:
        rate, surge = values.get(drive.rate, 0.0), values.get(drive.surge, 0.0)
        found[drive.name] = (values[drive.name] + rate * t + surge * t * t / 2, rate + surge * t, surge)
    for name, tree in derived:
        found[name] = jet(tree, found)
    return found


def _placed(trees: Sequence[Tree], sought: Sequence[str], known: Mapping[str, Trio], start: Pair) -> Pair:
    """Solve the projections from a start.

    Raises:
        UndefinedError: No solution was found.
    """
    at = start
    for _ in range(TURNS):
        off = _rates(trees, known, sought, at, (0.0, 0.0), 0)
        if max(map(abs, off)) < SMALL * (1 + max(map(abs, at))):
            return at
        step = _divided(_slopes(trees, sought, known, at), off)
        at = (at[0] - step[0], at[1] - step[1])
    raise UndefinedError("the projections have no solution here")


def _moving(trees: Sequence[Tree], sought: Sequence[str], known: Mapping[str, Trio], at: Pair) -> dict[str, Trio]:
    """Give the sought names with their rates: the same slopes divide what moves without them."""
    slopes = _slopes(trees, sought, known, at)
    speed = _divided(slopes, _rates(trees, known, sought, at, (0.0, 0.0), 1))
    speed = (-speed[0], -speed[1])
    surge = _divided(slopes, _rates(trees, known, sought, at, speed, 2))
    return {name: (at[k], speed[k], -surge[k]) for k, name in enumerate(sought)}


def _rates(
    trees: Sequence[Tree], known: Mapping[str, Trio], sought: Sequence[str], at: Pair, speed: Pair, order: int
) -> Pair:
    """Give the values of both equations (order 0), or their rates, the sought names moving at a speed."""
    moving = {**known, **{name: (at[k], speed[k], 0.0) for k, name in enumerate(sought)}}
    first, second = (jet(tree, moving)[order] for tree in trees)
    return first, second


def _slopes(trees: Sequence[Tree], sought: Sequence[str], known: Mapping[str, Trio], at: Pair) -> tuple[Pair, Pair]:
    """Give how both equations change with each sought name while all else stands."""
    still = {name: (value[0], 0.0, 0.0) for name, value in known.items()}
    return (
        _rates(trees, still, sought, at, (1.0, 0.0), 1),
        _rates(trees, still, sought, at, (0.0, 1.0), 1),
    )


def _divided(slopes: tuple[Pair, Pair], right: Pair) -> Pair:
    """Solve two linear equations by Cramer's rule; raises ZeroDivisionError where they do not determine both."""
    (a, c), (b, d) = slopes
    size = a * d - b * c
    return (right[0] * d - b * right[1]) / size, (a * right[1] - right[0] * c) / size


def plots(name: str, moved: Sequence[Trio], variant: Variant, title: str, language: str) -> Picture:
    """Plot a coordinate with its rates over the time of the motion."""
    make = catalogue.load(variant.exercise).exercise.machine
    assert make is not None
    machine = make(variant.givens)
    shown = next(one for one in machine.plotted if one.name == name)
    series = [
        _series(symbol, order, [row[order] for row in moved], language)
        for order, symbol in enumerate((shown.name, shown.rate, shown.surge))
    ]
    end = with_unit(decimal(machine.span, language, 2), "s", language)
    return plot.draw(f"plot-{name.replace('_', '-')}", Words(title, title, Table((), ())), end, series)


def _series(symbol: str, order: int, values: Sequence[float], language: str) -> plot.Series:
    unit, style = UNITS[order]
    least, largest = (decimal(value, language, 3) for value in (min(0.0, *values), max(0.0, *values)))
    return plot.Series(symbol, printed_unit(unit, language), style, tuple(values), least, largest)
