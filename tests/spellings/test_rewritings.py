"""Every correct rewriting of every reference gets full marks, and no mutant does, on a few seeds of each exercise."""

from __future__ import annotations

from functools import cache
from itertools import cycle, islice

import pytest

from exercises import catalogue, variants
from exercises.exercise import Submission
from exercises.grading import grade, reference
from exercises.solving import Solved
from graders import Code, Quantity, Symbols, Verdict
from graders.language import AnswerSyntaxError
from tests.depth import amount
from tests.spellings import amounts, answers
from tests.spellings.answers import Spelled
from tests.spellings.units import GROUPS, group_of

SEEDS = range(amount(2, 5))  # `benchmarks/spellings.py` takes two hundred
LEAST_RIGHT, LEAST_WRONG = 12, 8


@cache
def solved(exercise: str, seed: int) -> Solved:
    return Solved(catalogue.load(exercise).exercise, variants.deal(exercise, seed))


def judged(variant: Solved, name: str, texts: Spelled) -> list[tuple[str, str, Verdict | AnswerSyntaxError]]:
    grader, symbols, reference = variant.answers[name], variant.symbols(name), variant.reference(name)

    def verdict(text: str) -> Verdict | AnswerSyntaxError:
        try:
            return grader.check(grader.parse(text, symbols), reference)
        except AnswerSyntaxError as error:
            return error

    return [(kind, text, verdict(text)) for kind, text in texts]


def full(verdict: Verdict | AnswerSyntaxError) -> bool:
    return isinstance(verdict, Verdict) and (verdict.code, verdict.score) == (Code.RIGHT, 1)


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_every_rewriting_is_right(exercise: str) -> None:
    refused = []
    for seed in SEEDS:
        variant = solved(exercise, seed)
        for name in answers.covered(variant):
            texts = answers.right(variant, name)
            assert len({kind for kind, _ in texts}) >= LEAST_RIGHT
            refused += [(seed, name, *each) for each in judged(variant, name, texts) if not full(each[2])]
    assert refused == []


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_no_mutant_gets_full_marks(exercise: str) -> None:
    accepted = []
    for seed in SEEDS:
        variant = solved(exercise, seed)
        for name in answers.covered(variant):
            texts = answers.wrong(variant, name)
            assert len(texts) >= LEAST_WRONG
            accepted += [(seed, name, *each) for each in judged(variant, name, texts) if full(each[2])]
    assert accepted == []


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_a_whole_submission_of_rewritings_scores_one(exercise: str) -> None:
    variant = solved(exercise, 3)
    texts = {name: list(islice(cycle(answers.right(variant, name)), 5)) for name in answers.covered(variant)}
    for turn in range(5):
        typed = reference(variant.variant) | {name: spelled[turn][1] for name, spelled in texts.items()}
        assert grade(Submission(variant.variant, typed)).score == 1


def test_every_unit_printed_at_a_field_has_a_group() -> None:
    for exercise in catalogue.ids():
        for grader in solved(exercise, 0).answers.values():
            units = (grader.unit,) if isinstance(grader, Quantity) else getattr(grader, "units", ())
            assert all(group_of(unit)[2] for unit in units)


@pytest.mark.parametrize("kind", GROUPS)
def test_every_spelling_of_a_unit_is_right_at_a_field_of_its_group(kind: str) -> None:
    spellings = [s for s, _ in GROUPS[kind]]
    judge = Quantity(spellings[0] or "1", rtol=0.002)
    texts = amounts.quantity("x", 12.5, spellings[0] or "1")
    assert [text for _, text in texts if not _right(judge, text)] == []


def _right(judge: Quantity, text: str) -> bool:
    try:
        return judge.check(judge.parse(text, Symbols(())), 12.5).code is Code.RIGHT
    except AnswerSyntaxError:
        return False
