"""A6: the unknown itself, later unknowns and the statement's own words are no answer."""

from __future__ import annotations

import pytest

from graders import Code
from graders.language import Reason
from graders.verdict import Reading
from tests.security.conftest import Attack


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("omega2", 0), ("ω2", 0), ("ω₂", 0), ("omega2 = omega2", 0), ("1*omega_2", 2), ("l1 + ω2 - l1", 5),
        ("-(-ω2)", 3), ("omega2/omega2*ω2", 0), ("v3", 0), ("(-v3 - l1*omega1*sin(alpha1))/(l2*sin(alpha2))", 2),
        ("0*l1 + omega2", 7), ("ω2^1", 0), ("abs(ω2)", 4),
    ],
)  # fmt: skip
def test_a_name_that_is_not_allowed_is_refused_with_its_place(attack: Attack, text: str, place: int) -> None:
    verdict = attack(text)
    assert verdict.code is Code.UNREADABLE
    assert isinstance(verdict.details, Reading)
    assert verdict.details.reason is Reason.FORBIDDEN_NAME
    if text.count("omega2") < 2:
        assert verdict.details.position == place


@pytest.mark.parametrize(
    "text", ["l1 = l1", "l1 = 60 mm", "omega2 = ", "= omega2", "alpha2 = alpha2", "x = x", "0 = 0"]
)
def test_a_copied_equation_earns_nothing(attack: Attack, text: str) -> None:
    assert attack(text).score == 0


@pytest.mark.parametrize(
    "text", ["l3", "l3 = l3", "l3 mm", "x", "l1*cos(alpha1) + l2*cos(alpha2)", "l3 = l3 mm", "alpha2"]
)
def test_a_name_is_no_number(attack: Attack, text: str) -> None:
    assert attack(text, "l3").code is Code.UNREADABLE
