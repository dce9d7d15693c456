"""`grubler compare`: one object or one a line, each answered in its turn, whatever stands in it."""

from __future__ import annotations

import json
import sys
from io import BytesIO, TextIOWrapper
from typing import Any

import pytest

from tests.cli.calling import run

EQUAL = '{"kind": "expression", "a": "2*x", "b": "x + x", "vars": {"x": ["0", "pi"]}, "id": %s}'


def compared(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, text: str | bytes
) -> tuple[int, list[Any], str]:
    raw = text.encode() if isinstance(text, str) else text
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(raw), "ascii"))
    code, out, err = run(capsys, "compare")
    return code, [json.loads(line) for line in out.splitlines()], err


def test_a_batch_goes_on_after_bad_lines(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    batch = [
        EQUAL % 1,
        "{",
        "",
        EQUAL % '"two"',
        '{"kind": "nonsense", "a": "1", "b": "1", "id": 3}',
        '{"kind": "expression", "a": "1", "b": "1", "solve_for": "x", "id": 4}',
        '{"kind": "expression", "a": "1", "b": "1", "vars": {"x": [0, 1], "x": [0, 2]}, "id": 5}',
        '{"kind": "expression", "a": "x +", "b": "1", "vars": {"x": [0, 1]}, "id": 6}',
        '{"kind": "expression", "a": "\\ud800", "b": "1", "id": 7}',
        "[1]",
        EQUAL % "null",
    ]
    code, found, err = compared(capsys, monkeypatch, "\n".join(batch))
    assert (code, err) == (0, "")
    told = [one.get("verdict") or one["error"]["code"] for one in found]
    assert told == [
        "equal", "bad_json", "equal", "unknown_kind", "unknown_field", "repeated_field", "unreadable", "unreadable",
        "bad_json", "equal",
    ]  # fmt: skip
    assert [one.get("id") for one in found] == [1, None, "two", 3, 4, 5, 6, 7, None, None]
    assert "id" in found[-1] and "id" not in found[1]


def test_one_object_over_several_lines_is_one_request(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    request = json.dumps(json.loads(EQUAL % 1), indent=2)
    code, found, _ = compared(capsys, monkeypatch, request)
    assert code == 0 and [one["verdict"] for one in found] == ["equal"]


def test_the_secret_is_taken_from_the_environment_and_two_runs_agree(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    request = '{"kind": "equation", "a": "x = a", "b": "x = 2*a", "solve_for": "x", "vars": {"x": [0, 2], "a": [0, 1]}}'
    monkeypatch.delenv("GRUBLER_SECRET", raising=False)
    one, again = (compared(capsys, monkeypatch, request) for _ in range(2))
    monkeypatch.setenv("GRUBLER_SECRET", "another")
    assert one == again != compared(capsys, monkeypatch, request)


def test_a_closed_input_is_unusable(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", None)
    assert run(capsys, "compare")[0] == 2
