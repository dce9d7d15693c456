"""Marks as CSV and XLSX are read back with other programs' readers; the numbers are those of the gradebook."""

from __future__ import annotations

import csv
import io
from typing import Any

import pytest
from openpyxl import load_workbook

from exercises.grading import reference
from server.marks import exporting
from server.marks.api import _attached
from server.marks.export import Table, inert, written
from server.sets import handing
from tests.server.marks.test_api import book
from tests.server.sets.conftest import Course

FORMULAS = ("=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "  =1", "＝1")


def cells(content: bytes, delimiter: str) -> list[list[str]]:
    assert content.startswith(b"\xef\xbb\xbf")
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), delimiter=delimiter))


def sheet(content: bytes) -> list[tuple[Any, ...]]:
    return list(load_workbook(io.BytesIO(content)).active.iter_rows(values_only=True))


@pytest.mark.parametrize("text", FORMULAS)
def test_a_text_that_begins_like_a_formula_is_inert_in_every_form(text: str) -> None:
    table = Table("Results", (text, "n"), ((text, 1.5), ('a;b,"c"\n', None)))
    for separator, delimiter, number in (("comma", ",", "1.5"), ("semicolon", ";", "1,5")):
        found = cells(written(table, "csv", separator), delimiter)  # type: ignore[arg-type]
        assert found == [["'" + text, "n"], ["'" + text, number], ['a;b,"c"\n', ""]]
    excel = sheet(written(table, "xlsx", "comma"))
    assert [one[0].replace("_x000D_", "\r").replace("\n", "\r") for one in excel[:2]] == ["'" + text] * 2
    assert excel[1][1] == 1.5 and excel[2][1] is None


def test_an_export_shows_the_points_before_and_what_was_taken_off(course: Course) -> None:
    rules = {"late": "reduced", "late_loss": 0.1, "ladder": True, "hint_price": 0.2}
    number = course.published(title="Taken off", rules=rules, item={"attempts": None})
    variant = course.variant(number)
    course.hand_in(variant, {"l3": "9 m"})
    form = {"answer": "l3", "rung": "1"}
    assert course.student.post(f"/variants/{variant}/hints", data=form, follow_redirects=False).status_code == 303
    course.move(number, hours=1)
    course.hand_in(variant, reference(handing.variant_of(course.card(number))))
    path = f"/api/v1/task-sets/{number}/marks.csv?lang=en"
    head, *found = cells(course.lecturer.get(path).content, ",")
    (row,) = [dict(zip(head, line, strict=True)) for line in found if line[3] == "Student"]
    told = [
        row[name] for name in ("Points before deductions", "Taken off for lateness", "Taken off for hints", "Points")
    ]
    assert told == ["10", "1", "1.8", "7.2"]
    whole = cells(course.lecturer.get(f"/api/v1/courses/{course.school.course}/marks.csv?lang=en").content, ",")
    assert "Taken off for hints" in whole[0]


def test_points_and_the_sheet_are_named_in_the_language_of_who_exports(course: Course) -> None:
    path = f"/api/v1/task-sets/{course.published(item={'points': 4.5})}/marks"
    for language, task, title in (("pl", "Zadanie 1 (4,5)", "Wyniki"), ("ru", "Задача 1 (4,5)", "Результаты")):
        assert cells(course.lecturer.get(f"{path}.csv?lang={language}").content, ",")[0][5] == task
        excel = load_workbook(io.BytesIO(course.lecturer.get(f"{path}.xlsx?lang={language}").content))
        assert excel.sheetnames == [title]


@pytest.mark.parametrize("text", ["Olga", "1-2", "A=B", "", "Ł. Żuk"])
def test_other_texts_stay_as_they_are(text: str) -> None:
    assert inert(text) == text


def test_an_export_holds_what_the_gradebook_says_and_is_written_down(course: Course) -> None:
    number = course.published(title="=cmd|' /C calc'!A0")
    course.hand_in(course.variant(number), reference(handing.variant_of(course.card(number))))
    course.variant(number, course.other)
    course.hand_in(course.variant(number, course.other), {"l3": "1 mm"}, who=course.other)
    path, rows = f"/api/v1/task-sets/{number}/marks", book(course, number)
    reply = course.lecturer.get(f"{path}.csv?lang=en")
    named = "attachment; filename=\"marks.csv\"; filename*=UTF-8''%3Dcmd%20%27%20C%20calc%27%21A0.csv"
    assert reply.headers["content-disposition"] == named
    head, *found = cells(reply.content, ",")
    assert head[:6] == ["Course", "Group", "Index number", "Name", "Task set", "Task 1 (10)"]
    assert {line[4] for line in found} == {"'=cmd|' /C calc'!A0"}
    assert {line[3]: line[5] for line in found} == {"Leaver": "", "Other": "0", "Student": "10"}
    assert {line[3]: float(line[head.index("Points")]) for line in found} == {
        name: row["points"] for name, row in rows.items()
    }
    excel = sheet(course.lecturer.get(f"{path}.xlsx?lang=en").content)
    assert list(excel[0]) == head and [one[5] for one in excel[1:]] == [None, 0, 10]
    polish = cells(course.lecturer.get(f"{path}.csv?lang=pl&separator=semicolon").content, ";")
    assert polish[0][3] == "Imię i nazwisko" and len(polish) == len(found) + 1
    whole = cells(course.lecturer.get(f"/api/v1/courses/{course.school.course}/marks.csv").content, ",")
    assert "'=cmd|' /C calc'!A0 (10)" in whole[0] and len(whole) == len(found) + 1
    lines = course.lecturer.get(f"/api/v1/courses/{course.school.course}/audit").json()["lines"]
    assert [one["action"] for one in lines[:4]] == ["marks_exported"] * 4 and lines[0]["details"] == {"students": 3}
    assert course.student.get(f"{path}.csv").status_code == 403
    assert course.lecturer.get(f"{path}.ods").status_code == 422
    direct = exporting.marks(course.school.bench.settings, number, None, "csv", "comma", "en")
    assert direct == reply.content
    assert exporting.marks(course.school.bench.settings, None, "none", "csv", "comma", "en") is None


def test_marks_for_research_name_nobody_and_tell_the_same_person_alike(course: Course) -> None:
    first, second = course.published(title="First"), course.published(title="Second")
    course.hand_in(course.variant(first), reference(handing.variant_of(course.card(first))))
    settings = course.school.bench.settings
    found = []
    for task_set, whole in ((first, None), (second, None), (None, course.school.course)):
        content = exporting.marks(settings, task_set, whole, "csv", "comma", "en", named=False)
        named = exporting.marks(settings, task_set, whole, "csv", "comma", "en")
        assert content is not None and named is not None
        lines = cells(content, ",")[1:]
        assert not any(line[2] for line in lines)
        assert sorted(line[4:] for line in lines) == sorted(line[4:] for line in cells(named, ",")[1:])
        found.append([line[3] for line in lines])
    assert found[0] == found[1] == found[2] == sorted(set(found[0]))
    assert len(found[0]) == 3 and not {"Leaver", "Other", "Student"} & set(found[0])


@pytest.mark.parametrize(
    ("title", "name"),
    [("Zestaw 3: późne prace", "Zestaw%203%20p%C3%B3%C5%BAne%20prace"), ("..", "marks"), ("Ж" * 200, "%D0%96" * 80)],
)
def test_a_file_of_marks_is_named_by_its_set(title: str, name: str) -> None:
    assert _attached(title, "xlsx") == f"attachment; filename=\"marks.xlsx\"; filename*=UTF-8''{name}.xlsx"
