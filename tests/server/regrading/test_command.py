"""`grubler regrade`: beside a server or without one; `grubler worker` needs a store that can be shared."""

from __future__ import annotations

import asyncio
import json
from pathlib import Path

import pytest
from sqlalchemy import update

from server.database import Database
from server.judging.thread import JudgingThread
from server.settings import Settings
from server.tables import grades
from tests.cli.calling import run
from tests.server.jobs.counting import Here
from tests.server.regrading.classroom import SECRET, STUDENTS, Class, other_grade, published
from tests.server.sets.classroom import SET, enrol
from tests.server.stores import lay


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a store to which a right answer was handed in that older judges found wrong."""
    monkeypatch.setenv("GRUBLER_SECRET", SECRET.decode())
    monkeypatch.delenv("DATABASE_URL", raising=False)
    monkeypatch.setattr(JudgingThread, "apart", Here.apart)
    url = lay(Settings(tmp_path))
    enrol(url, STUDENTS)
    database = Database(url)
    school = Class(url, database, asyncio.run(published(url, database)))
    older = other_grade(school.grades("anna")[0]["grade"], 0.8, l3=("wrong", 0.0))
    school.do(update(grades).where(grades.c.submission == "anna").values(grade=older, grader_version="0"))
    database.close()
    return tmp_path


def test_a_regrade_tells_every_change_and_then_how_many(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = "regrade", "--task-set", SET, "--data-dir", str(folder)
    for _ in range(2):
        code, out, err = run(capsys, *command, "--dry-run")
        assert (code, err) == (0, "") and out.splitlines()[0] == "anna raised 0.8 -> 1; l3: wrong -> right"
    assert "3 judged: 2 unchanged, 1 higher" in out
    code, out, _ = run(capsys, *command, "--format", "json")
    change, end = map(json.loads, out.splitlines())
    assert (change["receipt"], change["effect"], end["counts"]["raised"], end["dry_run"]) == (
        "anna",
        "raised",
        1,
        False,
    )
    code, out, _ = run(capsys, *command)
    assert code == 0 and out.startswith("3 judged: 3 unchanged")


def test_a_set_that_is_not_there_is_unusable(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number in ("AAAA-AAAA-AAAA", "x"):
        code, _, err = run(capsys, "regrade", "--task-set", number, "--data-dir", str(folder))
        assert code == 2 and f"no published task set {number}" in err


def test_an_embedded_store_has_no_workers(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "worker", "--data-dir", str(folder))
    assert code == 2 and "DATABASE_URL" in err
    code, _, err = run(capsys, "worker", "--processes", "0")
    assert code == 2 and "--processes" in err
