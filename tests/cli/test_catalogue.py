from __future__ import annotations

import json

import pytest

from exercises import catalogue
from exercises.grading import reference
from exercises.variants import deal
from tests.cli.calling import run


def test_json_lists_each_exercise_with_what_it_asks(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "catalogue", "--json")
    listed = {entry["id"]: entry for entry in json.loads(out)}
    assert code == 0 and tuple(listed) == catalogue.ids()
    for name, entry in listed.items():
        assert set(entry) == {"id", "chapter", "systems", "answers", "languages"}
        assert entry["chapter"] == catalogue.chapter_of(name) and entry["systems"]
        assert entry["answers"] == list(reference(deal(name, 0)))
        assert entry["languages"] == ["pl", "en", "ru"]


def test_people_read_a_line_for_each_exercise(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "catalogue", "--lang", "pl")
    lines = out.splitlines()
    assert code == 0 and len(lines) == len(catalogue.ids())
    assert any("slider_crank" in line and "Mechanizm korbowo-tłokowy" in line for line in lines)
