"""Local time of a course, also on the two days a year on which the clocks change in Warsaw."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest

from server.sets.clock import NoSuchMoment, left, local, read, seconds_left, shifted, spoken, zone

WARSAW = zone("Europe/Warsaw")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2026-11-30T08:00", datetime(2026, 11, 30, 7, tzinfo=UTC)),
        ("2026-07-01 23:59", datetime(2026, 7, 1, 21, 59, tzinfo=UTC)),
        ("2026-10-25T02:30", datetime(2026, 10, 25, 1, 30, tzinfo=UTC)),  # comes twice: the later one
        ("2026-03-29T01:59", datetime(2026, 3, 29, 0, 59, tzinfo=UTC)),
        ("2026-03-29T03:00", datetime(2026, 3, 29, 1, 0, tzinfo=UTC)),  # one minute after 01:59
        ("2026-11-30T08:00+00:00", datetime(2026, 11, 30, 8, tzinfo=UTC)),
    ],
)
def test_local_time_is_read(text: str, expected: datetime) -> None:
    assert read(text, WARSAW) == expected


@pytest.mark.parametrize("text", ["", "soon", "2026-13-01T08:00", "2026-03-29T02:30", "0001-01-01T00:00", "9999-12-31"])
def test_what_is_no_moment_is_refused(text: str) -> None:
    with pytest.raises(NoSuchMoment):
        read(text, WARSAW)


def test_a_moment_is_written_as_it_was_read() -> None:
    assert local(read("2026-07-01T23:59", WARSAW), WARSAW) == "2026-07-01T23:59"


@pytest.mark.parametrize(
    ("language", "said", "exactly"),
    [
        ("pl", "03.07.2026, 01:59", "02.07.2026, 23:59:07"),
        ("en", "3 Jul 2026, 01:59", "2 Jul 2026, 23:59:07"),
        ("ru", "03.07.2026, 01:59", "02.07.2026, 23:59:07"),
    ],
)
def test_a_page_says_a_moment_as_its_language_writes_dates(language: str, said: str, exactly: str) -> None:
    moment = datetime(2026, 7, 2, 23, 59, 7, tzinfo=UTC)
    assert spoken(language, moment, WARSAW) == said
    assert spoken(language, moment, exact=True) == exactly
    assert spoken(language, None, WARSAW) == "—"


def test_a_shift_by_days_keeps_the_hour_on_the_wall() -> None:
    before = read("2026-03-27T23:59", WARSAW)
    after = shifted(before, 7, WARSAW)
    assert local(after, WARSAW) == "2026-04-03T23:59"
    assert after - before == timedelta(days=7, hours=-1)


def test_a_zone_that_does_not_exist_is_refused() -> None:
    for name in ("Europe/Atlantis", "../etc", ""):
        with pytest.raises(NoSuchMoment):
            zone(name)


@pytest.mark.parametrize(
    ("ahead", "told"),
    [
        (timedelta(days=5, hours=3, minutes=59), ("days", 5, 3)),
        (timedelta(days=1), ("days", 1, 0)),
        (timedelta(days=1) - timedelta(seconds=1), ("hours", 23, 59)),
        (timedelta(seconds=59), ("hours", 0, 0)),
        (timedelta(0), None),
        (timedelta(days=-1), None),
    ],
)
def test_the_time_left_is_told_in_two_parts_until_it_is_up(ahead: timedelta, told: tuple[str, int, int] | None) -> None:
    now = datetime(2026, 11, 28, 22, tzinfo=UTC)
    assert left(now + ahead, now) == told and left(None, now) is None
    assert seconds_left(now + ahead, now) == max(0, ahead.total_seconds()) and seconds_left(None, now) == 0
