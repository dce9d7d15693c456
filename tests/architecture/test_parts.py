"""The parts of others: what a build installs is pinned, and what is shipped may be used and passed on."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, metadata
from pathlib import Path

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
LOCKED = {one["name"]: one for one in tomllib.loads((ROOT / "uv.lock").read_text("utf-8"))["package"]}
NAME = re.compile(r"[A-Za-z0-9._-]+")
FITTING = (
    "MIT",
    "BSD",
    "Apache",
    "PSF",
    "ISC",
    "0BSD",
    "Zlib",
    "CC0",
    "MPL",
    "Mozilla",
    "LGPL",
)  # the last three: as they are


def named(requirement: str) -> str:
    """Give the name of a requirement as the lock writes it."""
    found = NAME.match(requirement)
    assert found
    return re.sub(r"[._-]+", "-", found[0]).lower()


def shipped(name: str, extras: Iterable[str], seen: set[str]) -> None:
    """Note a part and what it brings along by the lock, with the extras that are asked for."""
    part = LOCKED[name]
    asked = [*part.get("dependencies", []), *(one for e in extras for one in part["optional-dependencies"][e])]
    seen.add(name)
    for one in asked:
        if one["name"] not in seen or one.get("extra"):
            shipped(one["name"], one.get("extra", []), seen)


def licence(name: str) -> str | None:
    """Give the licence that a part declares, by expression or else by classifiers; none where it is not here."""
    try:
        told = metadata(name).json
    except PackageNotFoundError:  # for another system or another Python
        return None
    classified = [one for one in told.get("classifier", []) if one.startswith("License ::")]
    return str(told.get("license_expression") or "; ".join(classified) or told.get("license") or "")


def test_a_build_installs_pinned_parts_as_the_lock_has_them() -> None:
    pins = dict(pin.split("==") for pin in PROJECT["tool"]["uv"]["build-constraint-dependencies"])
    assert {named(one) for one in PROJECT["build-system"]["requires"]} <= pins.keys()
    assert {name: pin for name, pin in pins.items() if name in LOCKED and LOCKED[name]["version"] != pin} == {}


def test_what_is_shipped_may_be_used_and_passed_on() -> None:
    parts: set[str] = set()
    shipped("grubler", [], parts)
    told = {name: said for name in parts - {"grubler"} if (said := licence(name)) is not None}
    assert len(told) > 40
    assert {name: said for name, said in told.items() if not any(one in said for one in FITTING)} == {}
