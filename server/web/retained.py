"""What stood in a form that was refused: it is shown again, so that nobody has to type it twice."""

from __future__ import annotations

from collections.abc import Sequence
from urllib.parse import parse_qsl, urlsplit

from fastapi import HTTPException, Request
from starlette.requests import ClientDisconnect

FORM = "application/x-www-form-urlencoded"
WRITTEN = ("comment", "problem", "reason", "roster")  # what people write at length, beside answers; no password
MOST_FIELDS = 1000


async def typed(request: Request) -> Sequence[tuple[str, str]]:
    """Give names and texts of the answers and remarks in a posted form; none where the body cannot be read."""
    if request.method != "POST" or not request.headers.get("content-type", "").startswith(FORM):
        return ()
    try:
        pairs = parse_qsl((await request.body()).decode("utf-8"), max_num_fields=MOST_FIELDS)
    except (ValueError, HTTPException, ClientDisconnect):
        return ()
    return [(name.removeprefix("answer."), text) for name, text in pairs if _written(name) and text.strip()]


def _written(name: str) -> bool:
    return name.startswith("answer.") or name in WRITTEN


def page_before(request: Request) -> str:
    """Give the path of the page that a form was on; of the page itself where none was posted."""
    if request.method != "POST":
        return request.url.path
    before = urlsplit(request.headers.get("referer", ""))
    ours = before.netloc == request.headers.get("host") and before.path.startswith("/")
    return before.path if ours and not before.path.startswith("//") else "/home"
