"""The catalogue: words and figures come from the folder when they are first wanted."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from exercises import catalogue
from exercises.variants import deal

SLIDER = "slider_crank"


def test_the_figure_is_the_function_of_that_name_in_the_folder() -> None:
    picture = catalogue.load(SLIDER).picture(deal(SLIDER, 1).givens, "pl")
    assert picture is not None and picture.svg.startswith("<svg")


def test_a_folder_without_a_figure_has_none(tmp_path: Path) -> None:
    assert replace(catalogue.load(SLIDER), folder=tmp_path).picture(deal(SLIDER, 1).givens, "pl") is None


def test_an_exercise_speaks_three_languages_and_no_other() -> None:
    words = catalogue.load(SLIDER).words
    assert set(words) == {"pl", "en", "ru"} and len(words) == 3
    assert words["pl"] is words["pl"] and words["pl"]["title"] != words["en"]["title"]
    with pytest.raises(KeyError):
        words["../en"]


def test_what_exercises_share_is_no_exercise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue, "ROOT", tmp_path)
    for name in ("crane", "_lifting"):
        (tmp_path / catalogue.CHAPTERS[0] / name).mkdir(parents=True)
    for name in catalogue.FILES:
        (tmp_path / catalogue.CHAPTERS[0] / "crane" / name).touch()
    catalogue._shelf.cache_clear()
    try:
        assert catalogue.ids() == ("crane",)
    finally:
        catalogue._shelf.cache_clear()


@pytest.mark.parametrize("exercise_id", catalogue.ids())
def test_a_prompt_asks_and_does_not_tell_how_to_type(exercise_id: str) -> None:
    """Prompts are printed in reports and marks too; how to type is told by the field and the statement."""
    for words in catalogue.load(exercise_id).words.values():
        for prompt in words["answers"].values():
            assert "…" not in prompt and "_d" not in prompt
