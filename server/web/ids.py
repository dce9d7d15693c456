"""Numbers that are read aloud and typed off paper, and digests."""

from __future__ import annotations

import re
import secrets
from hashlib import sha256

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # Crockford's base 32: no I, L, O, U
GROUPS, SIGNS = 3, 4  # 60 random bits
FORM = re.compile(rf"[{ALPHABET}]{{{SIGNS}}}(-[{ALPHABET}]{{{SIGNS}}}){{{GROUPS - 1}}}")


def new() -> str:
    """Draw a number, such as ``7F3K-2M0Q-XW41``."""
    drawn = secrets.randbits(5 * GROUPS * SIGNS)
    signs = "".join(ALPHABET[drawn >> 5 * place & 31] for place in range(GROUPS * SIGNS))
    return "-".join(signs[start : start + SIGNS] for start in range(0, len(signs), SIGNS))


def known(text: str) -> bool:
    """Whether a text has the form of our numbers; nothing else is ever looked up."""
    return FORM.fullmatch(text) is not None


def digest(*parts: bytes) -> str:
    """Digest some parts, each with its length, so that no two lists of parts agree."""
    whole = sha256()
    for part in parts:
        whole.update(len(part).to_bytes(8))
        whole.update(part)
    return whole.hexdigest()
