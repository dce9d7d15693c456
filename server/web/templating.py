"""Pages from templates: everything is escaped but what the exercise room has made itself."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, partial
from typing import Any
from urllib.parse import urlencode

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from graders.words import NAMES, marked
from server.sets import clock
from server.web import language as languages

THEMES = ("system", "light", "dark")
THEME_COOKIE = "grubler_theme"
PREFERENCE_AGE = 365 * 24 * 3600  # s


@cache
def _templates() -> Environment:
    return Environment(
        loader=PackageLoader("server", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def page(
    request: Request,
    language: str,
    name: str,
    context: Mapping[str, Any],
    *,
    status: int = 200,
    path: str | None = None,
) -> HTMLResponse:
    """Render a page in the reader's language and appearance, and keep both if they were just chosen.

    Args:
        request: The request that is answered.
        language: The reader's language.
        name: File name of the template.
        context: What the template shows.
        status: HTTP status.
        path: Where the language switch leads, when it is not the address of this page.
    """
    theme = _theme(request)
    html = (
        _templates()
        .get_template(name)
        .render(
            t=partial(_said, language),
            n=partial(counted, language),
            number=partial(decimal, language),
            day=partial(clock.day_stamp, language),
            language=language,
            spoken=NAMES,
            theme=theme,
            assets=request.app.state.assets,
            me=getattr(getattr(request.state, "reader", None), "person", None),
            here=partial(_here, request, path),
            **context,
        )
    )
    response = HTMLResponse(html, status, {"Content-Language": language, "Vary": "Accept-Language, Cookie"})
    _keep(request, response, languages.COOKIE, language, request.query_params.get("lang") == language)
    _keep(request, response, THEME_COOKIE, theme, request.query_params.get("theme") == theme)
    return response


def keep_preferences(response: Response, secure: bool, language: str | None, theme: str | None) -> None:
    """Keep language and appearance in a browser, where a person has chosen them."""
    for name, value in ((languages.COOKIE, language), (THEME_COOKIE, theme)):
        if value is not None:
            response.set_cookie(name, value, max_age=PREFERENCE_AGE, httponly=True, samesite="lax", secure=secure)


def error_page(
    request: Request, language: str, context: Mapping[str, Any], number: str, headers: Mapping[str, str] | None
) -> Response:
    """Render the page of an error: what happened, what is safe, what was typed, the number to quote, the way back."""
    told = {**context, "quote": number, "wait": (headers or {}).get("Retry-After")}
    response = page(request, language, "error.html", told, status=context["status"], path="/")
    response.headers.update(headers or {})
    return response


def counted(language: str, number: int, key: str) -> str:
    """Word a number of things: `1 liczba`, `3 liczby`, `5 liczb`."""
    return f"{number} {languages.say(language, f'{key}_{plural(language, number)}')}"


def decimal(language: str, value: float) -> str:
    """Write a number of points as a language does: at most three places."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return marked(text, language)


def plural(language: str, number: int) -> str:
    """Give the form of a noun after a number: one, few or many."""
    tail, teens = number % 10, number % 100 in (12, 13, 14)
    if number == 1 or (language == "ru" and tail == 1 and number % 100 != 11):
        return "one"
    return "few" if language != "en" and tail in (2, 3, 4) and not teens else "many"


def _said(language: str, key: str, **values: object) -> str:
    """Word a sentence for a page; a value that is markup, such as a moment, stays so, and all else is escaped."""
    if not any(isinstance(value, Markup) for value in values.values()):
        return languages.say(language, key, **values)
    return Markup(escape(languages.words(language)[key])).format_map(values)


def _theme(request: Request) -> str:
    wishes = request.query_params.get("theme"), request.cookies.get(THEME_COOKIE)
    return next((wish for wish in wishes if wish in THEMES), "system")


def _here(request: Request, path: str | None, **changes: str) -> str:
    """This page with another language or appearance."""
    kept = [] if path else [one for one in request.query_params.multi_items() if one[0] not in changes]
    return f"{path or request.url.path}?{urlencode([*kept, *changes.items()])}"


def _keep(request: Request, response: Response, name: str, value: str, chosen: bool) -> None:
    if chosen:
        secure = request.app.state.settings.https
        response.set_cookie(name, value, max_age=PREFERENCE_AGE, httponly=True, samesite="lax", secure=secure)
