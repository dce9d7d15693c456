"""A33: what students and lecturers type never becomes a formula in a table that is exported, nor parts its cells."""

from __future__ import annotations

import csv
import io

import pytest
from openpyxl import load_workbook

from server.marks.export import Table, written

HOSTILE = (
    "=HYPERLINK(\"http://x\";\"y\")", "+cmd|' /C calc'!A0", "-2+3", "@SUM(1)", "\t=1", "\n=1", " =1", "＝1+1",
    'a";"b', "a;b,c", "a\r\nb;c", "\x00=1",
)  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE)
def test_a_hostile_text_stays_one_cell_without_a_formula(text: str) -> None:
    table = Table("Results", ("name", "points"), ((text, 1.0),))
    for separator, delimiter in (("comma", ","), ("semicolon", ";")):
        content = written(table, "csv", separator).decode("utf-8-sig")  # type: ignore[arg-type]
        _, (found, points) = csv.reader(io.StringIO(content, newline=""), delimiter=delimiter)
        assert points == "1" and not found.lstrip(" \0").startswith(tuple("=+-@\t\r\n＝"))
    (row,) = load_workbook(io.BytesIO(written(table, "xlsx", "comma"))).active.iter_rows(min_row=2)
    assert [cell.data_type for cell in row] == ["s", "n"] and not str(row[0].value).startswith("=")
