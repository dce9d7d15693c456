"""The motion that follows from a student's own projections: position, velocity and acceleration of what is plotted.

The driven coordinates move by constant acceleration. The sought names are found by Newton's method, their rates from
the same equations, differentiated by the arithmetic of jets. Of the reference only the start of the search enters.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import reduce
from itertools import product

from exercises import catalogue, solving
from exercises.exercise import Variant
from exercises.givens import numbers
from exercises.words import with_unit
from figures import plot
from figures.machine import Machine
from figures.picture import Picture, Table, Words
from graders.language import Tree, parse_line
from graders.language.doubles import UndefinedError
from graders.language.tree import Binary, Call, Name, Unary, names
from graders.polygon.drawn import Drawn, Vector
from graders.polygon.jets import Trio, jet
from graders.words import decimal, printed_unit

POINTS = 41
TURNS = 30  # of Newton's method
SMALL = 1e-12
UNITS = (("m", "f-pos"), ("m/s", "f-vel"), ("m/s^2", "f-acc"))  # with the style of the line
ROUND = (-2.6, -1.4, -0.3, 0.3, 1.4, 2.6)  # rad, where a sought angle may begin
SIZE = 0.3  # m, where a sought length does
Pair = tuple[float, float]


def own_motion(variant: Variant, drawn: Drawn) -> dict[str, tuple[Trio, ...]]:
    """Give what is plotted at equal steps of time, with its rates; empty where two projections do not lead to it."""
    exercise, solved = catalogue.load(variant.exercise).exercise, solving.solved(variant)
    sought, trees = drawn.unknowns or (), [equation.difference for equation in drawn.equations]
    if exercise.machine is None or len(sought) != 2 or len(trees) != 2:
        return {}
    machine, values = exercise.machine(variant.givens), numbers(variant.givens)
    derived = [(name, parse_line(line)) for name, line in solved.reference("polygon").derived]
    plotted = _coordinates(machine, drawn, sought)
    truth = {name: float(value) for name, value in solved.values.items() if isinstance(value, float | int)}
    found: dict[str, list[Trio]] = {name: [] for name in plotted}
    try:
        at = _begun(
            trees, sought, _known(machine, values, derived, 0.0), plotted, _guesses(drawn, sought, truth), truth
        )
        for k in range(POINTS):
            known = _known(machine, values, derived, machine.span * k / (POINTS - 1))
            at = _placed(trees, sought, known, at)
            moving = known | _moving(trees, sought, known, at)
            for name, tree in plotted.items():
                found[name].append(moving[tree.name] if isinstance(tree, Name) else jet(tree, moving))
        return {name: tuple(row) for name, row in found.items()}
    except (UndefinedError, KeyError, ZeroDivisionError):
        return {}


def _coordinates(machine: Machine, drawn: Drawn, sought: Sequence[str]) -> dict[str, Tree]:
    """Write what is plotted: its own name where it is sought, else the sum of the vectors of sought lengths."""
    closing = [one for one in drawn.vectors if names(one.length).intersection(sought)]
    found: dict[str, Tree] = {one.name: Name(one.name) for one in machine.plotted}
    for one in machine.plotted if closing else ():
        if one.name not in sought:
            parts = (_along(vector, one.axis, machine) for vector in closing)
            found[one.name] = reduce(lambda left, right: Binary("+", left, right), parts)
    return found


def _along(vector: Vector, axis: str, machine: Machine) -> Tree:
    """Project a vector, taken towards the last node: nodes lead there by the alphabet, its foot stands before it."""
    last = machine.links[-1].end
    start, end = ((node == last, node) for node in (vector.start, vector.end))
    part = Binary("*", vector.length, Call("cos" if axis == "x" else "sin", (vector.angle,)))
    return part if end >= start else Unary("-", part)


def _guesses(drawn: Drawn, sought: Sequence[str], truth: Mapping[str, float]) -> Iterator[Pair]:
    """Give where the search may begin: at the truth where a name is that of the task, else all round or at a length."""
    angles = {name for vector in drawn.vectors for name in names(vector.angle)}
    first, second = ([truth[name]] if name in truth else ROUND if name in angles else [SIZE] for name in sought)
    yield from product(first, second)


def _begun(
    trees: Sequence[Tree], sought: Sequence[str], known: Mapping[str, Trio], plotted: Mapping[str, Tree],
    guesses: Iterable[Pair], truth: Mapping[str, float],
) -> Pair:  # fmt: skip
    """Solve the projections at the start from several guesses, and keep the assembly nearest to the true one.

    Raises:
        UndefinedError: They have no solution there.
    """
    found: list[tuple[float, Pair]] = []
    for guess in guesses:
        with suppress(UndefinedError, ZeroDivisionError):
            at = _placed(trees, sought, known, guess)
            here = {**known, **{name: (value, 0.0, 0.0) for name, value in zip(sought, at, strict=True)}}
            found.append((sum(abs(jet(tree, here)[0] - truth[name]) for name, tree in plotted.items()), at))
    if not found:
        raise UndefinedError("the projections have no solution here")
    return min(found)[1]


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
