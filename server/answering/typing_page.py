"""How answers are typed: a page of examples, each read by the judge that reads such an answer."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from fastapi import APIRouter, Depends, Request
from starlette.responses import HTMLResponse

from graders import (
    DHTable,
    Diagram,
    Equation,
    Expression,
    Function,
    Grader,
    Inequality,
    Matrix,
    Quantity,
    Set,
    SymbolicMatrix,
    Symbols,
)
from graders.words import comma
from server.answering.previews import Understood, told
from server.answering.workspace import HELPED
from server.reader import Asking, admit
from server.web.templating import page
from server.workbench import Tools

SYMBOLS = Symbols(["l1", "l2", "alpha1", "alpha2", "omega1", "a", "b", "x", "q1", "q2", "L1", "L2", "R_A", "F1", "a1"])
NUMBER, ANGLE, FORMULA = Quantity("kN"), Quantity("deg"), Expression(step="x")
SAMPLES: dict[str, tuple[tuple[Grader, str], ...]] = {  # by the part of the page
    "numbers": tuple((NUMBER, typed) for typed in ("12.5", "12.5 kN", "12 500 N", "1.25e4 N", "1.25·10^4 N", "25/2")),
    "angles": tuple((ANGLE, typed) for typed in ("-12.37", "-12.37°", "12°22'12\"", "0.5236 rad", "pi/6")),
    "formulas": (
        *((FORMULA, typed) for typed in ("-l1*omega1*sin(alpha1)", "2 l1 cos α1", "(a + b)/(2*l1)", "a^2/b")),
        *((FORMULA, typed) for typed in ("sqrt(a^2 + b^2)", "sin(alpha1)^2", "atan2(b; a)", "cos(30°)")),
    ),
    "matrices": (
        (Matrix(2, 2), "[[1; 0], [0; 0.5]]"),
        (SymbolicMatrix("x", 2, 2), "[[cos(q1); -sin(q1)], [sin(q1); cos(q1)]]"),
        (DHTable("RR"), "[[q1; 0; L1; 0]; [q2; 0; L2; 0]]"),
    ),
    "lists": ((Set("mm"), "12.5; 13"), (Set(("deg", "deg")), "(30°; 45°); (-30°; 60°)")),
    "relations": (
        (Equation("x", (0, 1)), "l1*sin(alpha1) + l2*sin(alpha2) = 0"),
        (Inequality("x <= a", "x"), "0 < x <= a"),
        (Function("x", ("a1",)), "R_A*x - F1*<x - a1>^1"),
        (Diagram("kN"), "0 .. 1.5: 4 - 2*x"),
    ),
}

router = APIRouter(dependencies=[Depends(admit)], include_in_schema=False)


@dataclass(frozen=True, slots=True)
class Example:
    """What is typed, and how it is read."""

    typed: str
    read: Understood


@router.get("/typing")
async def show_typing(request: Request, bench: Tools, reader: Asking) -> HTMLResponse:
    """Show how answers are typed."""
    parts = await bench.judging.run(examples, reader.language)
    return page(request, reader.language, "typing.html", {"parts": parts, "kinds": HELPED})


@lru_cache(maxsize=8)
def examples(language: str) -> dict[str, tuple[Example, ...]]:
    """Give the examples of each part of the page, read by their judges."""
    return {part: tuple(_read(samples, language)) for part, samples in SAMPLES.items()}


def _read(samples: tuple[tuple[Grader, str], ...], language: str) -> Iterator[Example]:
    for judge, text in samples:
        typed = as_written(text, language)
        yield Example(typed, told(judge.echo(judge.parse(typed, SYMBOLS), comma(language)), language))


def as_written(text: str, language: str) -> str:
    """Write an example with the decimal sign of a language."""
    return re.sub(r"(?<=\d)\.(?=\d)", ",", text) if comma(language) else text
