"""What stands against publishing, in words."""

from __future__ import annotations

from server.sets.dealing import Trouble
from server.web.language import say


def said(language: str, trouble: Trouble) -> str:
    """Word a trouble in a language."""
    return say(language, f"sets.trouble_{trouble.code}", slot=trouble.slot, **trouble.values)
