"""What a lecturer is told before somebody may work on who has seen solutions: to how many they stand open."""

from __future__ import annotations

from datetime import datetime

from server.sets.handing import rules_of, shown_after, window_of
from server.sets.rules import Rules, Stage, Window
from server.storage.sets import PUBLISHED, TaskSet
from server.workbench import Bench


def told_results(task_set: TaskSet, own: Window, most: int, now: datetime) -> bool:
    """Tell whether results of an examination, or solutions of any set, have been shown to a student after its end."""
    rules = rules_of(task_set)
    shown = rules.mode == "exam" or rules.solutions != "never"
    return shown and shown_after(task_set, own, most).stage(now) is Stage.CLOSED


async def reopens(bench: Bench, task_set: TaskSet, person: str, minutes: int, now: datetime) -> bool:
    """Tell whether extra time lets a student work again on a set whose results or solutions have been shown."""
    begun, extra = await bench.sets.begun(task_set.id, person), await bench.sets.extra(task_set.id, person)
    own, most = window_of(task_set, extra, begun), await bench.sets.most_extra(task_set.id)
    again = window_of(task_set, minutes, begun).stage(now) is not Stage.CLOSED
    return again and told_results(task_set, own, most, now)


async def solved_for(bench: Bench, task_set: TaskSet, now: datetime) -> int:
    """Tell to how many students who opened a set its worked solutions stand open."""
    rules = rules_of(task_set)
    if task_set.state != PUBLISHED or rules.solutions == "never":
        return 0
    early = await bench.sets.used_up(task_set.id) if _open_early(rules) else ()
    return len({*early, *await _after_end(bench, task_set, now)})


def _open_early(rules: Rules) -> bool:
    return rules.mode == "practice" and rules.solutions == "after_last_attempt"


async def _after_end(bench: Bench, task_set: TaskSet, now: datetime) -> list[str]:
    """List the students who opened a set that has closed, for them or for everybody."""
    extra = {person: minutes for person, (minutes, _) in (await bench.sets.accommodations(task_set.id)).items()}
    begun: dict[str, datetime] = {}
    for card in await bench.marks.dealt(task_set.id):
        begun[card.person] = min(card.dealt, begun.get(card.person, card.dealt))
    most, found = max(extra.values(), default=0), []
    for person, first in begun.items():
        own = window_of(task_set, extra.get(person, 0), first)
        if shown_after(task_set, own, most).stage(now) is Stage.CLOSED:
            found.append(person)
    return found
