"""Pairs of answers whose equality was settled by hand: one file a kind, in tab-separated columns.

Columns: `verdict` (equal, different, unreadable), `a`, `b` (the members of a list parted by ` ;; `), `vars`, `more`
(`solve_for=x`, `rtol=0.01`, parted by `; `; empty where there is nothing) and `why`, the proof in a few words. `vars`
holds items such as `l1 0.04..0.12`, `phi 0..2*pi`, `z 12..80 int` and `@crank`, a set named in `domains.toml`, parted
by `; `. A line that begins with `#` is a heading.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from graders.judge import Domain
from graders.language import parse_line
from graders.language.doubles import line_runner

HERE = Path(__file__).parent
VERDICTS = ("equal", "different", "unreadable")


@dataclass(frozen=True, slots=True)
class Pair:
    """One row: two answers, the domains of their symbols, what else the comparison takes, and the settled verdict."""

    kind: str
    line: int
    verdict: str
    a: tuple[str, ...]
    b: tuple[str, ...]
    domains: tuple[tuple[str, Domain], ...]
    more: tuple[tuple[str, str], ...]
    why: str

    @property
    def place(self) -> str:
        """Give the place of the row, for messages."""
        return f"{self.kind}.tsv:{self.line}"


def kinds() -> list[str]:
    """Give the kinds that have a file."""
    return sorted(path.stem for path in HERE.glob("*.tsv"))


@lru_cache(maxsize=16)
def pairs(kind: str) -> tuple[Pair, ...]:
    """Read all pairs of a kind."""
    return tuple(_rows(kind))


def _rows(kind: str) -> Iterator[Pair]:
    for number, line in enumerate((HERE / f"{kind}.tsv").read_text("utf-8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        verdict, a, b, symbols, more, why = line.split("\t")
        options = tuple((key, value) for key, _, value in (part.partition("=") for part in more.split("; ") if part))
        yield Pair(kind, number, verdict, _members(a), _members(b), domains(symbols), options, why)


def _members(text: str) -> tuple[str, ...]:
    return tuple(text.split(" ;; "))


@lru_cache(maxsize=512)
def domains(written: str) -> tuple[tuple[str, Domain], ...]:
    """Read the domains of symbols: `x 0..1; z 12..80 int; @crank`."""
    found: dict[str, Domain] = {}
    for item in filter(None, written.split("; ")):
        if item.startswith("@"):
            found |= dict(domains(_named()[item[1:]]))
        else:
            name, bounds, *integer = item.split(" ")
            low, _, high = bounds.partition("..")
            found[name] = Domain(_value(low), _value(high), integer == ["int"])
    return tuple(found.items())


@lru_cache(maxsize=1)
def _named() -> dict[str, str]:
    return {name: str(line) for name, line in tomllib.loads((HERE / "domains.toml").read_text("utf-8")).items()}


def _value(bound: str) -> float:
    return float(line_runner(parse_line(bound)).run([])[0])
