"""Variants: dealing one, looking at it, and the worked solution."""

from __future__ import annotations

import secrets
from collections.abc import Mapping
from datetime import UTC, datetime, timedelta
from functools import lru_cache
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Response
from pydantic import BaseModel, ConfigDict, Field, StrictInt, TypeAdapter

from exercises import presenting
from exercises import variants as dealing
from exercises.catalogue import UnknownExercise
from exercises.exercise import Variant
from server.catalogue.api import known
from server.policy import CourseRole, Role, may_see_solution, may_see_variant
from server.reader import Asking, Reader, admit, remember, role_in, welcome
from server.sets import handing
from server.storage import Dealt
from server.web import ids
from server.web.errors import Failure, Refused, unknown_variant
from server.workbench import Bench, Tools

USED = timedelta(days=1)  # how exactly the last use is noted; a variant expires after 30 idle days
SEED_RANGE = dealing.MAX_SEED
PRESENTED: TypeAdapter[presenting.Presented] = TypeAdapter(presenting.Presented)

KEPT = 512  # variants whose pages need not be drawn again
router = APIRouter(prefix="/api/v1", dependencies=[Depends(admit)], tags=["variants"])
GONE: dict[int | str, dict[str, Any]] = {404: {"model": Failure}, 410: {"model": Failure}}


class NewVariant(BaseModel):
    """What may be wished for: a seed, so that two people get the same numbers."""

    model_config = ConfigDict(extra="forbid", json_schema_extra={"examples": [{"seed": 7}]})
    seed: Annotated[StrictInt, Field(ge=0, le=SEED_RANGE)] | None = None


class GivenLine(BaseModel):
    """A number of the statement: its name (HTML, empty on older cards), symbol (MathML) and printed value."""

    name: str
    symbol: str
    value: str


class Option(BaseModel):
    """One of the answers to choose from."""

    key: str
    html: str


class AskedFor(BaseModel):
    """An answer to give: how it is typed, in which unit, with which symbols, how exactly."""

    kind: str
    prompt: str
    prompt_html: str
    symbol: str
    unit: str
    symbols: list[str]
    tolerance: str
    rtol: float | None
    atol: float | None
    rows: int
    columns: int
    options: list[Option]


class Table(BaseModel):
    """A figure as a table."""

    header: list[str]
    rows: list[list[str]]


class ShownVariant(BaseModel):
    """A variant as its owner sees it. Nothing in it depends on a reference value.

    One that is dealt from a task set has a code, and no seed for its student.
    """

    id: str
    exercise: str
    version: int
    seed: int | None
    code: str | None
    title: str
    statement: str
    statement_text: str
    figure: str | None
    figure_table: Table | None
    givens: dict[str, Any]
    data: list[GivenLine]
    answers: dict[str, AskedFor]


class SolutionLine(BaseModel):
    """One line of the worked solution."""

    heading: str
    formula: str
    formula_text: str
    value: str


class Solution(BaseModel):
    """The worked solution with the numbers of the variant."""

    lines: list[SolutionLine]


@router.post(
    "/exercises/{exercise}/variants",
    status_code=201,
    responses={404: {"model": Failure}, 422: {"model": Failure}, 503: {"model": Failure}},
)
async def deal_variant(
    exercise: str, bench: Tools, reader: Asking, response: Response, wish: NewVariant | None = None
) -> ShownVariant:
    """Deal a variant for practice. It belongs to the bearer, or to the cookie that comes with it."""
    dealt, cookie = await dealt_to(bench, reader, exercise, wish.seed if wish else None)
    remember(response, bench, cookie)
    response.headers["Location"] = f"{router.prefix}/variants/{dealt.id}"
    return await shown(bench, dealt, reader.language)


@router.get("/variants/{variant}", responses=GONE | {422: {"model": Failure}})
async def show_variant(variant: str, bench: Tools, reader: Asking) -> ShownVariant:
    """Show a variant to its owner or to a lecturer."""
    dealt = await visible(bench, reader, variant)
    return await shown(bench, dealt, reader.language, resolved=reader.owner_id != dealt.owner.id)


@router.get("/variants/{variant}/solution", responses=GONE | {403: {"model": Failure}, 422: {"model": Failure}})
async def show_solution(variant: str, bench: Tools, reader: Asking) -> Solution:
    """Show the worked solution, once some submission to the variant has counted."""
    lines = await solved(bench, reader, await visible(bench, reader, variant))
    shown_lines = [
        SolutionLine(
            heading=line.heading_html, formula=line.formula_mathml, formula_text=line.formula_text, value=line.value
        )
        for line in lines
    ]
    return Solution(lines=shown_lines)


async def dealt_to(bench: Bench, reader: Reader, exercise: str, seed: int | None) -> tuple[Dealt, str | None]:
    """Deal a variant and store it; gives it and the cookie of a new owner.

    Raises:
        Refused: 403, an open set reserves the exercise, so its seeds cannot be chosen.
    """
    if seed is not None and reader.role < Role.LECTURER:
        await _refuse_reserved(bench, exercise)
    owner, cookie = welcome(reader, bench)
    drawn = secrets.randbelow(SEED_RANGE + 1) if seed is None else seed
    variant = await bench.judging.run(dealing.deal, known(exercise), drawn)
    givens, now = dealing.dump(variant)["givens"], datetime.now(UTC)
    assert isinstance(givens, Mapping)
    dealt = Dealt(ids.new(), owner, exercise, variant.version, drawn, givens, now, now)
    await bench.storage.keep_variant(dealt)
    return dealt, cookie


async def visible(bench: Bench, reader: Reader, number: str) -> Dealt:
    """Give a variant that this reader may see.

    Raises:
        Refused: 404, there is none, it has expired, or it is somebody else's.
    """
    dealt = await bench.storage.variant(number) if ids.known(number) else None
    if dealt is None or not await sees(bench, reader, dealt):
        raise unknown_variant()
    now = datetime.now(UTC)
    if now - dealt.last_used > USED:
        await bench.storage.touch(number, now)
    return dealt


async def sees(bench: Bench, reader: Reader, dealt: Dealt) -> bool:
    """Whether a reader may look at a variant and what was handed in for it."""
    return may_see_variant(reader.role, reader.owner_id, dealt, await _teaches(bench, reader, dealt))


async def _teaches(bench: Bench, reader: Reader, dealt: Dealt) -> bool:
    """Whether a reader teaches the owner: a card of a set is looked over in the course of the set alone, since whoever
    lectures may put anybody on a roster."""
    person, owner = reader.person, dealt.owner
    if person is None or owner.anonymous or owner.id == person.id:
        return False
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is None:
        return await bench.courses.teaches(person.id, owner.id)
    course = await bench.courses.course(place.task_set.course)
    role = await role_in(bench, reader, course) if course else None
    return role is not None and role >= CourseRole.ASSISTANT


def restored(dealt: Dealt) -> Variant:
    """Build the variant from what is stored.

    Raises:
        Refused: 410, the exercise was changed since so much that these givens no longer fit.
    """
    stored = {"exercise": dealt.exercise, "version": dealt.version, "seed": dealt.seed, "givens": dealt.givens}
    try:
        return dealing.restore(stored)
    except (UnknownExercise, ValueError, TypeError):
        raise Refused(410, "outdated_variant") from None


async def presented(bench: Bench, dealt: Dealt, language: str) -> presenting.Presented:
    """Present a variant in a language; one from a set as it was published."""
    card = await bench.sets.shown(dealt.id, language) if dealt.code else None
    if card is not None:
        return PRESENTED.validate_python(card)
    return await bench.judging.run(_presented, restored(dealt), language)


@lru_cache(maxsize=KEPT)
def _presented(variant: Variant, language: str) -> presenting.Presented:
    """Present a variant; drawing its figure again at every look is a third of the work of its page."""
    return presenting.presented(variant, language)


async def shown(bench: Bench, dealt: Dealt, language: str, *, resolved: bool = False) -> ShownVariant:
    """Show a stored variant in a language; `resolved` gives the seed behind a code."""
    seen = await presented(bench, dealt, language)
    picture = seen.picture
    return ShownVariant(
        id=dealt.id,
        exercise=dealt.exercise,
        version=dealt.version,
        seed=None if dealt.code and not resolved else dealt.seed,
        code=dealt.code,
        title=seen.title,
        statement=seen.statement_html,
        statement_text=seen.statement_text,
        figure=picture.svg if picture else None,
        figure_table=Table(header=list(picture.table.header), rows=list(map(list, picture.table.rows)))
        if picture
        else None,
        givens=dict(dealt.givens),
        data=[GivenLine(name=name, symbol=symbol, value=value) for name, symbol, value in seen.data],
        answers={name: asked_for(field) for name, field in seen.answers.items()},
    )


def asked_for(field: presenting.Field) -> AskedFor:
    """Describe an answer to give."""
    return AskedFor(
        kind=field.kind,
        prompt=field.prompt_text,
        prompt_html=field.prompt_html,
        symbol=field.symbol_mathml,
        unit=field.unit,
        symbols=list(field.symbols),
        tolerance=field.tolerance_text,
        rtol=field.rtol,
        atol=field.atol,
        rows=field.rows,
        columns=field.columns,
        options=[Option(key=key, html=html) for key, html in field.options],
    )


async def solved(bench: Bench, reader: Reader, dealt: Dealt) -> tuple[presenting.SolvedLine, ...]:
    """Give the worked solution.

    Raises:
        Refused: 403, not open yet.
    """
    if not await solution_is_open(bench, reader, dealt):
        if dealt.code is not None:
            raise Refused(403, "set_solution_closed", opens="rules_of_task_set")
        raise Refused(403, "solution_closed", opens="first_counted_submission")
    if dealt.code is None and reader.role < Role.LECTURER:
        await _refuse_reserved(bench, dealt.exercise)
    return await bench.judging.run(presenting.solution, restored(dealt), reader.language)


async def results_are_held(bench: Bench, reader: Reader, dealt: Dealt) -> bool:
    """Tell whether an examination holds back its results from this reader."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    return place is not None and reader.owner_id == dealt.owner.id and handing.is_held(place, datetime.now(UTC))


async def solution_is_open(bench: Bench, reader: Reader, dealt: Dealt) -> bool:
    """Tell whether a reader may see the worked solution: by the rules of the set, or in practice."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is None:
        return may_see_solution(reader.role, await bench.storage.counted(dealt.id))
    return reader.owner_id != dealt.owner.id or await handing.solution_is_open(bench, place)


async def ladder_is_open(bench: Bench, reader: Reader, dealt: Dealt) -> bool:
    """Tell whether wrong answers may be helped on: by the rules of the set, in practice unless a set reserves it."""
    place = await bench.sets.place(dealt.id) if dealt.code else None
    if place is None:
        return reader.role >= Role.LECTURER or not await bench.sets.reserved(dealt.exercise, datetime.now(UTC))
    return reader.owner_id != dealt.owner.id or handing.rules_of(place.task_set).ladder


async def _refuse_reserved(bench: Bench, exercise: str) -> None:
    if await bench.sets.reserved(exercise, datetime.now(UTC)):
        raise Refused(403, "reserved", opens="end_of_task_set")
