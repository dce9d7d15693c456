"""Writes `docs/reference/systems.md` from `systems.toml`: ``uv run python -m tests.docs.systems_reference``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

from exercises import catalogue

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "systems.md"
CITED = re.compile(r"\b(VP|VM|HC|STR|DH|AC|ML|TR|DY|BV|SM|RP)-(\d+)(?:(?:\.\.| to )(?:\1-)?(\d+))?")
HEAD = """# The systems by number

This page is written by `uv run python -m tests.docs.systems_reference`; a test compares the two.

Docstrings and the *source* of an exercise cite systems by number: *domain VP-2* is the centric slider-crank. They are
the numbers of the specification this program was written from, in which the lectures and laboratory sheets of theory
of machines and of strength of materials are put in order. The last columns lead to the modules of `mechanics/` that
solve a system, where the source of each formula stands, and to the exercises that ask for it.

"""
FIXED = """
## What the sources left open

The sources lack some drawings and tables. The specification fixes in their place:

* VP-6 to VP-8: the geometry of the three manipulators; VP-6 has the data l_AB, l_BC, Theta1, Theta2, h3.
* VP-2: equations (2) and (7) to (13) of the sheet, restored and confirmed by differentiation.
* HC-1: the labels of the links, K = (2096, 1300) and the senses of the ternary links; the number of assemblies depends
  on them.
* DH-11 to DH-15: tables that give the printed formulas of the point M; DH-16 and all inverse formulas are derived.
* STR-10: the sixth group is taken as PRP; one list calls it RPR, but its rule is that of PRP.
* TR-4: for z = 20, 40, 15, 45 the ratio is +6, not 4.
* SM-8: of torques of 200, 500 and 300 N m the largest is 300 N m in the order 200, -500, 300, and 500 N m in the order
  200, 300, -500.
"""


def page() -> str:
    """Give the whole page."""
    return HEAD + "\n".join(_rows()) + "\n" + FIXED


def names() -> Mapping[str, list[str]]:
    """Give the names of each system in English, Polish and Russian."""
    return tomllib.loads(Path(__file__).with_name("systems.toml").read_text("utf-8"))


@cache
def cited(text: str) -> frozenset[str]:
    """Give the numbers that a text cites, ranges such as DH-11 to DH-16 or STR-2..6 written out."""
    found = (
        f"{chapter}-{number}"
        for chapter, first, last in CITED.findall(text)
        for number in range(int(first), int(last or first) + 1)
    )
    return frozenset(found)


def places() -> Mapping[str, frozenset[str]]:
    """Give the numbers that each file of the rooms cites, by its path."""
    paths = sorted(path for room in ("mechanics", "exercises", "reports") for path in (ROOT / room).rglob("*.py"))
    return {str(path.relative_to(ROOT)): cited(path.read_text("utf-8")) for path in paths if path.parent.name != "wire"}


def _rows() -> Iterator[str]:
    yield from ("| number | English | Polish | Russian | solved in | asked in |", "|---|---|---|---|---|---|")
    solvers = {Path(at).stem: found for at, found in places().items() if at.startswith("mechanics/")}
    asked = {name: catalogue.load(name).exercise.systems for name in catalogue.ids()}
    for number, words in names().items():
        modules = ", ".join(f"[{name}](mechanics.md#{name})" for name, found in solvers.items() if number in found)
        exercises = ", ".join(f"`{name}`" for name, systems in asked.items() if number in systems)
        yield f"| {number} | {' | '.join(words)} | {modules} | {exercises} |"


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
