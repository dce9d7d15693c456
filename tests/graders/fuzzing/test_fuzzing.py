"""A small part of `benchmarks/fuzz.py` in every run: no text makes a reader or a judge fail, and none costs much."""

from __future__ import annotations

import tracemalloc
from functools import lru_cache, partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import KINDS
from graders.units import nearest_unit, read_unit
from tests.depth import amount
from tests.graders.effort import effort
from tests.graders.fuzzing.attack import Found, Target, attack, forget, one, targets

KNOWN = (
    "slider_crank", "rrr_matrices", "gear_train", "simple_beam", "stepped_shaft",
)  # fmt: skip
POSED = {"equation", "system", "inequality", "symbolic_matrix"}
LONGEST = 0.5  # s: ten times the promise, for a machine that does other work as well
MOST_MEMORY = 20e6
MENDED = [
    "25/dJ/",
    "93,75N/mm²²²",
    "5 /",
    "5 mm/(m^9/m^9)^9^9",
    "1 1/",
    "5 (((((m",
    "5 \\frac{m}{s",
    "2 " + "Gm^9*" * 20 + "s",
    "+pi/(<pi*-atan2(pi^2*pi; -pi)^(+5)>^1**2·pi)-1e-298",
    "12,\\sqrt37",
    "\\sqrt1; x",
    "\\sqrt{x}^{72,79}-\\frac{-pi}{-pi+pi·pi}" * 95,
]
HOSTILE = [
    "exp(" * 50 + "l1" + ")" * 50, "tan(" * 55 + "pi/2" + ")" * 55, "+".join(["tan(l1)^99"] * 150), "l1^1e999",
    "sin(9e999*l1)^9e999", "(1+1e-900)^1e900", "atan2(0*l1; 0*l1)", "|l1-l1|/(l1-l1)", "macaulay(l1-l1; 0)",
    "root(l1-l1; 1e9)",
    "9" * 60 + "e999", "√" * 1900 + "l1", "x<" * 900, "F<a>^1" * 300, "|" * 1999, "\\sqrt" * 1000, "\\frac" * 1100,
    "{" * 5000 + "\\", "\\left(" * 800, "\\begin{bmatrix}" * 300, "x_{" * 1900, "\\dot{" * 800, "a·" * 999, "ab" * 990,
    "5 " + "mm*" * 400, "5 " + "(" * 100, "1 000 " * 300, "x10^" * 400, "log_9(" * 300, ",5" * 999, "\\alpha" * 900,
    "^" * 1999, "1+" * 999 + "1", "l1*" * 600 + "l1", "l1/" * 180 + "l1", "l1 " * 199, "a=" * 999 + "a", "2;" * 900,
    "5 " + "²" * 1900, "a; " * 900, "-" * 1999 + "1", "[" * 1999, "'" * 1999 + "\\x", "deg " * 400,
]  # fmt: skip


@lru_cache(maxsize=1)
def every() -> tuple[Target, ...]:
    return tuple(targets(KNOWN, (1,)))


def each_kind() -> dict[str, Target]:
    return {target.grader.kind: target for target in every()}


@pytest.mark.parametrize("seed", range(amount(1, 3)))
def test_no_random_text_makes_a_reader_or_a_judge_fail(seed: int) -> None:
    assert attack(every(), seed, amount(500, 1000)).crashes == []


def test_enough_random_texts_pass_the_tokenizer_and_reach_a_judge() -> None:
    found = attack(every(), 11, amount(500, 1500))
    assert found.tokens >= 0.3 * found.tokenized > 0
    assert found.judged >= 0.1 * found.inputs
    assert set(found.kinds) <= set(KINDS)
    assert len(found.kinds) >= 6


def test_texts_reach_the_kinds_that_no_exercise_asks_for() -> None:
    found = attack([t for t in every() if t.grader.kind in POSED], 1, amount(400, 1200))
    assert found.crashes == []
    assert set(found.kinds) == POSED
    assert found.judged >= 0.05 * found.inputs
    assert found.right > 0


def test_the_same_seed_hands_in_the_same_texts() -> None:
    one_run, other = attack(every(), 5, 100), attack(every(), 5, 100)
    assert (one_run.tokens, one_run.kinds, one_run.reasons) == (other.tokens, other.kinds, other.reasons)


@settings(max_examples=amount(100, 300), deadline=None)
@given(st.integers(0, 10**6), st.text(max_size=60) | st.text(alphabet="\\{}^_frac&leftigh()[]|12x,. ", max_size=60))
def test_any_characters_are_read_or_refused_with_a_place_inside_them(number: int, text: str) -> None:
    found = Found()
    one(every()[number % len(every())], text, found)
    assert found.crashes == []


@pytest.mark.parametrize("text", [*MENDED, *HOSTILE])
def test_hostile_text_is_answered_at_once_by_every_judge(text: str) -> None:
    for target in each_kind().values():
        found = Found()
        assert effort(partial(one, target, text, found), 1) < LONGEST
        assert found.crashes == []


def test_hostile_text_takes_little_memory() -> None:
    tracemalloc.start()
    try:
        for text in HOSTILE:
            one(every()[-1], text, Found())
        assert tracemalloc.get_traced_memory()[1] < MOST_MEMORY
    finally:
        tracemalloc.stop()


def test_a_text_met_again_is_timed_as_if_for_the_first_time() -> None:
    read_unit("N/mm^2")
    nearest_unit("KN")
    assert read_unit.cache_info().currsize
    forget()
    assert read_unit.cache_info().currsize == nearest_unit.cache_info().currsize == 0


def test_what_two_processes_found_is_joined() -> None:
    one_run, other = attack(every(), 1, 50), attack(every(), 2, 50)
    total = Found()
    total.add(one_run)
    total.add(other)
    assert total.inputs == 100
    assert total.tokenized == one_run.tokenized + other.tokenized > total.tokens > 0
    assert total.judged == one_run.judged + other.judged
    assert total.slowest[0][0] == max(one_run.slowest[0][0], other.slowest[0][0])
