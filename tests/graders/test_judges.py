"""The judges: every kind tests itself by its samples, and says what it found in every language."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import (
    KINDS,
    AnswerSyntaxError,
    Choice,
    Choices,
    Code,
    DHTable,
    Expression,
    Grader,
    Integer,
    Matrix,
    Ordering,
    Outcome,
    Polygon,
    Quantity,
    Rates,
    Rational,
    Set,
    Symbols,
    Text,
)
from graders.language import Reason, parse
from graders.verdict import OUTCOMES
from graders.words import LANGUAGES, locale, message, tolerance
from tests.graders.chain.truth import motion
from tests.graders.judging import NOTHING, OMEGA2, SYMBOLS, judged
from tests.graders.polygon.mechanisms import SLIDER

RIGHT: list[tuple[Grader, Any, Symbols]] = [
    (Quantity("MPa"), 12.5e6, NOTHING),
    (Quantity("deg"), -0.2159, NOTHING),
    (Quantity("mm", atol=1e-5), 0.0032, NOTHING),
    (Integer(), 45.0, NOTHING),
    (Choice(("strength", "stiffness")), "stiffness", NOTHING),
    (Choices(("crank", "rod", "rocker", "slider")), "crank; rocker", NOTHING),
    (Choices(("crank", "rod")), "", NOTHING),
    (Choices(("crank", "rod")), "rod; crank", NOTHING),
    (Ordering(("draw", "solve", "check")), "draw; solve; check", NOTHING),
    (Rational(), -8 / 3, NOTHING),
    (Rational(rtol=0.01), 4.0, NOTHING),
    (Rational(either=True), 0.25, NOTHING),
    (Set(("deg", "m")), ((0.3, 1.5), (-0.3, 2.5)), NOTHING),
    (DHTable("RRP"), motion("RRP"), Symbols(motion("RRP").names)),
    (Text(), "", NOTHING),
    (Matrix(2, 2), ((0.5, -0.25), (0.0, 1.0)), NOTHING),
    (Expression("omega2"), OMEGA2, SYMBOLS),
    (Polygon(SLIDER.nodes, "alpha2"), SLIDER, Symbols(SLIDER.states()[0].names)),
    (Rates("polygon", 1, "omega2"), SLIDER, Symbols(SLIDER.states()[0].names)),
    (Rates("polygon", 2, "omega2"), SLIDER, Symbols(SLIDER.states()[0].names)),
]


@pytest.mark.parametrize(("grader", "reference", "symbols"), RIGHT)
def test_a_judge_passes_its_own_samples(grader: Grader, reference: Any, symbols: Symbols) -> None:
    samples = grader.samples(reference)
    right = {Code.KEPT} if grader.kind == "text" else {Code.RIGHT}
    assert {judged(grader, text, reference, symbols) for text in (*samples.right, grader.show(reference))} == right
    assert all(judged(grader, text, reference, symbols) is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            grader.parse(text, symbols)


def test_every_kind_stands_in_the_registry_under_its_name() -> None:
    assert all(str(cls.kind) == kind for kind, cls in KINDS.items())


def test_every_kind_is_tested_by_its_samples_here_or_in_a_file_of_its_name() -> None:
    here = {grader.kind for grader, *_ in RIGHT}
    elsewhere = {kind for kind in KINDS if any(Path(__file__).parent.rglob(f"test_{kind}.py"))}
    assert here | elsewhere == set(KINDS)


@pytest.mark.parametrize(("grader", "reference", "symbols"), RIGHT)
def test_a_judge_echoes_what_it_read_and_describes_its_field(grader: Grader, reference: Any, symbols: Symbols) -> None:
    answer = grader.parse(grader.show(reference), symbols)
    assert grader.echo(answer).text
    assert grader.describe() == json.loads(json.dumps(grader.describe()))
    assert grader.carried(answer) is not None or grader.kind in ("text", "polygon", "rates")
    assert grader.apart(reference, reference) == 0


def test_a_text_is_kept_and_is_no_right_answer() -> None:
    judge = Text()
    verdict = judge.check(judge.parse("Prędkość rośnie.\r\nТак и должно быть.", NOTHING), "")
    assert (verdict.outcome, verdict.score) == (Outcome.UNDECIDED, 0)
    assert judge.echo(judge.parse(" a\r\nb ", NOTHING)).text == "a\nb"
    assert judge.apart("a", "b") == 0
    assert judge.show("") == "…"


def test_every_code_has_an_outcome_and_words_in_every_language() -> None:
    assert set(OUTCOMES) == set(Code)
    for lang in LANGUAGES:
        assert set(locale(lang)["codes"]) == {code.value for code in Code}
        assert set(locale(lang)["reasons"]) == {reason.value for reason in Reason}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_an_unreadable_answer_is_worded_with_its_place_and_proposal(lang: str) -> None:
    from graders.verdict import unreadable

    with pytest.raises(AnswerSyntaxError) as refused:
        parse("1 + ax", Symbols(["a", "x"]))
    text = message(unreadable(refused.value), lang)
    assert "5" in text and "a·x" in text and "{" not in text


@pytest.mark.parametrize(("lang", "shown"), [("pl", "±0,5 %"), ("en", "±0.5 %"), ("ru", "±0,5 %")])
def test_the_tolerance_at_a_field_is_made_from_its_rule(lang: str, shown: str) -> None:
    assert tolerance(Quantity("mm").describe(), lang) == shown
    assert "0,01\u202fmm" in tolerance(Quantity("mm", atol=1e-5).describe(), "pl")
    assert tolerance(Integer().describe(), lang) == ""
    assert tolerance(Rational().describe(), lang) == locale(lang)["tolerance"]["exact"]
    assert "0" in tolerance(Matrix(4, 4).describe(), lang)


def test_a_language_that_is_not_spoken_is_refused() -> None:
    with pytest.raises(KeyError):
        locale("de")


def test_outcomes_cover_what_a_student_is_told() -> None:
    assert set(OUTCOMES.values()) == set(Outcome)


@given(st.sampled_from([g for g, *_ in RIGHT]), st.text(max_size=30))
def test_no_text_makes_a_judge_fail(grader: Grader, text: str) -> None:
    reference = next(reference for judge, reference, _ in RIGHT if judge is grader)
    try:
        answer = grader.parse(text, SYMBOLS)
    except AnswerSyntaxError as refused:
        assert refused.position >= 0
    else:
        assert 0 <= grader.check(answer, reference).score <= 1


def test_an_echo_has_the_decimal_mark_of_the_reader() -> None:
    judge = Quantity("mm")
    answer = judge.parse("12.5", NOTHING)
    assert "<mn>12,5</mn>" in judge.echo(answer, comma=True).mathml
    assert "<mn>12.5</mn>" in judge.echo(answer).mathml


@pytest.mark.parametrize(
    ("unit", "atol", "shown"),
    [
        ("°", 0.1, "±0,5 %, co najmniej ±0,1°"),
        ("", 0.001, "±0,5 %, co najmniej ±0,001"),
        ("kN", 2.0, "±0,5 %, co najmniej ±2\u202fkN"),
    ],
)
def test_a_tolerance_is_printed_with_its_unit_as_a_number_is(unit: str, atol: float, shown: str) -> None:
    assert tolerance({"rtol": 0.005, "atol": atol, "unit": unit}, "pl") == shown
