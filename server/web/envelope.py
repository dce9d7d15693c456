"""Around every request: a number, a bounded body, security headers, and no traceback."""

from __future__ import annotations

import asyncio
import logging
import secrets
from time import perf_counter

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from server.web import logs
from server.web.errors import Refused, respond

METHODS = ("GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS")
LARGEST_BODY = 64 * 1024  # bytes
LARGEST_ROSTER = 512 * 1024  # bytes; a thousand lines in any alphabet, also as a form writes them
SLOWEST_BODY = 20.0  # s
log = logging.getLogger("grubler")

CONTENT_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; img-src 'self'; connect-src 'self'; "
    "frame-ancestors 'none'; form-action 'self'; base-uri 'none'"
)
HEADERS = {
    "Content-Security-Policy": CONTENT_POLICY,
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}
HSTS = {"Strict-Transport-Security": "max-age=31536000"}


class Envelope:
    """Wraps the application; `https` adds the header that keeps browsers on it."""

    def __init__(self, app: ASGIApp, https: bool) -> None:
        self._app = app
        self._headers = HEADERS | (HSTS if https else {})

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        head = scope["method"] == "HEAD"  # answered as GET, without the body
        scope = {**scope, "request_id": f"r-{secrets.token_hex(5)}"} | ({"method": "GET"} if head else {})
        sealed, start = Sealed(send, self._headers | {"X-Request-ID": scope["request_id"]}, head), perf_counter()
        logs.REQUEST.set(scope["request_id"])
        try:
            await self._app(scope, bounded(scope, receive), sealed)
        except Exception:  # nothing of ours may reach the reader but its number
            log.exception("request %s failed", scope["request_id"])
            if sealed.begun:
                raise
            await respond(Request(scope), Refused(500, "our_fault"))(scope, receive, sealed)
        finally:
            _note(scope, "HEAD" if head else scope["method"], sealed.status, perf_counter() - start)


def _note(scope: Scope, method: str, status: int, seconds: float) -> None:
    """Count and log a request under the pattern of its route; an unknown one has none."""
    route = getattr(scope.get("route"), "path", "") or "unknown"
    known = method if method in METHODS else "OTHER"
    scope["app"].state.metrics.answered(known, route, status, seconds)
    fields = {"method": known, "route": route, "status": status, "ms": round(1e3 * seconds, 1)}
    logs.answered({"request": scope["request_id"], **fields})


class Sealed:
    """Sends a response with our headers; what is made for one reader is not stored on its way."""

    def __init__(self, send: Send, headers: dict[str, str], head: bool = False) -> None:
        self._send = send
        self._headers = headers
        self._head = head
        self.begun = False
        self.status = 0  # none was sent

    async def __call__(self, message: Message) -> None:
        """Send one message."""
        if message["type"] == "http.response.start":
            self.begun, self.status = True, message["status"]
            headers = MutableHeaders(scope=message)
            headers.update(self._headers)
            headers.setdefault("Cache-Control", "no-store")
        elif self._head:
            message = {**message, "body": b""}
        await self._send(message)


def bounded(scope: Scope, receive: Receive) -> Receive:
    """Bound the size of a body and the time it may take, while it is read."""
    declared = Headers(scope=scope).get("content-length", "0")
    largest = LARGEST_ROSTER if scope["path"].endswith("/roster") else LARGEST_BODY
    size, whole = 0, False
    deadline = asyncio.get_running_loop().time() + SLOWEST_BODY

    async def read() -> Message:
        nonlocal size, whole
        if whole:
            return await receive()
        if declared.isdecimal() and int(declared) > largest:
            raise _too_large(largest)
        try:
            async with asyncio.timeout_at(deadline):
                message = await receive()
        except TimeoutError:
            raise Refused(408, "too_slow", headers={"Connection": "close"}) from None
        size += len(message.get("body", b""))
        whole = not message.get("more_body", False)
        if size > largest:
            raise _too_large(largest)
        return message

    return read


def _too_large(largest: int) -> Refused:
    return Refused(413, "too_large", headers={"Connection": "close"}, limit=largest // 1024)
