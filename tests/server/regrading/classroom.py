"""A published set of one task, and what three students have handed in to it."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, replace
from datetime import timedelta
from typing import Any

from sqlalchemy import Connection, insert, select

from exercises.exercise import Submission
from exercises.variants import deal
from server.answering import receipts
from server.database import Database
from server.database.engine import engine
from server.jobs.kinds import KINDS
from server.jobs.working import Bureau, work
from server.judging.judging import graded
from server.regrading import job as regrade
from server.sets import dealing
from server.sets.planning import stored
from server.sets.rules import Rules, share
from server.storage.jobs import Job
from server.storage.sets import Card
from server.tables import grades
from tests.server.jobs.counting import Here
from tests.server.sets.classroom import NOW, SET, draft, publish

SECRET = b"the secret of the regrade"
STUDENTS = ("anna", "bob", "celia")
RULES = Rules(follow_through=0.5)
WRONG_FIRST = "-12 deg"


@dataclass
class Class:
    """A published set of one task, and what three students have handed in to it."""

    url: str
    database: Database
    cards: dict[str, Card]

    def regraded(self, **wish: Any) -> Job:
        """Regrade the set in this process."""
        return asyncio.run(self._regraded({"dry_run": False, **wish}))

    async def _regraded(self, wish: dict[str, Any]) -> Job:
        judging = Here()
        found = await self.database.sets.task_set(SET)
        assert found is not None
        number = await regrade.order(self.database.jobs, found, "lecturer", "lecturer", **wish)
        while batch := await self.database.jobs.take("tests"):
            await work(Bureau(self.database.jobs, judging, SECRET, KINDS), batch)
        judging.close()
        job = await self.database.jobs.job(number)
        assert job is not None and job.state == "done", job
        return job

    def changes(self, job: Job) -> list[Any]:
        batches = asyncio.run(self.database.jobs.results(job.id, 0, 99))
        return [change for _, result in batches for change in result["changes"]]

    def do(self, *statements: Any) -> None:
        """Change rows as nobody may."""
        store = engine(self.url, connections=1)
        with store.begin() as connection:
            for statement in statements:
                connection.execute(statement)
        store.dispose()

    def rows(self, query: Any) -> list[Any]:
        def read(connection: Connection) -> list[Any]:
            return list(connection.execute(query).mappings().all())

        return list(asyncio.run(self.database.jobs.plan(read)))

    def grades(self, student: str | None = None) -> list[Any]:
        """The grades of a student's submissions, the oldest first."""
        query = select(grades).order_by(grades.c.id)
        return self.rows(query if student is None else query.where(grades.c.submission == student))

    def ledger(self, student: str) -> Any:
        (line,) = asyncio.run(self.database.sets.ledger(SET, student))
        return line


async def published(url: str, database: Database) -> dict[str, Card]:
    """Publish, deal and hand in: one right, one with a slip that is followed, one unreadable besides."""
    made = replace(draft(slots=1), rules=RULES.model_dump(mode="json"))
    await database.sets.add(made)
    drawn = [dealing.card(who, deal("slider_crank", seed)) for seed, who in enumerate(STUDENTS, 7)]
    cards = [stored(made.slots[0].id, number, one, one.seat) for number, one in enumerate(drawn, 1)]
    publish(url, made, cards)
    dealt = {}
    for who in STUDENTS:
        card = await database.sets.open(made.slots[0], who, f"variant of {who}", NOW)
        assert card is not None
        dealt[who] = card
        handed = receipts.handed(f"variant of {who}", who, answers(card), None, "b", "pl", NOW + timedelta(hours=1))
        grade = _grade(card)
        await database.sets.keep_attempt(receipts.marked(replace(handed, receipt=who), grade, card.code), 1)
    return dealt


def answers(card: Card) -> dict[str, str]:
    texts: dict[str, str] = dict(card.reference["texts"])
    changed = {"anna": {}, "bob": {"alpha2": WRONG_FIRST}, "celia": {"v3": "nothing"}}
    return texts | changed[str(card.person)]


def _grade(card: Card) -> Any:
    variant = deal("slider_crank", card.seed)
    found = graded(Submission(variant, answers(card)), SECRET, limited=True)
    weights = {name: field["weight"] for name, field in card.shown["en"]["answers"].items()}
    return replace(found, score=share(found.verdicts, weights, RULES))


def first_grades(cards: dict[str, Card]) -> list[Any]:
    found = {who: _grade(card) for who, card in cards.items()}
    return [
        insert(grades).values(
            submission=who, grader_version="1", grade=receipts.GRADE.dump_python(grade, mode="json"),
            counted=grade.counted, time=NOW,
        )
        for who, grade in found.items()
    ]  # fmt: skip


def other_grade(grade: Any, score: float, **codes: tuple[str, float]) -> Any:
    """A grade as older judges could have given it."""
    said = {name: {"code": code, "score": value} for name, (code, value) in codes.items()}
    verdicts = {name: verdict | said.get(name, {}) for name, verdict in grade["verdicts"].items()}
    return grade | {"verdicts": verdicts, "score": score, "grader_version": "0"}
