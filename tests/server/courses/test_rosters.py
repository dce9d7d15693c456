"""A roster in a file: whatever program wrote it, what it would change is shown first."""

from __future__ import annotations

import codecs
import re
from html import unescape

import pytest
from starlette.testclient import TestClient

from server.courses import rosters
from server.web.envelope import LARGEST_ROSTER
from server.web.errors import Refused
from tests.server.school import School

EN = {"accept-language": "en", "accept": "text/html"}
POLISH = "Nr indeksu;Imię i nazwisko;Grupa\r\n3001;Świętosława Żółć;Środa\r\n"
RUSSIAN = "номер;имя\n3001;Ёлкина Юлия\n"


@pytest.mark.parametrize(
    ("text", "encoding", "language"),
    [(POLISH, encoding, "pl") for encoding in ("utf-8", "utf-8-sig", "cp1250", "utf-16", "utf-16-le", "utf-16-be")]
    + [(RUSSIAN, encoding, "ru") for encoding in ("utf-8", "cp1251", "utf-16", "utf-16-le", "utf-16-be")]
    + [("3001;Ann\n", encoding, "en") for encoding in ("ascii", "utf-16-le")],
)  # fmt: skip
def test_a_file_is_read_as_spreadsheets_write_it(text: str, encoding: str, language: str) -> None:
    assert rosters.decoded(text.encode(encoding), language) == text


@pytest.mark.parametrize(
    ("raw", "code"),
    [(b"PK\x03\x04xlsx", "roster_spreadsheet"), (b"\xd0\xcf\x11\xe0\xa1\xb1", "roster_spreadsheet"),
     (b"3001;\x81\x83\x88 \xff", "roster_encoding"), (codecs.BOM_UTF16_LE + b"a", "roster_encoding")],
)  # fmt: skip
def test_what_is_no_text_is_refused_with_advice(raw: bytes, code: str) -> None:
    with pytest.raises(Refused) as refused:
        rosters.decoded(raw, "pl")
    assert refused.value.code == code


def send(browser: TestClient, school: School, content: bytes, name: str = "lista.csv") -> tuple[int, str]:
    reply = browser.post(f"/courses/{school.course}/roster", files={"file": (name, content, "text/csv")}, headers=EN)
    return reply.status_code, reply.text


@pytest.mark.parametrize("name", ['"Anna', 'Anna "', '"Anna" Nowak', '"' + "a" * 200_000, "a" * 200_000])
def test_a_quotation_mark_out_of_place_swallows_no_student(name: str) -> None:
    read = rosters.read(f'1001;{name}\n1002;"Nowak; Jan";B\n')
    rows, unread = read.rows, read.unread
    assert (rows[-1].login, rows[-1].name, rows[-1].group) == ("1002", "Nowak; Jan", "B")
    assert [one.line for one in unread] == [1] * (2 - len(rows)) and len(rows) == 1 + (name == 'Anna "')


def test_a_name_in_two_columns_is_not_taken_for_a_group() -> None:
    read = rosters.read("1001;Nowak;Anna;B\n1002;Jan Nowak;B;\n1003;Ewa Lis;B;;")
    assert [row.login for row in read.rows] == ["1002", "1003"]
    assert [(one.line, one.code) for one in read.unread] == [(1, "many_columns")]


USOS = """Wydział Mechaniczny; rok akademicki 2026/2027
Przedmiot: TMM-2

Lp.;Nr albumu;Nazwisko;Imię;Drugie imię;E-mail;Kierunek;Grupa dziekańska
1;3001;Żółć;Świętosława;;s.zolc@example.edu;MiBM;12A
;;;;;;;
2;3002;Nowak;Jan;Maria;;MiBM;12B
3;3001;Inny;Ktoś;;;MiBM;12B
4;3003;Krótki
5;3004;Lis;Ewa;;;MiBM;12A;nadmiar
"""
DEKANAT = "№ п/п,Группа,ФИО,Номер зачётной книжки,Подгруппа\n1,МТ-31,Ёлкина Юлия Олеговна,18-204,2\n"
REGISTRY = "First name\tSurname\tStudent ID (6 digits)\tTutorial group\tGroup\nAnn\tO'Neil, Jr\t300412\t\tMon\n"


def meant(read: rosters.Reading) -> dict[str, list[int]]:
    found: dict[str, list[int]] = {}
    for one in read.columns:
        found.setdefault(one.meaning, []).append(one.number)
    return found


def test_an_export_is_read_by_its_headings_and_what_is_left_out_is_told() -> None:
    read = rosters.read("\ufeff" + USOS)
    assert [(row.login, row.name, row.group) for row in read.rows] == [
        ("3001", "Żółć Świętosława", "12A"),
        ("3002", "Nowak Jan Maria", "12B"),
        ("3003", "Krótki", ""),
    ]
    assert read.unread == (rosters.Unread(8, "twice_in_roster", 5), rosters.Unread(10, "surplus_cells"))
    assert meant(read) == {"unused": [1, 6, 7], "login": [2], "surname": [3], "name": [4, 5], "group": [8]}
    assert read.above == (1, 2)


@pytest.mark.parametrize(
    ("text", "row", "columns"),
    [
        (
            DEKANAT,
            ("18-204", "Ёлкина Юлия Олеговна", "МТ-31"),
            {"unused": [1, 5], "group": [2], "name": [3], "login": [4]},
        ),
        (
            REGISTRY,
            ("300412", "O'Neil, Jr Ann", "Mon"),
            {"name": [1], "surname": [2], "login": [3], "unused": [4], "group": [5]},
        ),
        (
            "Имя;Отчество;Фамилия;Номер\nЮлия;Олеговна;Ёлкина;18-204\n",
            ("18-204", "Ёлкина Юлия Олеговна", ""),
            {"name": [1, 2], "surname": [3], "login": [4]},
        ),
        ("e-mail;name\na@b.pl;Ann\n", ("a@b.pl", "Ann", ""), {"login": [1], "name": [2]}),
        ("3001;Ann;B\n", ("3001", "Ann", "B"), {"login": [1], "name": [2], "group": [3]}),
        ("3001;Ann\n", ("3001", "Ann", ""), {"login": [1], "name": [2]}),
        ("Indeks;Osoba zapisana\n3001;Ann\n", ("3001", "Ann", ""), {"login": [1], "name": [2]}),
    ],
)
def test_columns_stand_in_any_order(text: str, row: tuple[str, str, str], columns: dict[str, list[int]]) -> None:
    read = rosters.read(text)
    assert [(one.login, one.name, one.group) for one in read.rows] == [row] and read.unread == ()
    assert meant(read) == columns


def test_headings_tell_the_code_page_whatever_the_language_of_the_course() -> None:
    for language in ("pl", "en", "ru"):
        assert rosters.decoded(USOS.encode("cp1250"), language) == USOS
        russian = DEKANAT.replace("№ п/п", "№")
        assert rosters.decoded(russian.encode("cp1251"), language) == russian


def test_the_preview_says_what_is_read_from_which_column(school: School) -> None:
    lecturer = school.browser("lecturer")
    _, page = send(lecturer, school, USOS.encode("cp1250"))
    page = " ".join(unescape(re.sub(r"<[^>]+>", " ", page)).split())
    assert "Index number or e-mail 2 (Nr albumu) " in page and "Name 4 (Imię), 5 (Drugie imię) " in page
    assert "Surname (comes first in the name) 3 (Nazwisko) " in page
    assert "Not used 1 (Lp.), 6 (E-mail), 7 (Kierunek)" in page
    assert "Lines left out above the headings: 1, 2." in page
    told = lecturer.post(f"/api/v1/courses/{school.course}/roster", json={"csv": USOS}).json()
    assert told["columns"][1] == {"number": 2, "heading": "Nr albumu", "meaning": "login"} and told["above"] == [1, 2]


def test_a_file_shows_what_will_change_and_changes_nothing(school: School) -> None:
    lecturer = school.browser("lecturer")
    status, page = send(lecturer, school, (POLISH + "student;Ktoś Inny;\r\n").encode("cp1250"))
    assert status == 200 and "Świętosława Żółć" in page and "Apply changes: 1" in page
    assert "on this server: Student" not in page  # what does not change is only counted
    members = lecturer.get(f"/api/v1/courses/{school.course}/members").json()
    assert "3001" not in {member["login"] for member in members}
    _, page = send(lecturer, school, "outsider;Ktoś Inny;\r\n".encode())
    assert "on this server: Outsider" in page


def test_a_thousand_lines_are_shown_and_applied(school: School) -> None:
    lecturer = school.browser("lecturer")
    text = "".join(f"4{number:05};Żółcińska-Świętosławska Świętosława {number};Środa rano\n" for number in range(1000))
    status, page = send(lecturer, school, text.encode("utf-16"))
    assert status == 200 and "Apply changes: 1000" in page
    form = {"roster": text, "apply": "yes"}
    assert lecturer.post(f"/courses/{school.course}/roster", data=form).status_code == 303
    assert len(lecturer.get(f"/api/v1/courses/{school.course}/members").json()) == 1005
    status, page = send(lecturer, school, (text + "5;x\n").encode())
    assert status == 422 and "more than 1000 lines" in page


def test_a_file_that_is_too_large_or_missing_is_refused(school: School) -> None:
    lecturer = school.browser("lecturer")
    status, page = send(lecturer, school, b"1" * LARGEST_ROSTER)
    assert status == 413 and "512" in page
    path = f"/courses/{school.course}/roster"
    for files in ({"other": ("a.csv", b"1;A", "text/csv")}, {"file": (None, "1;A")}):
        assert lecturer.post(path, files=files).json()["error"]["code"] == "empty_roster"
    two = [("file", ("a.csv", b"1;A", "text/csv")), ("file", ("b.csv", b"2;B", "text/csv"))]
    assert lecturer.post(path, files=two).json()["error"]["code"] == "not_a_form"
    broken = {"content-type": "multipart/form-data; boundary=x"}
    assert lecturer.post(path, content=b"--y\r\n\r\n", headers=broken).status_code == 422
    assert school.browser("assistant").post(path, files=two).status_code == 403


@pytest.mark.parametrize(
    ("language", "passed", "refused"),
    [
        ("pl", "Pominięte wiersze, które tylko powtarzają wcześniejszy: 3 (jak 1), 5 (jak 2).", "stoi już w wierszu 2"),
        ("en", "because they only repeat an earlier one: 3 (same as 1), 5 (same as 2).", "stands in line 2 already"),
        ("ru", "лишь повторяют более раннюю: 3 (как 1), 5 (как 2).", "уже есть в строке 2"),
    ],
)
def test_a_line_that_repeats_another_is_passed_over_or_told_by_the_line_it_repeats(
    school: School, language: str, passed: str, refused: str
) -> None:
    lecturer, path = school.browser("lecturer"), f"courses/{school.course}/roster"
    again = "3001;Ann;A\n3002;Bob;B\n3001 ; Ann;A\n\n3002;Bob;B\n"
    page = unescape(lecturer.post(f"/{path}?lang={language}", data={"roster": again}).text)
    assert passed in page and 'role="alert"' not in page
    page = unescape(lecturer.post(f"/{path}?lang={language}", data={"roster": again + "3002;Bob;A\n"}).text)
    assert passed in page and refused in page
    told = lecturer.post(f"/api/v1/{path}", json={"csv": again, "apply": True}).json()
    assert told["applied"] and told["unread"] == [] and [one["login"] for one in told["changes"]] == ["3001", "3002"]
    assert told["repeated"] == [{"line": 3, "repeats": 1}, {"line": 5, "repeats": 2}]
    told = lecturer.post(f"/api/v1/{path}", json={"csv": "3001;Ann\n3001;Eve\n", "apply": False}).json()
    assert told["unread"] == [{"line": 2, "code": "twice_in_roster", "repeats": 1}]
