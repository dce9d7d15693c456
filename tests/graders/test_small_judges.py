"""What is told of whole numbers, ratios, options and orders to the last detail: places, scores, words, distances.

Mutants of these judges that mutmut leaves alive change nothing that can be seen:

* a bound moved by one (a text of 60 or 400 characters, a numerator or denominator at its greatest, a score of 1e-9, a
  value on the border of a tolerance), or a bound that stands before a stricter one (60 characters before 15 digits);
* `float("INF")`; the default of `comma`, which is always given or has no meaning for words; symbols, which none reads;
* `or 2` under a sum that is nothing; `<=` for `<` between places that are never equal;
* `in "XX+-XX"` for one sign; `case _` that returns what the end of a function returns; `strip(None)` before a reader
  that takes off brackets itself;
* texts in `samples`, which are there for tests alone: another one of them is as right or as wrong.
"""

from __future__ import annotations

from math import inf

import pytest

from graders import AnswerSyntaxError, Choice, Choices, Code, Grader, Integer, Ordering, Rational, Symbols
from graders.common_slips import CommonSlip
from graders.language import Reason

NOTHING = Symbols(())
THREE = ("crank", "rod", "slider")


def refused(judge: Grader, text: str) -> tuple[Reason, int, str]:
    with pytest.raises(AnswerSyntaxError) as error:
        judge.parse(text, NOTHING)
    return error.value.reason, error.value.position, error.value.proposal.found


@pytest.mark.parametrize(
    ("judge", "text", "reason", "place", "found"),
    [
        (Integer(), "  ", Reason.EMPTY, 0, ""),
        (Integer(), "  two and a half beams or more", Reason.NOT_AN_INTEGER, 0, "two and a half beams"),
        (Integer(), "2.5", Reason.NOT_AN_INTEGER, 0, "2.5"),
        (Integer(), "5.0/2.5", Reason.NOT_AN_INTEGER, 0, "5.0/2.5"),
        (Integer(), "1" * 70, Reason.NOT_AN_INTEGER, 0, "1" * 20),
        (Rational(), " ", Reason.EMPTY, 0, ""),
        (Rational(), "i = sqrt(2) + sqrt(3) + sqrt(5)", Reason.NOT_A_FRACTION, 4, "i = sqrt(2) + sqrt(3"),
        (Rational(), "-sqrt(2)", Reason.NOT_A_FRACTION, 0, "-sqrt(2)"),
        (Rational(), "2^13", Reason.NOT_A_FRACTION, 0, "2^13"),
        (Rational(), "sqrt(2)^2", Reason.NOT_A_FRACTION, 0, "sqrt(2)^2"),
        (Rational(), "2*sqrt(2)", Reason.NOT_A_FRACTION, 0, "2*sqrt(2)"),
        (Rational(), "sqrt(2)/3", Reason.NOT_A_FRACTION, 0, "sqrt(2)/3"),
        (Rational(), r"\frac{1}{\sqrt{2}}", Reason.NOT_A_FRACTION, 0, "((1)/(sqrt (2)))"),
        (Choice(THREE), "=", Reason.EMPTY, 0, ""),
        (Choice(THREE), "x = the one on the left side", Reason.NOT_A_CHOICE, 4, "the one on the left "),
        (Choice(THREE), "zz = zz", Reason.NOT_A_CHOICE, 5, "zz"),
        (Choice(THREE), "zz zz", Reason.NOT_A_CHOICE, 0, "zz zz"),
        (Ordering(THREE), "a; c", Reason.MISSING_ITEM, 4, "b"),
    ],
)
def test_a_refusal_names_reason_place_and_text(
    judge: Grader, text: str, reason: Reason, place: int, found: str
) -> None:
    assert refused(judge, text) == (reason, place, found)


@pytest.mark.parametrize(
    ("judge", "text", "meant"),
    [
        (Integer(), "-7", -7),
        (Integer(), "−7", -7),
        (Integer(), "–7", -7),
        (Integer(), "+7", 7),
        (Integer(), r"\frac{14}{2}", 7),
        (Integer(), "20 + 27", 47),
        (Choice(THREE), "kind = (b)", "rod"),
        (Choice(THREE), "c).", "slider"),
        (Choices(THREE), "chosen = none", frozenset()),
        (Choices(THREE), "-", frozenset()),
        (Choices(THREE), "a; c", frozenset({"crank", "slider"})),
        (Ordering(THREE), "c; a; b", ("slider", "crank", "rod")),
    ],
)
def test_many_spellings_mean_one_answer(judge: Grader, text: str, meant: object) -> None:
    assert judge.parse(text, NOTHING) == meant


@pytest.mark.parametrize(
    ("text", "value"), [("+3", 3), ("-3/4", -0.75), ("(-2)^3", -8), ("2^12", 4096), ("5 - 2*3", -1), ("1:4 + 1", 1.25)]
)
def test_a_ratio_is_computed_exactly(text: str, value: float) -> None:
    assert Rational().parse(text, NOTHING).value == value
    assert Rational().carried(Rational().parse(text, NOTHING)) == value


@pytest.mark.parametrize(
    ("judge", "text", "reference", "code", "score"),
    [
        (Integer(), "4", 5.0, Code.WRONG, 0),
        (Integer(), "-5", 5.0, Code.OPPOSITE_SIGN, 0),
        (Rational(rtol=0.01), "4,03", 4.0, Code.RIGHT, 1),
        (Rational(rtol=0.01), "4,05", 4.0, Code.WRONG, 0),
        (Rational(rtol=0.001), "4,03", 4.0, Code.NOT_PRECISE, 0),
        (Rational(rtol=0.01), "0,0052", 0.005, Code.WRONG, 0),
        (Rational(), "4,03", 4.0, Code.NOT_EXACT, 0),
        (Rational(), "0,25", 4.0, Code.INVERTED_RATIO, 0),
        (Choices(THREE), "a; b", "crank", Code.SOME_ITEMS, 0.5),
        (Choices(THREE), "a", "crank; rod", Code.SOME_ITEMS, 0.5),
        (Choices(THREE), "a; b; c", "crank; rod", Code.WRONG, 0),
        (Choices(THREE), "a; b", "crank; rod; slider", Code.SOME_ITEMS, 2 / 3),
        (Choices(THREE), "a", "", Code.WRONG, 0),
        (Ordering(THREE), "b; a; c", "crank; rod; slider", Code.SOME_ITEMS, 1 / 3),
        (Ordering(THREE), "c; b; a", "crank; rod; slider", Code.WRONG, 0),
    ],
)  # fmt: skip
def test_each_answer_has_its_code_and_score(
    judge: Grader, text: str, reference: object, code: Code, score: float
) -> None:
    verdict = judge.check(judge.parse(text, NOTHING), reference)
    assert verdict.code is code
    assert verdict.score == pytest.approx(score)


@pytest.mark.parametrize(
    ("judge", "one", "same", "other"),
    [
        (Integer(), 4.0, 4.0, 5.0),
        (Choice(THREE), "rod", "rod", "crank"),
        (Choices(THREE), "rod; crank", "crank; rod", "rod"),
        (Ordering(THREE), "rod; crank; slider", "rod; crank; slider", "crank; rod; slider"),
        (Rational(), 0.5, 0.5, 0.25),
    ],
)
def test_answers_are_the_same_or_far_apart(judge: Grader, one: object, same: object, other: object) -> None:
    assert judge.apart(one, same) == 0
    assert judge.apart(one, other) == inf


@pytest.mark.parametrize(
    ("judge", "text", "mathml", "shown"),
    [
        (Integer(), "-12", "<math><mrow><mo>−</mo><mn>12</mn></mrow></math>", "-12"),
        (Integer(), "0", "<math><mrow><mn>0</mn></mrow></math>", "0"),
        (Choice(THREE), "b", "", "rod"),
        (Choices(THREE), "c; a", "", "crank; slider"),
        (Choices(THREE), "-", "", "-"),
        (Ordering(THREE), "c; a; b", "", "slider; crank; rod"),
    ],
)
def test_what_was_read_is_echoed(judge: Grader, text: str, mathml: str, shown: str) -> None:
    echo = judge.echo(judge.parse(text, NOTHING))
    assert (echo.mathml, echo.text) == (mathml, shown)


def test_a_ratio_is_echoed_with_the_comma_of_the_language() -> None:
    answer = Rational().parse("2,5", NOTHING)
    assert "2,5" in Rational().echo(answer, comma=True).mathml
    assert "2.5" in Rational().echo(answer).mathml
    assert Rational().echo(answer).text == "2.5"


def test_what_is_carried_on_is_what_was_chosen() -> None:
    assert Choice(THREE).carried("rod") == "rod"
    assert Choices(THREE).carried(frozenset({"slider", "crank"})) == "crank; slider"
    assert Ordering(THREE).carried(("slider", "crank", "rod")) == "slider; crank; rod"
    assert Integer().carried(7) == 7


def test_the_fields_say_what_may_be_chosen() -> None:
    assert Choice(THREE).describe() == {"options": [*THREE]}
    assert Choices(THREE).describe() == {"options": [*THREE], "several": True}
    assert Ordering(THREE).describe() == {"options": [*THREE], "ordered": True}
    assert Choices(THREE).show("") == "-"
    assert Rational(rtol=0.01).describe() == {"rtol": 0.01}
    assert Rational().describe() == {"exact": True}


def test_a_count_agrees_only_where_it_is_no_chance() -> None:
    assert Integer().agrees(20, 20.0) and Integer().agrees(-45, -45.0)
    assert not Integer().agrees(19, 19.0)
    assert not Integer().agrees(45, 46.0)


@pytest.mark.parametrize(
    ("judge", "text", "reference", "slips"),
    [
        (Rational(), "-4", 4.0, {CommonSlip.OPPOSITE_SIGN}),
        (Rational(), "1/4", 4.0, {CommonSlip.INVERTED_RATIO}),
        (Rational(rtol=0.01), "0,2501", 4.0, {CommonSlip.INVERTED_RATIO}),
        (Rational(), "0,2501", 4.0, set()),
        (Rational(), "5", 4.0, set()),
        (Rational(), "0", 4.0, set()),
        (Rational(), "4", 0.0, set()),
        (Rational(), "400", 4.0, {CommonSlip.POWER_OF_TEN}),
        (Rational(rtol=0.01), "8,02", 4.0, {CommonSlip.FACTOR_TWO}),
        (Rational(rtol=0.01), "8,06", 4.0, set()),
    ],
)
def test_common_slips_are_told_by_a_ratio(judge: Rational, text: str, reference: float, slips: set[CommonSlip]) -> None:
    assert judge.slips(judge.parse(text, NOTHING), reference) == slips
