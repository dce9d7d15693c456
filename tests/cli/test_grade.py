from __future__ import annotations

import json
import os
from pathlib import Path
from xml.etree import ElementTree

import pytest

from cli.problems import LANGUAGES
from exercises import catalogue, grading
from exercises.exercise import Submission
from exercises.grading import reference
from exercises.variants import deal
from tests.cli.calling import item, process, run, written

SLIP = "1000 km"


def right(seed: int = 1) -> dict[str, object]:
    return item("slider_crank", seed)


def task(seed: int, exercise: str = "slider_crank") -> dict[str, object]:
    return {"exercise": exercise, "version": catalogue.load(exercise).exercise.version, "seed": seed}


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_the_reference_of_each_exercise_passes(
    exercise: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, {"items": [item(exercise, seed) for seed in range(3)]})
    code, out, err = run(capsys, "grade", file, "--pass", "1")
    assert (code, err) == (0, "") and out.startswith(f"{file}: 100 %, passed")


@pytest.mark.parametrize(("mark", "code"), [("0", 0), ("0.5", 0), ("0.51", 1), ("1", 1)])
def test_the_pass_mark_decides(mark: str, code: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    empty = {**right(), "answers": {}}
    file = written(tmp_path, {"items": [right(), empty]})
    assert run(capsys, "grade", file, "--pass", mark)[0] == code


def test_an_answer_that_cannot_be_read_is_no_unusable_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    texts = ("2 )(", "((" * 900, "9" * 3000, "5 qq", "__import__('os')", "\u202e", "1e999999999")
    file = written(tmp_path, {"items": [item("slider_crank", 1, l3=text) for text in texts]})
    code, out, _ = run(capsys, "grade", file, "--format", "json")
    assert code == 0
    found = [entry["verdicts"]["l3"]["outcome"] for entry in json.loads(out)["files"][0]["items"]]
    assert found == ["unreadable"] * len(texts)


def test_json_holds_scores_verdicts_and_messages(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, {"items": [right(), item("slider_crank", 2, v3=SLIP)]})
    code, out, _ = run(capsys, "grade", file, "--format", "json", "--lang", "pl")
    report = json.loads(out)
    assert code == 0 and report["passed"] is True and report["pass"] == 0.5
    (entry,) = report["files"]
    first, second = entry["items"]
    assert entry["score"] == 0.9 and first["score"] == 1 and second["score"] == 0.8
    assert second["verdicts"]["v3"]["outcome"] == "wrong" and second["verdicts"]["v3"]["score"] == 0
    assert second["verdicts"]["v3"]["message"].startswith("Jeszcze nie")
    assert second["verdicts"]["l3"] == {"outcome": "right", "code": "right", "score": 1.0, "message": "Dobrze."}


def slip() -> dict[str, object]:
    """The sign lost in the first projection, everything after it computed from that."""
    from exercises.solving import Solved
    from exercises.variants import predictions

    variant = deal("slider_crank", 5)
    solved = Solved(catalogue.load("slider_crank").exercise, variant)
    expected = predictions(solved)["lost_minus"]
    answers = {name: grader.show(expected[name]) for name, grader in solved.answers.items()}
    return {"exercise": "slider_crank", "seed": 5, "answers": answers}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_known_slip_brings_its_hint(lang: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, {"items": [slip()]})
    hint = {"pl": "Sprawdź znak", "en": "Check the sign", "ru": "Проверьте знак"}[lang]
    for form in ("text", "json", "junit", "gradescope", "github"):
        assert hint in run(capsys, "grade", file, "--lang", lang, "--format", form)[1]


def test_tasks_name_what_is_graded(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tasks = written(tmp_path, {"items": [task(1), task(2), task(3)]}, "tasks.json")
    file = written(tmp_path, {"items": [right(9), right(3), right(1)]})
    code, out, _ = run(capsys, "grade", file, "--tasks", tasks, "--format", "json")
    report = json.loads(out)["files"][0]
    assert code == 0 and report["score"] == pytest.approx(2 / 3, abs=1e-6)
    assert [(entry["seed"], entry["score"]) for entry in report["items"]] == [(1, 1), (2, 0), (3, 1)]
    assert report["items"][1]["note"] == "The file answers another variant of this exercise."


def test_a_missing_item_scores_0(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tasks = written(tmp_path, {"items": [task(1), task(2)]}, "tasks.json")
    file = written(tmp_path, {"items": [right(1)]})
    code, out, _ = run(capsys, "grade", file, "--tasks", tasks, "--pass", "0.51")
    assert code == 1 and "The file does not answer this task." in out and out.startswith(f"{file}: 50 %, below")


def test_one_good_item_is_not_counted_for_two_tasks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tasks = written(tmp_path, {"items": [task(1), task(1)]}, "tasks.json")
    file = written(tmp_path, {"items": [right(1)]})
    assert json.loads(run(capsys, "grade", file, "--tasks", tasks, "--format", "json")[1])["files"][0]["score"] == 0.5


def test_unusable_tasks_grade_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "grade", written(tmp_path, {"items": [right()]}), "--tasks", str(tmp_path / "none"))
    assert (code, out) == (2, "") and "there is no such file" in err


def test_one_unusable_file_does_not_stop_the_others(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good, bad = written(tmp_path, {"items": [right()]}), written(tmp_path, "{", "bad.json")
    code, out, err = run(capsys, "grade", bad, good, "--format", "json")
    first, second = json.loads(out)["files"]
    assert code == 2 and bad in err
    assert (first["passed"], first["error"]["code"], second["passed"]) == (False, "not_json", True)
    assert "could not be used" in run(capsys, "grade", bad, good)[1]


def test_junit_is_well_formed_whatever_is_answered(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    hostile = "]]><x a='b\">& \x00\x1b\ufffe\uffff"
    names = [written(tmp_path, {"items": [item("slider_crank", 1, l3=hostile)]}, 'a <b> & "c" \'\x07.json')]
    names.append(written(tmp_path, {"items": [{**right(), "exercise": hostile}]}, "bad.json"))
    code, out, _ = run(capsys, "grade", *names, "--format", "junit")
    first, second = ElementTree.fromstring(out)
    assert code == 2
    assert first.attrib == {"name": names[0].replace("\x07", "\ufffd"), "tests": "5", "failures": "1", "errors": "0"}
    assert second.attrib == {"name": names[1], "tests": "1", "failures": "0", "errors": "1"}
    failures = [case for case in first if len(case)]
    assert [case.attrib["name"] for case in failures] == ["slider_crank 1 l3"]
    assert failures[0][0].attrib["type"] == "unreadable"


def test_junit_counts_missing_tasks_as_failures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tasks = written(tmp_path, {"items": [task(1), task(2)]}, "tasks.json")
    out = run(capsys, "grade", written(tmp_path, {"items": [right()]}), "--tasks", tasks, "--format", "junit")[1]
    (suite,) = ElementTree.fromstring(out)
    assert (suite.attrib["tests"], suite.attrib["failures"]) == ("6", "1")


def test_gradescope_gets_a_point_for_each_task_and_why(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tasks = written(tmp_path, {"items": [task(1), task(2), task(3)]}, "tasks.json")
    file = written(tmp_path, {"items": [right(1), item("slider_crank", 2, l3="1 kN")]})
    code, out, _ = run(capsys, "grade", file, "--tasks", tasks, "--format", "gradescope", "--lang", "pl")
    results = json.loads(out)
    assert code == 0 and results["score"] == 1.8 and "output" not in results
    assert [(test["score"], test["max_score"], test["status"]) for test in results["tests"]] == [
        (1, 1, "passed"), (0.8, 1, "failed"), (0, 1, "failed"),
    ]  # fmt: skip
    assert results["tests"][0]["name"] == "slider_crank, ziarno 1"
    assert "l3: Jeszcze nie: ta jednostka mierzy inną wielkość." in results["tests"][1]["output"]


def test_gradescope_tells_files_apart_and_says_why_one_was_not_used(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    names = [written(tmp_path, {"items": [right(1)]}, "a.json"), written(tmp_path, {"items": 1}, "b.json")]
    code, out, _ = run(capsys, "grade", *names, "--format", "gradescope")
    results = json.loads(out)
    assert code == 2 and results["score"] == 1 and results["output"].startswith(f"{names[1]}: items: ")
    assert [test["name"] for test in results["tests"]] == [f"{names[0]}: slider_crank, seed 1"]


def test_github_annotates_the_tasks_that_are_not_right_and_the_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    odd = "100%, a:b\n::error::forged.json"
    names = [written(tmp_path, {"items": [right(1), item("slider_crank", 2, l3="::error::x")]}, odd)]
    names.append(written(tmp_path, {"items": 1}, "b.json"))
    code, out, _ = run(capsys, "grade", *names, "--format", "github")
    place = f"file={tmp_path}/100%25%2C a%3Ab\ufffd%3A%3Aerror%3A%3Aforged.json,title="
    warning, passed, unused = out.splitlines()
    assert code == 2
    assert warning.startswith(f"::warning {place}slider_crank%2C seed 2%3A 80 %25::alpha2: ") and "%0A" in warning
    assert passed == f"::notice {place}passed::90 %25"
    assert unused.startswith(f"::error file={names[1]},title=could not be used::{names[1]}: items: ")


@pytest.mark.parametrize("form", ["text", "github"])
def test_no_line_of_a_marking_begins_as_the_name_of_a_file_would_have_it(
    form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = written(tmp_path, {"items": [right(1)]}, "a\n::stop-commands::x.json")
    out = run(capsys, "grade", name, "--format", form)[1]
    assert out and not any(line.startswith("::stop") for line in out.splitlines())


def test_a_file_name_that_is_no_text_can_be_graded(tmp_path: Path) -> None:
    name = os.fsdecode(b"\xff\xfe.json")
    (tmp_path / name).write_text(json.dumps({"items": [right()]}))
    done = process("grade", str(tmp_path / name), "--format", "junit")
    assert done.returncode == 0 and ElementTree.fromstring(done.stdout.decode("utf-8"))


def test_two_runs_give_the_same_bytes(tmp_path: Path) -> None:
    file = written(tmp_path, {"items": [right(), item("slider_crank", 2, omega2_formula="l1*omega1")]})
    hashes = ({**os.environ, "PYTHONHASHSEED": seed, "TZ": zone} for seed, zone in (("1", "UTC"), ("2", "Asia/Tokyo")))
    one, other = (process("grade", file, "--format", "json", env=environment) for environment in hashes)
    assert one.stdout == other.stdout and one.returncode == other.returncode == 0


def test_the_secret_of_the_environment_changes_no_verdict(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file = written(tmp_path, {"items": [right(), item("slider_crank", 2, omega2_formula="l1*omega1")]})
    public = run(capsys, "grade", file)
    monkeypatch.setenv("GRUBLER_SECRET", "another one")
    assert run(capsys, "grade", file) == public


def test_a_fault_of_ours_spoils_no_other_item(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    honest = grading.grade

    def faulty(submission: Submission, secret: bytes) -> object:
        if submission.variant.seed == 2:
            raise ZeroDivisionError("a fault put in by the test")
        return honest(submission, secret)

    monkeypatch.setattr(grading, "grade", faulty)
    file = written(tmp_path, {"items": [right(1), right(2), right(3)]})
    code, out, err = run(capsys, "grade", file, "--format", "json")
    entries = json.loads(out)["files"][0]["items"]
    assert code == 3 and "a fault put in by the test" in err
    assert [entry["score"] for entry in entries] == [1, 0, 1]
    assert entries[1]["provisional"] and entries[1]["verdicts"]["l3"]["outcome"] == "fault"
    assert "provisional" in run(capsys, "grade", file)[1]
    suite = ElementTree.fromstring(run(capsys, "grade", file, "--format", "junit")[1])[0]
    assert suite.attrib["errors"] == str(len(reference(deal("slider_crank", 2))))


def test_grading_imports_nothing_heavy(tmp_path: Path) -> None:
    from tests.cli.test_main import imported

    file = written(tmp_path, {"items": [item(exercise, 1) for exercise in catalogue.ids()]})
    assert imported("grade", file) == set()
