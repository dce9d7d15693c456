"""Writes `docs/reference/security.md` from the tests of attacks: ``uv run python -m tests.docs.security_reference``."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reference" / "security.md"
SAID = re.compile(r"(A\d+(?:, A\d+)*)(?: in sets)?: (.+)")
HEAD = """# Attacks and what answers them

This page is written from the first sentences of `tests/security/` by `uv run python -m tests.docs.security_reference`;
a test compares the two. Each file there mounts its attack on the program and holds it to the sentence; comments and
tests name an attack by its number. How a server is set up safely: [run-a-server.md](../how-to/run-a-server.md),
[scale.md](../how-to/scale.md). What keeps students' text away from any evaluator:
[decision 0002](../decisions/0002-own-answer-language-and-ball-arithmetic.md).

| attack | what holds | tested in |
|---|---|---|
"""


def page() -> str:
    """Give the whole page."""
    return HEAD + "".join(f"{row}\n" for row in _rows())


def _rows() -> Iterator[str]:
    for path in sorted((ROOT / "tests" / "security").glob("test_a*.py")):
        said = SAID.fullmatch(_first(path))
        assert said, f"{path.name} begins with the number of its attack and what holds"
        yield f"| {said[1]} | {said[2]} | [{path.stem}](../../tests/security/{path.name}) |"


def _first(path: Path) -> str:
    """Give the first sentence of a file."""
    return (ast.get_docstring(ast.parse(path.read_text("utf-8"))) or "").partition("\n\n")[0].replace("\n", " ")


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
