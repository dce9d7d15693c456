"""The languages are listed in one place, and every room has the words of each."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import pytest

from cli import problems
from graders.words import LANGUAGES, NAMES, POINT, UNITS, comma, marked
from reports.docx import TAGS
from server.courses.api import NewCourse
from server.web import language

ROOT = Path(__file__).parents[2]
WORDED = sorted(
    path.parent for room in ("cli", "graders", "reports", "server") for path in (ROOT / room).rglob("en.toml")
)


def test_every_room_speaks_the_same_languages() -> None:
    assert len(WORDED) == 4
    assert {folder: sorted(file.stem for file in folder.glob("*.toml")) for folder in WORDED} == {
        folder: sorted(LANGUAGES) for folder in WORDED
    }


def test_what_cannot_read_the_list_agrees_with_it() -> None:
    assert problems.LANGUAGES == language.LANGUAGES == LANGUAGES == tuple(NAMES)
    assert get_args(NewCourse.model_fields["language"].annotation) == LANGUAGES
    assert TAGS.keys() == UNITS.keys() == NAMES.keys()
    assert NAMES.keys() > POINT


@pytest.mark.parametrize(("spoken", "mark"), [("pl", ","), ("en", "."), ("ru", ",")])
def test_a_number_has_the_decimal_mark_of_its_language(spoken: str, mark: str) -> None:
    assert marked("-12.5", spoken) == f"-12{mark}5"
    assert comma(spoken) is (mark == ",")
