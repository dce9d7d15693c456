"""The contract each exercise is held to; a new folder is tested without touching this file."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from functools import cache
from types import ModuleType
from typing import Any, Never

import pytest

from exercises import catalogue, solving, variants
from exercises.exercise import Answers, Line, Submission, Variant
from exercises.grading import grade, preview, reference
from exercises.presenting import hint, hint_text, presented, printed_givens, solution
from exercises.solving import Solved
from exercises.verifying import outside, verify
from exercises.words import named, plain
from graders import Code, Outcome, Verdict
from graders.language import doubles
from graders.words import LANGUAGES
from tests.depth import amount

EVERY = pytest.mark.parametrize("exercise_id", catalogue.ids())
SEEDS = range(amount(2, 5))
BUILT_IN = ("float", "max", "min", "abs", "len", "sum", "zip")
STEPS_ARE_SOLVED_BY = ((doubles, "run"), *((solving, name) for name in ("run", "evaluate", "solve")))
GATE = amount(2, 6)  # seeds here; a thousand are checked by `grubler verify` before an exercise is published


@cache
def dealt(exercise_id: str, seed: int) -> Variant:
    """Deal a variant once for all tests."""
    return variants.deal(exercise_id, seed)


def solved_answers(variant: Variant) -> Answers:
    return catalogue.load(variant.exercise).exercise.answers_of(variant.givens)


@EVERY
def test_the_publish_gate_finds_nothing(exercise_id: str) -> None:
    assert verify(exercise_id, range(GATE)).failures == ()


@EVERY
def test_the_same_seed_gives_the_same_variant(exercise_id: str) -> None:
    assert [dealt(exercise_id, seed) for seed in SEEDS] == [variants.deal(exercise_id, seed) for seed in SEEDS]


@EVERY
def test_drawn_numbers_lie_in_the_domains_they_declare(exercise_id: str) -> None:
    for seed in range(amount(40, 200)):
        assert not [*outside(dealt(exercise_id, seed).givens)], seed


@EVERY
def test_a_stored_variant_comes_back_as_it_was(exercise_id: str) -> None:
    for seed in SEEDS:
        variant = dealt(exercise_id, seed)
        assert variants.restore(variants.dump(variant)) == variant


@EVERY
def test_the_shown_reference_is_graded_right(exercise_id: str) -> None:
    for seed in SEEDS:
        variant = dealt(exercise_id, seed)
        grade_ = grade(Submission(variant, reference(variant)))
        assert grade_.score == 1
        texts = {name for name, judge in solved_answers(variant).items() if judge.kind == "text"}
        assert {verdict.code for name, verdict in grade_.verdicts.items() if name not in texts} == {Code.RIGHT}
        assert {grade_.verdicts[name].code for name in texts} <= {Code.KEPT}
        assert grade_.counted and grade_.mistake is None


@EVERY
def test_an_empty_submission_is_unreadable_and_not_counted(exercise_id: str) -> None:
    grade_ = grade(Submission(dealt(exercise_id, 1), {}))
    assert {verdict.outcome for verdict in grade_.verdicts.values()} == {Outcome.UNREADABLE}
    assert (grade_.score, grade_.counted) == (0, False)


def slips(exercise_id: str) -> list[tuple[Variant, str, dict[str, str]]]:
    """Each mistake made once: the first variant in which it has an occasion, and what is typed."""
    found: dict[str, tuple[Variant, str, dict[str, str]]] = {}
    exercise = catalogue.load(exercise_id).exercise
    for seed in range(60):
        if found.keys() == exercise.mistakes.keys():
            break
        variant = dealt(exercise_id, seed)
        solved = Solved(exercise, variant)
        for name, expected in variants.predictions(solved).items():
            typed = {answer: grader.show(expected[answer]) for answer, grader in solved.answers.items()}
            found.setdefault(name, (variant, name, typed))
    return list(found.values())


@EVERY
def test_each_mistake_is_wrong_and_recognised_and_has_a_hint(exercise_id: str) -> None:
    made = slips(exercise_id)
    assert {name for _, name, _ in made} == set(catalogue.load(exercise_id).exercise.mistakes)
    assert len(made) >= 4
    for variant, name, typed in made:
        grade_ = grade(Submission(variant, typed))
        assert grade_.mistake == name
        assert any(v.outcome in (Outcome.WRONG, Outcome.PARTLY) for v in grade_.verdicts.values()), name
        assert all(hint(variant, name, lang) and hint_text(variant, name, lang) for lang in LANGUAGES)


@EVERY
@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_variant_is_presented_and_solved_in_every_language(exercise_id: str, lang: str) -> None:
    variant = dealt(exercise_id, 3)
    shown = presented(variant, lang)
    assert shown.title and shown.summary and "{{" not in shown.statement_html and "$" not in shown.statement_text
    assert all(field.prompt_text for field in shown.answers.values())
    assert shown.picture is not None and shown.picture.svg.startswith("<svg")
    assert all(line.heading_html and line.value for line in solution(variant, lang))


@EVERY
def test_a_printed_tolerance_is_a_round_number(exercise_id: str) -> None:
    for name, field in presented(dealt(exercise_id, 1), "en").answers.items():
        figures = [found.replace(".", "").strip("0") for found in re.findall(r"[\d.]+", field.tolerance_text)]
        assert all(len(digits) <= 2 for digits in figures), (name, field.tolerance_text)


@EVERY
def test_a_preview_does_not_depend_on_the_seed(exercise_id: str) -> None:
    """Two seeds of one topology: whatever is typed, the same is understood."""
    one = dealt(exercise_id, 1)
    names = list(catalogue.load(exercise_id).exercise.answers_of(one.givens))
    other = next(v for v in (dealt(exercise_id, s) for s in range(2, 200)) if _symbols(v) == _symbols(one))
    for text in ("12,5", "3 mm", "l1 + 1", "ac(x+1)", "[[1; 2]]", ""):
        for name in names:
            assert preview(one, name, text) == preview(other, name, text)


def _symbols(variant: Variant) -> dict[str, frozenset[str]]:
    posed = solving.solved(variant)
    return {name: posed.symbols(name).names for name in posed.answers}


@EVERY
def test_text_that_is_no_answer_is_unreadable_with_its_place(exercise_id: str) -> None:
    variant = dealt(exercise_id, 2)
    for name, judge in solved_answers(variant).items():
        found = preview(variant, name, "\u0000" if judge.kind == "text" else "1 +* (")
        assert isinstance(found, Verdict) and found.outcome is Outcome.UNREADABLE


def poisoned(*_: Any, **__: Any) -> Never:
    raise RuntimeError("the oracle uses the steps")


def called_by(line: Line) -> Iterator[tuple[ModuleType, str]]:
    """Give the functions that a step calls, each with the module in which it looks for them."""
    for cell in getattr(line, "__closure__", None) or ():
        assert not callable(cell.cell_contents), "a step closes over a function"
    for used in getattr(getattr(line, "__code__", None), "co_names", ()):
        owner = sys.modules[line.__module__]
        if callable(getattr(owner, used, None)) and used not in BUILT_IN:
            yield owner, used


@EVERY
def test_the_oracle_does_not_stand_on_the_module_of_the_steps(exercise_id: str) -> None:
    """With every function poisoned that the steps call, the oracle's results do not change."""
    exercise = catalogue.load(exercise_id).exercise
    posed = [dealt(exercise_id, seed) for seed in SEEDS]
    before = [exercise.oracle(variant.givens) for variant in posed]
    with pytest.MonkeyPatch.context() as patch:
        for owner, used in STEPS_ARE_SOLVED_BY:
            patch.setattr(owner, used, poisoned)
        for variant in posed:
            for line in exercise.steps_of(variant.givens).values():
                for owner, used in called_by(line):
                    patch.setattr(owner, used, poisoned)
        with pytest.raises(RuntimeError, match="uses the steps"):
            Solved(exercise, posed[0])
        after = [exercise.oracle(variant.givens) for variant in posed]
    assert before == after


@EVERY
@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_given_has_a_name_and_no_name_is_of_nothing(exercise_id: str, lang: str) -> None:
    words = catalogue.load(exercise_id).words[lang]
    called = words["givens"]
    sections = {kind: names for kind, names in called.items() if isinstance(names, dict)}
    unused = {(kind, key) for kind, names in sections.items() for key in names}
    unused |= {("", key) for key in called if key not in sections}
    for seed in range(amount(40, 200)):
        variant = dealt(exercise_id, seed)
        for given in printed_givens(variant, lang):
            name = plain(named(given, variant.givens, words, lang))
            assert name and not set(name) & set("{}$"), given
            keys = (given.name, given.name.rstrip("0123456789") + "{i}")
            found = [(kind, key) for kind in (given.kind, "") for key in keys if (kind, key) in unused]
            unused -= set(found[:1])
    assert not unused
