"""A11: a formula that equals the reference only where it is tested, or that has no value there, is not accepted."""

from __future__ import annotations

from decimal import Decimal

import pytest

from exercises import catalogue
from exercises.solving import NO_SECRET, Solved
from graders import Code, Expression, Formula
from graders.language import parse
from tests.security.conftest import SECRET, VARIANT, Attack

RIGHT = "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))"


def judged(text: str, secret: bytes) -> Code:
    solved = Solved(catalogue.load("slider_crank").exercise, VARIANT, secret)
    symbols = solved.symbols("omega2_formula")
    reference = solved.reference("omega2_formula")
    assert isinstance(reference, Formula)
    return Expression("omega2").check(parse(text, symbols), reference).code


def forged(secret: bytes) -> str:
    """Vanish at every point drawn from a secret, with all the figures of its doubles."""
    solved = Solved(catalogue.load("slider_crank").exercise, VARIANT, secret)
    states = solved.states("omega2")
    omegas = [Decimal(point[states.names.index("omega1")]) for point in states.points]
    return f"{RIGHT} + " + "*".join(f"(ω1-{omega})" for omega in omegas)


def test_points_that_are_known_can_be_fooled_and_secret_ones_cannot() -> None:
    attack = forged(NO_SECRET)
    assert judged(attack, NO_SECRET) is Code.RIGHT
    assert judged(attack, SECRET) is Code.WRONG


def test_points_depend_on_the_secret_and_on_the_variant() -> None:
    solved = Solved(catalogue.load("slider_crank").exercise, VARIANT, SECRET)
    again = Solved(catalogue.load("slider_crank").exercise, VARIANT, SECRET)
    other = Solved(catalogue.load("slider_crank").exercise, VARIANT, SECRET + b"!")
    assert solved.states("omega2").points == again.states("omega2").points
    assert not set(solved.states("omega2").points) & set(other.states("omega2").points)


@pytest.mark.parametrize(
    "text",
    [
        f"{RIGHT} + sin(1000000*pi*l1)",
        f"{RIGHT} + sin(pi*200*l1)*sin(pi*200*l2)",
        f"{RIGHT}*(1 + 1e-25)",
        f"{RIGHT} + 1e-25",
        f"{RIGHT} + exp(-1000*l1)",
        f"{RIGHT} + <l1 - 0,119>^1",
        f"{RIGHT} + max(0; omega1 - 39)",
        "-0.333*l1*omega1*cos(alpha1)/(0.333*l2*cos(alpha2)) + 1e-9*l1",
    ],
)
def test_a_difference_too_small_for_doubles_is_proved(attack: Attack, text: str) -> None:
    assert attack(text).score == 0


@pytest.mark.parametrize(
    "text",
    [
        "0/0", "1/(l1 - l1)", "sqrt(-l1)", "ln(-l1)", "asin(2 + l1)", "0^-1", f"{RIGHT} + 0/0",
       
        f"({RIGHT})*(l1-l1)/(l1-l1)",
        f"({RIGHT})*sqrt(-l1)/sqrt(-l1)", f"({RIGHT})*ln(-1)/ln(-1)", f"{RIGHT} + 0*ln(0)", "tan(pi/2)", "(-l1)^0,5",
        f"({RIGHT})*sqrt(cos(alpha1))/sqrt(cos(alpha1))", f"({RIGHT})*acos(ω1)/acos(ω1)",
    ],
)  # fmt: skip
def test_an_answer_without_a_value_is_never_right(attack: Attack, text: str) -> None:
    assert attack(text).score == 0
    assert attack(text).code is not Code.RIGHT
