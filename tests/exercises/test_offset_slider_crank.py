"""What the offset slider-crank promises beyond the contract of every exercise: any right equation and condition is."""

from __future__ import annotations

from functools import lru_cache

import pytest

from exercises import variants
from exercises.catalogue import load
from exercises.solving import Solved
from graders import Code, Verdict


@lru_cache(maxsize=1)
def solved() -> Solved:
    return Solved(load("offset_slider_crank").exercise, variants.deal("offset_slider_crank", 4))


def judged(name: str, text: str) -> Verdict:
    grader = solved().answers[name]
    return grader.check(grader.parse(text, solved().symbols(name)), solved().reference(name))


@pytest.mark.parametrize(
    "text",
    [
        "(l3 - l1*cos(alpha1))^2 + (h - l1*sin(alpha1))^2 - l2^2 = 0",
        "l2² = (l1 cos α1 − l3)² + (l1 sin α1 − h)²",
        "l3^2 - 2*l1*l3*cos(alpha1) + l1^2 + h^2 - 2*l1*h*sin(alpha1) - l2^2 = 0",
        "l1^2 + l3^2 + h^2 - l2^2 = 2*l1*(l3*cos(alpha1) + h*sin(alpha1))",
        "l2 = sqrt((l3 - l1*cos(alpha1))^2 + (h - l1*sin(alpha1))^2)",
        "|l3 - l1*cos(alpha1)| = sqrt(l2^2 - (h - l1*sin(alpha1))^2)",
        "(l3 - l1*cos(alpha1))^2 = (l2 - h + l1*sin(alpha1))*(l2 + h - l1*sin(alpha1))",
        "((l3 - l1*cos(alpha1))/l2)^2 + ((h - l1*sin(alpha1))/l2)^2 = 1",
        "l3 = l1*cos(alpha1) + sqrt(l2^2 - (h - l1*sin(alpha1))^2)",  # the slider is on the positive side
        "l3 = l1*cos(alpha1) + l2*cos(asin((h - l1*sin(alpha1))/l2))",
        r"\left(l_{3}-l_{1}\cos\alpha_{1}\right)^{2}+\left(h-l_{1}\sin\alpha_{1}\right)^{2}=l_{2}^{2}",
    ],
)
def test_an_equation_of_the_position_is_right_however_it_is_written(text: str) -> None:
    assert judged("position", text).code is Code.RIGHT


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("l3 = l1*cos(alpha1) - sqrt(l2^2 - (h - l1*sin(alpha1))^2)", Code.NOT_SATISFIED),
        ("(l3 - l1*cos(alpha1))^2 + (h + l1*sin(alpha1))^2 = l2^2", Code.NOT_SATISFIED),
        ("(l3 - l1*cos(alpha1))^2 + (l1*sin(alpha1))^2 = l2^2", Code.NOT_SATISFIED),
        ("((l3 - l1*cos(alpha1))^2 + (h - l1*sin(alpha1))^2 - l2^2)*(l3 - l1) = 0", Code.SURPLUS_SOLUTION),
        ("0*l3 = 0", Code.UNDETERMINED),
    ],
)
def test_what_an_equation_loses_or_adds_is_named(text: str, code: Code) -> None:
    assert judged("position", text).code is code


@pytest.mark.parametrize(
    "text",
    [
        "l2 >= l1 + h",
        "l1 + h ≤ l2",
        "l2 - h >= l1",
        "0 <= l2 - l1 - h",
        "(l1 + h)/l2 <= 1",
        "h <= l2 - l1",
        "-l2 <= -l1-h",
    ],
)
def test_the_condition_of_a_full_turn_is_right_however_it_is_written(text: str) -> None:
    assert judged("turning", text).code is Code.RIGHT


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("l2 > l1 + h", Code.BORDER),
        ("l2 >= l1", Code.WRONG),
        ("l2 <= l1 + h", Code.SENSE_TURNED),
        ("l2 >= l1 - h", Code.WRONG),
    ],
)
def test_a_condition_of_another_mechanism_is_not(text: str, code: Code) -> None:
    assert judged("turning", text).code is code
