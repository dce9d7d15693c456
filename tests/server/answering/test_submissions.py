"""A submission is graded, stored, acknowledged by a receipt, and the same again for the same key."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime
from threading import current_thread
from typing import Any

import pytest
from sqlalchemy import func, select
from starlette.testclient import TestClient

from exercises import grading
from exercises.exercise import Submission
from exercises.variants import deal as dealt_by_hand
from server.database.engine import engine
from server.judging.thread import JudgingThread
from server.settings import Settings
from server.tables import submissions

RIGHT = grading.reference(dealt_by_hand("slider_crank", 7))


def hand_in(client: TestClient, number: str, answers: Any, key: str | None = None, language: str = "en") -> Any:
    headers = {"idempotency-key": key} if key else {}
    path = f"/api/v1/variants/{number}/submissions?lang={language}"
    return client.post(path, json={"answers": answers}, headers=headers)


def stored(settings: Settings) -> int:
    store = engine(settings.store_url, connections=1)
    with store.connect() as connection:
        number: int = connection.execute(select(func.count()).select_from(submissions)).scalar_one()
    store.dispose()
    return number


def test_the_reference_is_graded_right_and_receipted(client: TestClient, deal: Callable[..., str]) -> None:
    reply = hand_in(client, deal(), RIGHT)
    body = reply.json()
    assert reply.status_code == 201 and body["score"] == 1.0 and body["counted"] is True
    assert {verdict["outcome"] for verdict in body["verdicts"].values()} == {"right"}
    assert set(body["receipt"]) == {"id", "time", "digest"}
    assert abs((datetime.now(UTC) - datetime.fromisoformat(body["receipt"]["time"])).total_seconds()) < 60


def test_missing_empty_and_unreadable_answers_are_unreadable(client: TestClient, deal: Callable[..., str]) -> None:
    body = hand_in(client, deal(), {"l3": "", "v3": "1 m/", "omega2": "2"}).json()
    verdicts = body["verdicts"]
    assert verdicts["alpha2"]["code"] == verdicts["l3"]["code"] == "empty"
    assert verdicts["v3"]["code"] == "unreadable" and verdicts["v3"]["position"] is not None
    assert verdicts["omega2"]["outcome"] == "wrong"
    assert hand_in(client, deal(), {}).json()["counted"] is False


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_a_recognised_mistake_is_hinted_in_the_reader_s_language(
    client: TestClient, deal: Callable[..., str], language: str
) -> None:
    number = deal()
    wrong = {"omega2_formula": "-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"}
    body = hand_in(client, number, wrong, language=language).json()
    assert len(body["hints"]) == 1 and "<math>" in body["hints"][0]
    assert body["verdicts"]["omega2_formula"]["message"]


def test_a_later_answer_is_followed_through(client: TestClient, deal: Callable[..., str]) -> None:
    variant = dealt_by_hand("slider_crank", 7)
    g = variant.givens
    alpha2 = math.degrees(-math.asin(g.l1 * math.sin(g.alpha1) / g.l2))
    slip = -alpha2
    l3 = 1000 * (g.l1 * math.cos(g.alpha1) + g.l2 * math.cos(math.radians(slip)))
    body = hand_in(client, deal(), {"alpha2": f"{slip}°", "l3": f"{l3} mm"}).json()
    assert body["verdicts"]["alpha2"]["outcome"] == "wrong"
    assert body["verdicts"]["l3"]["outcome"] == "right"


def test_lists_of_lines_are_answers_too(client: TestClient, deal: Callable[..., str]) -> None:
    body = hand_in(client, deal(), {"l3": [RIGHT["l3"]], "v3": []}).json()
    assert body["verdicts"]["l3"]["outcome"] == "right" and body["verdicts"]["v3"]["code"] == "empty"
    assert body["answers"] == {"l3": [RIGHT["l3"]], "v3": []}


def test_a_submission_is_looked_up_by_its_receipt(client: TestClient, deal: Callable[..., str]) -> None:
    body = hand_in(client, deal(), {"l3": " 1,25  m "}).json()
    found = client.get(f"/api/v1/submissions/{body['receipt']['id']}?lang=en").json()
    assert found == body and found["answers"] == {"l3": " 1,25  m "}


def test_the_same_key_and_body_give_the_first_response(
    client: TestClient, settings: Settings, deal: Callable[..., str]
) -> None:
    number = deal()
    first = hand_in(client, number, {"l3": "1"}, "k", "pl")
    again = hand_in(client, number, {"l3": "1"}, "k", "ru")
    assert (first.status_code, again.status_code) == (201, 200)
    assert again.json() == first.json()
    assert stored(settings) == 1


def test_the_same_key_with_another_body_is_a_conflict(
    client: TestClient, settings: Settings, deal: Callable[..., str]
) -> None:
    number = deal()
    hand_in(client, number, {"l3": "1"}, "k")
    reply = hand_in(client, number, {"l3": "2"}, "k")
    assert (reply.status_code, reply.json()["error"]["code"]) == (409, "key_reused")
    assert stored(settings) == 1


def test_a_key_is_one_variant_s_own(client: TestClient, settings: Settings, deal: Callable[..., str]) -> None:
    assert [hand_in(client, deal(), {"l3": "1"}, "k").status_code for _ in range(2)] == [201, 201]
    assert stored(settings) == 2


def test_twenty_posts_at_once_with_one_key_are_one_submission(
    client: TestClient, settings: Settings, deal: Callable[..., str]
) -> None:
    number = deal()
    with ThreadPoolExecutor(20) as pool:
        replies = list(pool.map(lambda _: hand_in(client, number, {"l3": "1"}, "k"), range(20)))
    assert sorted(reply.status_code for reply in replies) == [200] * 19 + [201]
    assert len({reply.json()["receipt"]["id"] for reply in replies}) == 1
    assert stored(settings) == 1


@pytest.mark.parametrize("key", ["", "x" * 65, "a\tb", "ż"])
def test_a_key_that_cannot_be_one_is_refused(client: TestClient, deal: Callable[..., str], key: str) -> None:
    path = f"/api/v1/variants/{deal()}/submissions"
    reply = client.post(path, json={"answers": {}}, headers={b"idempotency-key": key.encode()})
    assert reply.status_code == 422


def test_what_is_refused_leaves_nothing_behind(
    client: TestClient, settings: Settings, deal: Callable[..., str]
) -> None:
    number = deal()
    for answers in ({"zz": "1"}, {"l3": 1}, None):
        assert hand_in(client, number, answers).status_code == 422
    assert stored(settings) == 0


def test_a_failure_of_ours_is_a_grade_that_costs_nothing(
    client: TestClient, deal: Callable[..., str], monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(submission: Submission, secret: bytes) -> None:
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(grading, "grade", fail)
    body = hand_in(client, deal(), RIGHT).json()
    assert {verdict["outcome"] for verdict in body["verdicts"].values()} == {"fault"}
    assert body["counted"] is False and body["provisional"] is True and body["receipt"]["id"]
    assert "a bug" in caplog.text


def thread_name() -> str:
    return current_thread().name


def test_grading_runs_on_one_thread_of_its_own() -> None:
    async def names() -> set[str]:
        judging = JudgingThread()
        found = await asyncio.gather(*(judging.run(thread_name) for _ in range(20)))
        judging.close()
        return set(found)

    assert asyncio.run(names()) == {"judge_0"}


@pytest.mark.parametrize(
    ("body", "name"),
    [
        ('{"answers": {"l3": "1 m", "l3": "204 mm"}}', "l3"),
        ('{"answers": {"l3": "1 m"}, "answers": {}}', "answers"),
        ('{"answers": {"v3": "", "\\u006c3": "1", "l3": "2"}}', "l3"),
    ],
)
def test_an_answer_given_twice_is_refused_and_not_stored(
    client: TestClient, settings: Settings, deal: Callable[..., str], body: str, name: str
) -> None:
    reply = client.post(
        f"/api/v1/variants/{deal()}/submissions", content=body, headers={"content-type": "application/json"}
    )
    assert (reply.status_code, reply.json()["error"]["code"], reply.json()["error"]["field"]) == (
        422, "repeated_name", name,
    )  # fmt: skip
    assert stored(settings) == 0
