"""Intervals of doubles hold every value that a formula takes on the box."""

from __future__ import annotations

import math
import random

import pytest

from graders.language import parse_line
from graders.language.doubles import DOUBLES, UndefinedError, run
from graders.language.intervals import INTERVALS
from graders.language.program import Builder, Runner
from tests.depth import amount

LINES = [
    "x*y - x/(y + 3)", "x*x", "x^2 - y^3", "sin(3*x) + cos(5*y)", "tan(x/3)*cot(y/9 + 2)", "asin(x/3)*acos(y/3)",
    "atan(x) + acot(y)", "atan2(x; y)", "atan2(y; x + 9)", "sinh(x) - cosh(y)*tanh(x)", "exp(x - y)", "ln(x + 9)",
    "log(y + 9; 2)", "log(x + 9)", "sqrt(x + 2)", "root(x; 3) + root(y + 9; 4)", "abs(x)*sign(y)",
    "min(x; y) - max(x; 2*y)", "<x - y>^2", "<x>^0", "(x + 9)^y", "(x + 9)^-2", "x^-1", "-x°", "pi*x",
    "sqrt(-1 - x^2)", "1/sqrt(x)", "x^0.5", "sin(40*x)*cos(40*y)", "(1/x)*(1/y)",
]  # fmt: skip


@pytest.mark.parametrize("line", LINES)
def test_an_interval_holds_the_values_of_its_points(line: str) -> None:
    builder, chance = Builder(("x", "y")), random.Random(line)
    program = builder.program(builder.add(parse_line(line)))
    doubles, intervals = Runner(program, DOUBLES), Runner(program, INTERVALS)
    for _ in range(amount(20, 60)):
        box = [tuple(sorted((chance.uniform(-3, 3), chance.uniform(-3, 3)))) for _ in range(2)]
        low, high = intervals.run(box)[0]
        for _ in range(8):
            try:
                (value,) = run(doubles, [chance.uniform(*side) for side in box])
            except UndefinedError:
                continue
            slack = 1e-12 * (1 + abs(value))
            assert not low - slack > value and not high + slack < value


@pytest.mark.parametrize(
    ("line", "box", "expected"),
    [
        ("x*x", [(-1, 2)], (0, 4)),
        ("x^2 + 1", [(-1, 2)], (1, 5)),
        ("sin(x)", [(0, 2)], (0, 1)),
        ("cos(x)", [(3, 4)], (-1, math.cos(4))),
        ("sqrt(x)", [(-1, 4)], (0, 2)),
        ("<x - 1>^1", [(0, 3)], (0, 2)),
        ("1/x", [(2, 4)], (0.25, 0.5)),
        ("abs(x)", [(-3, 1)], (0, 3)),
    ],
)
def test_an_interval_is_no_wider_than_it_must_be(
    line: str, box: list[tuple[float, float]], expected: tuple[float, float]
) -> None:
    builder = Builder(("x",))
    program = builder.program(builder.add(parse_line(line)))
    assert Runner(program, INTERVALS).run(box)[0] == pytest.approx(expected)
