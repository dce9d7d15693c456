"""Answers and steps are named as the tasks ask for them, in the reader's language."""

from __future__ import annotations

from dataclasses import replace

import pytest

from server.marks.asking import asked, chosen
from tests.server.sets.classroom import draft, slot

BOTH = replace(draft("s"), slots=(replace(slot("s"), pool=("slider_crank", "offset_slider_crank", "gone")),))


@pytest.mark.parametrize(
    ("language", "said"),
    [("pl", "Prędkość suwaka v3"), ("en", "Velocity of the slider v3"), ("ru", "Скорость ползуна v3")],
)
def test_an_answer_is_named_once_as_the_exercises_of_the_pool_ask_for_it(language: str, said: str) -> None:
    assert said in asked(BOTH, language)(1, "v3").split("; ")
    assert asked(replace(BOTH, slots=(slot("s"),)), language)(1, "v3") == said


def test_a_step_is_named_by_what_it_finds() -> None:
    one = replace(BOTH, slots=(slot("s"),))
    assert asked(one, "en", "steps")(1, "l3") == "Position of the slider from the projection on the x axis"


def test_what_nobody_asks_keeps_its_name() -> None:
    assert [asked(BOTH, "en")(item, "no_such") for item in (1, 2)] == ["no_such", "no_such"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("same", "in the same sense as the input shaft"),
        ("same; opposite", "in the same sense as the input shaft; in the opposite sense"),
        ("same; 3 mm", "same; 3 mm"),
        ("", ""),
    ],
)
def test_options_that_were_chosen_are_said_by_their_words(text: str, said: str) -> None:
    train = replace(BOTH, slots=(replace(slot("s"), pool=("gear_train", "gone")),))
    assert chosen(train, "en")(1, "sense", text) == said
    assert chosen(train, "en")(1, "u", "same") == "same"
