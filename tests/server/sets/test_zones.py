"""People are told moments in the zone of their course, with the zone where it matters, and programs can read them."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import datetime
from zoneinfo import ZoneInfo

from starlette.testclient import TestClient

from tests.server.answering.test_pages import post
from tests.server.sets.conftest import Course

MOMENT = re.compile(r'<time datetime="([^"]+\+00:00)">([^<]+)</time>')
WRONG = {"l3": "1 m"}


def of_the_receipt(page: str) -> tuple[datetime, str]:
    """Give the moment of the receipt on a page, as programs and as people read it."""
    found = MOMENT.search(page, page.index('class="receipt"'))
    assert found
    return datetime.fromisoformat(found[1]), found[2]


def test_practice_without_an_account_names_its_zone(client: TestClient, deal: Callable[..., str]) -> None:
    moment, said = of_the_receipt(post(client, deal("slider_crank", 7), WRONG))
    assert said == f"{moment.day} {moment:%b %Y, %H:%M:%S} (UTC)"


def test_a_receipt_of_a_set_is_told_in_the_zone_of_the_course(course: Course) -> None:
    variant = course.variant(course.published())
    receipt = course.hand_in(variant, WRONG).json()["receipt"]
    moment, said = of_the_receipt(course.student.get(f"/variants/{variant}?lang=pl").text)
    assert moment == datetime.fromisoformat(receipt["time"]).replace(microsecond=0)
    assert said == f"{moment.astimezone(ZoneInfo('Europe/Warsaw')):%d.%m.%Y, %H:%M:%S} (Europe/Warsaw)"


def test_practice_of_a_student_is_told_in_the_zone_of_the_course(course: Course) -> None:
    variant = course.student.post("/api/v1/exercises/slider_crank/variants", json={}).json()["id"]
    course.student.put(f"/api/v1/variants/{variant}/draft", json={"answers": WRONG, "revision": 0})
    page = course.student.get(f"/variants/{variant}?lang=pl").text
    saved = re.search(r"data-draft-state>(.*?)</span>", page)
    assert saved and re.search(r">\d\d:\d\d \(Europe/Warsaw\)</time>", saved[1])


def test_no_page_of_an_account_writes_a_moment_that_programs_cannot_read(course: Course) -> None:
    page = course.student.get("/account?lang=en").text
    assert len(MOMENT.findall(page)) >= 2 and "Time zone: Europe/Warsaw" in page and "UTC" not in page


def test_a_report_says_when_it_was_received_in_the_zone_of_the_course(course: Course) -> None:
    variant = course.variant(course.published(item={"exercise": "tmm2_oop"}))
    receipt = course.hand_in(variant, {"conclusions": "Ruch."}).json()["receipt"]["id"]
    written = course.student.get(f"/api/v1/reports/tmm2/{variant}.md?lang=pl&receipt={receipt}").text
    assert re.search(r"Przyjęto: [\d\\.]+, [\d:]+ \\\(Europe/Warsaw\\\)", written)
