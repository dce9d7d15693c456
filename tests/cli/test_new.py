from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from cli.new import scaffold
from cli.problems import Unusable
from exercises import catalogue
from tests.cli.calling import ROOT, process

ROOMS = ("cli", "exercises", "figures", "graders", "mechanics")


@pytest.fixture
def house(tmp_path: Path) -> Path:
    """A copy of the rooms in which an exercise can be added."""
    for room in ROOMS:
        shutil.copytree(ROOT / room, tmp_path / room, ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


@pytest.mark.parametrize("chapter", ["accuracy", "strength"])
def test_a_new_exercise_passes_all_checks(chapter: str, house: Path) -> None:
    made = process("new", "round_bar", "--chapter", chapter, cwd=house)
    folder = Path(made.stdout.decode().strip())
    assert (made.returncode, made.stderr) == (0, b"") and folder == house / "exercises" / chapter / "round_bar"
    gate = process("verify", "round_bar", "--seeds", "60", cwd=house)
    assert gate.returncode == 0 and b"0 failures" in gate.stdout
    for check in (["check"], ["format", "--check"]):
        command = [sys.executable, "-m", "ruff", *check, "--config", str(ROOT / "pyproject.toml"), str(folder)]
        assert subprocess.run(command, cwd=house, capture_output=True, check=False).returncode == 0


def test_a_new_exercise_is_served_like_any_other(house: Path) -> None:
    process("new", "round_bar", cwd=house)
    drawn = json.loads(process("draw", "round_bar", "--seed", "4", "--json", "--lang", "pl", cwd=house).stdout)
    assert drawn["title"] == "Pręt rozciągany" and drawn["figure"].startswith('<svg class="fig" id="round-bar"')


def test_an_incomplete_neighbour_is_named(house: Path) -> None:
    (house / "exercises" / "linkages" / "half_written").mkdir()
    for command in (["new", "round_bar"], ["verify"], ["catalogue"], ["draw", "four_bar", "--seed", "1"]):
        done = process(*command, cwd=house)
        assert done.returncode == 2 and b"linkages/half_written lacks" in done.stderr
        assert b"Traceback" not in done.stderr


def test_a_new_folder_holds_all_files_under_its_own_name(tmp_path: Path) -> None:
    folder = scaffold(tmp_path, "accuracy", "round_bar")
    assert folder == tmp_path / "accuracy" / "round_bar"
    assert {file.name for file in folder.iterdir()} == {*catalogue.FILES, "figure.py"}
    assert (tmp_path / "accuracy" / "__init__.py").read_text() == '"""Accuracy."""\n'
    words = "".join(file.read_text("utf-8") for file in folder.iterdir())
    assert not any(place in words for place in ("EXERCISE_ID", "EXERCISE-ID", "CHAPTER"))
    assert '"round-bar"' in words


@pytest.mark.parametrize("name", ["", "2bars", "Bar", "bar-two", "a/b", "..", "_bar", "class", "belka_ą", "b" * 41])
def test_an_id_that_cannot_stay_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(Unusable) as refused:
        scaffold(tmp_path, "strength", name)
    assert refused.value.key == "bad_id" and not list(tmp_path.iterdir())


def test_an_id_is_taken_once_in_all_chapters() -> None:
    with pytest.raises(Unusable) as refused:
        scaffold(catalogue.ROOT, "strength", "slider_crank")
    assert "there is an exercise of this name in linkages" in refused.value.worded("en")


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "strength").write_text("a file where the chapter should be")
    with pytest.raises(Unusable) as refused:
        scaffold(tmp_path, "strength", "round_bar")
    assert refused.value.key == "not_writable" and refused.value.file
