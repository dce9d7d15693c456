"""Writes `docs/reference/benchmarks.md` from the scripts: ``uv run python -m tests.docs.benchmark_reference``."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "benchmarks.md"
COMMAND = re.compile(r"``(uv run[^`]*? benchmarks/\w+\.py[^`]*)``")
HEAD = """# What is measured, and how

This page is written from the heads of `benchmarks/` by `uv run python -m tests.docs.benchmark_reference`; a test
compares the two. Each script says at its head how its figures are taken. What is compared takes turns in one run, so
that a busy machine slows both; figures by processor time hardly depend on what else it does.

| script | what it tells | run |
|---|---|---|
"""


def page() -> str:
    """Give the whole page."""
    return HEAD + "".join(f"{row}\n" for row in _rows())


def _rows() -> Iterator[str]:
    for path in sorted((ROOT / "benchmarks").glob("*.py")):
        text = path.read_text("utf-8")
        if '__name__ == "__main__"' in text:
            told = " ".join((ast.get_docstring(ast.parse(text)) or "").split("\n\n")[0].split())
            yield f"| `{path.name}` | {told} | `{_command(text, path.name).replace('|', chr(92) + '|')}` |"


def _command(text: str, name: str) -> str:
    found = COMMAND.search(" ".join(text.split()))
    return found[1] if found else f"uv run python benchmarks/{name}"


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
