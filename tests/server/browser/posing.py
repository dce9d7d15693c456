"""Kinds that no exercise of the catalogue asks for, on the page of a workspace that judges what is handed in."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any
from urllib.parse import parse_qsl

from playwright.sync_api import Page, Request, Route

from exercises.presenting import Field
from graders import (
    AnswerSyntaxError,
    Choices,
    Grader,
    Ordering,
    Samples,
    SymbolicMatrix,
    Symbols,
    System,
    Text,
    Verdict,
)
from graders.verdict import unreadable
from server.answering.forms import Form
from server.answering.submissions import judged
from server.answering.workspace import _line
from server.web import language as languages
from server.web.templating import _templates
from tests.graders.fuzzing.posed import posed
from tests.server.browser import components
from tests.server.browser.walking import desk

NAMES = ("one", "two", "three")
NOTHING = Symbols(())
HARD = {judge.kind: (judge, reference, symbols) for judge, reference, symbols in posed()}
POSED: dict[str, tuple[Grader, Any, Symbols]] = {
    Choices.kind: (Choices(NAMES), "one; three", NOTHING),
    Ordering.kind: (Ordering(NAMES), "two; three; one", NOTHING),
    SymbolicMatrix.kind: HARD[SymbolicMatrix.kind],
    System.kind: HARD[System.kind],
    Text.kind: (Text(), None, NOTHING),
}
SIZE = {"rows": 3, "columns": 3}  # of the matrix
FIELDS: dict[str, Field] = {
    kind: components.field(kind, **components.SHAPES.get(kind, {}) | (SIZE if kind == SymbolicMatrix.kind else {}))
    for kind in POSED
}


def texts(kind: str) -> tuple[str | None, ...]:
    """A right, a wrong and an unreadable text; None where a kind has none, or boxes cannot be ticked so."""
    judge, reference, _ = POSED[kind]
    shown: Samples = judge.samples(reference)
    first = [next(filter(str.strip, found), None) for found in (shown.right, shown.wrong, shown.unreadable)]
    return ("one; three", "two", None) if kind == Choices.kind else tuple(first)


def page(page: Page, address: str) -> None:
    """Open a workspace whose answers are the posed ones; what is handed in comes back with its verdicts."""
    desk(page, address)
    whole = page.request.get(page.url).text().replace("data-draft=", "data-kept=")

    def answer(route: Route, request: Request) -> None:
        pairs = parse_qsl(request.post_data or "", keep_blank_values=True)
        every = {name: [value for one, value in pairs if one == name] for name, _ in pairs}
        typed = {kind: Form(dict(pairs), every, b"").answer(field) for kind, field in FIELDS.items()}
        body = components.put(whole, _answers(typed if pairs else {}))
        route.fulfill(body=body, content_type="text/html")

    page.route(page.url, answer)
    page.goto(page.url)


def _answers(typed: Mapping[str, str]) -> str:
    template, words = _templates().get_template("answer.html"), partial(languages.say, "en")
    lines = [
        _line(at, field, typed.get(kind, ""), None, judged(_verdict(kind, typed[kind]), "en") if typed else None, None)
        for at, (kind, field) in enumerate(FIELDS.items(), 1)
    ]
    return "".join(template.render(line=line, t=words) for line in lines)


def _verdict(kind: str, text: str) -> Verdict:
    judge, reference, symbols = POSED[kind]
    try:
        return judge.check(judge.parse(text, symbols), reference)
    except AnswerSyntaxError as error:
        return unreadable(error)
