"""`grubler solve`: one object or one a line, each answered in its turn, whatever stands in it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from io import BytesIO, TextIOWrapper
from typing import Any

import pytest

from cli import lines
from cli.main import main
from mechanics.wire import solvers
from tests.cli.calling import ROOT, run

EXAMPLE = json.dumps(solvers.load("beam").EXAMPLE)


def solved(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, text: str | bytes, *arguments: str
) -> tuple[int, list[Any], str]:
    raw = text.encode() if isinstance(text, str) else text
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(raw), "ascii"))
    code, out, err = run(capsys, "solve", *(arguments or ("beam",)))
    return code, [json.loads(line) for line in out.splitlines()], err


def test_a_batch_goes_on_after_bad_lines(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    good = EXAMPLE[:-1] + ', "id": %s}'
    batch = "\n".join([good % 1, "{", "", good % 2, "nonsense", "[" * 70000, '{"id": 3}', "\ufeff" + good % '"z"'])
    code, found, err = solved(capsys, monkeypatch, batch)
    assert (code, err) == (0, "")
    codes = [one.get("error", {}).get("code") for one in found]
    assert codes == [None, "bad_json", None, "bad_json", "too_large", "missing_field", None]
    assert [one.get("id") for one in found] == [1, None, 2, None, None, 3, "z"]
    assert found[0]["M_max"] == found[2]["M_max"]


@pytest.mark.parametrize("indent", [None, 2])
@pytest.mark.parametrize("end", ["", "\n", "\r\n\n"])
def test_one_object_may_be_written_over_several_lines(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, indent: int | None, end: str
) -> None:
    text = json.dumps(solvers.load("beam").EXAMPLE, indent=indent) + end
    code, found, _ = solved(capsys, monkeypatch, text)
    assert code == 0 and [one["degree"] for one in found] == [0]


def test_a_broken_first_line_costs_the_others_nothing(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    code, found, _ = solved(capsys, monkeypatch, "\n".join([EXAMPLE[:40], *[EXAMPLE] * 300]))
    assert code == 0 and len(found) == 301
    assert found[0]["error"]["code"] == "bad_json" and all("error" not in one for one in found[1:])


@pytest.mark.parametrize("text", ["", "\n \n"])
def test_nothing_asked_is_nothing_answered(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    assert solved(capsys, monkeypatch, text) == (0, [], "")


def test_a_line_of_bytes_that_are_no_text_is_one_bad_line(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    code, found, _ = solved(capsys, monkeypatch, b"\xff\xfe\x00\n" + EXAMPLE.encode())
    assert code == 0 and found[0]["error"]["code"] == "bad_json" and found[1]["degree"] == 0


def test_a_line_far_too_long_is_passed_over(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    code, found, _ = solved(capsys, monkeypatch, '{"x": "' + "a" * 10**6 + '"}\n' + EXAMPLE)
    assert code == 0 and [one.get("error", {}).get("code") for one in found] == ["too_large", None]


def test_a_fault_of_ours_costs_one_answer(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def faulty(raw: bytes) -> dict[str, Any]:
        return {"half": 1 / int(raw)}

    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(b"2\n0\n1\n")))
    assert lines.answered(faulty) == 3
    said = capsys.readouterr()
    assert [json.loads(line) for line in said.out.splitlines()] == [{"half": 0.5}, lines.FAULT, {"half": 1.0}]
    assert "ZeroDivisionError" in said.err


def test_the_schema_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "solve", "--schema", "bar")
    assert code == 0 and json.loads(out)["properties"]["gap_right"]["x-unit"] == "m"


def test_an_unknown_solver_and_a_closed_input_are_unusable(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(capsys, "solve", "baem")[0] == 2
    monkeypatch.setattr(sys, "stdin", None)
    assert main(["solve", "beam"]) == 2


def test_each_answer_is_written_before_the_next_line_is_read() -> None:
    command = [sys.executable, "-m", "cli.main", "solve", "beam"]
    with subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=os.environ) as process:
        assert process.stdin is not None and process.stdout is not None
        for _ in range(2):
            process.stdin.write(EXAMPLE.encode() + b"\n")
            process.stdin.flush()
            assert json.loads(process.stdout.readline())["degree"] == 0
        process.stdin.close()
        assert process.wait(30) == 0
