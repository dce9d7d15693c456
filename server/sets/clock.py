"""Moments as a course writes them: local time in its zone, stored in UTC."""

from __future__ import annotations

from datetime import UTC, date, datetime, timedelta, tzinfo
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from markupsafe import Markup

from server.web.language import say


class NoSuchMoment(ValueError):
    """The text is no moment in this time zone."""


def zone(name: str) -> ZoneInfo:
    """Give a time zone by its name.

    Raises:
        NoSuchMoment: There is none.
    """
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        raise NoSuchMoment(name) from None


def read(text: str, place: ZoneInfo) -> datetime:
    """Read a moment such as ``2026-11-30T08:00``; without an offset it is local time of the course.

    An hour that the autumn change repeats is the later one, so that a deadline is never earlier than it reads.

    Raises:
        NoSuchMoment: Not a moment, or an hour that the spring change leaves out.
    """
    try:
        written = datetime.fromisoformat(text.strip())
    except ValueError:
        raise NoSuchMoment(text) from None
    if not 2000 <= written.year <= 2999:
        raise NoSuchMoment(text)
    if written.tzinfo is not None:
        return written.astimezone(UTC)
    moment = written.replace(tzinfo=place, fold=1).astimezone(UTC)
    if moment.astimezone(place).replace(tzinfo=None) != written:
        raise NoSuchMoment(text)
    return moment


def local(moment: datetime, place: ZoneInfo) -> str:
    """Write a moment in local time to the minute, as a form shows it."""
    return moment.astimezone(place).strftime("%Y-%m-%dT%H:%M")


def spoken(language: str, moment: datetime | None, place: tzinfo = UTC, exact: bool = False) -> str:
    """Write a moment in local time as a page says it, `exact` to the second; a dash where there is none."""
    if moment is None:
        return "—"
    here = moment.astimezone(place)
    time = here.strftime("%H:%M:%S" if exact else "%H:%M")
    return f"{day(language, here)}, {time}"


def named(language: str, moment: datetime, place: tzinfo) -> str:
    """Write a moment to the second with the zone in which it is told, as a receipt does."""
    return f"{spoken(language, moment, place, exact=True)} ({place})"


def stamp(language: str, moment: datetime | None, place: tzinfo = UTC) -> Markup:
    """Write a moment as `spoken` does, in an element that programs read; a dash where there is none."""
    return _element(moment, spoken(language, moment, place))


def exact_stamp(language: str, moment: datetime, place: tzinfo) -> Markup:
    """Write a moment as `named` does, in an element that programs read."""
    return _element(moment, named(language, moment, place))


def hour_stamp(moment: datetime, place: tzinfo) -> Markup:
    """Write the hour of a moment with its zone, in an element that programs read."""
    return _element(moment, f"{moment.astimezone(place):%H:%M} ({place})")


def day_stamp(language: str, date: date) -> Markup:
    """Write a day as a page says it, in an element that programs read."""
    return Markup('<time datetime="{:%Y-%m-%d}">{}</time>').format(date, day(language, date))


def _element(moment: datetime | None, text: str) -> Markup:
    if moment is None:
        return Markup(text)
    return Markup('<time datetime="{}">{}</time>').format(moment.astimezone(UTC).isoformat(timespec="seconds"), text)


def day(language: str, date: date) -> str:
    """Write a day as a page says it."""
    month = say(language, "dates.months").split()[date.month - 1]
    return say(language, "dates.day", day=date.day, month=month, year=date.year)


def left(until: datetime | None, now: datetime) -> tuple[str, int, int] | None:
    """Give the time left in two parts, with the unit: days and hours, hours and minutes; none once it is up."""
    minutes = int((until - now) / timedelta(minutes=1)) if until is not None and until > now else None
    if minutes is None:
        return None
    return ("days", *divmod(minutes // 60, 24)) if minutes >= 24 * 60 else ("hours", *divmod(minutes, 60))


def seconds_left(until: datetime | None, now: datetime) -> int:
    """Give the whole seconds left, 0 once the time is up or where it has no end."""
    return 0 if until is None else max(0, int((until - now).total_seconds()))


def shifted(moment: datetime, days: int, place: ZoneInfo) -> datetime:
    """Move a moment by whole days; the hour on the wall stays."""
    wall = moment.astimezone(place).replace(tzinfo=None) + timedelta(days=days)
    return wall.replace(tzinfo=place).astimezone(UTC)
