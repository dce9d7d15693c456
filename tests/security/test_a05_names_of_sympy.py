"""A5: names that mean something in a computer algebra system are plain symbols where declared, unknown elsewhere."""

from __future__ import annotations

from itertools import combinations

import pytest

from graders import Code, Expression, Formula, States, Symbols
from graders.language import Reason, parse_line
from graders.verdict import Reading
from tests.security.conftest import Attack

NAMES = ("E", "I", "S", "N", "O", "Q", "e", "beta", "gamma", "zeta", "lambda", "j", "C")
POINTS = tuple(tuple(0.3 + (k * (n + 2) * 0.618034) % 1 for n in range(len(NAMES))) for k in range(1, 17))
STATES = States(NAMES, POINTS)
SYMBOLS = Symbols(NAMES)


def judged(typed: str, line: str) -> Code:
    judge = Expression("z")
    return judge.check(judge.parse(typed, SYMBOLS), Formula(parse_line(line), STATES)).code


@pytest.mark.parametrize(("one", "other"), list(list(combinations(NAMES, 2))))
def test_declared_names_are_symbols_and_not_one_another(one: str, other: str) -> None:
    assert judged(f"{one}*{other}^2", f"{other}*{one}*{other}") is Code.RIGHT
    assert judged(f"{one} {other}", f"{other} {one}") is Code.RIGHT
    assert judged(one, other) is Code.WRONG


@pytest.mark.parametrize(
    ("typed", "line", "code"),
    [
        ("E*I", "I*E", Code.RIGHT),
        ("E·I·λ", "lambda*E*I", Code.RIGHT),
        ("I^2", "-1", Code.WRONG),
        ("E", "exp(1)", Code.WRONG),
        ("ln(E)", "1", Code.WRONG),
        ("j^2", "-1", Code.WRONG),
        ("e", "exp(1)", Code.WRONG),
        ("e^2", "exp(2)", Code.WRONG),
        ("N(2)", "2*N", Code.RIGHT),
        ("gamma(3)", "2", Code.WRONG),
        ("beta(2)/ζ", "2*beta/zeta", Code.RIGHT),
        ("S(1)/2", "1/2", Code.WRONG),
        ("Q*O", "0", Code.WRONG),
    ],
)
def test_no_name_brings_a_constant_or_a_function(typed: str, line: str, code: Code) -> None:
    assert judged(typed, line) is code


@pytest.mark.parametrize("name", NAMES)
def test_an_undeclared_name_is_unknown(attack: Attack, name: str) -> None:
    verdict = attack(f"2*{name}")
    assert isinstance(verdict.details, Reading)
    assert (verdict.details.reason, verdict.details.position) == (Reason.UNKNOWN_NAME, 2)
