"""What waits for a student in all courses: the set that is due next, every set, the latest results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime

from server.sets.rules import Stage
from server.sets.standing import Standing, Task, standing
from server.storage.courses import Course
from server.workbench import Bench

LATEST = 5  # results that are shown
NEVER = datetime.max.replace(tzinfo=UTC)


@dataclass(frozen=True, slots=True)
class Mine:
    """A set of a student: its course, and how the student stands in it at a moment."""

    course: Course
    own: Standing
    now: datetime

    @property
    def finished(self) -> int:
        """How many tasks need no more work."""
        return sum(map(self._is_finished, self.own.tasks))

    @property
    def task(self) -> Task | None:
        """The first task that needs work; None where none does, or where nothing is taken now."""
        is_open = self.own.stage in (Stage.OPEN, Stage.LATE)
        return next((task for task in self.own.tasks if is_open and not self._is_finished(task)), None)

    @property
    def begun(self) -> bool:
        """Whether a task was opened: before that, a click must not start the time limit."""
        return any(task.card for task in self.own.tasks)

    @property
    def until(self) -> datetime | None:
        """The deadline that comes next: when it is due, then when it closes."""
        found = self.own.window
        return found.due if found.due is not None and found.due > self.now else found.closes

    def _is_finished(self, task: Task) -> bool:
        """Tell by the points; while results are held, by what was handed in alone."""
        return task.left == 0 or (bool(task.ledger) if self.own.held else task.share == 1)


@dataclass(frozen=True, slots=True)
class Opened:
    """The card of a task that was opened: its title, its figure, and when its draft was saved."""

    title: str
    svg: str
    saved: datetime | None


async def sets_of(bench: Bench, person: str, courses: Sequence[tuple[Course, str]], now: datetime) -> list[Mine]:
    """List the published sets of the courses in which a person is a student: what is due first, then what is closed."""
    found = [
        Mine(course, await standing(bench, one, person, now), now)
        for course, role in courses
        if role == "student"
        for one in await bench.sets.of(course.id)
        if one.published
    ]
    return sorted(found, key=lambda mine: (mine.own.stage is Stage.CLOSED, mine.until or NEVER))


def due_next(found: Sequence[Mine]) -> Mine | None:
    """Give the first set in which something is to be done."""
    return next((mine for mine in found if mine.task), None)


async def opened(bench: Bench, mine: Mine, language: str) -> Opened | None:
    """Give the card with which a student goes on; None before it is opened, and where it has no figure."""
    card = mine.task.card if mine.task else None
    shown = await bench.sets.shown(card.variant, language) if card else None
    if card is None or not shown or not shown.get("picture"):
        return None
    draft = await bench.storage.draft(card.variant)
    return Opened(shown["title"], shown["picture"]["svg"], draft.time if draft else None)


def latest(found: Sequence[Mine]) -> list[tuple[Mine, Task]]:
    """List the tasks that were judged last, the newest first; nothing of an examination whose results are held."""
    judged = [(mine, task) for mine in found if not mine.own.held for task in mine.own.tasks if task.share is not None]
    return sorted(judged, key=lambda one: one[1].ledger[-1].time, reverse=True)[:LATEST]
