from __future__ import annotations

import os
import subprocess
import sys
import tomllib

import pytest

from cli.main import COMMANDS, main
from tests.cli.calling import ROOT, process, run

HEAVY = ("numpy", "sympy", "fastapi", "pydantic", "sqlalchemy", "uvicorn", "alembic")


def imported(*arguments: str) -> set[str]:
    """Which heavy modules a command has imported by its end."""
    script = f"""
import contextlib, sys
from cli.main import main
with contextlib.suppress(SystemExit):
    main({list(arguments)!r})
print(*(name for name in {HEAVY!r} if name in sys.modules), file=sys.stderr)
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True)
    return set(done.stderr.splitlines()[-1].split())


def test_help_imports_nothing_heavy() -> None:
    assert imported("--help") == set()


def test_a_drawn_and_presented_variant_needs_neither_the_web_nor_the_database() -> None:
    assert imported("draw", "slider_crank", "--seed", "1") == set()


def test_the_version_is_that_of_the_distribution(capsys: pytest.CaptureFixture[str]) -> None:
    said = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    assert run(capsys, "--version") == (0, f"grubler {said}\n", "")


def test_help_names_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "--help")
    assert code == 0
    assert all(name in out and summary in out for name, summary in COMMANDS.items())


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_explains_itself(capsys: pytest.CaptureFixture[str], command: str) -> None:
    code, out, _ = run(capsys, command, "--help")
    assert code == 0 and f"grubler {command}" in out


@pytest.mark.parametrize("arguments", [(), ("gradee",), ("grade",), ("grade", "a", "--pass", "2"), ("draw",)])
def test_a_wrong_command_line_is_unusable_input(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...]) -> None:
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (2, "") and "usage: grubler" in err


@pytest.mark.parametrize("share", ["nan", "inf", "-0.1", "half"])
def test_a_pass_mark_is_a_number_from_0_to_1(capsys: pytest.CaptureFixture[str], share: str) -> None:
    assert run(capsys, "grade", "a.json", f"--pass={share}")[0] == 2


def test_our_own_fault_has_its_own_exit_code(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(options: object) -> int:
        raise RuntimeError("a fault put in by the test")

    monkeypatch.setattr("cli.catalogue.run", broken)
    code, _, err = run(capsys, "catalogue")
    assert code == 3 and "fault of the program" in err and "put in by the test" in err


def test_an_interrupted_command_says_nothing(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(options: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("cli.catalogue.run", interrupted)
    assert run(capsys, "catalogue") == (130, "", "")


def test_a_reader_that_goes_away_is_no_error() -> None:
    command = f"{sys.executable} -m cli.main draw slider_crank --seed 1 --json | true"
    done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=ROOT, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")


def test_output_is_utf8_in_every_locale() -> None:
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    done = process("draw", "slider_crank", "--seed", "1", "--lang", "ru", env=environment)
    assert "Длина кривошипа" in done.stdout.decode("utf-8")


def test_main_takes_the_command_line_of_the_process(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.argv", ["grubler", "catalogue"])
    assert main() == 0
