"""The builder's form: what stands in it, and what is read from it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any
from zoneinfo import ZoneInfo

from exercises import catalogue
from graders.words import marked
from server.answering.forms import Form
from server.sets.building import MOST_SLOTS
from server.sets.clock import local
from server.sets.handing import rules_of
from server.sets.rules import Rules
from server.sets.wording import by_titles
from server.storage.sets import TaskSet
from server.web.errors import Refused, printable
from server.web.language import say, words

MOMENTS = ("opens", "due", "closes")
POOL = ".pool"
OF_SLOT = ("pool", "points", "attempts", "limits")
OF_SET = (
    "title", *MOMENTS, "mode", "minutes", "late", "late_loss", "keep", "hints", "hint_price", "solutions",
    "follow_through", "second_chance_of", "add",
)  # fmt: skip


def written(task_set: TaskSet, place: ZoneInfo, language: str) -> dict[str, Any]:
    """Give the values of the form for a set; limits are a text, with the decimal mark of the language."""
    moments = {name: getattr(task_set, name) for name in MOMENTS}
    slots = [
        {
            "number": slot.number,
            "pool": " ".join(_by_chapter(slot.pool)),
            "points": slot.points,
            "attempts": slot.attempts or "",
            "limits": _limited(slot.limits, language),
        }
        for slot in task_set.slots
    ]
    shown = {name: local(moment, place) if moment else "" for name, moment in moments.items()}
    form = {**shown, **_written(rules_of(task_set)), "title": task_set.title, "add": "", "slots": slots}
    return form | {"revision": task_set.revision, "base": json.dumps(flat(form), ensure_ascii=False)}


def _by_chapter(pool: Iterable[str]) -> list[str]:
    """Put exercises in the order in which the form offers them; what is not in the catalogue stands last."""
    places = {one: place for place, one in enumerate(catalogue.ids())}
    return sorted(pool, key=lambda one: places.get(one, len(places)))


def shelves(titles: Mapping[str, str], pool: Iterable[str]) -> dict[str, list[tuple[str, str]]]:
    """Give the exercises by chapter, each with its title; under no chapter those of a pool that are in none."""
    found: dict[str, list[tuple[str, str]]] = {}
    for one in titles:
        found.setdefault(catalogue.chapter_of(one), []).append((one, titles[one]))
    gone = [(one, one) for one in pool if one not in titles]
    return {**found, **({"": gone} if gone else {})}


def joined(form: Form) -> dict[str, str]:
    """Give the fields of the form, each pool as one text: its exercises are ticked one by one."""
    pools = {name: " ".join(" ".join(texts).split()) for name, texts in form.every.items() if name.endswith(POOL)}
    return {**form.values, **pools}


def flat(form: Mapping[str, Any]) -> dict[str, str]:
    """Give the fields of a form by their names, as texts."""
    slots = {f"slot.{one['number']}.{name}": one[name] for one in form["slots"] for name in OF_SLOT}
    fields = {name: form[name] for name in OF_SET if name != "add"} | slots
    return {name: f"{value:.12g}" if isinstance(value, float) else str(value) for name, value in fields.items()}


def unflat(fields: Mapping[str, str]) -> dict[str, Any]:
    """Give the values of a form by the names of its fields."""
    return typed(fields) | {"add": ""}


def _written(rules: Rules) -> dict[str, Any]:
    """Give the fields of the rules; shares are written in percent."""
    return {
        **{name: getattr(rules, name) for name in ("mode", "late", "keep", "solutions")},
        **{name: 100 * getattr(rules, name) for name in ("late_loss", "hint_price", "follow_through")},
        **{name: getattr(rules, name) or "" for name in ("minutes", "second_chance_of")},
        "hints": "ladder" if rules.ladder else "yes" if rules.hints else "no",
    }


def typed(values: Mapping[str, str]) -> dict[str, Any]:
    """Give the values of the form as they were typed, for it to be shown again."""
    slots = [
        {"number": number, **{name: values.get(f"slot.{number}.{name}", "") for name in OF_SLOT}}
        for number in _numbers(values)
    ]
    return {name: values.get(name, "") for name in (*OF_SET, "revision", "base")} | {"slots": slots}


def problem(language: str, refused: Refused, titles: Mapping[str, str]) -> str:
    """Word why the form cannot be taken, with the field as the form calls it."""
    if refused.said:
        return refused.said
    place, values = label(language, refused.field or ""), by_titles(refused.values, titles)
    if "name" in values:
        return say(language, f"errors.{refused.code}", **values | {"name": place})
    return ": ".join(filter(None, (place, say(language, f"errors.{refused.code}", **values))))


def label(language: str, field: str) -> str:
    """Name a field such as `items.0.points` or `rules.late_loss`; what the form has no word for is named as typed."""
    first, *rest = field.split(".")
    if first == "items" and rest:
        return ", ".join(
            [say(language, "sets.slot", number=int(rest[0]) + 1), *(_word(language, n) for n in rest[1:2])]
        )
    return _word(language, (rest or [first])[0])


def _word(language: str, name: str) -> str:
    return words(language).get(f"sets.{name}", name)


def draft_of_form(values: Mapping[str, str]) -> dict[str, Any]:
    """Read the form; what is not as it should be stays as it is, for the schema to refuse by name.

    Raises:
        Refused: 422, limits name a given twice.
    """
    order = _moved(_numbers(values), values.get("move", ""))
    kept = [number for number in order if values.get("remove") != str(number)]
    items = [_item(values, number, at) for at, number in enumerate(kept)]
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


def _numbers(values: Mapping[str, str]) -> list[int]:
    return [number for number in range(1, MOST_SLOTS + 1) if f"slot.{number}.pool" in values]


def _moved(numbers: list[int], wish: str) -> list[int]:
    """Let a slot change places with the one before it."""
    if wish.isascii() and wish.isdecimal() and int(wish[:3]) in numbers[1:]:
        at = numbers.index(int(wish[:3]))
        numbers[at - 1], numbers[at] = numbers[at], numbers[at - 1]
    return numbers


def _item(values: Mapping[str, str], number: int, at: int) -> dict[str, Any]:
    attempts = values.get(f"slot.{number}.attempts", "").strip()
    return {
        "pool": values[f"slot.{number}.pool"].replace(",", " ").split(),
        "points": values.get(f"slot.{number}.points", "1").strip().replace(",", "."),
        "attempts": int(attempts)
        if attempts.isascii() and attempts.isdecimal() and len(attempts) < 9
        else attempts or None,
        "limits": _limits(values.get(f"slot.{number}.limits", ""), f"items.{at}.limits"),
    }


def _limited(limits: Mapping[str, tuple[float, float]], language: str) -> str:
    return "; ".join(" ".join((name, *(_number(end, language) for end in ends))) for name, ends in limits.items())


def _number(value: float, language: str) -> str:
    return marked(repr(float(value)).removesuffix(".0"), language)


def _limits(text: str, field: str) -> dict[str, list[str]]:
    """Read limits such as ``l1 0,05 0,08; omega1 5 20``.

    Raises:
        Refused: 422, a given stands in them twice.
    """
    words = [part.replace(",", ".").split() for part in text.split(";") if part.strip()]
    names = [found[0] for found in words]
    twice = next((name for at, name in enumerate(names) if name in names[:at]), None)
    if twice is not None:
        raise Refused(422, "limited_twice", field=field, given=printable(twice))
    return {found[0]: found[1:] for found in words}


def _share(percent: str) -> float | str:
    try:
        return float(percent.replace(",", ".")) / 100
    except ValueError:
        return percent
