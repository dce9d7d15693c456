"""A25: the moment of receipt decides; a key belongs to its user, its variant and its body; no client's clock counts."""

from __future__ import annotations

from tests.server.sets.conftest import Course


def test_a_replay_after_closing_gives_the_old_receipt_and_takes_nothing_new(course: Course) -> None:
    number = course.published()
    variant = course.variant(number)
    first = course.hand_in(variant, {"l3": "1 m"}, "k").json()
    course.move(number, seconds=1)
    assert course.hand_in(variant, {"l3": "1 m"}, "k").json() == first
    assert course.hand_in(variant, {"l3": "2 m"}, "k").json()["error"]["code"] == "key_reused"
    assert course.hand_in(variant, {"l3": "1 m"}, "k2").json()["error"]["code"] == "set_closed"
    assert len(course.student.get(f"/api/v1/task-sets/{number}").json()["items"][0]["ledger"]) == 1


def test_the_clock_of_a_client_moves_nothing(course: Course) -> None:
    number = course.published()
    variant = course.variant(number)
    course.move(number, seconds=1)
    early = {"date": "Sun, 29 Nov 2020 00:00:00 GMT", "if-modified-since": "Sun, 29 Nov 2020 00:00:00 GMT"}
    path = f"/api/v1/variants/{variant}/submissions"
    assert course.student.post(path, json={"answers": {}}, headers=early).json()["error"]["code"] == "set_closed"
    timed = course.student.post(path, json={"answers": {}, "time": "2020-11-29T00:00:00Z"})
    assert (timed.status_code, timed.json()["error"]["code"]) == (422, "extra_field")


def test_a_key_of_somebody_else_is_another_key(course: Course) -> None:
    number = course.published()
    mine, theirs = course.variant(number), course.variant(number, course.other)
    first = course.hand_in(mine, {"l3": "1 m"}, "k").json()
    second = course.hand_in(theirs, {"l3": "1 m"}, "k", who=course.other)
    assert second.status_code == 201 and second.json()["receipt"]["id"] != first["receipt"]["id"]
    assert course.hand_in(mine, {"l3": "1 m"}, "k", who=course.other).status_code == 404
