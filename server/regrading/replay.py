"""Judging a batch again, in a process of its own: the installed judges on what was kept of each card."""

from __future__ import annotations

import json
import logging
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from exercises import catalogue, verifying
from exercises.exercise import Submission
from exercises.variants import restore
from server.answering.receipts import GRADE, whole
from server.judging.judging import graded_as_asked
from server.regrading.difference import Effect, difference
from server.sets.rules import Rules, valued
from server.storage import Answers

log = logging.getLogger("grubler")


@dataclass(frozen=True, slots=True)
class Work:
    """A submission to be judged again.

    Attributes:
        grade: The grade in force.
        version: Of the judges that gave it.
        all: Whether all that can be read was judged, whatever stood beside: so it is with drafts that were collected.
    """

    receipt: str
    answers: Answers
    grade: Mapping[str, Any]
    version: str
    counted: bool
    all: bool


@dataclass(frozen=True, slots=True)
class Dealt:
    """A card with what was handed in to it.

    Attributes:
        card: Its number in the store.
        code: What stands on it for people.
        slot: Number of the task, from 1.
        limited: Whether its attempts are limited.
        weights: Of its answers.
    """

    card: str
    code: str
    stored: Mapping[str, Any]
    reference: Mapping[str, Any]
    weights: Mapping[str, float]
    person: str | None
    slot: int
    limited: bool
    works: tuple[Work, ...]


@dataclass(frozen=True, slots=True)
class Lot:
    """What a batch works on; plain data.

    Attributes:
        recompute: References that the installed exercise does not lead to are computed anew, from the givens that were
            dealt.
        erased: People of the batch who were erased before it was read.
    """

    rules: Mapping[str, Any]
    allow_lower: bool
    recompute: bool
    cards: tuple[Dealt, ...]
    erased: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class NewGrade:
    """A grade that is to take the place of another, beside which it is kept."""

    receipt: str
    grade: Mapping[str, Any]
    version: str
    counted: bool
    effect: str


@dataclass(frozen=True, slots=True)
class Repair:
    """A reference that is to take the place of a wrong one; what is `told` holds all in which the two differ."""

    card: str
    reference: Mapping[str, Any]
    told: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Replayed:
    """What came of a batch: how many of each effect by person, what differs, the grades and references to be kept."""

    tallies: Mapping[str | None, Mapping[str, int]]
    changes: tuple[Mapping[str, Any], ...]
    grades: tuple[NewGrade, ...]
    repairs: tuple[Repair, ...] = ()
    erased: frozenset[str] = frozenset()

    @property
    def counts(self) -> dict[str, int]:
        """How many submissions were judged and to what effect, and how many references were computed anew."""
        found = Counter[str](dict.fromkeys((*(effect.value for effect in Effect), "stale", "judged"), 0))
        for tally in self.tallies.values():
            found.update(tally)
        return dict(found) | {"recomputed": len(self.repairs)}

    def without(self, people: frozenset[str]) -> Replayed:
        """Leave out what is said of some people."""
        tallies = {person: tally for person, tally in self.tallies.items() if person not in people}
        theirs = {change["receipt"] for change in self.changes if change["person"] in people}
        changes = tuple(change for change in self.changes if change["receipt"] not in theirs)
        grades = tuple(one for one in self.grades if one.receipt not in theirs)
        return replace(self, tallies=tallies, changes=changes, grades=grades)


def replay(secret: bytes, lot: Lot) -> Replayed:
    """Judge a batch again."""
    tallies: dict[str | None, Counter[str]] = defaultdict(Counter)
    changes, grades = [], []
    rules = Rules.model_validate(lot.rules)
    repairs = {one.card: one for one in map(_repaired, lot.cards) if one} if lot.recompute else {}
    for dealt in lot.cards:
        repair = repairs.get(dealt.card)
        card = replace(dealt, reference=repair.reference) if repair else dealt
        for work, new, stale in _judged(secret, card, rules):
            found = difference(work.grade, new, lot.allow_lower)
            tallies[card.person].update({found.effect.value: 1, "stale": int(stale), "judged": 1})
            if found.effect is not Effect.SAME:
                told = found.told() | {"receipt": work.receipt, "person": card.person, "slot": card.slot}
                versions = {"old": work.version, "new": new["grader_version"], "exercise": card.stored["version"]}
                changes.append(told | {"versions": versions | {"installed": _installed(card)}, "stale": stale})
            if found.in_force:
                grades.append(NewGrade(work.receipt, new, new["grader_version"], work.counted, found.effect.value))
    return Replayed(tallies, tuple(changes), tuple(grades), tuple(repairs.values()), lot.erased)


def _repaired(card: Dealt) -> Repair | None:
    """Solve the givens of a card anew; none where the installed exercise leads to what was kept, or cannot judge it."""
    try:
        variant = restore(card.stored)
        if verifying.reproduced(variant, card.reference):
            return None
        new = verifying.record(variant)
    except Exception:  # the exercise has gone, or has other givens now: the kept reference stays
        log.exception("the reference of a card of %s cannot be computed anew", card.stored["exercise"])
        return None
    steps, texts = ([*_apart(card.reference[part], new[part])] for part in ("values", "texts"))
    return Repair(card.card, new, {"code": card.code, "slot": card.slot, "steps": steps, "texts": texts})


def _apart(old: Mapping[str, Any], new: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """Give what two parts of a reference do not have in common; nothing on one side where it knows no such name."""
    for name in {**old, **new}:
        one, other = (json.loads(json.dumps(part.get(name))) for part in (old, new))
        if one != other:
            yield {"name": name, "old": one, "new": other}


def _judged(secret: bytes, card: Dealt, rules: Rules) -> Iterator[tuple[Work, dict[str, Any], bool]]:
    """Judge what was handed in to a card; tells of each whether the exercise no longer leads to what was kept."""
    try:
        variant = restore(card.stored)
        stale = not verifying.reproduced(variant, card.reference)
    except Exception:  # the exercise has gone, or has other givens now: what was judged stays as it is
        log.exception("exercise %s cannot judge its cards any more", card.stored["exercise"])
        yield from ((work, dict(work.grade), True) for work in card.works)
        return
    kept = verifying.kept(card.reference) if stale else ()
    for work in card.works:
        asked = {name: text for name, text in whole(work.answers).items() if name in card.weights}
        limited = card.limited and not work.all
        grade = graded_as_asked(Submission(variant, asked), secret, card.weights, limited=limited, kept=kept)
        yield work, GRADE.dump_python(valued(grade, card.weights, rules), mode="json"), stale


def _installed(card: Dealt) -> int | None:
    try:
        return catalogue.load(card.stored["exercise"]).exercise.version
    except catalogue.UnknownExercise:
        return None
