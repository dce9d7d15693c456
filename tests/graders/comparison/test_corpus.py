"""The settled pairs of the corpus through the door of `grubler compare`: none wrong, none left open."""

from __future__ import annotations

from typing import Any

import pytest

from graders import comparison
from graders.comparison.request import LISTS
from tests.corpus import Pair, pairs

KINDS = ("equation", "system", "inequality", "unordered_list", "quantity", "matrix")


def asked(pair: Pair, turned: bool = False) -> dict[str, Any]:
    a, b = (pair.b, pair.a) if turned else (pair.a, pair.b)
    texts = {"a": list(a), "b": list(b)} if pair.kind in LISTS else {"a": a[0], "b": b[0]}
    more: dict[str, Any] = dict(pair.more)
    if pair.kind == "system":
        more["solve_for"] = more["solve_for"].split(",")
    if "rtol" in more:
        more["rtol"] = float(more["rtol"])
    ranges = {name: [domain.low, domain.high] for name, domain in pair.domains}
    return {"kind": pair.kind, **texts, "vars": ranges, **more}


@pytest.mark.parametrize("kind", KINDS)
def test_every_settled_pair_is_decided_as_it_was_proved(kind: str) -> None:
    found = {pair.place: comparison.answer(asked(pair))["verdict"] for pair in pairs(kind)}
    assert found == {pair.place: pair.verdict for pair in pairs(kind)}


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "quantity"])
def test_the_other_way_round_the_verdict_is_the_same(kind: str) -> None:
    found = {pair.place: comparison.answer(asked(pair, turned=True), b"turned")["verdict"] for pair in pairs(kind)}
    assert found == {pair.place: pair.verdict for pair in pairs(kind)}


def test_every_difference_of_solutions_has_its_witness() -> None:
    for pair in (*pairs("equation"), *pairs("inequality")):
        found = comparison.answer(asked(pair))
        if found["verdict"] == "different" and found["code"] != "shape":
            assert found["witness"].keys() == dict(pair.domains).keys(), pair.place


@pytest.mark.parametrize(
    ("kind", "least"),
    [("equation", 60), ("system", 30), ("inequality", 30), ("unordered_list", 20), ("quantity", 40), ("matrix", 30)],
)
def test_the_corpus_is_large_and_no_verdict_dominates(kind: str, least: int) -> None:
    verdicts = [pair.verdict for pair in pairs(kind)]
    assert len(verdicts) >= least
    assert min(verdicts.count("equal"), verdicts.count("different")) >= least / 4
