"""The export of marks from the command line, straight from the store."""

from __future__ import annotations

import asyncio

from server.audit.acts import COMMAND_LINE
from server.database import Database, secret_of
from server.marks import export, gradebook, pseudonyms
from server.settings import Settings
from server.storage.audit import Action, Entry


def marks(
    settings: Settings, task_set: str | None, course: str | None, form: export.Form, separator: export.Separator,
    language: str, *, named: bool = True,
) -> bytes | None:  # fmt: skip
    """Write the marks of a set, or of a course, as a file; none where there is no such set or course.

    Where nobody is to be named, a pseudonym stands for each person, the same in every export of this server.
    """
    secret = None if named else settings.secret or secret_of(settings.store_url)
    database = Database(settings.store_url)
    try:
        table = asyncio.run(_table(database, task_set, course, language, secret))
    finally:
        database.close()
    return None if table is None else export.written(table, form, separator)


async def _table(
    database: Database, task_set: str | None, course: str | None, language: str, secret: bytes | None
) -> export.Table | None:
    one = await database.sets.task_set(task_set) if task_set else None
    found = await database.courses.course(one.course if one else course or "")
    if found is None:
        return None
    whole = await gradebook.of_course(database, found.id) if one is None else [await gradebook.gradebook(database, one)]
    books = whole if secret is None else pseudonyms.hidden(whole, secret)
    if one is None:
        table = export.of_course(books, found.title, language)
    else:
        table = export.of_set(books[0], found.title, language)
    noted = Entry(COMMAND_LINE, Action.MARKS_EXPORTED, found.id, found.id, {"students": len(table.rows)})
    await database.audit.note(noted)
    return table
