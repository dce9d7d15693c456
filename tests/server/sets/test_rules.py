"""Windows, lateness, counting and points, each against what the rule says in words."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import Code, Outcome, Verdict
from graders.verdict import EMPTY, FOLLOWED, RIGHT
from server.sets.rules import (
    Entry,
    Rules,
    Stage,
    Window,
    combined,
    held,
    left,
    result,
    same,
    share,
    solution_open,
    window,
    worth,
)  # fmt: skip
from tests.depth import amount

OPENS = datetime(2026, 11, 30, 7, tzinfo=UTC)
DUE = datetime(2026, 12, 7, 22, 59, tzinfo=UTC)
CLOSES = DUE + timedelta(days=2)
SECOND = timedelta(seconds=1)


def stages(found: Window, *moments: datetime) -> list[Stage]:
    return [found.stage(moment) for moment in moments]


def test_a_window_turns_on_its_very_seconds() -> None:
    found = window(OPENS, DUE, CLOSES, Rules(late="accepted"))
    assert stages(found, OPENS - SECOND, OPENS, DUE, DUE + SECOND, CLOSES, CLOSES + SECOND) == [
        Stage.BEFORE, Stage.OPEN, Stage.OPEN, Stage.LATE, Stage.LATE, Stage.CLOSED,
    ]  # fmt: skip


def test_without_late_work_the_window_closes_when_it_is_due() -> None:
    assert stages(window(OPENS, DUE, CLOSES, Rules()), DUE, DUE + SECOND) == [Stage.OPEN, Stage.CLOSED]


def test_a_set_without_moments_is_always_open() -> None:
    assert window(None, None, None, Rules()).stage(OPENS) is Stage.OPEN


def test_extra_time_moves_due_closing_and_limit() -> None:
    rules = Rules(late="accepted", minutes=90)
    more = window(OPENS, DUE, CLOSES, rules, extra=45)
    assert (more.due, more.closes) == (DUE + timedelta(minutes=45), CLOSES + timedelta(minutes=45))
    begun = window(OPENS, DUE, CLOSES, rules, extra=45, begun=OPENS)
    assert begun.closes == OPENS + timedelta(minutes=135)


@pytest.mark.parametrize(("moments", "longer"), [((0, 60), 20), ((60,), 10), ((61,), 0), ((-1,), 0), ((60, 65), 20)])
def test_time_limits_that_run_when_deadlines_are_moved_are_longer(moments: tuple[int, ...], longer: int) -> None:
    extended = [(OPENS + timedelta(minutes=at), 10) for at in moments]
    found = window(OPENS, DUE, CLOSES, Rules(late="accepted", minutes=60), begun=OPENS, extended=extended)
    assert found.closes == OPENS + timedelta(minutes=60 + longer)


def test_the_limit_ends_with_the_window_for_one_who_begins_late() -> None:
    found = window(OPENS, DUE, None, Rules(minutes=90), begun=DUE - timedelta(minutes=10))
    assert found.closes == DUE


@pytest.mark.parametrize(("late", "expected"), [("refused", 1.0), ("accepted", 1.0), ("reduced", 0.8)])
def test_each_day_begun_takes_its_loss(late: str, expected: float) -> None:
    rules = Rules.model_validate({"late": late, "late_loss": 0.1})
    assert worth(DUE + timedelta(days=1, seconds=1), DUE, rules) == pytest.approx(expected)
    assert worth(DUE, DUE, rules) == 1.0


def test_late_work_is_never_worth_less_than_nothing() -> None:
    assert worth(DUE + timedelta(days=30), DUE, Rules(late="reduced", late_loss=0.2)) == 0.0


def test_the_same_answers_are_the_same_however_they_are_spaced() -> None:
    assert same({"l3": " 1,25 m", "v3": ""}, {"l3": "1,25 m "})
    assert same({"p": ["a", "b"]}, {"p": "a\nb"})
    assert not same({"l3": "1,25 m"}, {"l3": "1.25 m"})


def test_follow_through_is_worth_its_price() -> None:
    wrong = Verdict(0.0, Code.WRONG)
    assert wrong.outcome is Outcome.WRONG
    verdicts = {"a": wrong, "b": FOLLOWED, "c": RIGHT, "d": EMPTY}
    weights = {"a": 1.0, "b": 2.0, "c": 1.0, "d": 1.0}
    assert share(verdicts, weights, Rules()) == 0.6
    assert share(verdicts, weights, Rules(follow_through=0.5)) == 0.4


def entries(*shares: float) -> list[Entry]:
    return [Entry(f"R{n}", OPENS + timedelta(hours=n), one, True) for n, one in enumerate(shares)]


def test_best_or_last_attempt() -> None:
    ledger = entries(0.5, 1.0, 0.25)
    assert result(ledger, DUE, Rules(keep="best")) == 1.0
    assert result(ledger, DUE, Rules(keep="last")) == 0.25
    assert result([], DUE, Rules()) is None


def test_what_was_not_counted_neither_earns_nor_hides() -> None:
    unread = Entry("R9", OPENS + timedelta(hours=9), 0.0, False)
    assert result([*entries(0.5), unread], DUE, Rules(keep="last")) == 0.5
    assert result([unread], DUE, Rules()) is None
    settled = Entry("R9", OPENS + timedelta(hours=9), 1.0, False)
    assert result([settled], DUE, Rules()) == 1.0


@given(
    shares=st.lists(st.floats(0, 1), max_size=6),
    better=st.floats(0, 1),
    hours=st.integers(0, 400),
    keep=st.sampled_from(["best", "last"]),
    late=st.sampled_from(["refused", "accepted", "reduced"]),
)
@settings(max_examples=amount(20, 60), deadline=None)
def test_a_better_attempt_never_lowers_the_score(
    shares: list[float], better: float, hours: int, keep: str, late: str
) -> None:
    rules = Rules.model_validate({"keep": keep, "late": late})
    before = result(entries(*shares), DUE, rules) or 0.0
    time = OPENS + timedelta(hours=6 + hours)
    if better * worth(time, DUE, rules) >= before:
        assert (result([*entries(*shares), Entry("new", time, better, True)], DUE, rules) or 0.0) >= before


def test_a_hint_takes_its_price_from_what_comes_after_it() -> None:
    late = Entry("R2", DUE + SECOND, 1.0, True, hints=1)
    ledger = [Entry("R1", OPENS, 0.7, True), late._replace(time=DUE)]
    assert result(ledger, DUE, Rules(hint_price=0.2)) == 0.8 and result(ledger, DUE, Rules()) == 1.0
    assert result(ledger, DUE, Rules(hint_price=0.5)) == 0.7
    assert result([late._replace(hints=3)], DUE, Rules(hint_price=0.5)) == 0.0
    assert result([late], DUE, Rules(late="reduced", late_loss=0.1, hint_price=0.2)) == 0.72


def test_attempts_left() -> None:
    assert [left(3, 1), left(3, 3), left(3, 4), left(None, 7)] == [2, 0, 0, None]


def test_a_second_chance_is_nine_tenths_of_the_better() -> None:
    assert combined(0.4, 0.8) == pytest.approx(0.76)
    assert combined(0.8, 0.4) == pytest.approx(0.76)
    assert combined(0.8, None) == 0.8


def test_an_exam_holds_its_results_until_it_closes() -> None:
    assert [held(Rules(mode="exam"), stage) for stage in (Stage.OPEN, Stage.LATE, Stage.CLOSED)] == [True, True, False]
    assert not held(Rules(), Stage.OPEN)


def test_when_the_worked_solution_opens() -> None:
    assert not solution_open(Rules(solutions="never"), Stage.CLOSED, 0)
    assert solution_open(Rules(), Stage.CLOSED, 2) and not solution_open(Rules(), Stage.OPEN, 0)
    early = Rules(solutions="after_last_attempt")
    assert solution_open(early, Stage.OPEN, 0)
    assert not solution_open(early, Stage.OPEN, 1) and not solution_open(early, Stage.OPEN, None)
    assert not solution_open(Rules(solutions="after_last_attempt", mode="exam"), Stage.OPEN, 0)
