"""Closing in on a zero takes few values, wherever the function bends, and ends at the jump where there is no zero."""

from __future__ import annotations

from collections.abc import Callable
from math import atan, exp, nan, pi, tan

import pytest

from graders.solutions.closing import closed_in, lowest


def closing(function: Callable[[float], float], ends: tuple[float, float], close: float = 1e-13) -> tuple[float, int]:
    seen = list[float]()

    def counted(x: float) -> float:
        seen.append(x)
        return function(x)

    return closed_in(counted, ends, (function(ends[0]), function(ends[1])), close), len(seen)


@pytest.mark.parametrize(
    ("function", "ends", "zero", "most"),
    [
        (lambda x: x - 0.7, (-1.0, 3.0), 0.7, 8),
        (lambda x: exp(x) - 2, (-1.0, 3.0), 0.6931471805599453, 12),
        (lambda x: tan(x) - 40, (0.0, 1.57), 1.5458015331759765, 20),
        (lambda x: x**9 - 1e-9, (-1.0, 3.0), 0.1, 30),
        (lambda x: atan(1e9 * (x - 0.3)), (-1.0, 3.0), 0.3, 50),
        (lambda x: abs(x - 2) - 0.1, (2.0, 2.5), 2.1, 8),
    ],
)
def test_a_zero_is_closed_in_on_with_few_values(
    function: Callable[[float], float], ends: tuple[float, float], zero: float, most: int
) -> None:
    for way in (ends, ends[::-1]):
        found, count = closing(function, way)
        assert found == pytest.approx(zero, abs=1e-12)
        assert count <= most


def test_a_jump_is_closed_in_on_by_halves() -> None:
    found, count = closing(lambda x: 1.0 if x > 0.123 else -1.0, (-1.0, 3.0))
    assert found == pytest.approx(0.123, abs=1e-12)
    assert count <= 50


def test_where_there_is_no_value_it_ends() -> None:
    found, count = closing(lambda x: nan if -0.5 < x < 2.5 else x - 1, (-1.0, 3.0))
    assert (-0.5 < found < 2.5, count) == (True, 1)


def test_the_lowest_place_of_a_value_is_found() -> None:
    assert lowest(lambda x: (x - pi) ** 2, 0.0, 4.0) == pytest.approx(pi, abs=1e-6)
