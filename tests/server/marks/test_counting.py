"""Marks by hand against tables worked by hand, and against what must hold in any order of events."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from server.marks.counting import by_submission, earned, entries, left_open, unsettled
from server.sets.rules import Rules, kept, result
from server.storage.marks import Mark
from server.storage.sets import Line
from tests.depth import amount

NOON = datetime(2026, 12, 1, 12, tzinfo=UTC)
WEIGHTS = {"l3": 1.0, "v3": 3.0}


def line(receipt: str = "R1", hour: int = 0, counted: bool = True, **codes: str) -> Line:
    """A submission whose answers have these codes; right is 1, all else 0."""
    scores = {name: float(code in ("right", "followed")) for name, code in codes.items()}
    verdicts = {name: {"code": code, "score": scores[name]} for name, code in codes.items()}
    score = sum(WEIGHTS[name] * scores[name] for name in codes) / 4
    grade: dict[str, Any] = {"verdicts": verdicts, "score": score}
    return Line("S1", "anna", "V1", receipt, NOON + timedelta(hours=hour), grade, counted)


def mark(number: int, answer: str | None, share: float | None, receipt: str = "R1") -> Mark:
    return Mark(receipt, answer, share, "", "lecturer", NOON, number)


@pytest.mark.parametrize(
    ("marks", "expected"),
    [
        ([], 0.25),  # l3 right: 1 of 4 weights
        ([mark(1, None, None)], 0.25),  # a comment changes nothing
        ([mark(1, "v3", 0.5)], 0.625),  # (1 + 3 * 0.5) / 4
        ([mark(1, "v3", 1.0), mark(2, "l3", 0.0)], 0.75),
        ([mark(1, "v3", 1.0), mark(2, "v3", 0.0)], 0.25),  # the newest word counts
        ([mark(1, "v3", 1.0), mark(2, None, 0.4)], 0.4),  # the whole goes before what was marked earlier
        ([mark(1, None, 0.4), mark(2, "v3", 1.0)], 1.0),  # an answer marked later takes the whole back
        ([mark(1, None, 0.0)], 0.0),
    ],
)
def test_points_with_marks_are_those_worked_by_hand(marks: list[Mark], expected: float) -> None:
    given = by_submission(marks).get("R1", {})
    assert earned(line(l3="right", v3="undecided"), given, WEIGHTS, Rules()) == pytest.approx(expected)


def test_follow_through_keeps_its_price_beside_a_mark() -> None:
    rules = Rules(follow_through=0.5)
    given = by_submission([mark(1, "v3", 1.0)])["R1"]
    assert earned(line(l3="followed", v3="wrong"), given, WEIGHTS, rules) == pytest.approx((0.5 + 3) / 4)


@pytest.mark.parametrize("code", ["undecided", "kept", "fault"])
def test_an_answer_is_open_until_it_or_the_whole_is_marked(code: str) -> None:
    found = line(l3="right", v3=code)
    assert left_open(found, {}) == ["v3"]
    for answer in ("v3", None):
        assert left_open(found, by_submission([mark(1, answer, 0.0)])["R1"]) == []
    assert left_open(found, by_submission([mark(1, "l3", 0.0)])["R1"]) == ["v3"]


def test_work_that_did_not_count_earns_once_it_is_settled_with_nothing_too() -> None:
    lines = [line(counted=False, l3="undecided", v3="undecided")]
    assert result(entries(lines, {}, {}, Rules()), None, Rules()) is None
    refused = by_submission([mark(1, None, 0.0)])
    assert result(entries(lines, refused, {}, Rules()), None, Rules()) == 0.0


@pytest.mark.parametrize(
    ("keep", "first", "second", "left"),
    [
        ("best", "undecided", "right", set()),  # full points stand whatever comes
        ("best", "undecided", "wrong", {"undecided"}),
        ("last", "undecided", "wrong", set()),  # what came before the last does not matter
        ("last", "right", "undecided", {"undecided"}),
    ],
)
def test_points_are_provisional_only_where_settling_can_change_them(
    keep: Any, first: str, second: str, left: set[str]
) -> None:
    rules = Rules(keep=keep)
    lines = [line("R1", 0, l3="right", v3=first), line("R2", 1, l3="right", v3=second)]
    ledger = entries(lines, {}, {"V1": WEIGHTS}, rules)
    assert unsettled(lines, {}, kept(ledger, None, rules), result(ledger, None, rules), rules) == left


EVENTS = st.lists(
    st.tuples(st.sampled_from(["mark", "whole", "comment", "grade"]), st.sampled_from(["l3", "v3"]), st.floats(0, 1)),
    max_size=12,
)


@settings(max_examples=amount(20, 60), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(EVENTS)
def test_no_regrade_and_no_later_submission_erases_a_mark(events: list[tuple[str, str, float]]) -> None:
    """After any history the last share given to an answer is what it earns, unless the whole was marked after it."""
    marks: list[Mark] = []
    grade, newer = line(l3="right", v3="wrong"), line("R2", 1, l3="wrong", v3="wrong")
    for number, (what, answer, share) in enumerate(events, 1):
        if what == "grade":
            grade = line(l3="right" if share > 0.5 else "wrong", v3="wrong")
        else:
            marks.append(mark(number, None if what == "whole" else answer, None if what == "comment" else share))
    shares = [one for one in marks if one.share is not None]
    got = entries([grade, newer], by_submission(marks), {"V1": WEIGHTS}, Rules())[0].share
    if shares and shares[-1].answer is None:
        assert got == shares[-1].share
    else:
        last = {one.answer: one.share for one in shares if one.answer}
        own = {name: last.get(name, grade.grade["verdicts"][name]["score"]) for name in WEIGHTS}
        assert got == pytest.approx((own["l3"] + 3 * own["v3"]) / 4, abs=1e-6)
