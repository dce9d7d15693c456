"""What a long text of one repeated thing costs, counted in calls: as its length, and never as the square of it."""

from __future__ import annotations

from contextlib import suppress
from functools import lru_cache, partial
from itertools import product

import pytest

from graders.language import AnswerSyntaxError, Reason, parse
from graders.language.symbols import Symbols, key
from graders.polygon.reading import read_polygon
from graders.units import read_unit
from tests.depth import amount
from tests.graders.effort import calls
from tests.graders.fuzzing.attack import Found, Target, forget, hand_in, targets
from tests.graders.fuzzing.families import families

KNOWN = ("slider_crank", "rrr_matrices", "gear_train", "simple_beam", "stepped_shaft", "slider_crank_polygon")
MOST_CALLS = 200_000  # of a text of 2,000 to 4,000 characters at a judge
EVERY = list(families())
TOGETHER = 3
NESTED = [
    "(…)", "|…|", "<…>^1", "[…]", "[[…]]", "√(…)", "sin(…)", "log_2(…)", "max(1; …)", "2^(…)", "1/(…)", "2(…)", "-…",
    r"1\times10^{…}", r"\frac{…}{2}", r"\frac{2}{…}", r"\sqrt{…}", r"\sqrt[…]{2}", r"\left(…\right)", r"\left|…\right|",
    r"\left\langle…\right\rangle^{2}", r"\left\langle 2\right\rangle^{…}", r"\sin^{2}\left(…\right)", r"\mathrm{…}",
    r"\dot{…}", "a_{…}", "2^{…}", r"\begin{bmatrix}…\end{bmatrix}", r"\left[…\right]",
]  # fmt: skip
DECLARED = Symbols(["a", "l1", "x", "omega1", "F"])


@lru_cache(maxsize=1)
def each_kind() -> tuple[Target, ...]:
    return tuple({target.grader.kind: target for target in targets(KNOWN, (1,))}.values())


@pytest.mark.parametrize("first", range(0, len(EVERY), TOGETHER))
def test_repeated_things_cost_a_bounded_number_of_calls(first: int) -> None:
    kinds, texts = each_kind(), EVERY[first : first + TOGETHER]
    for target, text in amount([(kinds[first // TOGETHER % len(kinds)], texts[0])], list(product(kinds, texts))):
        forget()
        assert calls(partial(hand_in, target, text, Found())) < MOST_CALLS, (target.grader.kind, text[:40])


@pytest.mark.parametrize("thing", ["sin", "ac", "q", "x_1", "l1", "ẋ", "l1ω1", "alpha1"])
def test_no_run_of_letters_is_searched_letter_by_letter(thing: str) -> None:
    def refuse() -> None:
        with pytest.raises(AnswerSyntaxError):
            parse(thing * (1900 // len(thing)), DECLARED)

    forget()
    assert calls(refuse) < 2_000


@pytest.mark.parametrize("outer", NESTED)
def test_what_stands_within_the_same_is_read_once(outer: str) -> None:
    costs = list[int]()
    for levels in (6, 12, 18):
        forget()
        costs.append(calls(partial(read_or_refuse, nested(outer, levels))))
    assert costs[2] - costs[1] < 2 * (costs[1] - costs[0]) + 500, costs


def nested(outer: str, levels: int) -> str:
    text = "x"
    for _ in range(levels):
        text = outer.replace("…", text)
    return text


def read_or_refuse(text: str) -> None:
    with suppress(AnswerSyntaxError):
        parse(text, DECLARED)


@pytest.mark.parametrize("mark", ["<", "=", " <= ", ">"])
def test_a_chain_of_relations_ends_early(mark: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        parse(f"x{mark}" * 300, DECLARED)
    assert refused.value.reason is Reason.TOO_LONG
    assert refused.value.position < 30 * len(f"x{mark}")


def test_a_long_word_is_no_node() -> None:
    forget()
    with pytest.raises(AnswerSyntaxError):
        read_polygon("l1: " + "AB" * 900 + " = l2", DECLARED, ("A", "B", "C"))
    assert key.cache_info().currsize < 100


def test_a_unit_is_looked_for_among_those_that_may_be_near() -> None:
    def refuse() -> None:
        with pytest.raises(AnswerSyntaxError):
            read_unit("Mpasq/qq")

    forget()
    assert calls(refuse) < 2_000
