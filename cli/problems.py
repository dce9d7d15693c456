"""What makes an input unusable, where, and how that is said in the reader's language."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Mapping
from functools import cache
from pathlib import Path

LANGUAGES = ("pl", "en", "ru")
LOCALES = Path(__file__).parent / "locales"


class Unusable(ValueError):
    """Input that cannot be used.

    Args:
        key: The sentence in `locales/`.
        file: The file as the user named it; empty where there is none.
        place: The item and field, such as `items[2].seed`.
        values: What stands in the sentence.
    """

    def __init__(self, key: str, file: str = "", place: str = "", **values: object) -> None:
        super().__init__(key)
        self.key, self.file, self.place, self.values = key, file, place, values

    def worded(self, lang: str) -> str:
        """Say file, place and problem in one line."""
        said = say(lang, self.key, **{name: _shown(value) for name, value in self.values.items()})
        return ": ".join(part for part in (_shown(self.file), _shown(self.place), said) if part)


def say(lang: str, key: str, **values: object) -> str:
    """Word one sentence of the command line."""
    return _words(lang)[key].format_map(values)


@cache
def _words(lang: str) -> Mapping[str, str]:
    import tomllib  # only for those who are told something

    return tomllib.loads((LOCALES / f"{lang}.toml").read_text("utf-8"))


def _shown(value: object) -> str:
    """Make foreign text safe to print on one line of a terminal."""
    text = str(value)
    shown = "".join(sign if sign.isprintable() else "\ufffd" for sign in text[:200])
    return shown + "…" if len(text) > 200 else shown


def language(parser: ArgumentParser) -> None:
    """Add the option that every command with words has."""
    parser.add_argument("--lang", choices=LANGUAGES, default="en", help="language of what is printed (default: en)")
