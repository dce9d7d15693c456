"""Texts as people type them, at the edge: any Unicode, but Unicode."""

from __future__ import annotations

from typing import Annotated, TypeAlias

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
