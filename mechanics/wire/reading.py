"""Strict JSON: one object, bounded in size and depth; what JSON text can hold and no request may is kept for a refusal.

A number beyond the range of floats and the words NaN and Infinity become the floats they mean, and are refused where
the field is known by name.
"""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

from mechanics.wire.refusal import Refusal, below_foreign, shown

LARGEST = 64 * 1024  # bytes of a request
_DIGITS = 20  # of a whole number; a longer one is read as a float


class Repeated(dict[str, Any]):
    """An object in which a name stands twice."""

    def __init__(self, fields: dict[str, Any], name: str) -> None:
        super().__init__(fields)
        self.name = name


def read(raw: bytes) -> dict[str, Any]:
    """Read one object.

    Raises:
        Refusal: `too_large` or `bad_json`.
    """
    if len(raw) > LARGEST:
        raise Refusal("too_large", f"a request has at most {LARGEST} bytes")
    try:
        found = json.loads(raw.rstrip().decode("utf-8-sig"), object_pairs_hook=_object, parse_int=_whole)
    except UnicodeDecodeError as error:
        raise Refusal("bad_json", f"not UTF-8 text (byte {error.start})") from None
    except json.JSONDecodeError as error:
        raise Refusal("bad_json", f"not JSON: {error.msg} (line {error.lineno}, column {error.colno})") from None
    except RecursionError:
        raise Refusal("bad_json", "the brackets of this JSON are nested too deeply") from None
    if not isinstance(found, dict):
        raise Refusal("bad_json", f"a request is an object, not {shown(found)}")
    return found


def distinct(found: Any, place: str = "") -> None:
    """Refuse a value in which some object has a name twice.

    Raises:
        Refusal: `repeated_field`.
    """
    if isinstance(found, Repeated):
        at = below_foreign(place, found.name)
        raise Refusal("repeated_field", f"{at} stands twice", at)
    inner = found.items() if isinstance(found, dict) else enumerate(found) if isinstance(found, list) else ()
    for name, value in inner:
        distinct(value, below_foreign(place, str(name)))


def is_json(raw: bytes) -> bool:
    """Whether a text, of the size of a request, is JSON."""
    try:
        json.loads(raw[: LARGEST + 1].decode("utf-8-sig"))
    except (ValueError, RecursionError):
        return False
    return True


def is_cut_off(raw: bytes) -> bool:
    """Whether a text is no JSON, but might become an object if it went on."""
    text = raw[: LARGEST + 1].decode("utf-8", "replace").removeprefix("\ufeff").strip()
    try:
        json.loads(text)
    except json.JSONDecodeError as error:
        return text.startswith("{") and error.pos >= len(text) - 1
    except (RecursionError, ValueError):
        return False
    return False


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) == len(pairs):
        return found
    times = Counter(name for name, _ in pairs)
    return Repeated(found, next(name for name in found if times[name] > 1))


def _whole(text: str) -> int | float:
    return int(text) if len(text) <= _DIGITS else float(text)
