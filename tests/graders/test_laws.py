"""Laws of equality on random formulas that turn: symmetry, other spellings, small differences, the plain search."""

from __future__ import annotations

from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from graders.equality import Finding, between
from graders.equality.pair import Pair
from graders.judge import Domain, Formula
from graders.language import parse_line
from graders.language.tree import Binary, Call, Tree
from graders.states import spread
from tests.depth import amount
from tests.graders.rewriting import PlainSearch, box, changed, drawn, rewritten

seeds = st.integers(0, 10**12).map(Random)
APART = {Finding.DIFFERENT, Finding.UNDEFINED}
TRIES = amount(40, 400)


def both(a: Tree, b: Tree, domains: dict[str, Domain]) -> set[Finding]:
    return {between(a, b, domains, b"laws").finding, between(b, a, domains, b"laws").finding}


@settings(max_examples=TRIES)
@given(seeds)
def test_a_formula_is_never_told_from_itself_in_another_spelling(rng: Random) -> None:
    domains, tree = box(rng), drawn(rng, rng.randint(1, 4))
    assert not both(tree, rewritten(rng, tree, 0.5), domains) & APART


@settings(max_examples=TRIES)
@given(seeds)
def test_what_is_equal_one_way_is_never_different_the_other_way(rng: Random) -> None:
    domains, tree = box(rng), drawn(rng, rng.randint(1, 4))
    found = both(tree, rewritten(rng, changed(rng, tree), 0.4), domains)
    assert Finding.EQUAL not in found or not found & APART


@settings(max_examples=TRIES)
@given(seeds, st.sampled_from(("1e-9", "1e-9*<x>^1 + 1e-25", "1e-20*(2 + sin(y))", "1e-12*exp(a)")))
def test_a_small_difference_is_never_equality(rng: Random, small: str) -> None:
    domains, tree = box(rng), Call("atan", (drawn(rng, rng.randint(0, 3)),))
    assert Finding.EQUAL not in both(tree, Binary("+", tree, parse_line(small)), domains)


@settings(max_examples=TRIES)
@given(seeds)
def test_the_judge_never_contradicts_a_plain_search(rng: Random) -> None:
    domains, tree = box(rng), drawn(rng, rng.randint(1, 4))
    other = rewritten(rng, changed(rng, tree), 0.4)
    reference = Formula(tree, spread(domains, b"laws"))
    found = {kind(other, reference, mutual=True).compared().finding for kind in (Pair, PlainSearch)}
    assert Finding.EQUAL not in found or not found & APART
