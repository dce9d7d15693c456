"""A draft that two people, or two windows, have changed: what each of them did, and both put together."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from graders.words import marked
from server.sets.form import MOMENTS, POOL, flat, label, typed, unflat
from server.web.language import words

Fields = Mapping[str, str]
NUMBERS = frozenset({"points", "attempts", "limits", "late_loss", "hint_price", "follow_through", "minutes"})
LIST = "list"  # names all tasks together


@dataclass(frozen=True, slots=True)
class Row:
    """A field that two have changed, in words: as it is stored, and as it was typed."""

    field: str
    stored: str
    typed: str


@dataclass(frozen=True, slots=True)
class Clash:
    """What came of two changes.

    Attributes:
        form: The values of the form: what was typed where something was, else what is stored.
        theirs: The fields that only the other one changed, in words.
        both: The fields that both have changed, and not to the same.
        mine: All fields in which what was typed here is not what is stored.
    """

    form: Mapping[str, Any]
    theirs: tuple[str, ...]
    both: tuple[Row, ...]
    mine: tuple[Row, ...]


def clash(language: str, values: Mapping[str, str], stored: Mapping[str, Any], titles: Mapping[str, str]) -> Clash:
    """Put together what was typed and what has been stored since the form was loaded.

    Args:
        language: Of the reader.
        values: The form as it was posted; `base` holds what stood in it when it was loaded.
        stored: The values of the form for the set as it is stored now.
        titles: Of sets and of exercises, by number and by id.
    """
    base, mine, theirs = _base(values.get("base", "")), flat(typed(values)), flat(stored)
    parts = _parts(base, mine, theirs)
    own = {part for part in parts if not _same(part, mine, base)}
    other = [part for part in parts if not _same(part, theirs, base)]
    apart = [part for part in parts if part in own and not _same(part, mine, theirs)]
    told = {p: Row(_called(language, p), *(_said(language, p, one, titles) for one in (theirs, mine))) for p in apart}
    merged = {name: text for part in parts for name, text in _of(part, mine if part in own else theirs).items()}
    form = unflat(merged) | {name: stored[name] for name in ("revision", "base")} | {"add": values.get("add", "")}
    taken = tuple(_called(language, part) for part in other if part not in own)
    return Clash(form, taken, tuple(told[part] for part in apart if part in other), tuple(told.values()))


def _base(text: str) -> Fields:
    """Read what stood in the form; nothing where it is not as we wrote it."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return {str(name): str(value) for name, value in found.items()} if isinstance(found, dict) else {}


def _parts(base: Fields, mine: Fields, theirs: Fields) -> list[str]:
    """Name what is compared: each field, and all tasks together where they are not the same tasks any more."""
    if _pools(base) == _pools(mine) == _pools(theirs):
        return list(dict.fromkeys([*theirs, *mine]))
    return [*(name for name in theirs if not name.startswith("slot.")), LIST]


def _pools(fields: Fields) -> list[str]:
    return [text for name, text in fields.items() if name.endswith(POOL)]


def _of(part: str, fields: Fields) -> dict[str, str]:
    if part == LIST:
        return {name: text for name, text in fields.items() if name.startswith("slot.")}
    return {part: fields[part]} if part in fields else {}


def _same(part: str, one: Fields, other: Fields) -> bool:
    """Tell whether two forms say the same; a number may be written in more than one way."""
    return {name: _plain(text) for name, text in _of(part, one).items()} == {
        name: _plain(text) for name, text in _of(part, other).items()
    }


def _plain(text: str) -> str | float:
    try:
        return float(text.replace(",", "."))
    except ValueError:
        return " ".join(text.split())


def _called(language: str, part: str) -> str:
    if not part.startswith("slot."):
        return label(language, part)
    _, number, name = part.split(".")
    return label(language, f"items.{int(number) - 1}.{name}")


def _marked(language: str, name: str, text: str) -> str:
    """Write numbers with the decimal mark of the language; a title keeps its own."""
    number = name.rpartition(".")[2] in NUMBERS
    return marked(text, language) if number else text


def _titled(text: str, name: str, titles: Mapping[str, str]) -> str:
    """Write a pool by the titles of its exercises."""
    return ", ".join(titles.get(one, one) for one in text.split()) if name.endswith(POOL) else text


def _said(language: str, part: str, fields: Fields, titles: Mapping[str, str]) -> str:
    """Say what stands in a field, or in all tasks, as the page does."""
    found = {name: _titled(_marked(language, name, text), name, titles) for name, text in _of(part, fields).items()}
    if part == LIST:
        tasks = groupby(found.items(), key=lambda one: one[0].split(".")[1])
        return "; ".join(" ".join(filter(None, (text for _, text in texts))) for _, texts in tasks) or "—"
    text = found.get(part, "")
    if part in MOMENTS:
        text = text.replace("T", " ")
    return words(language).get(f"sets.{part}_{text}", titles.get(text, text)) or "—"
