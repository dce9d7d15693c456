"""A4: what hangs a computer algebra system is not in the language."""

from __future__ import annotations

import pytest

from graders import Code
from graders.language import Reason
from graders.language.symbols import FUNCTIONS
from graders.verdict import Reading
from tests.security.conftest import Attack

WORDS = [
    "limit", "integrate", "diff", "simplify", "Piecewise", "Sum", "Product", "factorial", "gamma", "binomial", "zeta",
    "solve", "dsolve", "series", "factor", "expand", "Integral", "Derivative", "erf", "besselj", "hyper", "floor",
    "mod", "gcd", "prime", "fibonacci", "Matrix", "det", "sum", "prod", "int", "float", "Symbol", "S", "Rational",
]  # fmt: skip


@pytest.mark.parametrize("word", WORDS)
@pytest.mark.parametrize("call", ["{}(l1)", "{}(l1; l2)", "{}(sin(l1)/l1; l1; 0)"])
def test_the_word_is_unknown_at_its_place(attack: Attack, word: str, call: str) -> None:
    verdict = attack("2 + " + call.format(word))
    assert verdict.code is Code.UNREADABLE
    assert isinstance(verdict.details, Reading)
    assert (verdict.details.reason, verdict.details.position) == (Reason.UNKNOWN_NAME, 4)


def test_the_functions_of_the_language_are_the_elementary_ones() -> None:
    assert set(FUNCTIONS) == {
        "sin", "cos", "tan", "cot", "asin", "acos", "atan", "acot", "atan2", "sinh", "cosh", "tanh", "exp", "ln", "log",
        "sqrt", "root", "abs", "sign", "min", "max", "macaulay",
    }  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "+".join(f"max({k}*l1; l2; min(l1; {k}))" for k in range(60)),
        "*".join(f"<l1 - 0,0{k}>^3" for k in range(10, 99)),
        "+".join(f"|l1 - 0,0{k}|*sign(l2 - 0,{k})" for k in range(10, 90)),
    ],
)
def test_many_branches_do_not_explode(attack: Attack, text: str) -> None:
    assert attack(text).score == 0
