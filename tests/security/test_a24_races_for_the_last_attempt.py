"""A24: many posts at once use up the last attempt once, first opens deal one card, clicks buy a hint once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from server.app import create_app
from server.settings import Settings
from tests.depth import amount
from tests.server.conftest import SECRET
from tests.server.sets.conftest import Course, made
from tests.server.stores import Postgres, lay

MANY = amount(40, 100)


@pytest.fixture
def two_servers(tmp_path: Path, postgres: Postgres) -> Iterator[tuple[Course, TestClient]]:
    """A course on PostgreSQL, and the student at another server of the same store."""
    settings = Settings(tmp_path, database_url=postgres.empty(), secret=SECRET, limited=False)
    lay(settings)
    for course in made(settings):
        with TestClient(create_app(settings), raise_server_exceptions=False) as other:
            other.cookies.update(course.student.cookies)
            yield course, other


def test_of_many_posts_to_two_servers_of_one_store_one_is_counted(two_servers: tuple[Course, TestClient]) -> None:
    course, other = two_servers
    number = course.published(item={"attempts": 1})
    variant, doors = course.variant(number), (course.student, other)
    with ThreadPoolExecutor(20) as pool:
        replies = list(
            pool.map(lambda n: course.hand_in(variant, {"l3": f"{n} m"}, who=doors[n % 2]), range(1, MANY + 1))
        )
    assert Counter(reply.status_code for reply in replies) == {201: 1, 403: MANY - 1}
    item = course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]
    assert (item["left"], len(item["ledger"])) == (0, 1)
    keyed = course.variant(course.published(item={"attempts": 9}))
    with ThreadPoolExecutor(20) as pool:
        same = list(pool.map(lambda n: course.hand_in(keyed, {"l3": "1 m"}, "one", who=doors[n % 2]).json(), range(20)))
    assert len({reply["receipt"]["id"] for reply in same}) == 1


def test_of_many_posts_with_one_attempt_left_one_is_counted(course: Course) -> None:
    number = course.published(item={"attempts": 1})
    variant = course.variant(number)
    with ThreadPoolExecutor(20) as pool:
        replies = list(pool.map(lambda n: course.hand_in(variant, {"l3": f"{n} m"}), range(1, MANY + 1)))
    assert Counter(reply.status_code for reply in replies) == {201: 1, 403: MANY - 1}
    item = course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]
    assert (item["left"], len(item["ledger"])) == (0, 1)


def test_the_same_answers_from_a_nervous_hand_cost_one_attempt(course: Course) -> None:
    number = course.published(item={"attempts": 3})
    variant = course.variant(number)
    with ThreadPoolExecutor(10) as pool:
        replies = list(pool.map(lambda _: course.hand_in(variant, {"l3": "1 m"}).json(), range(20)))
    assert sum(reply["counted"] for reply in replies) == 1
    assert course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["left"] == 2


def test_first_opens_at_once_deal_one_card(course: Course) -> None:
    number = course.published()
    with ThreadPoolExecutor(20) as pool:
        replies = list(pool.map(lambda _: course.open(number).json()["id"], range(20)))
    assert len(set(replies)) == 1


def test_many_clicks_buy_a_hint_once(course: Course) -> None:
    number = course.published(rules={"ladder": True, "hint_price": 0.2}, item={"attempts": None})
    variant = course.variant(number)
    course.hand_in(variant, {"l3": "9 m"})
    step = {"answer": "l3", "rung": "1"}
    with ThreadPoolExecutor(20) as pool:
        replies = list(pool.map(lambda _: course.student.post(f"/variants/{variant}/hints", data=step), range(MANY)))
    assert Counter(reply.status_code for reply in replies) == {303: MANY}
    assert [one.rung for one in course.school.portal.call(course.school.bench.sets.hints, variant)] == [1]
