"""A set judged again, in both databases: nothing changes by itself, and what changes is told and kept beside."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator, Sequence
from types import SimpleNamespace
from typing import Any

import pytest
from sqlalchemy import insert, select, update

from server.database import Database, regrades
from server.people.personal import erased
from server.settings import Settings
from server.tables import audit, deck, grades, marks, task_sets
from tests.server.jobs.counting import Here
from tests.server.regrading.classroom import STUDENTS, Class, first_grades, other_grade, published
from tests.server.sets.classroom import NOW, SET, enrol
from tests.server.stores import lay


@pytest.fixture(scope="module", params=["sqlite", "postgres"])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Class]:
    url = request.getfixturevalue("shared_database_url") if request.param == "postgres" else None
    address = lay(Settings(tmp_path_factory.mktemp("regrade"), database_url=url))
    enrol(address, STUDENTS)
    database = Database(address)
    cards = asyncio.run(published(address, database))
    yield Class(address, database, cards)
    database.close()


@pytest.fixture
def school(made: Class) -> Class:
    """The class with the first grades in force and nothing else."""
    made.do(grades.delete(), marks.delete(), *first_grades(made.cards))
    kept = {card.id: card.reference for card in made.cards.values()}
    made.do(*(update(deck).where(deck.c.id == number).values(reference=value) for number, value in kept.items()))
    return made


def test_the_same_judges_say_the_same_to_the_last_sign(school: Class) -> None:
    before = school.grades()
    job = school.regraded(allow_lower=True)
    assert {**job.result, "judged": 3, "same": 3} == job.result
    assert sum(job.result.values()) == 6 and school.changes(job) == []
    assert school.grades() == before
    assert before[1]["grade"]["score"] != 1.0 and "unreadable" in str(before[2]["grade"])


def test_a_raised_score_is_kept_beside_the_old_one(school: Class) -> None:
    (first,) = school.grades("anna")
    older = other_grade(first["grade"], 0.8, l3=("wrong", 0.0))
    school.do(update(grades).where(grades.c.submission == "anna").values(grade=older, grader_version="0"))
    mark = {"submission": "anna", "share": 0.9, "comment": "neat", "author": "lecturer", "time": NOW}
    school.do(insert(marks).values(**mark))
    dry = school.regraded(dry_run=True)
    assert dry.result["raised"] == 1 and len(school.grades("anna")) == 1
    job = school.regraded(reason="a better judge")
    assert school.changes(job) == school.changes(dry)
    (change,) = school.changes(job)
    assert (change["receipt"], change["person"], change["slot"], change["effect"]) == ("anna", "anna", 1, "raised")
    assert (change["old"], change["new"], change["stale"]) == (0.8, 1.0, False)
    assert change["versions"] == {"old": "0", "new": "1", "exercise": 1, "installed": 1}
    assert change["answers"] == [
        {
            "name": "l3",
            "old": {"outcome": "wrong", "code": "wrong", "score": 0.0},
            "new": {"outcome": "right", "code": "right", "score": 1.0},
        }
    ]
    old, new = school.grades("anna")
    assert (old["grade"], new["grade"]) == (older, first["grade"])
    assert (new["reason"], new["job"], new["counted"]) == ("a better judge", job.id, old["counted"])
    assert school.ledger("anna").grade["score"] == 1.0
    assert [(row["submission"], row["share"]) for row in school.rows(select(marks))] == [("anna", 0.9)]


def test_a_lower_score_is_told_but_stays_away_unless_it_is_allowed(school: Class) -> None:
    (first,) = school.grades("bob")
    school.do(update(grades).where(grades.c.submission == "bob").values(grade=other_grade(first["grade"], 1.0)))
    job = school.regraded()
    assert (job.result["withheld"], job.result["lowered"]) == (1, 0)
    assert school.changes(job)[0]["effect"] == "withheld" and school.ledger("bob").grade["score"] == 1.0
    job = school.regraded(allow_lower=True)
    assert (job.result["withheld"], job.result["lowered"]) == (0, 1)
    assert school.ledger("bob").grade == first["grade"]
    assert [row["grade"]["score"] for row in school.grades("bob")] == [1.0, first["grade"]["score"]]


@pytest.fixture
def small(store_url: str) -> Iterator[Class]:
    """A class of the own, for what cannot be undone."""
    enrol(store_url, STUDENTS)
    database = Database(store_url)
    yield Class(store_url, database, asyncio.run(published(store_url, database)))
    database.close()


def test_who_is_erased_between_the_reading_and_the_writing_gets_no_new_grade(
    small: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    """So it is with what was read of them only: who was erased before is judged by what is left."""
    school, store = small, small.database
    for who in ("anna", "bob"):
        (first,) = school.grades(who)
        older = other_grade(first["grade"], 0.1)
        school.do(update(grades).where(grades.c.submission == who).values(grade=older, grader_version="0"))
    asyncio.run(erased(store.people, store.personal, "bob", "lecturer"))

    async def meanwhile(judging: Here, compute: Any, tasks: Sequence[Any]) -> list[Any]:
        await erased(store.people, store.personal, "anna", "lecturer")
        return [compute(*task) for task in tasks]

    monkeypatch.setattr(Here, "apart", meanwhile)
    job = school.regraded()
    assert [change["person"] for change in school.changes(job)] == ["bob"]
    assert {**job.result, "judged": 2, "raised": 1, "same": 1} == job.result and sum(job.result.values()) == 4
    assert (len(school.grades("anna")), len(school.grades("bob"))) == (1, 2)


def test_what_the_steps_no_longer_lead_to_is_told_and_the_kept_reference_judges(school: Class) -> None:
    card = school.cards["anna"]
    kept = {**card.reference, "values": card.reference["values"] | {"l3": card.reference["values"]["l3"] * 1.5}}
    school.do(update(deck).where(deck.c.id == card.id).values(reference=kept))
    job = school.regraded()
    (change,) = school.changes(job)
    assert (job.result["stale"], change["stale"], change["effect"]) == (1, True, "withheld")
    assert [(one["name"], one["new"]["outcome"]) for one in change["answers"]] == [("l3", "wrong")]


def test_wrong_references_are_computed_anew_from_the_givens_that_were_dealt(school: Class) -> None:
    card, (first,) = school.cards["anna"], school.grades("anna")
    right = card.reference["values"]["l3"]  # drawn with the card, and checked against the oracle of the exercise
    wrong = {**card.reference, "values": card.reference["values"] | {"l3": 1.5 * right}}
    (row,) = school.rows(select(deck).where(deck.c.id == card.id))
    spare = {**row, "id": "spare", "code": "spare", "number": 99, "person": None, "variant": None, "dealt": None}
    below = other_grade(first["grade"], 0.8, l3=("wrong", 0.0))
    school.do(
        update(deck).where(deck.c.id == card.id).values(reference=wrong),
        insert(deck).values(**spare | {"reference": wrong}),
        update(grades).where(grades.c.submission == "anna").values(grade=below),
    )
    kept = select(deck.c.reference).where(deck.c.id.in_((card.id, "spare")))
    assert school.regraded().result["same"] == 3  # the wrong reference has judged, and judges the same again
    dry = school.regraded(dry_run=True, recompute_references=True)
    assert [one["reference"] for one in school.rows(kept)] == [wrong, wrong]
    job = school.regraded(recompute_references=True)
    told = [
        one for _, result in asyncio.run(school.database.jobs.results(job.id, 0, 9)) for one in result["references"]
    ]
    assert {one["code"]: one["steps"] for one in told} == {
        code: [{"name": "l3", "old": 1.5 * right, "new": right}] for code in (card.code, "spare")
    }
    assert (dry.result, job.result["recomputed"], job.result["raised"]) == (job.result, 2, 1)
    assert [one["reference"]["values"]["l3"] for one in school.rows(kept)] == [right, right]
    assert [one["grade"]["score"] for one in school.grades("anna")] == [0.8, 1.0]
    again = school.regraded(recompute_references=True)
    assert (again.result["recomputed"], again.result["same"]) == (0, 3)
    school.do(deck.delete().where(deck.c.id == "spare"))


def test_a_card_whose_exercise_has_gone_keeps_its_grades(school: Class, caplog: pytest.LogCaptureFixture) -> None:
    card = school.cards["bob"]
    school.do(update(deck).where(deck.c.id == card.id).values(exercise="no_such"))
    job = school.regraded(allow_lower=True)
    school.do(update(deck).where(deck.c.id == card.id).values(exercise=card.exercise))
    assert (job.result["same"], job.result["stale"]) == (3, 1) and "no_such" in caplog.text


def test_a_regrade_is_written_into_the_audit_log_and_a_dry_run_is_not(school: Class) -> None:
    lines = select(audit.c.action, audit.c.actor, audit.c.object, audit.c.details)
    before = len(school.rows(lines))
    school.regraded(dry_run=True)
    assert len(school.rows(lines)) == before
    school.regraded()
    last = school.rows(lines.order_by(audit.c.id))[-1]
    assert (last["action"], last["actor"], last["object"]) == ("regraded", "lecturer", SET)
    assert last["details"] == {"raised": 0, "lowered": 0, "withheld": 0, "reworded": 0, "recomputed": 0}


def test_many_submissions_make_many_batches_and_none_is_left_out(
    school: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(regrades, "BATCH", 2)
    job = school.regraded()
    assert (job.total, job.result["judged"]) == (2, 3)


def test_a_set_to_which_nothing_was_handed_in_is_regraded_at_once(school: Class) -> None:
    pieces = asyncio.run(school.database.jobs.plan(lambda connection: regrades.pieces(connection, "none", whole=False)))
    assert pieces == [["", ""]]
    assert school.rows(select(task_sets.c.id)) == [{"id": SET}]


@pytest.mark.parametrize(
    ("key", "body", "collected"), [("time-out now", "9f" * 32, False), (None, "time-out now", True)]
)
def test_a_key_that_a_student_chooses_passes_for_no_collected_draft(
    key: str | None, body: str, collected: bool
) -> None:
    row = SimpleNamespace(
        receipt="r", answers={}, key=key, body=body, grade={}, grader_version="1", counted=True
    )  # fmt: skip
    assert regrades._work(row).all is collected


@pytest.mark.parametrize("own", [{"alpha2": 1.0, "l3": 1.0, "omega2_formula": 1.0, "omega2": 1.0, "v3": 4.0}, None])
def test_a_regrade_takes_the_weights_that_stand_on_the_card(school: Class, own: dict[str, float] | None) -> None:
    (before,) = school.grades("bob")
    card = school.cards["bob"]
    school.do(update(deck).where(deck.c.id == card.id).values(weights=own))
    job = school.regraded(allow_lower=True)
    school.do(update(deck).where(deck.c.id == card.id).values(weights=card.weights))
    score = before["grade"]["score"]
    assert score == 0.8 and [one["new"] for one in school.changes(job)] == ([0.875] if own else [])
