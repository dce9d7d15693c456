"""Signs that follow: from other signs, from the box, from the points that were looked at."""

from __future__ import annotations

import math
from contextlib import suppress

import pytest
from flint import arb
from hypothesis import assume, given
from hypothesis import strategies as st

from graders import Domain
from graders.equality import Finding, between
from graders.equality.inside import one_signed
from graders.equality.probing import look
from graders.equality.sides import whole
from graders.equality.signs import Signed, implied, screened
from graders.language import parse_line
from graders.language.balls import BALLS, precision
from graders.language.doubles import DOUBLES, UndefinedError
from graders.language.intervals import INTERVALS
from graders.language.program import Builder, Program, Runner

BOX = {"x": Domain(0, 1), "y": Domain(-1, 0), "z": Domain(-1, 1), "n": Domain(0, 3, integer=True)}
factors = st.floats(-9, 9).filter(lambda x: abs(x) > 1e-3)
columns = st.lists(st.floats(0.01, 9), min_size=3, max_size=3)


def program_of(text: str) -> Program:
    builder = Builder(tuple(BOX))
    return builder.program(builder.add(parse_line(text)))


def has_one_sign(text: str) -> bool:
    program = program_of(text)
    slots = Runner(program, INTERVALS).slots(whole(tuple(BOX.values())))
    return program.outputs[0] in one_signed(program, slots, tuple(BOX.values()))


@given(columns, columns, factors, factors, st.booleans(), st.booleans())
def test_a_sum_has_the_sign_of_its_terms(
    a: list[float], b: list[float], first: float, second: float, one_below: bool, other_below: bool
) -> None:
    with precision(128):
        one = [arb(-x if one_below else x) for x in a]
        other = [arb(-x if other_below else x) for x in b]
        inside = [arb(first) * x + arb(second) * y for x, y in zip(one, other, strict=True)]
        found = implied(inside, [Signed(one, one_below)], [screened(Signed(other, other_below))])
    below = {(factor < 0) is not sign for factor, sign in ((first, one_below), (second, other_below))}
    assert found is None or below == {found}


@given(columns, columns, columns)
def test_a_column_that_hangs_on_nothing_known_has_any_sign(a: list[float], b: list[float], c: list[float]) -> None:
    determinant = abs(sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3)))
    ratios = [[x * y**way / z for x, y, z in zip(b, c, a, strict=True)] for way in (1, -1)]
    assume(determinant > 1e-3 and all(max(ratio) > 1.001 * min(ratio) for ratio in ratios))
    with precision(128):
        balls = [[arb(x) for x in column] for column in (a, b, c)]
        assert implied(balls[0], [Signed(balls[1], False)], [screened(Signed(balls[2], False))]) is None


@pytest.mark.parametrize(
    "text",
    [
        "x",
        "-y",
        "x*y",
        "x/(1 + x)",
        "x - y",
        "x + y^2",
        "1 - x",
        "sqrt(x)*y",
        "x - 1",
        "exp(-900*x)",
        "x^1.5",
        "2 - n/2",
    ],
)
def test_what_vanishes_at_an_end_alone_has_one_sign(text: str) -> None:
    assert has_one_sign(text)


@pytest.mark.parametrize(
    "text",
    [
        "n",
        "z",
        "x + y",
        "x - x^2 - 1/4",
        "z^2",
        "abs(z)",
        "sin(z)^2",
        "1 - cos(z)",
        "0*x",
        "1 - sqrt(abs(z))",
        "sqrt(z)",
    ],
)
def test_what_may_vanish_inside_has_none(text: str) -> None:
    assert not has_one_sign(text)


terms = st.recursive(
    st.sampled_from(("x", "y", "z", "n", "1", "0.5")),
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from("+-*/"), inner),
        st.builds("{}({})".format, st.sampled_from(("sqrt", "abs", "exp", "ln", "asin", "atan", "1 - ", "-")), inner),
        st.builds("({})^{}".format, inner, st.sampled_from("23")),
    ),
    max_leaves=6,
)
shares = st.floats(0.01, 0.99)


@given(terms, st.tuples(shares, shares, shares), st.tuples(shares, shares, shares))
def test_one_sign_is_that_of_every_value_inside(
    text: str, one: tuple[float, float, float], other: tuple[float, float, float]
) -> None:
    assume(has_one_sign(text))
    runner, values = Runner(program_of(text), DOUBLES), []
    for share, whole_number in ((one, 0.0), (other, 3.0)):
        point = [low + (high - low) * at for at, (low, high) in zip(share, ((0, 1), (-1, 0), (-1, 1)), strict=True)]
        values += [value for value in look(runner, (*point, whole_number)) if math.isfinite(value)]
    assert all(value > 0 for value in values) or all(value < 0 for value in values)


@pytest.mark.parametrize(
    ("a", "b", "finding"),
    [
        ("x + <x - 0.5>^1 - <x - 0.5001>^1 - 0.0001*<x - 0.5001>^0", "x", Finding.DIFFERENT),
        ("sign(x - 0.3)", "tanh(1e9*(x - 0.3))", Finding.DIFFERENT),
        ("abs(x - 0.3) + abs(z)", "sqrt((x - 0.3)^2) + max(z; -z)", Finding.EQUAL),
        ("atan2(-z; -y)", "atan2(z; y) - pi*sign(z)", Finding.EQUAL),
        ("<z>^1*<x - 0.3>^1*<z - 0.999>^0", "0", Finding.DIFFERENT),
    ],
)
def test_points_that_were_met_are_enough_only_where_each_sign_changes_alone(a: str, b: str, finding: Finding) -> None:
    assert between(parse_line(a), parse_line(b), BOX, b"met").finding is finding
    assert between(parse_line(b), parse_line(a), BOX, b"met").finding is finding


@pytest.mark.parametrize("outer", ["ln({})", "<{}>^0/0.5", "sign(1/{})", "(1/{})^0", "atan2(1/{}; -1)"])
def test_what_is_not_sure_to_have_a_value_is_not_called_undefined(outer: str) -> None:
    a, b = (parse_line(outer.format(inner)) for inner in ("acos(x/x)", "(pi/2 - asin(x*(1/x)))"))
    assert not {between(a, b, BOX).finding, between(b, a, BOX).finding} & {Finding.DIFFERENT, Finding.UNDEFINED}


@pytest.mark.parametrize("name", sorted(set(BALLS.functions) - {"pi", "integer_power"}))
def test_nothing_has_a_value_where_an_argument_is_not_sure_to_have_one(name: str) -> None:
    unsure, function, found = arb("nan"), BALLS.functions[name], []
    for arguments in ((unsure,), (unsure, arb(0)), (unsure, arb(2)), (unsure, arb(-1))):
        with suppress(TypeError, UndefinedError):
            found.append(function(*arguments).is_finite())
    assert found and not any(found)
