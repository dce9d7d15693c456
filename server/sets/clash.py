"""A draft that two people, or two windows, have changed: what each of them did, and both put together."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from graders.words import marked
from server.sets.aligning import POOL, Aligned, Fields, aligned, pools, task_of
from server.sets.form import MOMENTS, flat, label, typed, unflat
from server.web.language import words

NUMBERS = frozenset({"points", "attempts", "limits", "late_loss", "hint_price", "follow_through", "minutes"})
LIST = "list"  # names which tasks there are, and their order


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
    loaded, posted, theirs = _base(values.get("base", "")), flat(typed(values)), flat(stored)
    places = aligned(loaded if pools(loaded) else posted, theirs)
    base, mine = _still_there(places, places.renumbered(loaded), places.renumbered(posted))
    parts = list(dict.fromkeys([*theirs, *mine]))
    own = {part for part in parts if task_of(part) in places.gone or not _same(part, mine, base)}
    other = [part for part in parts if not _same(part, theirs, base)]
    apart = [part for part in parts if part in own and not _same(part, mine, theirs)]
    told = {p: Row(_called(language, p), *(_said(language, p, one, titles) for one in (theirs, mine))) for p in apart}
    merged = {part: (mine if part in own else theirs).get(part, "") for part in parts}
    form = unflat(merged) | {name: stored[name] for name in ("revision", "base")} | {"add": values.get("add", "")}
    taken = [part for part in other if part not in own and task_of(part) not in places.new]
    known = tuple(_called(language, part) for part in ([LIST] if places.moved else []) + taken)
    rows = {part: row for part, row in told.items() if row.stored != row.typed}
    return Clash(
        form, known, tuple(rows[part] for part in apart if part in other and part in rows), tuple(rows.values())
    )


def _still_there(places: Aligned, base: Fields, mine: Fields) -> tuple[Fields, Fields]:
    """Let go of the tasks that the other one has removed and in which nothing was typed here."""
    typed_in = {task_of(name) for name in mine if not _same(name, mine, base)}
    idle = places.gone - typed_in
    kept = [{name: text for name, text in one.items() if task_of(name) not in idle} for one in (base, mine)]
    return kept[0], kept[1]


def _base(text: str) -> Fields:
    """Read what stood in the form; nothing where it is not as we wrote it."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return {str(name): str(value) for name, value in found.items()} if isinstance(found, dict) else {}


def _same(part: str, one: Fields, other: Fields) -> bool:
    """Tell whether two forms say the same in a field; a number may be written in more than one way."""
    return _plain(part, one.get(part)) == _plain(part, other.get(part))


def _plain(part: str, text: str | None) -> str | float | None:
    if text is None or not _is_number(part):
        return text and " ".join(text.split())
    try:
        return float(text.replace(",", "."))
    except ValueError:
        return " ".join(text.replace(",", ".").split())


def _is_number(part: str) -> bool:
    return part.rpartition(".")[2] in NUMBERS


def _called(language: str, part: str) -> str:
    if not part.startswith("slot."):
        return label(language, part)
    _, number, name = part.split(".")
    return label(language, f"items.{int(number) - 1}.{name}")


def _marked(language: str, name: str, text: str) -> str:
    """Write numbers with the decimal mark of the language; a title keeps its own."""
    return marked(text, language) if _is_number(name) else text


def _titled(text: str, name: str, titles: Mapping[str, str]) -> str:
    """Write a pool by the titles of its exercises."""
    return ", ".join(titles.get(one, one) for one in text.split()) if name.endswith(POOL) else text


def _said(language: str, part: str, fields: Fields, titles: Mapping[str, str]) -> str:
    """Say what stands in a field as the page does."""
    text = _titled(_marked(language, part, fields.get(part, "")), part, titles)
    if part in MOMENTS:
        text = text.replace("T", " ")
    return words(language).get(f"sets.{part}_{text}", titles.get(text, text)) or "—"
