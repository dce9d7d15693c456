"""A deadline, a lesson, and a class behind one address, against a server as people run it, with all its limits.

Deadline: a published set; every student of a course hands in once within a minute, one in a hundred with hostile text,
every second with a slip. Afterwards every receipt is looked up. Lesson: students read pages and preview what they type.
Class: students who are not signed in, all behind one address, practise as fast as a class does.

Run: ``uv run python benchmarks/load.py --store sqlite|postgres``; prints its figures last.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import asyncio
import json
import os
import random
import secrets
import time
from collections import Counter
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import Any

from sqlalchemy import insert, select

from benchmarks.stores import KINDS, Environment, cpu, serving, settings, stores
from exercises import grading
from exercises.variants import deal
from server.database.engine import engine
from server.tables import deck, sessions
from server.web import ids
from tests.server.sets.classroom import COURSE, enrol
from tests.server.stores import free_port

EXERCISE = "slider_crank"
HOSTILE = ("9^9^9^9", "(" * 5000, "sin(" * 400 + "1", "1e999999999 m", "<script>alert(1)</script>", "l1" * 4000)
CLASS = 60
LOOK = 0.5  # s between two looks at a set that is being published
AT_ONCE = 16  # requests at once while the ground is prepared
OK = range(200, 300)


@dataclass
class Browser:
    """One student's browser: a cookie, a connection that is kept, and how long each answer took."""

    port: int
    cookie: str = ""
    seconds: list[float] = field(default_factory=list)
    statuses: Counter[int] = field(default_factory=Counter)
    wire: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None

    async def ask(self, method: str, path: str, body: object = None, lasts: float = 60.0) -> tuple[int, Any]:
        """Send a request; gives status and body."""
        begin = time.perf_counter()
        async with asyncio.timeout(lasts):
            status, head, content = await self._exchange(method, path, body)
        self.seconds.append(time.perf_counter() - begin)
        self.statuses[status] += 1
        for line in head.split("\r\n"):
            if line.lower().startswith("set-cookie:"):
                self.cookie = line.split(":", 1)[1].split(";")[0].strip()
        return status, json.loads(content) if b"json" in head.lower().encode() and content else content

    async def _exchange(self, method: str, path: str, body: object) -> tuple[int, str, bytes]:
        content = b"" if body is None else json.dumps(body).encode()
        head = f"{method} {path} HTTP/1.1\r\nHost: localhost\r\nCookie: {self.cookie}\r\nAccept-Language: en\r\n"
        head += f"Content-Type: application/json\r\nContent-Length: {len(content)}\r\n\r\n"
        for _ in range(2):  # a server may have closed a connection that was silent
            reader, writer = self.wire = self.wire or await asyncio.open_connection("127.0.0.1", self.port)
            try:
                writer.write(head.encode() + content)
                return await _answer(reader)
            except (asyncio.IncompleteReadError, ConnectionError):
                self.wire = None
        raise ConnectionError(path)

    def close(self) -> None:
        """Close the connection."""
        if self.wire:
            self.wire[1].close()


async def _answer(reader: asyncio.StreamReader) -> tuple[int, str, bytes]:
    head = (await reader.readuntil(b"\r\n\r\n")).decode()
    fields = dict(line.lower().split(": ", 1) for line in head.split("\r\n")[1:] if ": " in line)
    if "content-length" in fields:
        return int(head[9:12]), head, await reader.readexactly(int(fields["content-length"]))
    content = b""
    while size := int(await reader.readline(), 16):
        content += (await reader.readexactly(size + 2))[:-2]
    await reader.readline()
    return int(head[9:12]), head, content


@dataclass(frozen=True)
class Course:
    """The course, its set, and the browsers of its people; `server` is the number of the server's process."""

    server: int
    port: int
    environment: Environment
    lecturer: Browser
    students: dict[str, Browser]

    async def publish(self) -> str:
        """Build and publish a set of one task; gives its number."""
        item = {"exercise": EXERCISE, "points": 10, "attempts": 3}
        due = (datetime.now(UTC) + timedelta(hours=2)).isoformat()
        body = {"course": COURSE, "title": "Set", "items": [item], "due": due}
        status, built = await self.lecturer.ask("POST", "/api/v1/task-sets", body)
        assert status == 201, built
        path = f"/api/v1/task-sets/{built['id']}"
        status, opened = await self.lecturer.ask("POST", f"{path}/open", {})
        while status == 202 or opened["state"] == "publishing":
            await asyncio.sleep(LOOK)
            status, opened = await self.lecturer.ask("GET", path)
        assert opened["state"] == "published", opened
        return str(built["id"])

    async def dealt(self, task_set: str) -> dict[str, str]:
        """Let every student open the task; gives the numbers of their variants."""

        async def opened(student: str) -> tuple[str, str]:
            status, body = await self.students[student].ask("POST", f"/api/v1/task-sets/{task_set}/items/1/variant", {})
            assert status == 200, body
            return student, body["id"]

        return dict(await some_at_once(opened, self.students))


def people(environment: Environment, server: int, port: int, students: int) -> Course:
    """Write a course into the store, everybody signed in."""
    url, now = settings(environment).store_url, datetime.now(UTC)
    names = [f"student{number}" for number in range(students)]
    enrol(url, names)
    cookies = {name: secrets.token_urlsafe(32) for name in ("lecturer", *names)}
    store = engine(url, connections=1)
    rows = [
        {
            "digest": ids.digest(b"session", cookie.encode()), "person": name, "created": now, "last_used": now,
            "expires": now + timedelta(days=1), "agent": "",
        }
        for name, cookie in cookies.items()
    ]  # fmt: skip
    with store.begin() as connection:
        connection.execute(insert(sessions), rows)
    store.dispose()
    browsers = {name: Browser(port, f"grubler_session={cookie}") for name, cookie in cookies.items()}
    return Course(server, port, environment, browsers.pop("lecturer"), browsers)


async def some_at_once(work: Callable[[str], Awaitable[Any]], names: Iterable[str]) -> list[Any]:
    """Do something for everybody, a few at a time."""
    gate = asyncio.Semaphore(AT_ONCE)

    async def one(name: str) -> Any:
        async with gate:
            return await work(name)

    return await asyncio.gather(*(one(name) for name in names))


def answers(environment: Environment, variants: dict[str, str], chance: random.Random) -> dict[str, dict[str, str]]:
    """Write what each student types: right, with a slip in every second, hostile in one of a hundred."""
    store = engine(settings(environment).store_url, connections=1)
    with store.connect() as connection:
        seeds = {row.variant: row.seed for row in connection.execute(select(deck.c.variant, deck.c.seed))}
    store.dispose()
    typed: dict[str, dict[str, str]] = {}
    for number, (student, variant) in enumerate(variants.items()):
        right = {name: str(text) for name, text in grading.reference(deal(EXERCISE, seeds[variant])).items()}
        if number % 100 == 50:
            right = dict.fromkeys(right, chance.choice(HOSTILE))
        elif number % 2:
            right["l3"] = f"{chance.uniform(50, 500):.1f} mm"
        typed[student] = right
    return typed


async def deadline(course: Course, task_set: str, within: float, chance: random.Random) -> list[str]:
    """Everybody hands in once at a moment before the deadline; gives the figures."""
    variants = await course.dealt(task_set)
    typed = answers(course.environment, variants, chance)
    for browser in course.students.values():
        browser.seconds.clear()
        browser.statuses.clear()
    kept: dict[str, Any] = {}
    busy = cpu(course.server)

    async def hand_in(student: str) -> None:
        await asyncio.sleep(chance.uniform(0, within))
        path = f"/api/v1/variants/{variants[student]}/submissions"
        status, body = await course.students[student].ask("POST", path, {"answers": typed[student]})
        if status in OK:
            kept[student] = body

    await asyncio.gather(*(hand_in(student) for student in course.students))
    busy = cpu(course.server) - busy
    seconds, statuses = collected(course.students.values())

    async def lost(student: str) -> bool:
        path = f"/api/v1/submissions/{kept[student]['receipt']['id']}"
        status, body = await course.students[student].ask("GET", path)
        return status != 200 or body != kept[student]

    missing = sum(await some_at_once(lost, kept))
    return [
        f"deadline: {len(variants)} students within {within:g} s, answered {told(statuses)}",
        f"deadline: acknowledged and graded after {percentiles(seconds)}",
        f"deadline: {1e3 * busy / len(seconds):.1f} ms of a processor for each in the server",
        f"deadline: lost {missing} of {len(kept)} acknowledged",
    ]


async def lesson(course: Course, lasts: float, students: int, chance: random.Random) -> list[str]:
    """Students read and preview, with a few seconds of thought between; gives the figures."""
    browsers = list(course.students.values())[:students]
    numbers = [(await one.ask("POST", f"/api/v1/exercises/{EXERCISE}/variants", {}))[1]["id"] for one in browsers]
    for browser in browsers:
        browser.seconds.clear()
        browser.statuses.clear()

    async def learn(browser: Browser, number: str) -> None:
        end = time.perf_counter() + lasts
        await asyncio.sleep(chance.uniform(0, 3))
        while time.perf_counter() < end:
            text = {"answer": "omega2_formula", "text": f"-l1*omega1*cos(alpha1)/(l2*{chance.randint(1, 10**6)})"}
            await browser.ask("POST", f"/api/v1/variants/{number}/preview", text)
            await asyncio.sleep(chance.uniform(1, 3))
            await browser.ask("GET", chance.choice(("/", f"/exercises/{EXERCISE}", f"/variants/{number}")))
            await asyncio.sleep(chance.uniform(1, 3))

    await asyncio.gather(*(learn(browser, number) for browser, number in zip(browsers, numbers, strict=True)))
    seconds, statuses = collected(browsers)
    return [f"lesson: {len(browsers)} students, answered {told(statuses)} after {percentiles(seconds)}"]


async def classroom(port: int) -> list[str]:
    """A class that nobody knows opens its first task at once, previews and hands in; gives the figures."""
    browsers = [Browser(port) for _ in range(CLASS)]

    async def practise(browser: Browser) -> None:
        await browser.ask("GET", f"/exercises/{EXERCISE}")
        status, body = await browser.ask("POST", f"/api/v1/exercises/{EXERCISE}/variants", {})
        for number in range(10 if status in OK else 0):
            text = {"answer": "omega2_formula", "text": f"l1*{number}"}
            await browser.ask("POST", f"/api/v1/variants/{body['id']}/preview", text)
        for number in range(3 if status in OK else 0):
            handed = {"answers": {"l3": f"{number} mm"}}
            await browser.ask("POST", f"/api/v1/variants/{body['id']}/submissions", handed)

    await asyncio.gather(*(practise(browser) for browser in browsers))
    _, statuses = collected(browsers)
    return [f"class: {CLASS} students behind one address, answered {told(statuses)}; locked out {statuses[429]}"]


def collected(browsers: Iterable[Browser]) -> tuple[list[float], Counter[int]]:
    """Put together what the browsers saw, and close them for now."""
    seconds: list[float] = []
    statuses: Counter[int] = Counter()
    for browser in browsers:
        seconds += browser.seconds
        statuses += browser.statuses
        browser.close()
        browser.wire = None
    return sorted(seconds), statuses


def percentiles(seconds: list[float]) -> str:
    """Word the median and the slow end."""
    named = {"p50": 0.5, "p95": 0.95, "p99": 0.99}
    parts = [f"{name} {1e3 * seconds[int(share * (len(seconds) - 1))]:.0f} ms" for name, share in named.items()]
    return ", ".join([*parts, f"slowest {1e3 * seconds[-1]:.0f} ms"])


def told(statuses: Counter[int]) -> str:
    """Word how often each status was answered."""
    return ", ".join(f"{count} x {status}" for status, count in sorted(statuses.items()))


async def run(environment: Environment, server: int, port: int, given: argparse.Namespace) -> list[str]:
    """Run the three parts in turn."""
    chance = random.Random(given.seed)
    course = people(environment, server, port, given.students)
    figures = await deadline(course, await course.publish(), given.within, chance)
    figures += await lesson(course, given.lesson, given.learners, chance)
    return figures + await classroom(port)


def main() -> None:
    """Read the command line, run, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--store", choices=KINDS, default="sqlite")
    parser.add_argument("--students", type=int, default=500)
    parser.add_argument("--within", type=float, default=60.0, help="seconds in which all hand in")
    parser.add_argument("--learners", type=int, default=300)
    parser.add_argument("--lesson", type=float, default=30.0, help="seconds that the lesson lasts")
    parser.add_argument("--seed", type=int, default=1)
    given, port = parser.parse_args(), free_port()
    before = os.getloadavg()[0]
    with stores(given.store) as (environment,), serving(environment, port) as server:
        figures = asyncio.run(run(environment, server, port, given))
    print(f"store {given.store}; load average {before:.1f} before, {os.getloadavg()[0]:.1f} after")
    print("\n".join(figures))
    sys.exit(0 if any("lost 0 of" in line for line in figures) else 1)


if __name__ == "__main__":
    main()
