"""The figure of every exercise, over many variants: all in view, no text on a text, no line through a text."""

from __future__ import annotations

import pytest

from exercises import catalogue
from exercises.presenting import presented
from exercises.variants import deal
from tests.depth import amount
from tests.figures.reading import assert_sound


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_texts_of_the_figure_of_an_exercise_are_clear_of_texts_and_lines(exercise: str) -> None:
    for seed in range(amount(10, 200)):
        picture = presented(deal(exercise, seed), "pl").picture
        assert picture is not None
        assert_sound(picture.svg)
