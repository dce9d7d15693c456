"""The pages of the catalogue: all exercises as cards, and one of them with the button that deals a variant."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request
from starlette.responses import HTMLResponse

from exercises import catalogue
from exercises.variants import MAX_SEED
from server.catalogue.api import known
from server.catalogue.shelf import Wish, card
from server.reader import Asking, admit
from server.web.templating import page
from server.workbench import Tools

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@router.get("/")
async def show_catalogue(
    request: Request, bench: Tools, reader: Asking,
    chapter: Annotated[str, Query(max_length=40)] = "", q: Annotated[str, Query(max_length=80)] = "",
    answer: Annotated[frozenset[str], Query()] = frozenset(), order: Annotated[str, Query(max_length=40)] = "",
) -> HTMLResponse:  # fmt: skip
    """Show all exercises or those of a chapter, that say something, are answered in some way; maybe shortest first."""
    cards = [await card(bench, name, reader.language) for name in catalogue.ids()]
    wish = Wish(chapter, q, answer, order == "time")
    counts = {"chapters": wish.chapters(cards), "ways": wish.answered_by(cards)}
    context = {"cards": wish.found(cards), **counts, "chapter": chapter, "q": q, "chosen": answer, "order": order}
    return page(request, reader.language, "catalogue.html", context)


@router.get("/exercises/{exercise}")
async def show_exercise(exercise: str, request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show one exercise and the button that deals a variant."""
    context = {"card": await card(bench, known(exercise), reader.language), "max_seed": MAX_SEED}
    return page(request, reader.language, "exercise.html", context)
