"""Pages that list things are compared with the program they describe."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from cli.reading import LARGEST, LONGEST
from graders import Outcome
from tests.docs import (
    api_reference,
    benchmark_reference,
    command_reference,
    language_reference,
    mechanics_reference,
    security_reference,
    solver_reference,
    systems_reference,
)

DOCS = api_reference.ROOT / "docs"


@pytest.mark.parametrize(
    ("page", "written"),
    [
        (api_reference.PAGE, api_reference.page),
        (benchmark_reference.PAGE, benchmark_reference.page),
        (command_reference.PAGE, command_reference.page),
        (language_reference.PAGE, language_reference.page),
        (mechanics_reference.PAGE, mechanics_reference.page),
        (security_reference.PAGE, security_reference.page),
        (solver_reference.PAGE, solver_reference.page),
        (systems_reference.PAGE, systems_reference.page),
    ],
    ids=["api", "benchmarks", "commands", "language", "mechanics", "security", "solvers", "systems"],
)
def test_a_written_page_is_up_to_date(page: Path, written: Callable[[], str]) -> None:
    assert page.read_text("utf-8") == written(), f"write {page.name} again: see its first lines"


def test_each_system_that_is_cited_by_number_has_its_names() -> None:
    cited = {number: at for at, numbers in systems_reference.places().items() for number in numbers}
    assert {number: at for number, at in cited.items() if number not in systems_reference.names()} == {}
    assert {"VP-2", "DH-13", "SM-11"} <= set(cited)


def test_the_page_on_files_names_the_limits_and_the_outcomes() -> None:
    page = (DOCS / "reference" / "files.md").read_text("utf-8")
    assert f"{LARGEST:,} bytes" in page and f"{LONGEST:,} characters" in page
    assert all(f"`{outcome.value}`" in page for outcome in Outcome)


def test_each_public_function_of_the_mechanics_room_says_what_it_does() -> None:
    page = mechanics_reference.PAGE.read_text("utf-8")
    for module in mechanics_reference.modules():
        assert module.__doc__, module.__name__
        for function in mechanics_reference.functions(module):
            assert function.__doc__ and f"| `{function.__name__}` |" in page, function.__qualname__


@pytest.mark.parametrize(
    ("words", "module"),
    [
        ("deflection beam", "beam"),
        ("ratio planetary", "willis"),
        ("counterweight four-bar", "balancing"),
        ("jacobian", "chain"),
        ("passive constraints", "mobility"),
        ("geneva", "geneva"),
        ("four-bar coupler", "four_bar"),
        ("instant centre", "instant_centre"),
        ("linear drive", "variable_length_link"),
        ("class iii unit", "class_iii"),
        ("assur", "assur"),
        ("base excitation", "vibration"),
        ("torsion shaft", "shaft"),
        ("coriolis acceleration", "inverted_slider"),
        ("coriolis acceleration", "manipulator"),
        ("von mises", "stress"),
        ("second moment area", "section"),
        ("bending moment", "beam"),
        ("resonance", "vibration"),
        ("inverse kinematics", "rod_groups"),
        ("universal joint", "hooke_joint"),
    ],
)
def test_a_reader_finds_a_solver_by_what_it_is_for(words: str, module: str) -> None:
    """Searching for the thing leads to a line of the first table or of the module's own section."""
    page = mechanics_reference.PAGE.read_text("utf-8").lower()
    section = page.partition(f"\n### {module}\n")[2].partition("\n### ")[0]
    rows = [line for line in page.splitlines() if f"(#{module})" in line] + section.splitlines()
    assert any(all(word in line for word in words.split()) for line in rows)
