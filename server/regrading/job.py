"""Ordering a regrade, and what its batches do."""

from __future__ import annotations

from datetime import UTC, datetime
from functools import partial

from server.database import regrades
from server.regrading.replay import replay
from server.storage.jobs import Jobs, Kind, Order
from server.storage.sets import TaskSet
from server.web import ids

NAME = "regrade"
REGRADE = Kind(NAME, regrades.read, replay, regrades.write, regrades.finish, regrades.undo)


async def order(
    jobs: Jobs, task_set: TaskSet, actor: str, person: str | None, *,
    dry_run: bool, allow_lower: bool = False, recompute_references: bool = False, reason: str = "",
) -> str:  # fmt: skip
    """Order the regrade of a published set; gives the number of the job.

    Args:
        jobs: The store of jobs.
        task_set: The set.
        actor: Who orders, as the audit log names it.
        person: The number of that person; none for the command line.
        dry_run: Whether only to tell what would change.
        allow_lower: Whether a lower score may take the place of a higher one.
        recompute_references: Whether references that the installed exercises do not lead to are computed anew.
        reason: Why, as it stands beside the new grades.

    Raises:
        Busy: One is under way.
    """
    pieces = await jobs.plan(partial(regrades.pieces, task_set=task_set.id, whole=recompute_references))
    wish = {"dry_run": dry_run, "allow_lower": allow_lower, "recompute_references": recompute_references}
    payload = {"task_set": task_set.id, "actor": actor, "reason": reason, **wish}
    made = Order(ids.new(), NAME, task_set.id, task_set.course, payload, pieces, person, datetime.now(UTC))
    await jobs.start(made)
    return made.id
