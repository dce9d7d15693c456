"""Jobs in both databases: a batch is taken under a fence and written once."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest

from server.database import Database
from server.database.jobs import MOST_FAILURES, Jobs
from server.settings import Settings
from server.storage.jobs import Batch, Busy, Fenced, Job, Kept, Order
from tests.server.jobs.counting import COUNTING, KIND, left, order
from tests.server.stores import lay


@pytest.fixture(scope="module", params=["sqlite", "postgres"])
def store(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Database]:
    """A store that the tests of this module share; each works on jobs of its own."""
    url = request.getfixturevalue("shared_database_url") if request.param == "postgres" else None
    made = Database(lay(Settings(tmp_path_factory.mktemp("jobs"), database_url=url)))
    yield made
    made.close()


@pytest.fixture
def jobs(store: Database, request: pytest.FixtureRequest) -> Iterator[Jobs]:
    """The jobs of the store; what a test has left under way is ended."""
    yield store.jobs
    store.jobs.lease = 30.0
    while (batch := take(store.jobs)) is not None:
        asyncio.run(store.jobs.cancel(COUNTING, batch.job))


def started(jobs: Jobs, pieces: Sequence[Any], subject: str) -> str:
    made: Order = order(pieces, subject)
    asyncio.run(jobs.start(made))
    return made.id


def take(jobs: Jobs, worker: str = "one") -> Batch | None:
    return asyncio.run(jobs.take(worker))


def held(jobs: Jobs, number: str, batch: int = 1, worker: str = "one") -> Batch:
    taken = asyncio.run(jobs.take_one(worker, number, batch))
    assert taken is not None
    return taken


def keep(jobs: Jobs, batch: Batch, outcome: int = 7) -> None:
    asyncio.run(jobs.keep(COUNTING, batch, outcome))


def job(jobs: Jobs, number: str) -> Job:
    found = asyncio.run(jobs.job(number))
    assert found is not None
    return found


def rows(jobs: Jobs, number: str) -> Any:
    return asyncio.run(jobs.plan(lambda connection: [left(connection, number)]))[0]


def test_a_job_is_done_when_its_last_batch_is_written(jobs: Jobs) -> None:
    number = started(jobs, [1, 2], "done")
    assert job(jobs, number).state == "waiting"
    for batch in (1, 2):
        keep(jobs, held(jobs, number, batch), 10 * batch)
        assert (job(jobs, number).done, job(jobs, number).live) == (batch, batch == 1)
    found = job(jobs, number)
    assert (found.state, found.result, found.finished is None) == ("done", {"sum": 30}, False)
    assert asyncio.run(jobs.results(number, 0, 9)) == [(1, 10), (2, 20)]
    assert asyncio.run(jobs.content(number, 1)) == b"document"
    assert asyncio.run(jobs.latest(KIND, "done")) == found


def test_a_batch_is_in_one_pair_of_hands(jobs: Jobs) -> None:
    number = started(jobs, [1], "hands")
    held(jobs, number)
    assert asyncio.run(jobs.take_one("two", number, 1)) is None
    assert asyncio.run(jobs.take_one("two", number, 2)) is None


def test_who_comes_after_the_lease_writes_nothing(jobs: Jobs) -> None:
    number = started(jobs, [1, 2], "late")
    jobs.lease = -1.0
    slow = held(jobs, number, worker="slow")
    jobs.lease = 30.0
    other = held(jobs, number, worker="other")
    assert (slow.fence, other.fence) == (1, 2)
    assert not asyncio.run(jobs.renew(slow)) and asyncio.run(jobs.renew(other))
    with pytest.raises(Fenced):
        keep(jobs, slow, 1)
    assert (rows(jobs, number), job(jobs, number).done) == (0, 0)
    keep(jobs, other, 2)
    for late in (slow, other):
        with pytest.raises(Fenced):
            keep(jobs, late, 3)
    assert (rows(jobs, number), job(jobs, number).done) == (1, 1)


def test_how_far_a_batch_is_stands_until_another_begins_it_anew(jobs: Jobs) -> None:
    made = order([4, 5], "parts", parts=9)
    asyncio.run(jobs.start(made))
    batch = held(jobs, made.id)
    assert asyncio.run(jobs.renew(batch, 6))
    assert reached(jobs, made.id) == [(4, 6, 9), (5, 0, 9)]
    asyncio.run(jobs.give_back(batch))
    again = held(jobs, made.id)
    assert reached(jobs, made.id) == [(4, 0, 9), (5, 0, 9)] and not asyncio.run(jobs.renew(batch, 8))
    keep(jobs, again)
    assert reached(jobs, made.id) == [(4, 9, 9), (5, 0, 9)]


def test_a_batch_that_came_to_nothing_is_over_and_none_of_its_parts_is_done(jobs: Jobs) -> None:
    made = order([4, 5], "refused", parts=9)
    asyncio.run(jobs.start(made))
    batch = held(jobs, made.id)
    assert asyncio.run(jobs.renew(batch, 6))
    refusing = replace(COUNTING, write=lambda connection, batch, outcome: Kept({}, refused=True))
    asyncio.run(jobs.keep(refusing, batch, None))
    found = asyncio.run(jobs.progress(made.id))
    assert [(one.reached, one.refused) for one in found] == [(0, True), (0, False)]
    assert job(jobs, made.id).done == 1


def test_a_batch_of_a_job_that_was_cancelled_is_not_kept_for_longer(jobs: Jobs) -> None:
    number = started(jobs, [1], "cancelled meanwhile")
    batch = held(jobs, number)
    asyncio.run(jobs.cancel(COUNTING, number))
    assert not asyncio.run(jobs.renew(batch))


def reached(jobs: Jobs, number: str) -> list[tuple[Any, int, int]]:
    return [(one.piece, one.reached, one.parts) for one in asyncio.run(jobs.progress(number))]


def test_a_batch_whose_lease_is_over_is_taken_back(jobs: Jobs) -> None:
    number = started(jobs, [1], "silent")
    jobs.lease = -1.0
    held(jobs, number)
    jobs.lease = 30.0
    assert asyncio.run(jobs.take_back()) == 1
    assert asyncio.run(jobs.take_back()) == 0
    assert held(jobs, number).fence == 2


def test_a_worker_that_is_started_anew_takes_back_what_it_had(jobs: Jobs) -> None:
    number = started(jobs, [1, 2], "anew")
    held(jobs, number, 1, "mine"), held(jobs, number, 2, "other")
    assert asyncio.run(jobs.take_back("mine")) == 1
    assert held(jobs, number, 1).fence == 2
    assert asyncio.run(jobs.take_one("mine", number, 2)) is None


def test_shorter_jobs_go_first(jobs: Jobs) -> None:
    long, short = started(jobs, [1, 2, 3], "long"), started(jobs, [1, 2], "short")
    taken = [take(jobs) for _ in range(6)]
    assert [batch and (batch.job, batch.number) for batch in taken] == [
        (short, 1), (short, 2), (long, 1), (long, 2), (long, 3), None,
    ]  # fmt: skip


def test_a_subject_has_one_live_job_of_a_kind(jobs: Jobs) -> None:
    number = started(jobs, [1], "only")
    with pytest.raises(Busy, match=number):
        started(jobs, [1], "only")
    keep(jobs, held(jobs, number))
    assert started(jobs, [1], "only") != number


def test_a_record_that_cannot_be_written_starts_no_job(jobs: Jobs) -> None:
    def refuse(connection: Any) -> None:
        raise ValueError("no")

    made = order([1], "refused")
    with pytest.raises(ValueError, match="no"):
        asyncio.run(jobs.start(made, refuse))
    assert asyncio.run(jobs.job(made.id)) is None


def test_a_batch_that_keeps_failing_ends_its_job_and_leaves_nothing(jobs: Jobs) -> None:
    number = started(jobs, [1, 2], "failing")
    keep(jobs, held(jobs, number, 1))
    for failure in range(MOST_FAILURES):
        assert job(jobs, number).live
        asyncio.run(jobs.fail(COUNTING, held(jobs, number, 2), f"fault {failure}"))
    found = job(jobs, number)
    assert (found.state, found.error, rows(jobs, number)) == ("failed", f"fault {MOST_FAILURES - 1}", 0)


def test_a_job_whose_ending_is_a_failure_leaves_nothing(jobs: Jobs) -> None:
    number = started(jobs, [1], "too much")
    keep(jobs, held(jobs, number), 20_000)
    found = job(jobs, number)
    assert (found.state, found.result, rows(jobs, number)) == ("failed", {"sum": 20_000}, 0)


def test_a_cancelled_job_takes_no_more(jobs: Jobs) -> None:
    number = started(jobs, [1, 2, 3], "cancelled")
    keep(jobs, held(jobs, number, 1))
    under_way = held(jobs, number, 2)
    assert asyncio.run(jobs.cancel(COUNTING, number))
    assert not asyncio.run(jobs.cancel(COUNTING, number))
    with pytest.raises(Fenced):
        keep(jobs, under_way)
    assert asyncio.run(jobs.take_one("two", number, 3)) is None
    assert (job(jobs, number).state, rows(jobs, number)) == ("cancelled", 0)


def test_documents_are_forgotten_after_a_while(jobs: Jobs) -> None:
    number = started(jobs, [1], "old")
    keep(jobs, held(jobs, number))
    for later, kept in ((-1, b"document"), (1, None)):
        asyncio.run(jobs.forget(datetime.now(UTC) + timedelta(hours=later)))
        assert asyncio.run(jobs.content(number, 1)) == kept
