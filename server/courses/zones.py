"""The time zone in which moments are told: the course's; in practice that of the reader's newest course, else UTC."""

from __future__ import annotations

from datetime import UTC, tzinfo
from functools import partial
from typing import Any

from server.reader import Reader
from server.sets import clock
from server.storage import Dealt
from server.workbench import Bench


async def of_reader(bench: Bench, reader: Reader) -> tzinfo:
    """Give the zone of the newest course of a reader; UTC for one who is in none."""
    mine = await bench.courses.of(reader.person.id) if reader.person else ()
    return clock.zone(mine[0][0].time_zone) if mine else UTC


async def of_variant(bench: Bench, reader: Reader, dealt: Dealt) -> tzinfo:
    """Give the zone of the course in which a variant was dealt; in practice the reader's."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    course = await bench.courses.course(place.task_set.course) if place else None
    return clock.zone(course.time_zone) if course else await of_reader(bench, reader)


def told(language: str, place: tzinfo) -> dict[str, Any]:
    """Give what a page needs to tell moments in a zone."""
    return {
        "zone": str(place),
        "local": partial(clock.stamp, language, place=place),
        "exact": partial(clock.exact_stamp, language, place=place),
        "hour": partial(clock.hour_stamp, place=place),
    }
