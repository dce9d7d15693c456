"""The catalogue: which exercises there are, in the reader's language."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated
from urllib.parse import urlencode

from fastapi import APIRouter, Depends, Query
from pydantic import BaseModel

from exercises import catalogue, presenting
from exercises.variants import deal
from server.reader import Asking, admit
from server.web.errors import Failure, Refused
from server.web.language import LANGUAGES
from server.workbench import Bench, Tools

MOST = 100  # exercises in one answer

router = APIRouter(prefix="/api/v1/exercises", dependencies=[Depends(admit)], tags=["exercises"])


class Asked(BaseModel):
    """An answer that is asked for, without the numbers of a variant."""

    kind: str


class Exercise(BaseModel):
    """An exercise in the reader's language. Which answers it asks for is shown on one of its variants."""

    id: str
    chapter: str
    title: str
    summary: str
    systems: list[str]
    version: int
    minutes: int
    answers: dict[str, Asked]
    languages: list[str]


class Exercises(BaseModel):
    """A part of the catalogue, and where the next part is."""

    exercises: list[Exercise]
    next: str | None


@router.get("", responses={422: {"model": Failure}})
async def list_exercises(
    bench: Tools,
    reader: Asking,
    chapter: Annotated[str | None, Query(max_length=40)] = None,
    after: Annotated[str | None, Query(max_length=64)] = None,
    limit: Annotated[int, Query(ge=1, le=MOST)] = MOST,
) -> Exercises:
    """List the catalogue by chapter."""
    names = [name for name in catalogue.ids() if chapter in (None, catalogue.chapter_of(name))]
    start = names.index(after) + 1 if after in names else 0
    part = names[start : start + limit]
    further = {"chapter": chapter, "after": part[-1], "limit": limit} if start + limit < len(names) else None
    query = urlencode({name: value for name, value in (further or {}).items() if value is not None})
    shown = [await described(bench, name, reader.language) for name in part]
    return Exercises(exercises=shown, next=f"{router.prefix}?{query}" if further else None)


@router.get("/{exercise}", responses={404: {"model": Failure}, 422: {"model": Failure}})
async def show_exercise(exercise: str, bench: Tools, reader: Asking) -> Exercise:
    """Describe one exercise."""
    return await described(bench, known(exercise), reader.language)


def known(exercise: str) -> str:
    """Give the id back if there is such an exercise.

    Raises:
        Refused: 404, there is none.
    """
    if exercise not in catalogue.ids():
        raise Refused(404, "unknown_exercise")
    return exercise


async def described(bench: Bench, exercise: str, language: str) -> Exercise:
    """Describe an exercise in a language."""
    shown = await bench.judging.run(sample, exercise, language)
    entry = catalogue.load(exercise)
    return Exercise(
        id=exercise,
        chapter=entry.chapter,
        title=shown.title,
        summary=shown.summary,
        systems=list(entry.exercise.systems),
        version=entry.exercise.version,
        minutes=entry.exercise.minutes,
        answers={name: Asked(kind=field.kind) for name, field in shown.answers.items()},
        languages=list(LANGUAGES),
    )


@lru_cache(maxsize=2048)
def sample(exercise: str, language: str) -> presenting.Presented:
    """Present one variant of an exercise, always the same, for its card."""
    return presenting.presented(deal(exercise, 0), language)


def title(exercise: str, language: str) -> str:
    """Give the title of an exercise."""
    return sample(exercise, language).title
