"""Writes `docs/reference/mechanics.md` from the docstrings: ``uv run python -m tests.docs.mechanics_reference``."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from types import FunctionType, ModuleType

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "mechanics.md"
CHAPTERS = {
    "VP": "Linkages by vector polygons",
    "VM": "Velocity and acceleration methods",
    "HC": "Mechanisms of a higher class",
    "STR": "Structure and mobility",
    "DH": "Manipulators",
    "AC": "Accuracy",
    "ML": "Motion laws",
    "TR": "Transmissions",
    "DY": "Dynamics",
    "BV": "Balancing and vibration",
    "SM": "Strength of materials",
}
ENTRY = r"\((?:SI; )?(?:domain )?([A-Z]+-\d[^)]*)\)"  # of the domain, named in brackets
SHARED = "Shared by the solvers"
HEAD = """# The mechanics room

This page is written from the docstrings of `mechanics/` by `uv run python -m tests.docs.mechanics_reference`; a test
compares the two. SI units, angles in radians; each module states its sign convention at its head. What cannot be solved
is raised as a `ValueError` that names the value (`mechanics.errors`). The same solvers without Python:
[solvers.md](solvers.md). What *domain VP-2* and the like name: [systems.md](systems.md).

To find something, search this page for the thing itself: deflection, planetary, Coriolis. The first table has a row a
module; below it, each module has a row a function and a row for what a class can tell: what it is, and the source of
its formula.
"""


def page() -> str:
    """Give the whole page."""
    grouped: dict[str, list[ModuleType]] = {title: [] for title in (*CHAPTERS.values(), SHARED)}
    for module in modules():
        grouped[_chapter(module)].append(module)
    sections = [line for title, found in grouped.items() if found for line in _section(title, found)]
    return "\n".join([HEAD, *_index(grouped), *sections]).rstrip() + "\n"


def modules() -> list[ModuleType]:
    """Give every module of the room itself; those on the wire have a page of their own."""
    names = sorted(path.stem for path in (ROOT / "mechanics").glob("*.py") if path.stem != "__init__")
    return [import_module(f"mechanics.{name}") for name in names]


def functions(module: ModuleType) -> list[Callable[..., object]]:
    """Give the public functions a module defines, in the order it defines them."""
    found = [one for name, one in inspect.getmembers(module, inspect.isfunction) if not name.startswith("_")]
    return sorted(
        (one for one in found if one.__module__ == module.__name__), key=lambda one: one.__code__.co_firstlineno
    )


def members(module: ModuleType) -> dict[str, FunctionType]:
    """Give the properties and methods with a docstring of the public classes a module defines, as `Class.name`."""
    found: dict[str, FunctionType] = {}
    for name, kind in vars(module).items():
        if not inspect.isclass(kind) or kind.__module__ != module.__name__ or name.startswith("_"):
            continue
        for own, one in vars(kind).items():
            told = one.fget if isinstance(one, property) else one
            if isinstance(told, FunctionType) and told.__doc__ and not own.startswith("_"):
                found[f"{name}.{own}"] = told
    return found


def _index(grouped: dict[str, list[ModuleType]]) -> Iterator[str]:
    yield from ("| what | module |", "|---|---|")
    for found in grouped.values():
        yield from (f"| {_cell(_first(module))} | [{_name(module)}](#{_name(module)}) |" for module in found)
    yield ""


def _section(title: str, found: list[ModuleType]) -> Iterator[str]:
    yield from (f"## {title}", "")
    for module in found:
        yield from (f"### {_name(module)}", "", " ".join((module.__doc__ or "").split()), "")
        if rows := {one.__name__: one for one in functions(module)} | members(module):
            yield from ("| function | what | source |", "|---|---|---|")
            yield from (f"| `{name}` | {_cell(_what(one))} | {_cell(_source(one))} |" for name, one in rows.items())
            yield ""


def _chapter(module: ModuleType) -> str:
    """Tell the chapter by the domain entry that the module's docstring names first."""
    found = re.search(rf"\b({'|'.join(CHAPTERS)})-\d", module.__doc__ or "")
    return CHAPTERS[found[1]] if found else SHARED


def _name(module: ModuleType) -> str:
    return module.__name__.removeprefix("mechanics.")


def _first(module: ModuleType) -> str:
    return re.sub(" " + ENTRY, "", _line(module.__doc__)).rstrip(".")


def _what(one: Callable[..., object]) -> str:
    return re.sub(" " + ENTRY, "", _line(one.__doc__)).rstrip(".")


def _source(one: Callable[..., object]) -> str:
    """Give the source from its section, else from the brackets of the first line."""
    section = re.search(r"^Source:\n((?: {4}.*\n?)+)", inspect.cleandoc(one.__doc__ or ""), re.MULTILINE)
    if section:
        return " ".join(section[1].split()).rstrip(".")
    named = re.search(ENTRY, _line(one.__doc__)) or re.search(ENTRY, inspect.getmodule(one).__doc__ or "")
    return f"Domain {named[1]}" if named else ""


def _line(text: str | None) -> str:
    """Give the first paragraph as one line."""
    return " ".join(inspect.cleandoc(text or "").partition("\n\n")[0].split())


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
