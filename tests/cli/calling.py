"""Calling the command line: in this process for speed, in another one for what only a process shows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from cli.main import main
from exercises.grading import reference
from exercises.variants import deal

ROOT = Path(__file__).parents[2]


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    """Run a command here: exit code, output, errors."""
    try:
        code = main(arguments)
    except SystemExit as stop:
        code = int(stop.code or 0)
    said = capsys.readouterr()
    return code, said.out, said.err


def process(*arguments: str, cwd: Path = ROOT, env: dict[str, str] | None = None) -> subprocess.CompletedProcess[bytes]:
    """Run a command in a process of its own."""
    command = [sys.executable, "-m", "cli.main", *arguments]
    return subprocess.run(command, cwd=cwd, env=env, capture_output=True, timeout=300, check=False)


def item(exercise: str, seed: int, **changed: str) -> dict[str, Any]:
    """An item with right answers, some of them changed."""
    answers = {**reference(deal(exercise, seed)), **changed}
    return {"exercise": exercise, "seed": seed, "answers": answers}


def written(folder: Path, document: Any, name: str = "answers.json") -> str:
    """Write a document (JSON values, or text as it is) to a file."""
    text = document if isinstance(document, str) else json.dumps(document)
    (folder / name).write_text(text, "utf-8")
    return str(folder / name)
