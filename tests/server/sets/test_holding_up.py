"""What lecturers build holds up nobody who waits for a verdict: the judge is told of it in pieces."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import pytest

from exercises import catalogue
from server.judging.thread import JudgingThread
from server.sets import building, publishing
from server.sets.foresight import traits
from server.storage.sets import Slot, TaskSet
from server.workbench import Bench


class Noting(JudgingThread):
    """Notes how many exercises were looked through at a time, and what was computed apart."""

    def __init__(self) -> None:
        super().__init__()
        self.looks: list[int] = []
        self.others: list[Callable[..., Any]] = []

    async def run(self, compute: Callable[..., Any], *args: Any, **kwargs: Any) -> Any:
        """Compute, and note."""
        before = traits.cache_info().misses
        try:
            return await super().run(compute, *args, **kwargs)
        finally:
            self.looks.append(traits.cache_info().misses - before)

    async def apart(self, compute: Callable[..., Any], tasks: Any) -> list[Any]:
        """Compute here, and note."""
        self.others.append(compute)
        return [compute(*task) for task in tasks]


def test_exercises_of_a_draft_are_looked_through_one_at_a_time() -> None:
    traits.cache_clear()
    judging, names = Noting(), catalogue.ids()[:6]
    draft = SimpleNamespace(slots=[SimpleNamespace(pool=(name,), limits={}) for name in names])
    bench = cast(Bench, SimpleNamespace(judging=judging))
    assert asyncio.run(building.unfit(bench, cast(TaskSet, draft))) is None
    judging.close()
    assert max(judging.looks) == 1 and sum(judging.looks) == len(names)


def test_scarce_limits_are_told_by_the_number_of_their_task() -> None:
    judging, impossible = Noting(), {"l1": (0.0501, 0.0502)}
    slots = [SimpleNamespace(pool=("slider_crank",), limits=one) for one in ({}, impossible, {}, impossible)]
    bench = cast(Bench, SimpleNamespace(judging=judging))
    found = asyncio.run(building.scarcely(bench, cast(TaskSet, SimpleNamespace(slots=slots))))
    judging.close()
    assert [one.slot for one in found] == [2, 4] and len(judging.looks) == len(slots)


def card(*told: object) -> str:
    """Stand for what is drawn."""
    return "card"


@pytest.mark.parametrize("limits", [{}, {"l1": (0.05, 0.08)}])
def test_a_spare_card_within_limits_is_drawn_beside_the_judging(
    monkeypatch: pytest.MonkeyPatch, limits: dict[str, tuple[float, float]]
) -> None:
    async def append(card: object) -> None:
        kept.append(card)

    kept: list[object] = []
    plan = SimpleNamespace(slot="s", limits=limits)
    monkeypatch.setattr(publishing, "planned", lambda *_: [plan])
    monkeypatch.setattr(publishing, "_drawn", card)
    monkeypatch.setattr(publishing, "stored", lambda *told: told[2])
    judging = Noting()
    bench = cast(Bench, SimpleNamespace(judging=judging, secret=b"", sets=SimpleNamespace(append=append)))
    asyncio.run(publishing.one_more(bench, cast(TaskSet, None), cast(Slot, SimpleNamespace(id="s"))))
    judging.close()
    assert kept == ["card"] and (len(judging.others), len(judging.looks)) == ((1, 0) if limits else (0, 1))
