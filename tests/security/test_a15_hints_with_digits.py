"""A15: hints and verdicts are worded without values: no hint has a place for a number, no message holds a reference."""

from __future__ import annotations

import re

import pytest

from exercises import catalogue
from exercises.exercise import Submission
from exercises.grading import grade
from exercises.solving import Solved
from exercises.variants import deal, predictions
from graders import Quantity
from graders.words import LANGUAGES, message

EVERY = pytest.mark.parametrize("exercise", catalogue.ids())


@EVERY
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_hint_has_no_place_for_a_number(exercise: str, language: str) -> None:
    for name, hint in catalogue.load(exercise).words[language]["mistakes"].items():
        assert "{{" not in hint, name
        assert not re.search(r"\d[.,]\d", re.sub(r"\$[^$]*\$", "", hint)), name


@EVERY
def test_no_message_holds_a_digit_of_the_reference(exercise: str) -> None:
    variant = deal(exercise, 4)
    solved = Solved(catalogue.load(exercise).exercise, variant)
    for _, expected in predictions(solved).items():
        typed = {name: judge.show(expected[name]) for name, judge in solved.answers.items()}
        verdicts = grade(Submission(variant, typed)).verdicts
        for name, judge in solved.answers.items():
            if isinstance(judge, Quantity):
                figures = re.sub(r"\D", "", judge.show(solved.reference(name)).split()[0])[:4].lstrip("0")
                said = message(verdicts[name], "en")
                assert len(figures) < 3 or figures not in re.sub(r"\D", "", said)
