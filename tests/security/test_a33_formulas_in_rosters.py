"""A33: what a spreadsheet would compute or split comes in by no roster and goes out in no table."""

from __future__ import annotations

import csv
import io

import pytest

from server.courses import rosters
from server.people import access, identity
from server.web.errors import Refused
from tests.server.school import School

FORMULAS = ('=HYPERLINK("//evil.example")', "+1+1", "-1+1", "@SUM(A1)", "\t=1+1", "\r=1+1", "=cmd|'/c calc'!A1")


@pytest.mark.parametrize("formula", FORMULAS)
def test_a_roster_with_a_formula_in_any_column_is_not_taken(formula: str) -> None:
    cells = io.StringIO()
    csv.writer(cells, delimiter=";").writerows([[formula, "Ann", "A"], ["1", formula, "A"], ["2", "Ben", formula]])
    read = rosters.read(cells.getvalue())
    rows, unread = read.rows, read.unread
    assert not [
        row for row in rows if any(cell.lstrip()[:1] in "=+-@" for cell in (row.login, row.name, row.group) if cell)
    ]
    assert len(unread) >= 3


@pytest.mark.parametrize("formula", FORMULAS)
def test_nobody_signs_up_under_a_formula(formula: str) -> None:
    for read in (identity.login_of, identity.name_of):
        with pytest.raises(Refused):
            read(formula)


def test_a_name_with_separators_and_quotes_stays_one_cell(school: School) -> None:
    lecturer, place = school.browser("lecturer"), f"/api/v1/courses/{school.course}"
    awkward = 'Ewa "Eve"; O\'Neil, jr'
    held = io.StringIO()
    csv.writer(held).writerow(["4001", awkward, "A,B;C"])
    assert lecturer.post(f"{place}/roster", json={"csv": held.getvalue(), "apply": True}).json()["applied"]
    for language, separator in (("en", ","), ("pl", ";")):
        table = lecturer.post(f"/courses/{school.course}/links?lang={language}").content.decode("utf-8-sig")
        rows = list(csv.reader(io.StringIO(table), delimiter=separator))
        assert rows[1][:3] == ["4001", awkward, "A,B;C"] and len(rows[1]) == 4
        assert not [cell for row in rows for cell in row if cell[:1] in ("=", "+", "-", "@", "\t", "\r")]


def test_a_name_in_full_width_signs_is_no_formula_in_the_table_of_links() -> None:
    wide = access.LinkFor(link="https://lab/links/x", person="P", login="＝1+1", name="＝HYPERLINK(1)", group="＋1")
    _, row = csv.reader(io.StringIO(access.table("pl", [wide]).decode("utf-8-sig")), delimiter=";")
    assert row == ["'＝1+1", "'＝HYPERLINK(1)", "'＋1", "https://lab/links/x"]
