"""A request that is not answered with numbers: a code for programs, a sentence with value, unit and reason."""

from __future__ import annotations

import json
from typing import Any

LONGEST = 60  # characters shown of a foreign value


class Refusal(ValueError):
    """What is wrong with a request.

    Args:
        code: Such as ``unknown_field``; the solvers' own are those of `mechanics.errors`.
        message: The sentence.
        field: Where it is wrong, such as ``loads[1].F``; empty where no field is.
    """

    def __init__(self, code: str, message: str, field: str = "") -> None:
        super().__init__(message)
        self.code, self.message, self.field = code, message, field


def shown(value: Any) -> str:
    """Make a foreign value safe to print on one line."""
    if isinstance(value, dict | list):
        return "an object" if isinstance(value, dict) else "a list"
    if isinstance(value, int) and abs(value) >= 10**20:
        return "a number of more than 20 digits"
    text = json.dumps(value, ensure_ascii=False)
    safe = "".join(sign if sign.isprintable() else "\ufffd" for sign in text[:LONGEST])
    return safe + "…" if len(text) > LONGEST else safe


def below(place: str, name: str) -> str:
    """Give the place of a field of the object at a place."""
    return f"{place}.{name}" if place else name


def below_foreign(place: str, name: str) -> str:
    """Give the place of a field whose name is not ours."""
    return below(place, shown(name)[1:-1])
