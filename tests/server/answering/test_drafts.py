"""A draft is kept over the revision it was typed over, found again on another device, and nobody else's."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import timedelta
from typing import Any

import pytest
from starlette.testclient import TestClient

from server.database import Database
from server.storage import Draft, Problem, UnknownVariant
from tests.server.test_database import NOW, VARIANT
from tests.server.test_policy import bearer

EN = {"accept-language": "en"}


def put(client: TestClient, number: str, revision: int, **answers: Any) -> Any:
    return client.put(f"/api/v1/variants/{number}/draft", json={"answers": answers, "revision": revision})


def kept(client: TestClient, number: str) -> Any:
    return client.get(f"/api/v1/variants/{number}/draft").json()


def test_a_draft_is_found_again_as_it_was_typed(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    assert kept(client, number) == {"answers": {}, "revision": 0, "time": None}
    first = put(client, number, 0, l3=" 1,2", v3=["1", "m/"]).json()
    assert first["revision"] == 1 and first == kept(client, number)
    assert first["answers"] == {"l3": " 1,2", "v3": ["1", "m/"]}
    assert put(client, number, 1, l3="2").json()["revision"] == 2
    assert kept(client, number)["answers"] == {"l3": "2"}


def test_the_page_shows_the_draft_without_script(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    client.post(f"/variants/{number}", data={"answer.l3": "17 mm", "answer.v3": "1 m/s"})
    put(client, number, 1, l3="18 mm", v3="1 m/s")
    page = client.get(f"/variants/{number}", headers=EN).text
    assert 'value="18 mm"' in page and 'data-revision="2"' in page
    assert page.count('class="verdict v-wrong"') == 1  # of v3: what is typed in l3 now was not judged
    client.post(f"/variants/{number}", data={"answer.l3": "19 mm"})
    assert 'value="19 mm"' in client.get(f"/variants/{number}").text  # handed in after the draft


def test_a_look_at_the_reading_keeps_the_draft(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    for text in ("1", "2"):
        client.post(f"/variants/{number}/preview", data={"answer.l3": text})
    assert kept(client, number)["answers"]["l3"] == "2" and kept(client, number)["revision"] == 2


def test_a_draft_typed_over_an_older_one_is_not_kept(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    put(client, number, 0, l3="1")
    reply = put(client, number, 0, l3="2")
    assert (reply.status_code, reply.json()["error"]["code"]) == (409, "draft_changed")
    assert kept(client, number)["answers"] == {"l3": "1"}


def test_of_twenty_drafts_over_one_revision_one_is_kept(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    with ThreadPoolExecutor(20) as pool:
        codes = sorted(pool.map(lambda text: put(client, number, 0, l3=str(text)).status_code, range(20)))
    assert codes == [200] + [409] * 19 and kept(client, number)["revision"] == 1


@pytest.mark.parametrize(
    "body",
    [
        {"answers": {"zz": "1"}, "revision": 0},
        {"answers": {"l3": 1}, "revision": 0},
        {"answers": {}, "revision": -1},
        {"answers": {}, "revision": True},
        {"answers": {}, "revision": 2**40},
        {"answers": {}, "revision": 0, "time": "2026-01-01"},
        {"answers": {}},
    ],
)
def test_what_is_no_draft_is_refused(client: TestClient, deal: Callable[..., str], body: Any) -> None:
    number = deal()
    assert client.put(f"/api/v1/variants/{number}/draft", json=body).status_code == 422
    assert kept(client, number)["revision"] == 0


def test_a_draft_larger_than_a_submission_may_be_is_refused(client: TestClient, deal: Callable[..., str]) -> None:
    assert put(client, deal(), 0, l3="1" * 70_000).status_code == 413


def test_nobody_else_reads_or_writes_a_draft(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    put(client, number, 0, l3="1")
    client.cookies.clear()
    for stranger in (bearer("student", "bob"), bearer("lecturer"), {}):
        path = f"/api/v1/variants/{number}/draft"
        assert client.get(path, headers=stranger).status_code == 404
        assert client.put(path, json={"answers": {}, "revision": 1}, headers=stranger).status_code == 404


def test_a_draft_goes_with_its_variant_unless_a_problem_is_open(database: Database) -> None:
    practice = database.practice

    async def work() -> None:
        await practice.keep_variant(VARIANT)
        draft = Draft(VARIANT.id, {"l3": "1"}, NOW, 1)
        assert await practice.keep_draft(draft) == (draft, True)
        assert await practice.keep_draft(draft) == (draft, False)
        newer = replace(draft, answers={}, revision=2)
        assert await practice.keep_draft(newer) == (newer, True) and await practice.draft(VARIANT.id) == newer
        problem = Problem("P1", VARIANT.id, VARIANT.owner.id, "x", NOW)
        assert await practice.keep_problem(problem, 1) and not await practice.keep_problem(replace(problem, id="P2"), 1)
        late = NOW + timedelta(days=1)
        assert await practice.purge(late) == 0
        (found,) = await practice.problems(late, 9, None)
        assert (found.exercise, found.version, found.seed) == ("slider_crank", 4, 2**53 - 1)
        assert await practice.settle_problem("P1", NOW, None) and not await practice.settle_problem("P1", NOW, None)
        assert await practice.problems(late, 9, None) == []
        assert await practice.purge(late) == 1 and await practice.draft(VARIANT.id) is None
        with pytest.raises(UnknownVariant):
            await practice.keep_draft(draft)

    asyncio.run(work())


def test_a_draft_on_its_way_while_its_answers_are_handed_in_is_not_kept(
    client: TestClient, deal: Callable[..., str]
) -> None:
    for number, revision in ((deal(), 0), (deal(seed=8), 1)):
        if revision:
            put(client, number, 0, l3="17")
        client.post(f"/variants/{number}", data={"answer.l3": "18 mm"})
        late = put(client, number, revision, l3="17 m")
        assert (late.status_code, late.json()["error"]["code"]) == (409, "draft_changed")
        assert kept(client, number)["answers"]["l3"] == "18 mm"
        assert 'value="18 mm"' in client.get(f"/variants/{number}").text
        assert put(client, number, revision + 1, l3="19").json()["revision"] == revision + 2


def test_an_earlier_receipt_shows_what_was_handed_in_and_is_only_looked_at(
    client: TestClient, deal: Callable[..., str]
) -> None:
    number = deal()
    first = client.post(f"/variants/{number}", data={"answer.l3": "17 mm"}).url.params["receipt"]
    last = client.post(f"/variants/{number}", data={"answer.l3": "18 mm"}).url.params["receipt"]
    put(client, number, 2, l3="19 mm")
    old = client.get(f"/variants/{number}?receipt={first}", headers=EN).text
    assert 'value="17 mm"' in old and "<fieldset" in old and "This is what you handed in" in old
    assert "data-draft" not in old and "Check answers" not in old
    new = client.get(f"/variants/{number}?receipt={last}", headers=EN).text
    assert 'value="19 mm"' in new and 'data-revision="3"' in new and "Check answers" in new
