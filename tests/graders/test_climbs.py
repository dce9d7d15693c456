"""What only rises or falls along every symbol is looked at in a corner, and nowhere else."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import pytest

from graders.equality import Finding, between
from graders.equality.sides import Part, ends
from graders.judge import Domain
from graders.language import Symbols, parse

BOX = {"t": Domain(0.0, 3.0), "b": Domain(0.5, 40.0), "m": Domain(0.1, 50.0), "x": Domain(0.3, 2.0)}


def compared(a: str, b: str, box: Mapping[str, Domain] = BOX) -> Finding:
    symbols = Symbols(box)
    return between(parse(a, symbols), parse(b, symbols), box, b"climbs").finding


@pytest.mark.parametrize(
    ("one", "other", "finding"),
    [
        ("m*exp(-b*t/(2*m))", "m*(exp(-b/(2*m)))^t", Finding.EQUAL),
        ("m + exp(-b*t*9)", "m", Finding.DIFFERENT),  # only where t is next to nothing
        ("1 + exp(-b*(x - 0.3)*999)", "1", Finding.DIFFERENT),
    ],
)
def test_an_exponent_without_a_turn_is_greatest_in_a_corner(
    one: str, other: str, finding: Finding, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("graders.equality.steep.look", lambda *_: pytest.fail("nothing is climbed"))
    assert compared(one, other) is finding


def test_an_exponent_that_turns_is_climbed() -> None:
    assert compared("1 + exp(900 - 1e6*(x - 0.7123)^2 - 300*b)*exp(-750)", "1") is Finding.DIFFERENT


def test_an_argument_without_a_turn_is_not_searched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Part, "_bounded", lambda *_: pytest.fail("it is least in a corner"))
    box = {"x": Domain(0.4, 1.0), "y": Domain(0.4, 1.0)}
    assert compared("abs(1/x + 1/y - x*y - 0.9)", "1/x + 1/y - x*y - 0.9", box) is Finding.EQUAL


def test_the_corner_of_what_has_another_side_there_is_found() -> None:
    box = {"x": Domain(0.4, 1.0), "y": Domain(0.4, 1.0)}
    assert compared("abs(1/x + 1/y - x*y - 1.01)", "1/x + 1/y - x*y - 1.01", box) is Finding.DIFFERENT


@pytest.mark.parametrize(
    ("value", "most"),
    [
        (lambda x: x - 0.7123, 4),
        (lambda x: x**3 - 0.2, 20),
        (lambda x: math.exp(9 * x) - 2, 24),
        (lambda x: 0.31 - x * x, 20),
        (lambda x: 1e-9 - (1 - x) ** 9, 75),
        (lambda x: math.copysign(1.0, x - 0.123), 75),
        (lambda x: 1 / (x - 0.3), 75),
    ],
)
def test_a_border_is_enclosed_by_a_few_values(value: Callable[[float], float], most: int) -> None:
    asked = list[float]()

    def listened(point: tuple[float, ...]) -> float:
        asked.append(point[0])
        return value(point[0])

    domains = (Domain(0.0, 1.0),)
    part = Part(listened, lambda _: True, lambda box: box[0], domains, ends(domains), (0,), (), 1, 1, False, tuple)
    low, high = part._border((0.0,), (1.0,))
    assert 0 < high - low <= 1e-10 and (value(low) > 0) is not (value(high) > 0)
    assert len(asked) <= most
