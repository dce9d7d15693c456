"""Sets in the store: drafts by revision, one card a student, one attempt of a hundred, on both databases."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import timedelta
from typing import Any

import pytest
from sqlalchemy import Engine, event, update

from server.database import Database
from server.database import marks as marks_of
from server.database import sets as sets_of
from server.database.engine import engine
from server.migrate import migrate
from server.settings import Settings
from server.storage import Draft, Handed, KeyReused, Marked
from server.storage.marks import Mark, Progress
from server.storage.sets import Card, DeadlinesMoved, Hint, NoAttemptLeft, NotADraft, Slot, TaskSet
from server.tables import deck
from tests.server.sets.classroom import COURSE, NOW, card, draft, enrol, publish, slot

STUDENTS = ("anna", "bob", "celia", "dora", "emil")


@dataclass
class School:
    """Two servers on one store with a class of five; each test makes a set of its own."""

    url: str
    one: Database
    two: Database
    made: int = 0

    def draft(self, **changes: Any) -> TaskSet:
        """Store the draft of a set with two slots."""
        self.made += 1
        new = replace(draft(f"SET{self.made}"), **changes)
        asyncio.run(self.one.sets.add(new))
        return new

    def published(self, **changes: Any) -> TaskSet:
        """Publish one: cards for Anna and Bob, and two spares."""
        new = self.draft(**changes)
        seats = list(enumerate(("anna", "bob", None, None), 1))
        publish(self.url, new, [card(of, n, who) for of in new.slots for n, who in seats])
        return new

    def opened(self, slot: Slot, who: str, variant: str = "") -> Card:
        """Deal a student's card."""
        found = asyncio.run(self.one.sets.open(slot, who, variant or f"{slot.id} {who}", NOW))
        assert found is not None
        return found

    def keep(self, card: Card, receipt: str, limit: int | None, **changes: Any) -> tuple[Marked, bool]:
        """Hand in."""
        return asyncio.run(self.one.sets.keep_attempt(marked(card, receipt, **changes), limit))


@pytest.fixture(scope="module", params=["sqlite", "postgres"])
def school(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[School]:
    """A school on each database."""
    found = request.getfixturevalue("postgres").empty() if request.param == "postgres" else None
    url = Settings(tmp_path_factory.mktemp("school"), database_url=found).store_url
    migrate(url)
    enrol(url, STUDENTS)
    made = School(url, Database(url), Database(url))
    yield made
    made.one.close()
    made.two.close()


def marked(card: Card, receipt: str, **changes: Any) -> Marked:
    assert card.variant is not None and card.person is not None
    handed = Handed(receipt, card.variant, card.person, {"l3": receipt}, NOW, None, "body", "digest", "pl")
    return Marked(replace(handed, **changes), {"score": 1.0}, True, "1", card.code)


def test_a_draft_is_changed_over_its_own_revision_only(school: School) -> None:
    old = school.draft()
    new = replace(old, title="Set 5", revision=2, slots=old.slots[1:])
    asyncio.run(school.one.sets.change(new, 1))
    assert asyncio.run(school.one.sets.task_set(new.id)) == new
    assert new in asyncio.run(school.one.sets.of(COURSE))
    with pytest.raises(NotADraft):
        asyncio.run(school.one.sets.change(new, 1))


def test_what_is_published_is_frozen(school: School) -> None:
    old = school.published()
    with pytest.raises(NotADraft):
        asyncio.run(school.one.sets.change(replace(old, revision=2), 1))
    with pytest.raises(NotADraft):
        publish(school.url, old, [])
    assert asyncio.run(school.one.sets.task_set(old.id)) == replace(old, state="published", published=NOW)


def test_a_deck_of_an_older_draft_is_not_published(school: School) -> None:
    old = school.draft()
    asyncio.run(school.one.sets.change(replace(old, revision=2), 1))
    with pytest.raises(NotADraft):
        publish(school.url, old, [card(old.slots[0], 1)])
    assert asyncio.run(school.one.sets.deck(old.id)) == []


def test_a_student_is_dealt_his_own_card_once(school: School) -> None:
    slot = school.published().slots[0]
    dealt = school.opened(slot, "bob")
    assert (dealt.number, dealt.person, dealt.dealt) == (2, "bob", NOW)
    assert school.opened(slot, "bob", "another") == dealt
    place = asyncio.run(school.one.sets.place(dealt.variant or ""))
    brief = replace(dealt, shown={})
    assert place is not None and (place.card, place.slot, place.begun, place.extra) == (brief, slot, NOW, 0)
    assert asyncio.run(school.one.sets.place("another")) is None


def test_a_late_joiner_gets_one_seat_in_all_slots(school: School) -> None:
    first, second = school.published().slots
    assert school.opened(first, "celia").number == 3
    assert school.opened(second, "dora").number == 4
    assert school.opened(second, "celia").number == 3
    assert asyncio.run(school.one.sets.open(first, "emil", "none left", NOW)) is None


def test_fifty_first_opens_at_once_deal_one_card(school: School) -> None:
    slot = school.published().slots[0]

    async def race() -> list[Card | None]:
        stores = (school.one, school.two)
        return await asyncio.gather(*(stores[n % 2].sets.open(slot, "anna", f"{slot.id} {n}", NOW) for n in range(50)))

    found = asyncio.run(race())
    assert len({one.variant for one in found if one}) == 1 and None not in found


def test_a_faulty_card_is_replaced_by_a_spare(school: School) -> None:
    slot = school.published().slots[0]
    school.opened(slot, "anna")
    found = asyncio.run(school.one.sets.replace(slot, "anna", f"{slot.id} new", NOW))
    assert found is not None and (found.number, found.turn, found.variant) == (4, 2, f"{slot.id} new")
    assert school.opened(slot, "anna", "another") == found
    asyncio.run(school.one.sets.append(replace(card(slot, 1, "dora"), id=f"{slot.id} N", code=f"{slot.id} N"[-16:])))
    assert school.opened(slot, "dora").number == 5


def test_of_a_hundred_posts_with_one_attempt_left_one_is_counted(school: School) -> None:
    task_set = school.published()
    dealt = school.opened(task_set.slots[0], "anna")

    async def race() -> list[object]:
        stores = (school.one, school.two)
        posts = (stores[n % 2].sets.keep_attempt(marked(dealt, f"{task_set.id} {n}"), 1) for n in range(100))
        return await asyncio.gather(*posts, return_exceptions=True)

    found = asyncio.run(race())
    assert sum(isinstance(one, NoAttemptLeft) for one in found) == 99
    (line,) = asyncio.run(school.one.sets.ledger(task_set.id))
    assert (line.person, line.counted) == ("anna", True)


def test_the_same_key_gives_the_same_receipt_when_no_attempt_is_left(school: School) -> None:
    dealt = school.opened(school.published().slots[0], "anna")
    first, again = (school.keep(dealt, f"{dealt.id} {n}", 1, key="k", answers={"l3": "1"}) for n in range(2))
    assert (again[0], first[1], again[1]) == (first[0], False, True)
    with pytest.raises(KeyReused):
        school.keep(dealt, f"{dealt.id} 3", 1, key="k", body="other")


def test_the_same_answers_again_take_no_attempt(school: School) -> None:
    task_set = school.published()
    dealt = school.opened(task_set.slots[0], "anna")
    kept = [
        school.keep(dealt, f"{dealt.id} {text}", 2, answers={"l3": text})[0].counted for text in ("1 m", " 1 m", "2 m")
    ]
    assert kept == [True, False, True]
    lines = asyncio.run(school.one.sets.ledger(task_set.id, "anna"))
    assert sorted(line.counted for line in lines) == [False, True, True]
    assert asyncio.run(school.one.sets.ledger(task_set.id, "bob")) == []


def test_attempts_run_on_over_a_replaced_card(school: School) -> None:
    slot = school.published().slots[0]
    dealt = school.opened(slot, "anna")
    school.keep(dealt, f"{dealt.id} 1", 2)
    other = asyncio.run(school.one.sets.replace(slot, "anna", f"{slot.id} new", NOW))
    assert other is not None
    school.keep(other, f"{dealt.id} 2", 2)
    with pytest.raises(NoAttemptLeft):
        school.keep(other, f"{dealt.id} 3", 2)


def test_extra_time_is_given_and_taken_back(school: School) -> None:
    task_set = school.published()
    dealt = school.opened(task_set.slots[0], "anna")
    for minutes in (30, 45):
        asyncio.run(school.one.sets.accommodate(task_set.id, "anna", minutes, "dyslexia"))
    place = asyncio.run(school.one.sets.place(dealt.variant or ""))
    assert place is not None and place.extra == 45
    assert asyncio.run(school.one.sets.accommodations(task_set.id)) == {"anna": (45, "dyslexia")}
    asyncio.run(school.one.sets.accommodate(task_set.id, "anna", 0, ""))
    assert asyncio.run(school.one.sets.extra(task_set.id, "anna")) == 0


def test_an_exercise_is_reserved_until_the_set_is_over(school: School) -> None:
    sets, after = school.one.sets, NOW + timedelta(days=70)
    task_set = school.published()
    assert asyncio.run(sets.reserved("slider_crank", NOW))
    assert not asyncio.run(sets.reserved("planetary", NOW)) and not asyncio.run(sets.reserved("slider_crank", after))
    asyncio.run(sets.move([(task_set, replace(task_set, due=after, closes=None))]))
    assert asyncio.run(sets.reserved("slider_crank", after))


def test_deadlines_move_together_and_from_those_that_were_seen(school: School) -> None:
    one, other = school.published(due=NOW), school.published(due=None)
    moves = [(old, replace(old, due=NOW + timedelta(hours=1))) for old in (one, other)]
    asyncio.run(school.one.sets.move(moves[:1]))
    for again in (moves, moves[::-1]):
        with pytest.raises(DeadlinesMoved):
            asyncio.run(school.two.sets.move(again))
    found = [asyncio.run(school.one.sets.task_set(old.id)) for old in (one, other)]
    assert [one.due for one in found if one] == [NOW + timedelta(hours=1), None]


def test_drafts_of_an_examination_that_were_not_handed_in_wait(school: School) -> None:
    slots = (replace(slot("EXAM"), attempts=2),)
    task_set = school.published(id="EXAM", rules={"mode": "exam"}, slots=slots)
    dealt = school.opened(task_set.slots[0], "anna")
    school.keep(dealt, f"{dealt.id} 1", 2)
    assert asyncio.run(school.one.sets.waiting()) == []
    assert dealt.variant is not None
    later = Draft(dealt.variant, {"l3": "2"}, NOW + timedelta(minutes=1), 2)
    assert asyncio.run(school.one.practice.keep_draft(later)) == (later, True)
    (found,) = asyncio.run(school.one.sets.waiting())
    assert (found.variant, found.person, found.answers) == (dealt.variant, "anna", {"l3": "2"})
    school.keep(dealt, f"{dealt.id} 2", 2, time=NOW + timedelta(minutes=2))
    assert asyncio.run(school.one.sets.waiting()) == []
    more = replace(later, time=NOW + timedelta(minutes=3), revision=4)
    assert asyncio.run(school.one.practice.keep_draft(more)) == (more, True)
    assert asyncio.run(school.one.sets.waiting()) == []  # no attempt is left for it


def test_of_a_hundred_clicks_one_opens_a_hint_and_later_work_tells_of_it(school: School) -> None:
    task_set = school.published()
    dealt = school.opened(task_set.slots[0], "anna")
    assert dealt.variant is not None
    hint = Hint(dealt.variant, "l3", 1, NOW + timedelta(minutes=2))

    async def race() -> None:
        await asyncio.gather(*((school.one, school.two)[n % 2].sets.open_hint(hint) for n in range(100)))

    asyncio.run(race())
    assert asyncio.run(school.two.sets.hints(dealt.variant)) == [hint]
    for at in (1, 2, 3):
        school.keep(dealt, f"{dealt.id} {at}", None, time=NOW + timedelta(minutes=at))
    for lines in (school.one.sets.ledger(task_set.id), school.one.marks.lines(task_set.id)):
        assert [line.hints for line in asyncio.run(lines)] == [0, 1, 1]


@pytest.mark.parametrize("own", [{"l3": 2.0, "v3": 1.0}, None])  # none on a card of an older version
def test_marks_by_hand_weights_and_progress_are_read_on_both_databases(
    school: School, own: dict[str, float] | None
) -> None:
    new = school.draft()
    asked = {"en": {"answers": {} if own else {"l3": {"weight": 2.0}, "v3": {"weight": 1.0}}}}
    cards = [replace(card(of, 1, "anna"), shown=asked, weights=own) for of in new.slots]
    publish(school.url, new, cards)
    mine = school.opened(new.slots[0], "anna")
    school.opened(new.slots[1], "anna")
    for at in (1, 2):
        school.keep(mine, f"{new.id} {at}", None, time=NOW + timedelta(minutes=at))
    assert asyncio.run(school.one.marks.weights(new.id)) == {}
    given = [Mark(f"{new.id} 1", answer, 0.5, "why", "lecturer", NOW) for answer in ("l3", None)]
    asyncio.run(school.one.marks.give(given))
    found = asyncio.run(school.one.marks.of(new.id))
    assert [replace(one, number=0) for one in found] == given and found[0].number < found[1].number
    assert asyncio.run(school.one.marks.of(new.id, "bob")) == []
    assert asyncio.run(school.one.marks.on(f"{new.id} 1")) == found
    assert asyncio.run(school.one.marks.weights(new.id, "anna")) == {mine.variant: {"l3": 2.0, "v3": 1.0}}
    (far,) = asyncio.run(school.one.marks.progress(new.id))
    assert far == Progress("anna", 2, 1, 2, NOW + timedelta(minutes=2))
    assert [one.receipt for one in asyncio.run(school.one.marks.handed(new.id))] == [f"{new.id} 1", f"{new.id} 2"]
    assert [one.slot for one in asyncio.run(school.one.marks.dealt(new.id))] == [of.id for of in new.slots]


def test_the_weights_of_a_card_are_read_once(school: School, monkeypatch: pytest.MonkeyPatch) -> None:
    new = school.draft()
    publish(school.url, new, [replace(card(new.slots[0], 1, "anna"), weights={"l3": 3.0})])
    mine, asked = school.opened(new.slots[0], "anna"), []
    school.keep(mine, f"{new.id} 1", None)
    asyncio.run(school.one.marks.give([Mark(f"{new.id} 1", "l3", 0.5, "why", "lecturer", NOW)]))
    with listening(lambda *told: asked.append(told[2])):
        found = [asyncio.run(school.one.marks.weights(new.id)) for _ in range(2)]
        assert found == [{mine.variant: {"l3": 3.0}}] * 2 and sum("shown" in one for one in asked) == 1
        monkeypatch.setattr(marks_of, "MOST_WEIGHTS", 0)
        found = [asyncio.run(school.two.marks.weights(new.id)) for _ in range(2)]
        assert found == [{mine.variant: {"l3": 3.0}}] * 2


def test_the_slots_of_a_published_set_are_read_once_and_its_deadlines_each_time(
    school: School, monkeypatch: pytest.MonkeyPatch
) -> None:
    new, asked = school.published(), []
    mine = school.opened(new.slots[0], "anna").variant or ""
    with listening(lambda *told: asked.append(told[2])):
        first = asyncio.run(school.one.sets.place(mine))
        assert first is not None and first.task_set.slots == new.slots
        asyncio.run(school.two.sets.move([(first.task_set, replace(first.task_set, due=NOW))]))
        again = asyncio.run(school.one.sets.place(mine))
        assert again is not None and (again.task_set.slots, again.task_set.due) == (new.slots, NOW)
        assert sum(one.startswith("SELECT slots.id") for one in asked) == 1
        monkeypatch.setattr(sets_of, "MOST_SETS", 0)
        other = school.opened(school.published().slots[1], "bob").variant or ""
        for variant in (other, mine):
            found = asyncio.run(school.one.sets.place(variant))
            assert found is not None and found.slot in found.task_set.slots


def test_the_place_of_a_card_is_told_without_what_it_shows_unless_its_weights_stand_there_alone(school: School) -> None:
    new = school.published()
    mine, other = (school.opened(new.slots[0], who).variant or "" for who in ("anna", "bob"))
    bare = update(deck).where(deck.c.variant == other).values(weights=None)  # as an older version dealt it
    store = engine(school.url, connections=1)
    with store.begin() as connection:
        connection.execute(bare)
    store.dispose()
    asked: list[str] = []
    with listening(lambda *told: asked.append(told[2])):
        found = [asyncio.run(school.one.sets.place(variant)) for variant in (mine, other)]
    assert [place and place.card.weights for place in found] == [{"l3": 2.0}] * 2
    assert sum("shown" in one for one in asked) == 1
    shown = [asyncio.run(school.one.sets.shown(variant, "pl")) for variant in (mine, "practice")]
    assert shown[0] is not None and (shown[0]["title"], shown[1]) == ("1", None)


@contextmanager
def listening(note: Callable[..., Any]) -> Iterator[None]:
    """Hear of the statements that are sent to databases."""
    event.listen(Engine, "before_cursor_execute", note)
    yield
    event.remove(Engine, "before_cursor_execute", note)


def test_titles_are_those_of_the_cards_that_were_opened_last(school: School) -> None:
    task_set = school.published()
    slot = task_set.slots[0]
    assert asyncio.run(school.one.sets.titles(task_set.id, "anna", "pl")) == {}
    school.opened(slot, "anna")
    other = asyncio.run(school.one.sets.replace(slot, "anna", f"{slot.id} new", NOW))
    assert other is not None
    assert asyncio.run(school.one.sets.titles(task_set.id, "anna", "pl")) == {1: other.shown["pl"]["title"]}
