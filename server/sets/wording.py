"""What stands against a set, in words, with exercises by their titles."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from exercises import catalogue
from server.catalogue.api import title
from server.sets.dealing import Trouble
from server.web.language import say
from server.workbench import Bench

OF_EXERCISES = frozenset({"exercise", "counts"})  # values that name exercises by their ids
Titles = Mapping[str, str]


def said(language: str, trouble: Trouble, titles: Titles) -> str:
    """Word a trouble in a language."""
    return say(language, f"sets.trouble_{trouble.code}", slot=trouble.slot, **by_titles(trouble.values, titles))


def by_titles(values: Mapping[str, Any], titles: Titles) -> dict[str, Any]:
    """Name the exercises in the values of a sentence by their titles."""

    def titled(name: str, value: Any) -> Any:
        known = name in OF_EXERCISES and isinstance(value, str)
        return re.sub(r"\w+", lambda word: titles.get(word[0], word[0]), value) if known else value

    return {name: titled(name, value) for name, value in values.items()}


async def titles_of(bench: Bench, language: str) -> dict[str, str]:
    """Give the titles of all exercises in a language, by chapter."""
    return {one: await title_of(bench, one, language) for one in catalogue.ids()}


async def title_of(bench: Bench, exercise: str, language: str) -> str:
    """Give the title of an exercise in a language; its id where it is no longer in the catalogue."""
    if exercise not in catalogue.ids():
        return exercise
    return await bench.judging.run(title, exercise, language)
