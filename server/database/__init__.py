"""The store in a relational database, one file a noun: the same code on SQLite and on PostgreSQL."""

from __future__ import annotations

from server.database.audit import Audit
from server.database.connections import Connections
from server.database.courses import Courses
from server.database.jobs import Jobs
from server.database.marks import Marks
from server.database.people import People
from server.database.personal import Personal
from server.database.practice import Practice
from server.database.secret import secret_of
from server.database.sets import Sets

__all__ = ["Database", "secret_of"]


class Database:
    """All that rests, by noun, over one writer and one set of readers."""

    def __init__(self, url: str) -> None:
        self._connections = Connections(url)
        self.audit = Audit(self._connections)
        self.practice = Practice(self._connections)
        self.sets = Sets(self._connections)
        self.marks = Marks(self._connections)
        self.people = People(self._connections)
        self.personal = Personal(self._connections)
        self.courses = Courses(self._connections)
        self.jobs = Jobs(self._connections)

    def close(self) -> None:
        """Finish what is under way and let go of the files."""
        self._connections.close()
