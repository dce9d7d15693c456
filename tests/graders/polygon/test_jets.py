"""Rates and sensitivities of formulas against differences and against the doubles of the language."""

from __future__ import annotations

from math import isfinite

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders.language import parse_line
from graders.language.doubles import UndefinedError, line_runner, run
from graders.polygon.jets import FUNCTIONS, Trio, jet, sensitive
from graders.polygon.walks import rank
from tests.depth import amount

FORMULAS = [
    "a + b - a*b/(2 + b)",
    "a^3 - 2*a^b + b^0 + a^1 + a^-2",
    "sin(a)*cos(b) + tan(a/4) - cot(b)",
    "asin(a/9) + acos(b/9)",
    "atan(a) + acot(b)",
    "sinh(a/3) + cosh(b/3) + tanh(a)",
    "exp(-a) + ln(b) + log(a) + log(a; 3)",
    "sqrt(a*b) + abs(a - b)",
    "sign(a) + min(a; b) + max(a; b)",
    "atan2(a; b)",
    "root(a; 3) + <a - 0.1>^2 + <b - 9>^2",
    "-a*30° + pi*b",
    "12°30'*a",
    "2^a",
    "a^2.5 + (a*b)^2",
]
values = st.floats(0.3, 2.0)


@settings(max_examples=amount(8, 25), deadline=None)
@given(a=values, b=values, da=st.floats(-1, 1), db=st.floats(-1, 1), dda=st.floats(-1, 1))
@pytest.mark.parametrize("text", FORMULAS)
def test_rates_are_the_differences_of_values(text: str, a: float, b: float, da: float, db: float, dda: float) -> None:
    tree, step = parse_line(text), 1e-4
    if abs(a - b) < 1e-2:
        return

    def at(t: float) -> float:
        (value,) = run(
            line_runner(tree),
            [x for x, name in ((a + da * t + dda * t * t / 2, "a"), (b + db * t, "b")) if name in text],
        )
        return float(value)

    found = jet(tree, {"a": (a, da, dda), "b": (b, db, 0.0)})
    assert found[0] == pytest.approx(at(0), rel=1e-12)
    assert found[1] == pytest.approx((at(step) - at(-step)) / (2 * step), rel=1e-5, abs=1e-5)
    assert found[2] == pytest.approx((at(step) - 2 * at(0) + at(-step)) / step**2, rel=1e-3, abs=1e-3)


@settings(max_examples=amount(8, 25), deadline=None)
@given(a=values, b=values)
@pytest.mark.parametrize("text", FORMULAS)
def test_a_sensitivity_is_at_least_what_a_small_change_does(text: str, a: float, b: float) -> None:
    tree, shift = parse_line(text), 1e-7
    value, size = sensitive(tree, {"a": a, "b": b})
    assert size >= abs(value) * (1 - 1e-12)
    moved, _ = sensitive(tree, {"a": a * (1 + shift), "b": b * (1 - shift)})
    assert abs(moved - value) <= 1.01 * shift * size + 1e-12


def test_a_sum_that_cancels_keeps_the_size_of_its_terms() -> None:
    value, size = sensitive(parse_line("3*(a - a*1)"), {"a": 5.0})
    assert value == 0 and size >= 30


def test_every_function_has_finite_slopes_inside_its_domain() -> None:
    for slopes in FUNCTIONS.values():
        assert all(map(isfinite, slopes(0.4)))


@pytest.mark.parametrize("text", ["1/(a - a)", "sqrt(-a)", "(-a)^0.5", "ln(a - a)", "exp(1000*a)*1e308*10"])
def test_what_has_no_value_is_undefined(text: str) -> None:
    still: Trio = (2.0, 0.0, 0.0)
    with pytest.raises(UndefinedError):
        jet(parse_line(text), {"a": still})


def test_a_macaulay_bracket_is_still_before_it_opens() -> None:
    assert jet(parse_line("<a - 5>^2"), {"a": (1.0, 1.0, 1.0)}) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ([], 0),
        ([{}], 0),
        ([{"a": 1.0, "b": 2.0}, {"a": 2.0, "b": 4.0}], 1),
        ([{"a": 1e-9, "b": 2e-9}, {"a": 1e9, "b": 1.0}], 2),
        ([{"a": 1.0}, {"b": 1.0}, {"a": 1.0, "b": -1.0}], 2),
    ],
)
def test_rank_counts_independent_rows(rows: list[dict[str, float]], expected: int) -> None:
    assert rank(rows) == expected
