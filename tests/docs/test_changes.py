"""Fragments of changes become a section of CHANGELOG.md, and nothing that is told in them is lost."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FRAGMENTS = ROOT / "changelog.d"
NAMED = re.compile(r"[a-z0-9][A-Za-z0-9_-]*\.(added|changed|fixed)\.md")


def released(folder: Path, version: str) -> str:
    """Gather the fragments of a folder into its list of changes, and give the list."""
    command = [sys.executable, "-m", "towncrier", "build", "--yes", "--version", version, "--date", "2030-01-31"]
    subprocess.run([*command, "--dir", str(folder)], check=True, capture_output=True)
    return (folder / "CHANGELOG.md").read_text("utf-8")


@pytest.fixture
def house(tmp_path: Path) -> Path:
    for name in ("pyproject.toml", "CHANGELOG.md"):
        shutil.copy(ROOT / name, tmp_path)
    shutil.copytree(FRAGMENTS, tmp_path / "changelog.d")
    return tmp_path


def test_each_change_has_a_name_a_kind_and_a_sentence() -> None:
    found = {path.name: path.read_text("utf-8") for path in FRAGMENTS.iterdir() if path.suffix != ".jinja"}
    assert [name for name, text in found.items() if not (NAMED.fullmatch(name) and text.strip().endswith("."))] == []


def test_a_release_gathers_the_fragments_above_the_release_before(house: Path) -> None:
    told = [" ".join(path.read_text("utf-8").split()) for path in FRAGMENTS.glob("*.md")]
    for kind in ("added", "changed", "fixed"):
        (house / "changelog.d" / f"tried.{kind}.md").write_text(f"Something was {kind}, as `<x-a>`.\n", "utf-8")
    before = (ROOT / "CHANGELOG.md").read_text("utf-8")
    latest = re.findall(r"^## .*", before, re.MULTILINE)[0]
    new, _, old = released(house, "99.1.0").partition(latest)
    assert old == before.partition(latest)[2]
    assert re.findall(r"^##+ .*", new, re.MULTILINE) == [
        "## 99.1.0, 2030-01-31",
        "### Added",
        "### Changed",
        "### Fixed",
    ]
    assert all(f"- Something was {kind}, as `<x-a>`.\n" in new for kind in ("added", "changed", "fixed"))
    assert [text for text in told if text not in " ".join(new.split())] == []


def test_a_release_leaves_no_fragment_for_the_next_one(house: Path) -> None:
    (house / "changelog.d" / "tried.fixed.md").write_text("Something was mended.\n", "utf-8")
    released(house, "99.1.0")
    assert list((house / "changelog.d").glob("*.md")) == []
