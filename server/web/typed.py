"""Texts as people type them, at the edge: any Unicode, but Unicode."""

from __future__ import annotations

import json
from contextlib import suppress
from typing import Annotated, Any, TypeAlias

from pydantic import AfterValidator, StrictStr
from pydantic_core import PydanticCustomError


def _whole(text: str) -> str:
    """JSON can spell half a character (a lone surrogate); such a text could be neither stored nor shown."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise PydanticCustomError("bad_text", "the text holds half a character") from None
    return text


def sendable(text: str) -> str:
    """Give a foreign text with a question mark for each half of a character: only whole ones can be sent back."""
    return text.encode(errors="replace").decode()


Typed: TypeAlias = Annotated[StrictStr, AfterValidator(_whole)]


def repeated_name(raw: bytes) -> str | None:
    """Find a name that stands twice in one object of a JSON text, of which readers keep only the last.

    Returns:
        The name; None where there is none, or the text is no JSON.
    """
    repeated: list[str] = []

    def note(pairs: list[tuple[str, Any]]) -> None:
        names = [name for name, _ in pairs]
        if len(set(names)) < len(names):
            repeated.append(next(name for name in names if names.count(name) > 1))

    with suppress(ValueError, RecursionError):
        json.loads(raw, object_pairs_hook=note)
    return sendable(repeated[0]) if repeated else None
