from __future__ import annotations

import pytest

from cli import verify
from exercises.verifying import Report
from tests.cli.calling import run


def test_an_exercise_without_failures_passes(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "verify", "slider_crank", "--seeds", "12")
    assert (code, out) == (0, "slider_crank: 12 seeds, 12 distinct, 0 failures\n")
    assert "1 × 12 variants" in err


def test_more_processes_print_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    alone = run(capsys, "verify", "slider_crank", "--seeds", "5")
    both = run(capsys, "verify", "slider_crank", "--seeds", "5", "--jobs", "2")
    assert both[:2] == alone[:2]


def test_failures_are_told_and_do_not_pass(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(exercise: str, seeds: range) -> Report:
        return Report(exercise, len(seeds), 3, tuple(f"seed {seed}: no" for seed in seeds))

    monkeypatch.setattr(verify, "verify", failing)
    code, out, _ = run(capsys, "verify", "slider_crank", "--seeds", "23")
    assert code == 1 and "23 failures" in out and "  seed 19: no\n  and 3 more\n" in out


@pytest.mark.parametrize("arguments", [["no_such"], ["--seeds", "0"], ["--jobs", "x"], ["--seeds", "²"]])
def test_what_cannot_be_verified_is_unusable(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "verify", *arguments)[0] == 2
