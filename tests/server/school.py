"""A server of this process with a course and somebody of every role, each with a browser of their own."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime

from anyio.from_thread import BlockingPortal
from fastapi import FastAPI
from pwdlib.hashers.argon2 import Argon2Hasher
from starlette.testclient import TestClient

from server.app import create_app
from server.people.passwords import Passwords
from server.settings import Settings
from server.storage.courses import Course, Group
from server.storage.people import Person
from server.web import ids
from server.workbench import Bench

CHEAP = Argon2Hasher(time_cost=1, memory_cost=8, parallelism=1)
PASSWORD = "chalk and blackboard"
NOW = datetime(2026, 11, 28, 9, 0, tzinfo=UTC)
CODE = "KX49-2MQT"
MEMBERS = {
    "lecturer": "lecturer",
    "assistant": "assistant",
    "student": "student",
    "other": "student",
    "leaver": "student",
}
ROLES = {"administrator": "administrator", "lecturer": "lecturer", "stranger": "lecturer"}  # all others: student
NAMES = ("administrator", "lecturer", "stranger", "assistant", "student", "other", "leaver", "outsider")


@dataclass(frozen=True, slots=True)
class School:
    """The server, its course and its people by name.

    `stranger` lectures elsewhere, `outsider` is in no course, `leaver` is there to be taken out.
    """

    app: FastAPI
    portal: BlockingPortal
    course: str
    group: str
    people: dict[str, str]

    @property
    def bench(self) -> Bench:
        """The tools of the server."""
        found: Bench = self.app.state.bench
        return found

    def browser(self, who: str | None = None) -> TestClient:
        """Open a browser; signed in, where a name is given."""
        client = TestClient(self.app, raise_server_exceptions=False, follow_redirects=False)
        client.portal = self.portal  # the loop of the server, where each request would start one of its own
        if who is not None:
            reply = client.post("/api/v1/sessions", json={"login": who, "password": PASSWORD})
            assert reply.status_code == 201, reply.text
        return client


@contextmanager
def opened(settings: Settings) -> Iterator[School]:
    """Start the server and let its people in."""
    app = create_app(settings, passwords=Passwords(CHEAP))
    with TestClient(app, raise_server_exceptions=False) as client:
        assert client.portal is not None
        bench: Bench = app.state.bench
        people = {name: client.portal.call(_person, bench, name) for name in NAMES}
        course, group = client.portal.call(_course, bench, people)
        yield School(app, client.portal, course, group, people)


async def _person(bench: Bench, name: str) -> str:
    person = Person(
        ids.new(), name, name.title(), ROLES.get(name, "student"), NOW, await bench.passwords.hashed(PASSWORD)
    )
    assert await bench.people.add(person)
    return person.id


async def _course(bench: Bench, people: dict[str, str]) -> tuple[str, str]:
    course, group = Course(ids.new(), "TMM", "pl", "Europe/Warsaw", NOW, CODE), ids.new()
    await bench.courses.add(course, people["lecturer"])
    await bench.courses.add(Course(ids.new(), "Other", "pl", "Europe/Warsaw", NOW, "ZZZZ-0000"), people["stranger"])
    await bench.courses.add_group(Group(group, course.id, "A"))
    for name in ("assistant", "student", "other", "leaver"):
        assert await bench.courses.join(course.id, people[name], MEMBERS[name], NOW)
    return course.id, group
