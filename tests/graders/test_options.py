"""Options and orders: read by letter or name, earned by their share; what no small judge reads."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graders import AnswerSyntaxError, Choice, Choices, Code, Grader, Integer, Ordering, Rational, Text
from graders.language import Reason
from tests.graders.judging import NOTHING, judged


@pytest.mark.parametrize("typed", ["b", "B)", "stiffness", "б"])
def test_an_option_is_chosen_by_letter_or_name(typed: str) -> None:
    judge = Choice(("strength", "stiffness"))
    if typed == "б":
        with pytest.raises(AnswerSyntaxError):
            judge.parse(typed, NOTHING)
    else:
        assert judged(judge, typed, "stiffness") is Code.RIGHT


@pytest.mark.parametrize(
    "typed", ["47 zębów", "47 teeth", "47 зубьев.", "z4: 47", "$47$", "30+47-30", "94/2", "ok. 47"]
)
def test_a_count_is_read_with_its_word_and_as_a_sum(typed: str) -> None:
    assert Integer().parse(typed, NOTHING) == 47


@pytest.mark.parametrize(
    ("typed", "place", "told"),
    [
        ("w = 46 = 47", 7, "46 ≠ 47"),
        ("W = 3*3 - 2*4 = 2", 14, "3*3 - 2*4 ≠ 2"),
        ("3*3 - 2*4 ≈ 2", 10, "3*3 - 2*4 ≠ 2"),
        ("w = 1 = 2 = 2", 10, "1 ≠ 2"),
    ],
)
def test_two_counts_that_differ_are_both_named(typed: str, place: int, told: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Integer().parse(typed, NOTHING)
    found = refused.value
    assert (found.reason, found.position, found.proposal.found) == (Reason.TWO_VALUES, place, told)


@pytest.mark.parametrize("typed", ["W = 3*17 - 2*2 = 47", "w = 47.0 = 47", "w = 46.9 = 47", "3n - 2*2 = 47"])
def test_a_count_may_stand_behind_its_computation(typed: str) -> None:
    assert Integer().parse(typed, NOTHING) == 47


@pytest.mark.parametrize("typed", ["47 mm", "95/2", "47 48", "2*23,5", "zębów", "47 or 48", "9^99"])
def test_what_is_no_count_is_refused(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        Integer().parse(typed, NOTHING)
    assert refused.value.reason is Reason.NOT_AN_INTEGER


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("a; c", Code.RIGHT, 1),
        ("C,A", Code.RIGHT, 1),
        ("ca", Code.RIGHT, 1),
        ("links = crank; rocker", Code.RIGHT, 1),
        ("(a) c)", Code.RIGHT, 1),
        ("a", Code.SOME_ITEMS, 0.5),
        ("a; b; c", Code.SOME_ITEMS, 0.5),
        ("a; b", Code.WRONG, 0),
        ("abcd", Code.WRONG, 0),
        ("b; d", Code.WRONG, 0),
        ("-", Code.WRONG, 0),
    ],
)
def test_several_choices_earn_their_share_and_all_of_them_nothing(typed: str, code: Code, score: float) -> None:
    judge = Choices(("crank", "rod", "rocker", "slider"))
    verdict = judge.check(judge.parse(typed, NOTHING), "crank; rocker")
    assert (verdict.code, verdict.score) == (code, score)


@given(st.integers(2, 8).flatmap(lambda n: st.tuples(st.just(n), st.sets(st.integers(0, n - 1)))))
def test_ticking_at_random_earns_nothing_on_the_average(drawn: tuple[int, set[int]]) -> None:
    """The mean over all selections of one size of share of right less share of wrong ones is zero."""
    count, right = drawn
    options = tuple(f"option{k}" for k in range(count))
    judge, reference = Choices(options), "; ".join(options[k] for k in right)
    assert judge.check(frozenset(options), reference).score == (1 if len(right) == count else 0)
    assert judge.check(frozenset(), reference).score == (0 if right else 1)


@pytest.mark.parametrize(
    ("typed", "code", "score"),
    [
        ("a; b; c; d", Code.RIGHT, 1),
        ("a → b → c → d", Code.RIGHT, 1),
        ("abcd", Code.RIGHT, 1),
        ("b; a; c; d", Code.SOME_ITEMS, 2 / 3),
        ("a; c; d; b", Code.SOME_ITEMS, 1 / 3),
        ("b; a; d; c", Code.SOME_ITEMS, 1 / 3),
        ("d; a; b; c", Code.WRONG, 0),
        ("d; c; b; a", Code.WRONG, 0),
    ],
)
def test_an_order_earns_by_its_pairs(typed: str, code: Code, score: float) -> None:
    judge = Ordering(("one", "two", "three", "four"))
    verdict = judge.check(judge.parse(typed, NOTHING), "one; two; three; four")
    assert verdict.code is code
    assert verdict.score == pytest.approx(score)


@pytest.mark.parametrize(
    ("judge", "typed", "reason", "place"),
    [
        (Ordering(("one", "two", "three")), "a; c", Reason.MISSING_ITEM, 4),
        (Ordering(("one", "two", "three")), "a; c; a", Reason.REPEATED_ITEM, 6),
        (Ordering(("one", "two", "three")), "a; q; b", Reason.NOT_A_CHOICE, 3),
        (Choices(("one", "two", "three")), "a; a", Reason.REPEATED_ITEM, 3),
        (Choices(("one", "two", "three")), " ; ", Reason.EMPTY, 0),
        (Choices(("one", "two", "three")), "a;" * 300, Reason.TOO_LONG, 400),
        (Choice(("one", "two")), " " * 500 + "a", Reason.TOO_LONG, 400),
        (Choice(("one", "two")), " zz", Reason.NOT_A_CHOICE, 1),
        (Text(longest=5), "123456", Reason.TOO_LONG, 5),
        (Text(), "ab\u202e", Reason.BAD_CHARACTER, 2),
        (Rational(), "3" * 300, Reason.TOO_LONG, 200),
        (Rational(), "sin(1)", Reason.NOT_A_FRACTION, 0),
        (Rational(), "9^9^9", Reason.NOT_A_FRACTION, 0),
        (Rational(), "9^12", Reason.OUT_OF_RANGE, 0),
        (Rational(), "i = 1/(2-2)", Reason.OUT_OF_RANGE, 4),
        (Rational(), "2 1/2", Reason.MIXED_NUMBER, 2),
        (Rational(), r"\frac{8}{}", Reason.EMPTY_BOX, 8),
        (Integer(), r"\frac{9}{2}", Reason.NOT_AN_INTEGER, 0),
    ],
)
def test_what_no_small_judge_reads_is_refused_with_its_place(
    judge: Grader, typed: str, reason: Reason, place: int
) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        judge.parse(typed, NOTHING)
    assert (refused.value.reason, refused.value.position) == (reason, place)
