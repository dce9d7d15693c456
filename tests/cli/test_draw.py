from __future__ import annotations

import json
from pathlib import Path

import pytest

from exercises import catalogue
from exercises.variants import MAX_SEED, deal, restore
from tests.cli.calling import run, written


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_the_printed_reference_is_graded_right(
    exercise: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    drawn = json.loads(run(capsys, "draw", exercise, "--seed", "11", "--json", "--with-reference")[1])
    assert set(drawn["reference"]) == set(drawn["answers"])
    document = {"items": [{"exercise": exercise, "seed": drawn["seed"], "answers": drawn["reference"]}]}
    assert run(capsys, "grade", written(tmp_path, document), "--pass", "1")[0] == 0


@pytest.mark.parametrize("exercise", catalogue.ids())
@pytest.mark.parametrize("lang", ["pl", "en", "ru"])
def test_a_variant_is_shown_whole_in_each_language(
    exercise: str, lang: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, _ = run(capsys, "draw", exercise, "--seed", "2", "--lang", lang)
    drawn = json.loads(run(capsys, "draw", exercise, "--seed", "2", "--lang", lang, "--json")[1])
    assert code == 0 and "$" not in out and "{{" not in out
    assert drawn["title"] in out and drawn["statement"] in out and drawn["language"] == lang
    for name, field in drawn["answers"].items():
        assert f"{name}: {field['prompt']}" in out and field["tolerance"] in out


def test_an_option_is_shown_with_its_words(capsys: pytest.CaptureFixture[str]) -> None:
    drawn = run(capsys, "draw", "stepped_shaft", "--seed", "7", "--lang", "pl")[1]
    assert "strength (warunek wytrzymałości), stiffness (warunek sztywności)" in drawn


def test_without_being_asked_no_reference_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    with_it = run(capsys, "draw", "slider_crank", "--seed", "3", "--with-reference")[1]
    without = run(capsys, "draw", "slider_crank", "--seed", "3")[1]
    assert "reference: -l1*omega1*cos(alpha1)" in with_it and "reference" not in without
    assert "reference" not in json.loads(run(capsys, "draw", "slider_crank", "--seed", "3", "--json")[1])


def test_the_printed_variant_is_the_stored_one(capsys: pytest.CaptureFixture[str]) -> None:
    drawn = json.loads(run(capsys, "draw", "slider_crank", "--seed", str(MAX_SEED), "--json")[1])
    assert restore(drawn) == deal("slider_crank", MAX_SEED)


@pytest.mark.parametrize("seed", ["-1", str(MAX_SEED + 1), "1.0", "1e3", "x", "", "٣", "9" * 5000])
def test_a_seed_out_of_range_is_unusable(seed: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "draw", "slider_crank", f"--seed={seed}")
    assert (code, out) == (2, "") and err == f"grubler: --seed: a seed is a whole number from 0 to {MAX_SEED}\n"


def test_an_unknown_exercise_is_unusable(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "draw", "no_such", "--seed", "1", "--lang", "ru")
    assert (code, out) == (2, "") and "нет задачи no_such" in err
