"""The gradebook of a large class over HTTP: time for 300 students and 20 tasks, and how it grows with the class.

A store is filled with a published set, two submissions a task and some marks by hand; the server runs in this process.
The ratio compares the time a cell with that of a class of a tenth; the number of queries must not depend on the class.
Run: ``uv run python benchmarks/gradebook.py``.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[0] = str(ROOT)  # else benchmarks/http.py would stand before the library's http

import argparse
import gc
import time
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from sqlalchemy import Connection, Engine, Table, event, insert
from starlette.testclient import TestClient

from exercises.variants import deal
from server.app import create_app
from server.database import secret_of
from server.database.engine import engine
from server.migrate import migrate
from server.people import tokens
from server.sets import dealing
from server.settings import Settings
from server.storage.sets import weights_of
from server.tables import (
    attempts,
    courses,
    deck,
    grades,
    marks,
    memberships,
    owners,
    persons,
    slots,
    submissions,
    task_sets,
    variants,
)
from server.web import ids

NOW = datetime(2026, 11, 28, 12, tzinfo=UTC)
ANSWERS = ("alpha2", "l3", "omega2_formula", "omega2", "v3")
EVERY = 20  # every so many submissions one is marked by hand
OPEN = 50  # every so many one has an answer that is left to the lecturer
TARGET = 0.5  # s


def fill(url: str, students: int, tasks: int) -> tuple[str, str]:
    """Write a class that has worked; gives the numbers of the set and of the course."""
    course, task_set = ids.new(), ids.new()
    people = [ids.new() for _ in range(students + 1)]
    store, shown = engine(url, connections=1), dealing.card("", deal("slider_crank", 1)).shown
    with store.begin() as connection:
        _people(connection, course, people)
        line = {"id": task_set, "course": course, "title": "Set", "rules": {}, "state": "published", "opens": NOW}
        moments = {"due": NOW + timedelta(days=7), "closes": None, "published": NOW, "created": NOW}
        connection.execute(insert(task_sets), line | moments | {"revision": 1})
        rows: dict[Table, list[dict[str, Any]]] = {}
        for number in range(1, tasks + 1):
            slot = {"id": f"{task_set}-{number}", "task_set": task_set, "number": number, "pool": ["slider_crank"]}
            rows.setdefault(slots, []).append(slot | {"points": 10.0, "attempts": None, "limits": {}})
            for at, person in enumerate(people[1:], 1):
                for table, row in _work(str(slot["id"]), at, person, people[0], shown):
                    rows.setdefault(table, []).append(row)
        for table in (slots, variants, deck, submissions, grades, attempts, marks):
            connection.execute(insert(table), rows[table])
    store.dispose()
    return task_set, course


def _people(connection: Connection, course: str, people: list[str]) -> None:
    connection.execute(insert(owners), [{"id": one, "anonymous": False, "created": NOW} for one in people])
    person = {"role": "student", "active": True, "created": NOW}
    connection.execute(insert(persons), [person | {"id": one, "login": one, "name": one} for one in people])
    line = {"id": course, "title": "Course", "language": "pl", "time_zone": "Europe/Warsaw", "archived": False}
    connection.execute(insert(courses), line | {"created": NOW})
    roles = ["lecturer", *["student"] * (len(people) - 1)]
    members = [{"course": course, "person": p, "role": r, "joined": NOW} for p, r in zip(people, roles, strict=True)]
    connection.execute(insert(memberships), members)


def _work(slot: str, at: int, person: str, lecturer: str, shown: Any) -> Iterator[tuple[Table, dict[str, Any]]]:
    variant = ids.new()
    same: dict[str, Any] = {"exercise": "slider_crank", "version": 1, "seed": at, "givens": {"l1": 0.05}}
    yield variants, same | {"id": variant, "owner": person, "created": NOW, "last_used": NOW}
    dealt = {"person": person, "turn": 1, "variant": variant, "dealt": NOW, "code": ids.new()}
    yield deck, same | dealt | {"id": ids.new(), "slot": slot, "number": at, "shown": shown, "reference": {},
                                  "weights": weights_of(shown)}  # fmt: skip
    for attempt in (1, 2):
        receipt, received = ids.new(), NOW + timedelta(minutes=attempt)
        handed = {"receipt": receipt, "variant": variant, "owner": person, "answers": dict.fromkeys(ANSWERS, "1")}
        sums = {"body": "b", "digest": "d", "language": "pl", "key": None}
        yield submissions, handed | sums | {"time": received}
        right = [(at + place) % (3 if attempt == 1 else 5) != 0 for place in range(len(ANSWERS))]
        codes = ["right" if one else "wrong" for one in right]
        left = (at + attempt) % OPEN == 0
        codes[0] = "undecided" if left else codes[0]
        verdicts = {
            n: {"score": float(c == "right"), "code": c, "details": None} for n, c in zip(ANSWERS, codes, strict=True)
        }
        grade = {"verdicts": verdicts, "score": sum(right) / len(right), "mistake": None, "slip": None, "counted": True,
                 "provisional": left, "grader_version": "1"}  # fmt: skip
        given = {"submission": receipt, "grader_version": "1", "grade": grade, "counted": True, "time": received}
        yield grades, given
        yield attempts, {"variant": variant, "number": attempt, "submission": receipt}
        if (at + attempt) % EVERY == 0:
            yield marks, {"submission": receipt, "answer": "l3", "share": 1.0, "comment": "", "author": lecturer,
                          "time": received}  # fmt: skip


def measured(client: TestClient, path: str, number: int) -> tuple[float, float, int, int]:
    """Ask several times; gives the medians of the seconds and of the seconds of work, which differ on a busy machine,
    the different queries of one answer (what the server does in the background repeats itself), and its size."""
    queries: list[str] = []

    def note(_: Any, __: Any, statement: str, *___: Any) -> None:
        queries.append(statement)

    event.listen(Engine, "before_cursor_execute", note)
    reply = client.get(path)
    event.remove(Engine, "before_cursor_execute", note)
    assert reply.status_code == 200, reply.text
    spent = []
    for _ in range(number):
        started, worked = time.perf_counter(), time.process_time()
        client.get(path)
        spent.append((time.perf_counter() - started, time.process_time() - worked))
    seconds, work = (median(column) for column in zip(*spent, strict=True))
    return seconds, work, len(set(queries)), len(reply.content)


def main() -> None:
    """Fill two classes and compare them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--students", type=int, default=300)
    parser.add_argument("--tasks", type=int, default=20)
    parser.add_argument("--runs", type=int, default=7)
    asked = parser.parse_args()
    with TemporaryDirectory() as folder:
        settings = Settings(Path(folder), limited=False)
        migrate(settings.store_url)
        few = max(10, asked.students // 10)
        classes = {n: fill(settings.store_url, n, asked.tasks) for n in (few, asked.students)}
        bearer = {"authorization": f"Bearer {tokens.issue('administrator', secret_of(settings.store_url))}"}
        with TestClient(create_app(settings), headers=bearer) as client:
            gc.collect()
            gc.freeze()  # as the server does when it has started
            for name, path in (
                ("gradebook", "/api/v1/task-sets/{}/gradebook"), ("page", "/sets/{}/results"),
                ("progress", "/api/v1/task-sets/{}/progress"),
            ):  # fmt: skip
                report(client, name, path, classes, asked)
        print(f"gradebook target {TARGET} s for 300 x 20")


def report(client: TestClient, name: str, path: str, classes: dict[int, tuple[str, str]], asked: Any) -> None:
    """Print the figures of one address for both classes."""
    figures = {n: measured(client, path.format(found[0]), asked.runs) for n, found in classes.items()}
    (few, small), (many, large) = sorted(figures.items())
    print(
        f"{name}: {many} x {asked.tasks} in {large[0]:.3f} s ({large[1]:.3f} s of work), {large[3] / 1000:.0f} kB, "
        f"{large[2]} different queries ({small[2]} for {few}); "
        f"ratio {large[1] / many / (small[1] / few):.2f} a student to the class of {few}"
    )


if __name__ == "__main__":
    main()
