"""Pages that list things are compared with the program they describe."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from cli.reading import LARGEST, LONGEST
from graders import Outcome
from tests.docs import api_reference, command_reference, language_reference, solver_reference

DOCS = api_reference.ROOT / "docs"


@pytest.mark.parametrize(
    ("page", "written"),
    [
        (api_reference.PAGE, api_reference.page),
        (command_reference.PAGE, command_reference.page),
        (language_reference.PAGE, language_reference.page),
        (solver_reference.PAGE, solver_reference.page),
    ],
    ids=["api", "commands", "language", "solvers"],
)
def test_a_written_page_is_up_to_date(page: Path, written: Callable[[], str]) -> None:
    assert page.read_text("utf-8") == written(), f"write {page.name} again: see its first lines"


def test_the_page_on_files_names_the_limits_and_the_outcomes() -> None:
    page = (DOCS / "reference" / "files.md").read_text("utf-8")
    assert f"{LARGEST:,} bytes" in page and f"{LONGEST:,} characters" in page
    assert all(f"`{outcome.value}`" in page for outcome in Outcome)
