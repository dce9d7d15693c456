"""A43: a file of answers cannot change the task, the score or the report; what is no answer file is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.calling import item, run, written

Capture = pytest.CaptureFixture[str]
TASKS = {"items": [{"exercise": "slider_crank", "version": 1, "seed": 7}]}


def graded(capsys: Capture, *arguments: str) -> tuple[int, float]:
    code, out, _ = run(capsys, "grade", *arguments, "--format", "json")
    (file,) = json.loads(out)["files"]
    return code, file["score"]


def test_another_seed_than_the_task_earns_nothing(tmp_path: Path, capsys: Capture) -> None:
    tasks = written(tmp_path, TASKS, "tasks.json")
    easier = written(tmp_path, {"items": [item("slider_crank", 8)]})
    assert graded(capsys, easier, "--tasks", tasks) == (1, 0)


@pytest.mark.parametrize("name", ["score", "verdicts", "passed", "weight", "pass", "tolerance"])
def test_a_file_cannot_bring_its_own_score(name: str, tmp_path: Path, capsys: Capture) -> None:
    forged = written(tmp_path, {"items": [item("slider_crank", 7) | {name: 1}]})
    code, _, said = run(capsys, "grade", forged)
    assert code == 2 and name in said


def test_the_same_item_twice_is_not_counted_twice(tmp_path: Path, capsys: Capture) -> None:
    more = [{"exercise": "gear_train", "version": 1, "seed": seed} for seed in (3, 4)]
    tasks = written(tmp_path, {"items": [*TASKS["items"], *more]}, "tasks.json")
    twice = written(tmp_path, {"items": [item("slider_crank", 7)] * 2})
    code, score = graded(capsys, twice, "--tasks", tasks)
    assert code == 1 and score <= 1 / 3 + 1e-6


def test_grading_writes_nothing_beside_its_output(tmp_path: Path, capsys: Capture) -> None:
    file = written(tmp_path, {"items": [item("slider_crank", 7)]})
    before = {path: path.stat().st_mtime_ns for path in tmp_path.iterdir()}
    run(capsys, "grade", file)
    assert {path: path.stat().st_mtime_ns for path in tmp_path.iterdir()} == before


def test_a_link_to_a_foreign_file_shows_nothing_of_it(tmp_path: Path, capsys: Capture) -> None:
    secret = tmp_path / "secret"
    secret.write_text("the password is swordfish")
    link = tmp_path / "answers.json"
    link.symlink_to(secret)
    code, out, said = run(capsys, "grade", str(link))
    assert code == 2 and "swordfish" not in out + said
