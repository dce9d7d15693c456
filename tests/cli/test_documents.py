"""`grubler report` and `grubler sheet`: files written whole, refusals that say why."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.calling import item, run, written

Capture = pytest.CaptureFixture[str]


@pytest.mark.parametrize(("kind", "start"), [("pdf", b"%PDF-"), ("docx", b"PK"), ("typ", b"#set"), ("md", b"# ")])
def test_a_report_is_written_in_each_format(kind: str, start: bytes, tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / f"report.{kind}"
    asked = ("--exercise", "tmm2_opo", "--seed", "3", "--lang", "pl", "--format", kind, "--output", str(file))
    assert run(capsys, "report", "tmm2", *asked) == (0, "", "")
    assert file.read_bytes().startswith(start)


def test_a_report_is_filled_from_an_answers_file(tmp_path: Path, capsys: Capture) -> None:
    file = str(tmp_path / "report.md")
    answers = written(tmp_path, {"items": [item("tmm2_poo", 4)]})
    asked = ("--exercise", "tmm2_poo", "--answers", answers, "--format", "md", "--output", file)
    assert run(capsys, "report", "tmm2", *asked, "--seed", "4")[0] == 0
    assert "right" in Path(file).read_text("utf-8")
    code, _, said = run(capsys, "report", "tmm2", *asked, "--seed", "5")
    assert code == 2 and "no item of tmm2_poo with seed 5" in said


@pytest.mark.parametrize(
    ("exercise", "output", "expected"),
    [
        ("simple_beam", "r.pdf", "is no laboratory"),
        ("nothing", "r.pdf", "no exercise nothing"),
        ("tmm2_oop", "none/r.pdf", "cannot be written"),
    ],
)
def test_what_cannot_be_written_is_said(
    exercise: str, output: str, expected: str, tmp_path: Path, capsys: Capture
) -> None:
    file = tmp_path / output
    code, _, said = run(capsys, "report", "tmm2", "--exercise", exercise, "--seed", "1", "--output", str(file))
    assert code == 2 and expected in said and not file.exists()


def test_sheets_and_their_key_are_two_files(tmp_path: Path, capsys: Capture) -> None:
    sheet, key = tmp_path / "sheets.typ", tmp_path / "key.typ"
    asked = ("--count", "20", "--seed", "5", "--format", "typ", "--output", str(sheet), "--key", str(key))
    code, _, said = run(capsys, "sheet", "gear_train", *asked)
    assert code == 0 and "20/20" in said
    assert "24, 20 of 20" in sheet.read_text("utf-8") and "Variant 24" in key.read_text("utf-8")


@pytest.mark.parametrize("count", ["0", "501", "x"])
def test_a_number_of_sheets_out_of_range_is_refused(count: str, tmp_path: Path, capsys: Capture) -> None:
    assert run(capsys, "sheet", "gear_train", "--count", count, "--output", str(tmp_path / "s.pdf"))[0] == 2
