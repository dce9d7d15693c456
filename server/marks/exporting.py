"""The export of marks from the command line, straight from the store."""

from __future__ import annotations

import asyncio

from server.audit.acts import COMMAND_LINE
from server.database import Database
from server.marks import export, gradebook
from server.settings import Settings
from server.storage.audit import Action, Entry


def marks(
    settings: Settings, task_set: str | None, course: str | None, form: export.Form, separator: export.Separator,
    language: str,
) -> bytes | None:  # fmt: skip
    """Write the marks of a set, or of a course, as a file; none where there is no such set or course."""
    database = Database(settings.store_url)
    try:
        table = asyncio.run(_table(database, task_set, course, language))
    finally:
        database.close()
    return None if table is None else export.written(table, form, separator)


async def _table(database: Database, task_set: str | None, course: str | None, language: str) -> export.Table | None:
    one = await database.sets.task_set(task_set) if task_set else None
    found = await database.courses.course(one.course if one else course or "")
    if found is None:
        return None
    if one is None:
        table = export.of_course(await gradebook.of_course(database, found.id), found.title, language)
    else:
        table = export.of_set(await gradebook.gradebook(database, one), found.title, language)
    noted = Entry(COMMAND_LINE, Action.MARKS_EXPORTED, found.id, found.id, {"students": len(table.rows)})
    await database.audit.note(noted)
    return table
