"""The ladder of hints under wrong answers: what is open of it, and opening the next step at the price of the set."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends
from pydantic import BaseModel, ConfigDict, Field, StrictInt

from exercises import presenting
from graders.verdict import OUTCOMES, Code, Outcome
from server.answering.variants import GONE, ladder_is_open, restored, visible
from server.answering.workspace import Line, laddered
from server.reader import Asking, Reader, admit
from server.sets.handing import is_held, refuse_unless_working, rules_of
from server.storage import Dealt
from server.storage.sets import Hint, Place
from server.web.errors import Failure, Refused
from server.web.typed import Typed
from server.workbench import Bench, Tools

ASTRAY = (Outcome.WRONG, Outcome.PARTLY)
MOST_STEPS = 9

router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["hints"])


class NextHint(BaseModel):
    """The step that is to be opened under an answer, from 1; one that is open costs nothing again."""

    model_config = ConfigDict(extra="forbid", json_schema_extra={"examples": [{"answer": "l3", "step": 1}]})
    answer: Typed
    step: Annotated[StrictInt, Field(ge=1, le=MOST_STEPS)]


class Ladder(BaseModel):
    """The hints under an answer that was wrong or partly right, as HTML: the symbols it follows from, its equation,
    and that with the numbers of the task; in a laboratory the shape of the equation, and that with its functions.

    `left` are the steps that can still be opened, each for `price`, a share of the points of the task.
    """

    answer: str
    steps: list[str]
    left: int
    price: float


@router.get("/variants/{variant}/hints", responses=GONE | {422: {"model": Failure}})
async def show_hints(variant: str, bench: Tools, reader: Asking) -> list[Ladder]:
    """Give the hints under the answers that were handed in last; none where there are none to give."""
    return await ladders(bench, reader, await visible(bench, reader, variant))


@router.post(
    "/variants/{variant}/hints", responses=GONE | {code: {"model": Failure} for code in (403, 409, 413, 422, 503)}
)
async def buy_hint(variant: str, wish: NextHint, bench: Tools, reader: Asking) -> Ladder:
    """Open the next hint under an answer at its price."""
    dealt = await visible(bench, reader, variant)
    await open_hint(bench, reader, dealt, wish.answer, str(wish.step))
    return next(one for one in await ladders(bench, reader, dealt) if one.answer == wish.answer)


async def ladders(bench: Bench, reader: Reader, dealt: Dealt) -> list[Ladder]:
    """Give the ladders under the answers of the last submission: whole ones, or what was opened at a price."""
    if not await ladder_is_open(bench, reader, dealt):
        return []
    cost, opened = await price(bench, reader, dealt), Counter[str]()
    if cost:
        opened.update(hint.answer for hint in await bench.sets.hints(dealt.id))
    astray, found = await _astray(bench, dealt), list[Ladder]()
    for answer in dict.fromkeys((*astray, *opened)):
        steps = await bench.judging.run(presenting.ladder, restored(dealt), answer, reader.language)
        seen = steps[: opened[answer]] if cost else steps
        left = len(steps) - len(seen) if answer in astray else 0
        found += [Ladder(answer=answer, steps=[step.html for step in seen], left=left, price=cost)] if steps else []
    return found


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
        Refused: 403, the set is closed, or the student has left the course; 409, there is no such step to open now.
    """
    now, place = datetime.now(UTC), await bench.sets.place(dealt.id) if dealt.code else None
    if place is None or not await price(bench, reader, dealt) or not await _offered(bench, place, dealt, answer):
        raise Refused(409, "no_hint")
    refuse_unless_working(place, now)
    steps = await bench.judging.run(presenting.ladder, restored(dealt), answer, reader.language)
    bought = sum(hint.answer == answer for hint in await bench.sets.hints(dealt.id))
    if rung not in map(str, range(1, min(bought + 1, len(steps)) + 1)):
        raise Refused(409, "no_hint")
    await bench.sets.open_hint(Hint(dealt.id, answer, int(rung), now))


async def _offered(bench: Bench, place: Place, dealt: Dealt, answer: str) -> bool:
    """Tell whether the last answer was wrong or partly right, and its student is told so."""
    return rules_of(place.task_set).ladder and answer in await _astray(bench, dealt)


async def _astray(bench: Bench, dealt: Dealt) -> list[str]:
    """Name the answers that were wrong or partly right when they were last handed in; none while that is held back."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is not None and is_held(place, datetime.now(UTC)):
        return []
    last = await bench.storage.latest(dealt.id)
    verdicts = last.grade["verdicts"] if last else {}
    return [name for name, verdict in verdicts.items() if OUTCOMES[Code(verdict["code"])] in ASTRAY]
