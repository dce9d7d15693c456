"""The builder's form: what stands in it, and what is read from it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from zoneinfo import ZoneInfo

from server.sets.building import MOST_SLOTS
from server.sets.clock import local
from server.sets.handing import rules_of
from server.storage.sets import TaskSet

MOMENTS = ("opens", "due", "closes")


def written(task_set: TaskSet, place: ZoneInfo) -> dict[str, Any]:
    """Give the values of the form for a set."""
    moments = {name: getattr(task_set, name) for name in MOMENTS}
    slots = [
        {
            "number": slot.number,
            "pool": " ".join(slot.pool),
            "points": slot.points,
            "attempts": slot.attempts or "",
            "limits": "; ".join(f"{name} {low:g} {high:g}" for name, (low, high) in slot.limits.items()),
        }
        for slot in task_set.slots
    ]
    shown = {name: local(moment, place) if moment else "" for name, moment in moments.items()}
    return {**shown, "title": task_set.title, "rules": rules_of(task_set), "slots": slots}


def draft_of_form(values: Mapping[str, str]) -> dict[str, Any]:
    """Read the form; what is not as it should be stays as it is, for the schema to refuse by name."""
    numbers = [number for number in range(1, MOST_SLOTS + 1) if f"slot.{number}.pool" in values]
    order = _moved(numbers, values.get("move", ""))
    items = [_item(values, number) for number in order if values.get("remove") != str(number)]
    added = values.get("add", "")
    items += [{"exercise": added}] if added else []
    rules = {name: values[name] for name in ("mode", "late", "keep", "solutions") if name in values}
    minutes = values.get("minutes", "").strip()
    moments = {name: values.get(name, "").strip() or None for name in MOMENTS}
    return {
        "title": values.get("title", "").strip(),
        "items": items,
        "rules": {
            **rules,
            "minutes": minutes or None,
            "hints": values.get("hints", "yes") != "no",
            "ladder": values.get("hints") == "ladder",
            "hint_price": _share(values.get("hint_price", "0")),
            "late_loss": _share(values.get("late_loss", "10")),
            "follow_through": _share(values.get("follow_through", "100")),
            "second_chance_of": values.get("second_chance_of", "").strip() or None,
        },
        **moments,
    }


def _moved(numbers: list[int], wish: str) -> list[int]:
    """Let a slot change places with the one before it."""
    if wish.isascii() and wish.isdecimal() and int(wish[:3]) in numbers[1:]:
        at = numbers.index(int(wish[:3]))
        numbers[at - 1], numbers[at] = numbers[at], numbers[at - 1]
    return numbers


def _item(values: Mapping[str, str], number: int) -> dict[str, Any]:
    attempts = values.get(f"slot.{number}.attempts", "").strip()
    return {
        "pool": values[f"slot.{number}.pool"].replace(",", " ").split(),
        "points": values.get(f"slot.{number}.points", "1").strip().replace(",", "."),
        "attempts": int(attempts)
        if attempts.isascii() and attempts.isdecimal() and len(attempts) < 9
        else attempts or None,
        "limits": _limits(values.get(f"slot.{number}.limits", "")),
    }


def _limits(text: str) -> dict[str, list[str]]:
    """Read limits such as ``l1 0,05 0,08; omega1 5 20``."""
    words = [part.replace(",", ".").split() for part in text.split(";") if part.strip()]
    return {found[0]: found[1:] for found in words}


def _share(percent: str) -> float | str:
    try:
        return float(percent.replace(",", ".")) / 100
    except ValueError:
        return percent
