"""Names in the order of the alphabet: Ć after C, Ł after L, Ё as Е, L10 after L2, whatever the store sorts by."""

from __future__ import annotations

import re
from functools import lru_cache
from unicodedata import normalize

NUMBER, DIGITS = re.compile(r"[0-9]+"), 12  # numbers in a name stand by their value
BARRED = str.maketrans("łøđħ", "lodh")  # letters with a bar, which Unicode does not take apart


def alphabetical(text: str) -> list[tuple[str, str]]:
    """Give the key to sort names by; a letter with a mark stands after the same letter without one.

    Ё is no letter of its own there, as in Russian lists: it only decides between names that are else the same.
    """
    plain = normalize("NFC", text).casefold()
    counted = NUMBER.sub(lambda found: found[0].zfill(DIGITS), plain.replace("ё", "е"))
    return [*map(_placed, counted), ("", plain)]


@lru_cache(maxsize=4096)
def _placed(letter: str) -> tuple[str, str]:
    return normalize("NFD", letter.translate(BARRED))[0], letter
