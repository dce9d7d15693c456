"""Formulas whose equality was settled by hand: every pair is judged as it was settled, whichever side is the answer."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Domain, Symbols
from graders.equality import Finding, between
from graders.language import parse
from tests.corpus import Pair, pairs

VERDICTS = {Finding.EQUAL: "equal", Finding.DIFFERENT: "different", Finding.UNDEFINED: "different"}


def verdict(a: str, b: str, domains: tuple[tuple[str, Domain], ...], chance: bytes) -> str:
    symbols = Symbols(name for name, _ in domains)
    try:
        found = between(parse(a, symbols), parse(b, symbols), dict(domains), chance)
    except AnswerSyntaxError:
        return "unreadable"
    return VERDICTS.get(found.finding, found.finding.value)


@pytest.mark.parametrize("chance", [b"one", b"another"])
def test_every_pair_is_judged_as_it_was_settled(chance: bytes) -> None:
    judged = {pair.place: verdict(pair.a[0], pair.b[0], pair.domains, chance) for pair in pairs("expression")}
    assert judged == {pair.place: pair.verdict for pair in pairs("expression")}


def test_the_sides_may_be_exchanged() -> None:
    for pair in pairs("expression"):
        assert verdict(pair.b[0], pair.a[0], pair.domains, b"one") == pair.verdict, pair.place


def test_a_difference_is_proved_at_a_point_of_the_domain() -> None:
    for pair in pairs("expression"):
        if pair.verdict != "different":
            continue
        witness = witnessed(pair)
        assert witness.keys() == dict(pair.domains).keys(), pair.place
        assert all(domain.low <= witness[name] <= domain.high for name, domain in pair.domains), pair.place


def witnessed(pair: Pair) -> dict[str, float]:
    symbols = Symbols(name for name, _ in pair.domains)
    return dict(between(parse(pair.a[0], symbols), parse(pair.b[0], symbols), dict(pair.domains), b"one").witness)


def test_there_are_six_hundred_pairs_and_no_pair_stands_twice() -> None:
    rows = [(pair.a, pair.b, pair.domains) for pair in pairs("expression")]
    assert len(rows) >= 600 and len(set(rows)) == len(rows)
    counts = {kind: sum(pair.verdict == kind for pair in pairs("expression")) for kind in ("equal", "different")}
    assert min(counts.values()) > 200
