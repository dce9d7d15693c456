"""The one shape of an error, worded in the reader's language: JSON for programs, a page for people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote

from fastapi import FastAPI, HTTPException, Request
from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel
from starlette.exceptions import HTTPException as StarletteHTTPException
from starlette.responses import JSONResponse, RedirectResponse, Response

from server.judging.judging import JudgingEnded
from server.storage import KeyReused, StorageUnavailable, UnknownVariant
from server.web import language, retained, templating, typed

RETRY_AFTER = 2  # seconds; the store is usually back by then
CODES = {400: "malformed_json", 401: "bad_token", 403: "forbidden", 404: "not_found", 405: "method_not_allowed"}
ENDED = ("token_needed", "unknown_variant", "unknown_course")  # what somebody meets whose session has ended
KINDS = {
    "json_invalid": "malformed_json",
    "missing": "missing_field",
    "extra_forbidden": "extra_field",
    "bad_text": "bad_text",
    "greater_than_equal": "out_of_range",
    "less_than_equal": "out_of_range",
}


class Problem(BaseModel):
    """What went wrong, where, what opens a closed door, and the number to quote when you ask about it."""

    code: str
    message: str
    field: str | None = None
    position: int | None = None
    opens: str | None = None
    request_id: str


class Failure(BaseModel):
    """The body of every response that is not a success."""

    error: Problem


class Refused(HTTPException):
    """A request that is answered with an error; `values` stand in its sentence, unless `said` is the sentence."""

    def __init__(
        self, status: int, code: str, *, field: str | None = None, position: int | None = None,
        opens: str | None = None, headers: Mapping[str, str] | None = None, said: str | None = None, **values: object,
    ) -> None:  # fmt: skip
        super().__init__(status, code, dict(headers or {}))
        self.said = said and typed.sendable(said)
        self.field = field and typed.sendable(field)
        self.code, self.position, self.opens, self.values = code, position, opens, values


def install(app: FastAPI) -> None:
    """Answer every refusal, and every failure of the store and of the judging, in the one shape."""
    app.add_exception_handler(StarletteHTTPException, _http)
    app.add_exception_handler(RequestValidationError, _schema)
    for kind in (KeyReused, UnknownVariant, StorageUnavailable, JudgingEnded):
        app.add_exception_handler(kind, _store)


def unknown_variant() -> Refused:
    """A variant that does not exist, has expired, or belongs to somebody else: nobody can tell which."""
    return Refused(404, "unknown_variant")


def unavailable() -> Refused:
    """The store cannot take the request now."""
    return Refused(503, "unavailable", headers={"Retry-After": str(RETRY_AFTER)})


async def _store(request: Request, error: Exception) -> Response:
    if isinstance(error, KeyReused):
        return await _retaining(request, Refused(409, "key_reused"))
    return await _retaining(request, unknown_variant() if isinstance(error, UnknownVariant) else unavailable())


async def _http(request: Request, error: Exception) -> Response:
    assert isinstance(error, StarletteHTTPException)
    if isinstance(error, Refused):
        return await _retaining(request, error)
    status = 422 if error.status_code == 400 else error.status_code
    code = CODES.get(error.status_code, "invalid_value")
    return await _retaining(request, Refused(status, code, headers=error.headers))


async def _retaining(request: Request, error: Refused) -> Response:
    """Answer with an error; a page shows what was typed into the form that is refused."""
    return respond(request, error, await retained.typed(request) if wants_page(request) else ())


def _schema(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    return respond(request, _first(error.errors()[0]))


def _first(problem: Mapping[str, Any]) -> Refused:
    code = KINDS.get(problem["type"], "wrong_type")
    if code == "malformed_json":
        return Refused(422, code, position=problem["loc"][-1])
    field = ".".join(printable(part) for part in problem["loc"][1:3]) or None  # deeper parts name types
    if field is None:
        return Refused(422, "no_object")
    return Refused(422, code, field=field, name=field)


def printable(part: object) -> str:
    """Give what somebody sent in a form that can be shown: not too long, nothing invisible."""
    return "".join(sign if sign.isprintable() else "\ufffd" for sign in str(part)[:80])


def respond(request: Request, error: Refused, kept: Sequence[tuple[str, str]] = ()) -> Response:
    """Answer with an error: JSON below /api, for programs and probes; a page for a browser, with what was typed."""
    spoken = language.of(request)
    values = _named(spoken, error.values) if wants_page(request) else error.values
    problem = Problem(
        code=error.code,
        message=error.said or language.say(spoken, f"errors.{error.code}", **values),
        field=error.field,
        position=error.position,
        opens=error.opens,
        request_id=request.scope.get("request_id", ""),
    )
    if error.code == "token_needed" and wants_page(request) and request.method == "GET":
        back = quote(request.url.path, safe="/")
        return RedirectResponse(f"/signin?next={back}", 303, {"Content-Language": spoken})
    if wants_page(request):
        before, ended = retained.page_before(request), error.code in ENDED
        context = {
            "status": error.status_code, "message": problem.message, "kept": kept, "before": before, "ended": ended,
            "posted": request.method == "POST",
        }  # fmt: skip
        return templating.error_page(request, spoken, context, problem.request_id, error.headers)
    body = Failure(error=problem).model_dump()
    return JSONResponse(body, error.status_code, {**(error.headers or {}), "Content-Language": spoken})


def _named(spoken: str, values: Mapping[str, object]) -> Mapping[str, object]:
    """Name the field of a form as people call it; programs read the name that they send."""
    known = language.words(spoken).get(f"fields.{values.get('name')}")
    return {**values, "name": known} if known else values


def wants_page(request: Request) -> bool:
    """Whether the reader looks at pages, not at JSON; below /api only one who follows a link to a document does."""
    below_api = request.url.path.startswith("/api/") and request.headers.get("sec-fetch-mode") != "navigate"
    return not below_api and "text/html" in request.headers.get("accept", "")
