"""Every unusable file is refused with exit code 2 and a line that names file, item and field."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cli.problems import LANGUAGES, Unusable
from cli.reading import LARGEST, LONGEST, read_answers, read_tasks
from exercises.variants import MAX_SEED
from tests.cli.calling import run, written
from tests.depth import amount

GOOD: dict[str, Any] = {"exercise": "slider_crank", "seed": 1, "answers": {"l3": "1 m"}}


def items(**changed: Any) -> str:
    """An answer file of two items, the second one changed; None takes a field away."""
    second = {name: value for name, value in {**GOOD, **changed}.items() if value is not None}
    return json.dumps({"items": [GOOD, second]})


REFUSED = {
    "not JSON": ('{"items": [', "line 1, column 12"),
    "two documents": ("{} {}", "line 1, column 4"),
    "nothing at all": ("", "line 1, column 1"),
    "a list": ("[]", "must be an object"),
    "a number": ("3", "must be an object"),
    "no items": ("{}", "items: the field is missing"),
    "items of a wrong type": ('{"items": {}}', "items: this must be a list"),
    "an empty list": ('{"items": []}', "items: there are no items"),
    "a foreign field at the top": ('{"items": [], "score": 1}', "score: there is no such field"),
    "an item that is a text": ('{"items": ["x"]}', "items[0]: this must be an object"),
    "a foreign field": (items(score=1), "items[1].score: there is no such field"),
    "no exercise": (items(exercise=None), "items[1].exercise: the field is missing"),
    "an unknown exercise": (items(exercise="no_such"), "items[1].exercise: there is no exercise no_such"),
    "a path as exercise": (items(exercise="../../x"), "items[1].exercise: there is no exercise"),
    "an exercise that is null": ('{"items": [{"exercise": null, "seed": 1, "answers": {}}]}', "items[0].exercise"),
    "a negative seed": (items(seed=-1), "items[1].seed: a seed is a whole number"),
    "a seed out of range": (items(seed=MAX_SEED + 1), "items[1].seed: a seed is a whole number"),
    "a seed of many digits": (items(seed=7).replace("7", "7" * 5000), "items[1].seed: a seed is a whole number"),
    "a seed that is true": (items(seed=True), "items[1].seed: this must be a whole number"),
    "a seed with a point": (items(seed=1.0), "items[1].seed: this must be a whole number"),
    "a seed in quotes": (items(seed="1"), "items[1].seed: this must be a whole number"),
    "a seed that is NaN": (items(seed=float("nan")), "items[1].seed: this must be a whole number"),
    "answers in a list": (items(answers=[]), "items[1].answers: this must be an object"),
    "an answer that is a number": (items(answers={"l3": 1}), "items[1].answers.l3: this must be a text"),
    "an answer that is NaN": (items(answers={"l3": float("nan")}), "items[1].answers.l3: this must be a text"),
    "an answer that is infinite": (items(answers={"l3": float("inf")}), "items[1].answers.l3: this must be a text"),
    "a list with a number": (items(answers={"l3": ["1", 2]}), "items[1].answers.l3: this must be a text"),
    "a text over the limit": (items(answers={"l3": "1" * (LONGEST + 1)}), "items[1].answers.l3: the text is longer"),
    "half a pair": (items(answers={"l3": "\ud800"}), "items[1].answers.l3: the text holds half"),
    "a name twice in an item": (
        '{"items": [{"exercise": "slider_crank", "seed": 1, "seed": 2, "answers": {}}]}',
        "items[0]: the name seed stands twice",
    ),
    "an answer twice": (
        '{"items": [{"exercise": "slider_crank", "seed": 1, "answers": {"l3": "1", "l3": "2"}}]}',
        "items[0].answers: the name l3 stands twice",
    ),
    "items twice": ('{"items": [], "items": []}', "the name items stands twice"),
    "an answer that is not asked for": (items(answers={"l4": "1"}), "items[1].answers.l4: the exercise does not ask"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_unusable_answers_are_refused_with_their_place(
    case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, place = REFUSED[case]
    file = written(tmp_path, text)
    code, _, err = run(capsys, "grade", file)
    assert code == 2
    assert err.startswith(f"grubler: {file}: ") and place in err and len(err.splitlines()) == 1


def test_each_refusal_is_worded_in_each_language(tmp_path: Path) -> None:
    for text, _ in list(REFUSED.values())[:-1]:
        with pytest.raises(Unusable) as refused:
            read_answers(written(tmp_path, text))
        sentences = {refused.value.worded(lang).replace(str(tmp_path), "") for lang in LANGUAGES}
        assert len(sentences) == len(LANGUAGES)


@pytest.mark.parametrize(
    ("raw", "said"),
    [
        (b'{"items": "\xff"}', "this is not UTF-8 text (byte 11)"),
        (b" " * (LARGEST + 1), f"larger than {LARGEST} bytes"),
        (b"[" * 200_000, "nested too deeply"),
        (b'{"items":' * 90_000, "nested too deeply"),
    ],
)
def test_bytes_that_cannot_be_read_are_refused(
    raw: bytes, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "raw.json").write_bytes(raw)
    code, _, err = run(capsys, "grade", str(tmp_path / "raw.json"))
    assert code == 2 and said in err


@pytest.mark.parametrize(
    ("name", "lang", "said"),
    [
        ("absent.json", "en", "there is no such file"),
        ("absent.json", "pl", "nie ma takiego pliku"),
        (".", "ru", "это папка, а не файл"),
        ("a\0b", "en", "the file cannot be read"),
    ],
)
def test_a_file_that_cannot_be_opened_is_refused(
    name: str, lang: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _, err = run(capsys, "grade", f"{tmp_path}/{name}", "--lang", lang)
    assert code == 2 and said in err


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    (one,) = read_answers(written(tmp_path, "\ufeff" + json.dumps({"items": [GOOD]})))
    assert (one.exercise, one.seed, one.answers) == ("slider_crank", 1, {"l3": "1 m"})


def test_a_list_of_texts_is_read_as_lines(tmp_path: Path) -> None:
    document = {"items": [{**GOOD, "answers": {"l3": ["1", "m"]}}]}
    assert read_answers(written(tmp_path, document))[0].answers == {"l3": "1\nm"}


@pytest.mark.parametrize(
    ("task", "said"),
    [
        ({"exercise": "slider_crank", "seed": 1}, "items[0].version: the field is missing"),
        ({"exercise": "slider_crank", "seed": 1, "version": 999}, "items[0].version: the task has version 999"),
        ({"exercise": "slider_crank", "seed": 1, "version": "1"}, "items[0].version: this must be a whole number"),
        ({"exercise": "slider_crank", "seed": -3, "version": 1}, "items[0].seed: a seed is a whole number"),
        ({"exercise": "none", "seed": 1, "version": 1}, "items[0].exercise: there is no exercise"),
        ({"exercise": "slider_crank", "seed": 1, "version": 1, "answers": {}}, "items[0].answers: there is no such"),
    ],
)
def test_unusable_tasks_are_refused_with_their_place(task: dict[str, Any], said: str, tmp_path: Path) -> None:
    with pytest.raises(Unusable) as refused:
        read_tasks(written(tmp_path, {"items": [task]}))
    assert said in refused.value.worded("en")


def test_a_refusal_prints_foreign_text_harmlessly(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    hostile = "\x1b[2J\n\u202e" + "x" * 10_000
    code, _, err = run(capsys, "grade", written(tmp_path, items(exercise=hostile)))
    assert code == 2 and len(err.splitlines()) == 1 and len(err) < 1000
    assert err.rstrip("\n").isprintable()


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["items", "exercise", "seed", "answers", "l3"]), inner, max_size=4)
    ),
    max_leaves=12,
)


@settings(max_examples=amount(50, 150), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(document=json_values)
def test_whatever_json_is_read_or_refused(document: Any, tmp_path: Path) -> None:
    try:
        read = read_answers(written(tmp_path, {"items": [document]}))
    except Unusable as refused:
        assert refused.place or refused.key == "wants_object"
    else:
        assert read[0].exercise == document["exercise"]
