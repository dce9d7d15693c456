"""Names in the order of the alphabet: Ć after C, Ł after L, Ё after Е, whatever the store sorts by."""

from __future__ import annotations

from functools import lru_cache
from unicodedata import normalize

BARRED = str.maketrans("łøđħ", "lodh")  # letters with a bar, which Unicode does not take apart


def alphabetical(text: str) -> list[tuple[str, str]]:
    """Give the key to sort names by; a letter with a mark stands after the same letter without one."""
    return [_placed(letter) for letter in normalize("NFC", text).casefold()]


@lru_cache(maxsize=4096)
def _placed(letter: str) -> tuple[str, str]:
    return normalize("NFD", letter.translate(BARRED))[0], letter
