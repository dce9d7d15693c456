"""The ladder of hints under wrong answers: what is open of it, and opening the next step at the price of the set."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from datetime import UTC, datetime

from exercises import presenting
from graders.verdict import OUTCOMES, Code, Outcome
from server.bench import Bench
from server.errors import Refused
from server.reader import Reader
from server.sets.handing import is_held, own_window, refuse_unless_open, rules_of
from server.storage import Dealt
from server.storage.sets import Hint, Place
from server.variants import ladder_is_open, restored
from server.workspace import Line, laddered


async def with_ladders(bench: Bench, reader: Reader, dealt: Dealt, laid: Sequence[Line]) -> list[Line]:
    """Put ladders under the answers of a page: whole ones, or what a student has opened at a price."""
    if not await ladder_is_open(bench, reader, dealt):
        return list(laid)
    opened = None
    if await price(bench, reader, dealt):
        opened = Counter(hint.answer for hint in await bench.sets.hints(dealt.id))
    return await bench.judging.run(laddered, restored(dealt), laid, reader.language, opened)


async def price(bench: Bench, reader: Reader, dealt: Dealt) -> float:
    """Give the share of the points that a hint costs this reader; 0 in practice and for those who teach."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is None or reader.owner_id != dealt.owner.id:
        return 0.0
    return rules_of(place.task_set).hint_price


async def open_hint(bench: Bench, reader: Reader, dealt: Dealt, answer: str, rung: str) -> None:
    """Open a step of a ladder at its price; one that is open costs nothing again.

    Raises:
        Refused: 403, the set is closed; 409, there is no such step to open now.
    """
    now, place = datetime.now(UTC), await bench.sets.place(dealt.id) if dealt.code else None
    if place is None or not await price(bench, reader, dealt) or not await _offered(bench, place, dealt, answer):
        raise Refused(409, "no_hint")
    refuse_unless_open(own_window(place), now)
    steps = await bench.judging.run(presenting.ladder, restored(dealt), answer, reader.language)
    bought = sum(hint.answer == answer for hint in await bench.sets.hints(dealt.id))
    if rung not in map(str, range(1, min(bought + 1, len(steps)) + 1)):
        raise Refused(409, "no_hint")
    await bench.sets.open_hint(Hint(dealt.id, answer, int(rung), now))


async def _offered(bench: Bench, place: Place, dealt: Dealt, answer: str) -> bool:
    """Tell whether the last answer was wrong or partly right, and its student is told so."""
    last = await bench.storage.latest(dealt.id)
    verdict = last.grade["verdicts"].get(answer) if last else None
    astray = verdict is not None and OUTCOMES[Code(verdict["code"])] in (Outcome.WRONG, Outcome.PARTLY)
    return astray and rules_of(place.task_set).ladder and not is_held(place, datetime.now(UTC))
