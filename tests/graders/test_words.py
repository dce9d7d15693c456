"""Verdicts in words where their code alone is known."""

from __future__ import annotations

import math

import pytest

from graders import Quantity, Set
from graders.verdict import Code
from graders.words import LANGUAGES, taken, titled
from tests.graders.judging import judged


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_code_alone_is_worded_with_its_gaps_left_open(lang: str) -> None:
    assert titled("wrong_angle", lang).count("…") == 1
    assert not any("{" in titled(code, lang) or "…." in titled(code, lang) for code in Code)


def test_a_code_that_has_no_sentence_has_no_title() -> None:
    assert titled("of_another_version", "en") == ""


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize(("unit", "bare", "other"), [("deg", 40.0, math.radians(40)), ("rad", 0.7, math.degrees(0.7))])
def test_an_angle_is_taken_in_the_units_that_the_words_tell(lang: str, unit: str, bare: float, other: float) -> None:
    named = taken(unit, lang).split()[-1]
    angle = bare if unit == "rad" else other
    for typed in (f"{bare}", f"{other:.6f} {named}"):
        assert judged(Quantity(unit), typed, angle) is Code.RIGHT
        assert judged(Set(unit), typed, ((angle,),)) is Code.RIGHT


@pytest.mark.parametrize("unit", ["", "mm", "rad/s", "deg/m"])
def test_what_is_no_angle_is_told_by_its_unit_alone(unit: str) -> None:
    assert taken(unit, "en") == ""
