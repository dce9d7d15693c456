"""A school whose lecturer builds sets; decks are small and drawn in this process, so that tests stay short."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import cached_property
from typing import Any

import pytest
from starlette.testclient import TestClient

from exercises import verifying
from exercises.verifying import verify
from server.judging.thread import JudgingThread
from server.sets import dealing, pages
from server.settings import Settings
from server.storage.sets import Card
from tests.conftest import Laid
from tests.depth import amount
from tests.server.conftest import SECRET
from tests.server.school import School, opened

EXERCISE = "slider_crank"


def gate(exercise: str, seeds: Iterable[int]) -> verifying.Report:
    """Pass an exercise through the gate on the first card of a deck alone, unless everything is asked for."""
    deck = list(seeds)
    return verify(exercise, deck[: amount(1, len(deck))])


async def in_this_process(judging: JudgingThread, compute: Callable[..., Any], tasks: Sequence[Any]) -> list[Any]:
    """Compute long tasks here."""
    return [await judging.run(compute, *task) for task in tasks]


@dataclass
class Course:
    """The school with browsers of its lecturer and its two students."""

    school: School

    @cached_property
    def lecturer(self) -> TestClient:
        return self.school.browser("lecturer")

    @cached_property
    def student(self) -> TestClient:
        return self.school.browser("student")

    @cached_property
    def other(self) -> TestClient:
        return self.school.browser("other")

    def built(self, **changes: Any) -> str:
        """Build a set of one slot with two attempts; gives its number."""
        items = [{"exercise": EXERCISE, "points": 10, "attempts": 2, **changes.pop("item", {})}]
        body = {"course": self.school.course, "title": "Set 4", "items": items, "due": moment(hours=1), **changes}
        reply = self.lecturer.post("/api/v1/task-sets", json=body)
        assert reply.status_code == 201, reply.text
        number: str = reply.json()["id"]
        return number

    def published(self, **changes: Any) -> str:
        """Build and publish a set; gives its number."""
        number = self.built(**changes)
        reply = self.lecturer.post(f"/api/v1/task-sets/{number}/open")
        assert reply.status_code == 200, reply.text
        return number

    def open(self, number: str, who: TestClient | None = None, **body: Any) -> Any:
        """Open the first task as a student."""
        return (who or self.student).post(f"/api/v1/task-sets/{number}/items/1/variant", json=body)

    def variant(self, number: str, who: TestClient | None = None) -> str:
        """Give the number of a student's variant of the first task."""
        reply = self.open(number, who)
        assert reply.status_code == 200, reply.text
        found: str = reply.json()["id"]
        return found

    def card(self, number: str, who: str = "student") -> Card:
        """Give a student's card of the first task, with what nobody is served."""
        found = self.school.portal.call(self.school.bench.sets.cards, number, self.school.people[who])
        return [card for card in found if card.variant][-1]

    def hand_in(self, variant: str, answers: Any, key: str | None = None, who: TestClient | None = None) -> Any:
        """Hand in answers."""
        headers = {"idempotency-key": key} if key else {}
        path = f"/api/v1/variants/{variant}/submissions?lang=en"
        return (who or self.student).post(path, json={"answers": answers}, headers=headers)

    def move(self, number: str, **ago: float) -> None:
        """Let a set have been due some time ago."""
        self.date(number, datetime.now(UTC) - timedelta(**ago), None)

    def date(self, number: str, due: datetime | None, closes: datetime | None) -> None:
        """Give a set other deadlines."""
        call, sets = self.school.portal.call, self.school.bench.sets
        old = call(sets.task_set, number)
        assert old is not None
        call(sets.move, [(old, replace(old, due=due, closes=closes))])


def moment(**ahead: float) -> str:
    """Write a moment from now, with its offset."""
    return (datetime.now(UTC) + timedelta(**ahead)).isoformat()


def made(settings: Settings) -> Iterator[Course]:
    """Open a school with small decks."""
    with pytest.MonkeyPatch.context() as patch, opened(settings) as school:
        patch.setattr(dealing, "LEAST_CARDS", 4)
        patch.setattr(verifying, "verify", gate)
        patch.setattr(JudgingThread, "apart", in_this_process)
        patch.setattr(pages, "PATIENCE", 60.0)  # a slow machine is no reason to look at the job
        yield Course(school)


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[Course]:
    """A school that the tests of a module share."""
    yield from made(laid_for_all(tmp_path_factory.mktemp("school"), secret=SECRET, limited=False))
