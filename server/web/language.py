"""Which of the languages a reader is answered in, and every sentence the server says."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files

from fastapi import Request

from graders import words as spoken

LANGUAGES = spoken.LANGUAGES
DEFAULT = "en"
COOKIE = "grubler_lang"
LONGEST_HEADER = 200  # characters of Accept-Language that are read


def of(request: Request) -> str:
    """Give the reader's language: asked for in the address, kept in a cookie, or preferred by the browser."""
    for wish in (request.query_params.get("lang"), request.cookies.get(COOKIE)):
        if wish in LANGUAGES:
            return wish
    return preferred(request.headers.get("accept-language", ""))


def preferred(header: str) -> str:
    """Give the best of our languages for an Accept-Language header."""
    wishes = sorted(map(_wish, header[:LONGEST_HEADER].split(",")), key=lambda wish: -wish[1])
    return next((name for name, weight in wishes if name in LANGUAGES and weight > 0), DEFAULT)


def _wish(part: str) -> tuple[str, float]:
    name, _, weight = part.partition(";")
    try:
        value = float(weight.strip().removeprefix("q=") or 1)
    except ValueError:
        value = 0.0
    return name.strip().split("-")[0].lower(), value


@cache
def words(language: str) -> Mapping[str, str]:
    """Give all sentences of one language, keyed as `section.name`."""
    text = (files("server") / "locales" / f"{language}.toml").read_text("utf-8")
    return {f"{part}.{name}": said for part, lines in tomllib.loads(text).items() for name, said in lines.items()}


def say(language: str, key: str, **values: object) -> str:
    """Word one sentence; the values stand where the sentence names them."""
    return words(language)[key].format_map(values)


def part(language: str, section: str) -> dict[str, str]:
    """Give the sentences of one section, for an island that words its own state."""
    found = ((key.partition("."), said) for key, said in words(language).items())
    return {key[2]: said for key, said in found if key[0] == section}
