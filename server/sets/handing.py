"""Working in a set: opening a task, handing in, and the drafts that are taken when the time runs out."""

from __future__ import annotations

import asyncio
import json
import logging
from datetime import UTC, datetime
from functools import lru_cache
from time import monotonic

from exercises import verifying
from exercises.exercise import Grade, Submission, Variant
from exercises.grading import UnknownAnswer, failed
from exercises.variants import restore
from graders import Code
from server.answering import receipts
from server.judging.judging import JudgingEnded, graded_as_asked
from server.sets import publishing
from server.sets.rules import Rules, Stage, Window, held, left, solution_open, valued, window
from server.storage import KeyReused, Marked, Problem
from server.storage.sets import PUBLISHED, Card, NoAttemptLeft, Place, Slot, TaskSet, Waiting
from server.storage.sets import weights_of as weights_in
from server.web import ids
from server.web.errors import Refused
from server.web.language import DEFAULT, say
from server.workbench import Bench

MOST_OPEN = 10  # reported problems of one variant
EXAM_SECONDS = 0.1  # that judging lasts at least while results are held back
log = logging.getLogger("grubler")


def rules_of(task_set: TaskSet) -> Rules:
    """Give the rules of a set."""
    return Rules.model_validate(task_set.rules)


def window_of(task_set: TaskSet, extra: int, begun: datetime | None) -> Window:
    """Give the window of one student."""
    extended = [(datetime.fromisoformat(moment), minutes) for moment, minutes in task_set.extended]
    dates, rules = (task_set.opens, task_set.due, task_set.closes), rules_of(task_set)
    return window(*dates, rules, extra=extra, begun=begun, extended=extended)


def own_window(place: Place) -> Window:
    """Give the window of the student whose card it is."""
    return window_of(place.task_set, place.extra, place.begun)


def shown_after(task_set: TaskSet, own: Window, most: int) -> Window:
    """Give the window after which a student is shown results and solutions: that of whoever may work longest.

    One who is done early could tell the others; where a set closes for nobody by its dates, the own window counts.
    """
    longest = window_of(task_set, most, None)
    return own if longest.closes is None else longest


def refuse_unless_open(found: Window, now: datetime) -> None:
    """Refuse work before the set opens and after it has closed for this student.

    Raises:
        Refused: 403, and from when it is open.
    """
    stage = found.stage(now)
    if stage is Stage.BEFORE:
        assert found.opens is not None
        raise Refused(403, "set_not_open", opens=found.opens.isoformat())
    if stage is Stage.CLOSED:
        raise Refused(403, "set_closed")


def refuse_unless_working(place: Place, now: datetime) -> None:
    """Refuse work on a card before the set opens, after it has closed for its student, and after the student has left.

    Raises:
        Refused: 403, and from when it is open.
    """
    if not place.enrolled:
        raise Refused(403, "left_course")
    refuse_unless_open(own_window(place), now)


def is_exam(place: Place) -> bool:
    """Tell whether the set is an examination."""
    return rules_of(place.task_set).mode == "exam"


def is_held(place: Place, now: datetime) -> bool:
    """Tell whether the results are held back from the student."""
    return held(rules_of(place.task_set), _shown_after(place).stage(now))


def _shown_after(place: Place) -> Window:
    return shown_after(place.task_set, own_window(place), place.most)


async def solution_is_open(bench: Bench, place: Place) -> bool:
    """Tell whether the worked solution is open to the student whose card it is."""
    assert place.card.person is not None
    lines = await bench.sets.ledger(place.task_set.id, place.card.person)
    counted = sum(line.counted for line in lines if line.slot == place.slot.id)
    stage = _shown_after(place).stage(datetime.now(UTC))
    return solution_open(rules_of(place.task_set), stage, left(place.slot.attempts, counted))


async def open_task(bench: Bench, task_set: TaskSet, slot: Slot, person: str) -> str:
    """Give the number of a student's variant of a slot; the first open deals it.

    Raises:
        Refused: 403, the set is not open, and nothing was dealt before.
    """
    now = datetime.now(UTC)
    if task_set.state != PUBLISHED:
        raise Refused(404, "unknown_set")
    begun = await bench.sets.begun(task_set.id, person)
    found = window_of(task_set, await bench.sets.extra(task_set.id, person), begun)
    mine = await _mine(bench, task_set, slot, person)
    if mine is not None and found.stage(now) is not Stage.BEFORE:
        return mine
    refuse_unless_open(found, now)
    return (await _dealt(bench, task_set, slot, person, now)).variant or ""


async def _mine(bench: Bench, task_set: TaskSet, slot: Slot, person: str) -> str | None:
    cards = await bench.marks.dealt(task_set.id, person)
    return next((card.variant for card in reversed(cards) if card.slot == slot.id), None)


async def _dealt(bench: Bench, task_set: TaskSet, slot: Slot, person: str, now: datetime) -> Card:
    card = await bench.sets.open(slot, person, ids.new(), now)
    while card is None:
        await publishing.one_more(bench, task_set, slot)
        card = await bench.sets.open(slot, person, ids.new(), now)
    return card


async def another_card(bench: Bench, place: Place) -> Card:
    """Deal another card in place of one that our fault has spoilt.

    Raises:
        Refused: 403, the set is closed, or the last answers to this card were judged.
    """
    now, person = datetime.now(UTC), place.card.person
    assert person is not None and place.card.variant is not None
    refuse_unless_working(place, now)
    last = await bench.storage.latest(place.card.variant)
    if last is None or not faulty(last):
        raise Refused(403, "card_is_sound")
    card = await bench.sets.replace(place.slot, person, ids.new(), now)
    while card is None:
        await publishing.one_more(bench, place.task_set, place.slot)
        card = await bench.sets.replace(place.slot, person, ids.new(), now)
    return card


def faulty(marked: Marked) -> bool:
    """Tell whether a submission could not be graded by our fault."""
    codes = {verdict["code"] for verdict in marked.grade["verdicts"].values()}
    return codes == {Code.FAULT.value}


async def judge(bench: Bench, place: Place, submission: Submission, *, whole: bool = False) -> tuple[Grade, bool]:
    """Grade answers to a card: by what was kept of it, with the score it has under the rules of the set.

    Where attempts are limited an unreadable answer stops the judging, unless the `whole` is to be judged. In an
    examination it lasts a while at least: a wrong answer is looked through for slips, and that time would tell.

    Returns:
        The grade, and whether the installed exercise still leads to what was kept.
    """
    begun = monotonic()
    limited = place.slot.attempts is not None and not whole
    try:
        grade, sound = await bench.judging.run(_judged, place.card, submission, bench.secret, limited)
    except JudgingEnded:
        grade, sound = failed(submission), True
    if is_exam(place) and not whole:
        await asyncio.sleep(begun + EXAM_SECONDS - monotonic())
    return valued(grade, weights_of(place.card), rules_of(place.task_set)), sound


def _judged(card: Card, submission: Submission, secret: bytes, limited: bool) -> tuple[Grade, bool]:
    sound = reproduced(card)
    kept = () if sound else verifying.kept(card.reference)
    return graded_as_asked(submission, secret, weights_of(card), limited=limited, kept=kept), sound


def weights_of(card: Card) -> dict[str, float]:
    """Give the weights of the answers of a card."""
    return weights_in(card.shown) if card.weights is None else dict(card.weights)


def reproduced(card: Card) -> bool:
    """Tell whether the installed exercise still leads to what was kept; else the card needs a regrade."""
    return _reproduced(json.dumps(_stored(card), sort_keys=True), json.dumps(card.reference, sort_keys=True))


def variant_of(card: Card) -> Variant:
    """Build the variant of a card."""
    return restore(_stored(card))


def _stored(card: Card) -> dict[str, object]:
    return {"exercise": card.exercise, "version": card.version, "seed": card.seed, "givens": card.givens}


@lru_cache(maxsize=1024)
def _reproduced(stored: str, recorded: str) -> bool:
    return verifying.reproduced(restore(json.loads(stored)), json.loads(recorded))


async def keep(bench: Bench, place: Place, marked: Marked) -> tuple[Marked, bool]:
    """Store a submission to a set; one that our fault has spoilt is reported to the lecturers.

    Raises:
        Refused: 403, the attempts are used up.
    """
    try:
        kept = await bench.sets.keep_attempt(marked, place.slot.attempts)
    except NoAttemptLeft:
        raise Refused(403, "no_attempt_left") from None
    if faulty(marked):
        handed = marked.handed
        said = say(handed.language, "sets.fault", receipt=handed.receipt)
        problem = Problem(ids.new(), handed.variant, handed.owner, said, handed.time)
        await bench.storage.keep_problem(problem, MOST_OPEN)
    return kept


async def collect(bench: Bench, now: datetime) -> int:
    """Take the last drafts of examinations that are over; gives how many were taken.

    A draft that cannot be taken holds up no other.
    """
    taken = 0
    for draft in await bench.sets.waiting():
        place = await bench.sets.place(draft.variant)
        if place is None or not _over(place, draft.time, now):
            continue
        try:
            await _take(bench, place, draft)
            taken += 1
        except (Refused, KeyReused, UnknownAnswer, ValueError) as error:
            log.warning("the draft of variant %s was not taken: %r", draft.variant, error)
    return taken


def _over(place: Place, typed: datetime, now: datetime) -> bool:
    found = own_window(place)
    return is_exam(place) and found.stage(now) is Stage.CLOSED and found.stage(typed) in (Stage.OPEN, Stage.LATE)


async def _take(bench: Bench, place: Place, draft: Waiting) -> None:
    """Hand in a draft with the time at which it was last typed; what can be read is judged, whatever stands beside."""
    card = place.card
    grade, _ = await judge(bench, place, Submission(variant_of(card), receipts.whole(draft.answers)), whole=True)
    key = f"time-out {draft.time.isoformat()}"
    handed = receipts.handed(draft.variant, draft.person, draft.answers, key, key, DEFAULT, draft.time)
    await keep(bench, place, receipts.marked(handed, grade, card.code))
