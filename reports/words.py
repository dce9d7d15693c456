"""The words of documents, in the language of the reader."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

Words = Mapping[str, Any]
FOLDER = Path(__file__).parent / "locales"


@lru_cache(maxsize=8)
def words(language: str) -> Words:
    """Read the words of a language."""
    return tomllib.loads((FOLDER / f"{language}.toml").read_text("utf-8"))
