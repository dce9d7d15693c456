"""Names of answers and steps as people say them: as the task asks, in the reader's language."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from exercises import catalogue
from exercises.presenting import words_of
from exercises.words import indexed, plain
from server.storage.sets import TaskSet


def asked(task_set: TaskSet, language: str, part: str = "answers") -> Callable[[int, str], str]:
    """Give how an answer of a task is asked for, or what a step of it finds; its bare name where nobody says so.

    Args:
        task_set: The set of the tasks.
        language: The reader's language.
        part: `answers` or `steps`.
    """
    return partial(_said, {slot.number: slot.pool for slot in task_set.slots}, language, part)


def chosen(task_set: TaskSet, language: str) -> Callable[[int, str, str], str]:
    """Give an answer to a task as its words say it, where options were chosen; any other text as it stands."""
    return partial(_chosen, {slot.number: slot.pool for slot in task_set.slots}, language)


def in_words(options: Mapping[str, str], text: str) -> str:
    """Say options that were chosen, such as `same` or `c; a; b`, by their words."""
    keys = [key.strip() for key in text.split(";")]
    return "; ".join(options[key] for key in keys) if all(key in options for key in keys) else text


def _chosen(pools: dict[int, Sequence[str]], language: str, item: int, name: str, text: str) -> str:
    for exercise in pools.get(item, ()):
        known = words_of(exercise, language).get("choices", {}) if exercise in catalogue.ids() else {}
        text = in_words({key: plain(words) for key, words in known.get(name, {}).items()}, text)
    return text


def _said(pools: dict[int, Sequence[str]], language: str, part: str, item: int, name: str) -> str:
    """Say it as the exercises of the task do, each wording once."""
    found = [_worded(one, language, part, name) for one in pools.get(item, ())]
    return "; ".join(dict.fromkeys(one for one in found if one)) or name


def _worded(exercise: str, language: str, part: str, name: str) -> str:
    if exercise not in catalogue.ids():
        return ""
    try:
        return plain(indexed(words_of(exercise, language).get(part, {}), name))
    except KeyError:
        return ""
