"""What is said to rise or to fall along a symbol does so between any two of its values."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders.equality.rising import Trend, trends
from graders.language import Symbols, parse
from graders.language.doubles import DOUBLES
from graders.language.intervals import INTERVALS
from graders.language.program import Builder, Program, Runner

BOX = {"x": (0.1, 3.0), "a": (0.5, 1.5), "b": (-2.0, -0.5), "c": (-1.0, 1.0)}
RISES = [
    "x", "a*x", "x/a", "x - a", "c + x", "-b*x", "x^2", "x^3", "exp(x)", "ln(x)", "sqrt(x)", "root(x; 3)", "x^a",
    "sin(x/2)", "-cos(x)", "tan(x/2)", "asin(x/3)", "-acos(x/3)", "-1/x", "b/x", "a - exp(-x)", "x*ln(x + 1)",
    "|x|", "-|b*x|*b", "sinh(x)", "x^2 - a*cos(x) + c", "(a + x)^2", "-(b - x)^2*b", "-x^b", "a*x/(2 - cos(a))",
    "-acot(x)", "atan(x)", "x*(1 - c)",
]  # fmt: skip
FALLS = ["-x", "b*x", "1/x", "a - x", "cos(x)", "a*cos(x) - x^2", "x^b", "16*a/(pi*x^3) - a", "(x - 4)^2", "sin(x/2)/b"]
UNKNOWN = [
    "c*x", "sin(x)", "tan(x)", "(x - 1)^2", "x - x^2", "x/(x + 1)", "|x - 1|", "<x - 1>^1", "sign(x)", "atan2(x; a)",
    "1/(x - 1)", "sqrt(x - 1)", "asin(x)", "x*cos(x)", "cosh(x - 1)", "x^c", "a^x", "x/c", "exp(1e3*x)*x", "x + 0/c",
    "max(x; a)",
]  # fmt: skip


def program(text: str) -> Program:
    builder = Builder(list(BOX))
    return builder.program(builder.add(parse(text, Symbols(BOX))))


def way_of(text: str) -> Trend:
    whole = program(text)
    return trends(whole, Runner(whole, INTERVALS).slots(list(BOX.values())), 0)[whole.outputs[0]]


@pytest.mark.parametrize(
    ("text", "way"), [*((text, 1) for text in RISES), *((text, -1) for text in FALLS), ("a*c", 0), ("sin(c)/0.5", 0)]
)
def test_the_way_is_told(text: str, way: int) -> None:
    assert way_of(text) == way


@pytest.mark.parametrize("text", UNKNOWN)
def test_what_may_turn_back_or_break_off_is_not_told(text: str) -> None:
    assert way_of(text) in (None, 0)


@given(
    st.sampled_from([(text, 1) for text in RISES] + [(text, -1) for text in FALLS]),
    st.lists(st.floats(*BOX["x"]), min_size=2, max_size=6, unique=True),
    st.tuples(*(st.floats(*BOX[name]) for name in "abc")),
)
def test_values_follow_the_way(case: tuple[str, int], places: list[float], others: tuple[float, ...]) -> None:
    text, way = case
    runner = Runner(program(text), DOUBLES)
    values = [runner.run([x, *others])[0] for x in sorted(places)]
    assert all((after - before) * way >= -1e-9 * abs(before) for before, after in pairwise(values))
