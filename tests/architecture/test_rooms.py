"""The house: every module is analysed, the machinery stays small, arrows are held by import-linter."""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import grimp
import pytest

ROOT = Path(__file__).parents[2]
ROOMS = ("cli", "server", "reports", "exercises", "graders", "mechanics", "figures")


def test_no_module_is_silently_left_out_of_the_analysis() -> None:
    graph = grimp.build_graph(*ROOMS, cache_dir=None)
    skipped = {"node_modules", "__pycache__", "template"}
    files = [p for room in ROOMS for p in (ROOT / room).rglob("*.py") if not skipped & set(p.parts)]
    assert len(graph.modules) == len(files)


def test_the_machinery_of_the_exercise_room_has_at_most_ten_files() -> None:
    assert len([p for p in (ROOT / "exercises").glob("*.py") if p.name != "__init__.py"]) <= 10


def test_the_top_of_the_server_room_holds_only_what_its_resources_share() -> None:
    assert len([p for p in (ROOT / "server").glob("*.py") if p.name != "__init__.py"]) <= 8


@cache
def imported_by_grading() -> frozenset[str]:
    """Every module that a process has imported which has graded the reference of each exercise."""
    script = (
        "import sys; from exercises import variants; from exercises.grading import grade, reference;"
        "from exercises.exercise import Submission; from exercises import catalogue;"
        "[grade(Submission(v, reference(v))) for v in (variants.deal(i, 1) for i in catalogue.ids())];"
        "print(*sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    return frozenset(done.stdout.split())


@pytest.mark.parametrize("heavy", ["sympy", "fastapi", "sqlalchemy", "numpy", "latex2mathml"])
def test_grading_imports_nothing_heavy(heavy: str) -> None:
    assert "exercises.grading" in imported_by_grading()
    assert heavy not in imported_by_grading()


def test_grading_numbers_imports_no_figure_no_oracle_and_no_balls() -> None:
    script = (
        "import sys; from exercises import variants; from exercises.grading import grade;"
        "from exercises.exercise import Submission;"
        "grade(Submission(variants.deal('slider_crank', 1), {'v3': '-1,2 m/s'}));"
        "assert not {'figures', 'mechanics.planar', 'flint', 'graders.kinds.matrix'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


BETWEEN_OUR_PROCESSES = ["judge.py: pickle"]  # a server and its judge, over a pair of sockets


def test_student_text_never_reaches_an_evaluator() -> None:
    forbidden = ("eval(", "exec(", "sympify(", "parse_expr(", "lambdify(", "pickle", "yaml.load")
    product = [p for room in ROOMS for p in (ROOT / room).rglob("*.py") if "node_modules" not in p.parts]
    found = [f"{p.name}: {word}" for p in product for word in forbidden if word in p.read_text("utf-8")]
    assert sorted(found) == BETWEEN_OUR_PROCESSES
