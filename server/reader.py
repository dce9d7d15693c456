"""Who asks: a bearer token, an anonymous cookie, or nobody yet; and whether the route lets them."""

from __future__ import annotations

import re
import secrets
from dataclasses import dataclass
from typing import Annotated
from urllib.parse import urlsplit

from fastapi import Depends, Request, Response

from server import ids, language, tokens
from server.bench import Bench, Tools
from server.errors import Refused
from server.limits import ADDRESS, NEWCOMERS, OWNER
from server.policy import POLICIES, Role
from server.storage import Owner

COOKIE = "grubler_practice"
COOKIE_FORM = re.compile(r"[A-Za-z0-9_-]{43}")
COOKIE_DAYS = 180
SAFE = ("GET", "HEAD", "OPTIONS")


@dataclass(frozen=True, slots=True)
class Reader:
    """The one who asks; without an owner until the first variant is dealt."""

    role: Role
    owner: Owner | None
    language: str

    @property
    def owner_id(self) -> str | None:
        """Number of the owner, if there is one."""
        return self.owner.id if self.owner else None


async def admit(request: Request, bench: Tools) -> Reader:
    """Let a reader in, or refuse: the policy of the route, the token, the origin of the page that posts.

    Raises:
        Refused: 401 for a bad or missing token, 403 for a role that does not suffice or a foreign page, 429 for too
            many posts.
    """
    needed = POLICIES.get((request.method, request.scope["route"].path))
    if needed is None:
        raise Refused(403, "forbidden")
    role, owner = _known(request, bench)
    if role < needed:
        raise Refused(*((401, "token_needed") if role is Role.ANONYMOUS else (403, "forbidden")))
    if request.method not in SAFE and bench.settings.limited:
        _take_turn(request, bench, owner)
    return Reader(role, owner, language.of(request))


def _take_turn(request: Request, bench: Bench, owner: Owner | None) -> None:
    """Count a post of its owner and of its address, which behind a proxy is not known."""
    turns = [(OWNER, owner.id)] if owner else []
    if request.client is not None and bench.settings.public_url is None and (owner is None or owner.anonymous):
        turns += [(ADDRESS, request.client.host)] + ([] if owner else [(NEWCOMERS, request.client.host)])
    seconds = max((bench.limiter.wait(rate, name) for rate, name in turns), default=0)
    if seconds:
        raise Refused(429, "too_many", headers={"Retry-After": str(seconds)}, seconds=seconds)


Asking = Annotated[Reader, Depends(admit)]


def _known(request: Request, bench: Bench) -> tuple[Role, Owner | None]:
    authorization = request.headers.get("authorization")
    if authorization is not None:
        return _bearer(authorization, bench.secret)
    if request.method not in SAFE:
        _check_origin(request, bench)
    kept = request.cookies.get(cookie_name(bench), "")
    owner = Owner(ids.digest(kept.encode()), anonymous=True) if COOKIE_FORM.fullmatch(kept) else None
    return Role.ANONYMOUS, owner


def _bearer(authorization: str, secret: bytes) -> tuple[Role, Owner]:
    scheme, _, token = authorization.partition(" ")
    try:
        if scheme.lower() != "bearer":
            raise tokens.BadToken(scheme)
        role, subject = tokens.read(token.strip(), secret)
    except tokens.BadToken:
        raise Refused(401, "bad_token", headers={"WWW-Authenticate": "Bearer"}) from None
    return role, Owner(ids.digest(b"subject", subject.encode()), anonymous=False)


def _check_origin(request: Request, bench: Bench) -> None:
    """A browser tells from which page it posts; a page of another site may not use our cookies."""
    origin, site = request.headers.get("origin"), request.headers.get("sec-fetch-site")
    ours = {request.headers.get("host"), urlsplit(bench.settings.public_url or "").netloc}
    foreign = origin is not None and (not urlsplit(origin).netloc or urlsplit(origin).netloc not in ours)
    if foreign or site in ("cross-site", "same-site"):
        raise Refused(403, "foreign_page")


def cookie_name(bench: Bench) -> str:
    """Give the name of the practice cookie; the prefix binds it to this host where https allows that."""
    return f"__Host-{COOKIE}" if bench.settings.https else COOKIE


def welcome(reader: Reader, bench: Bench) -> tuple[Owner, str | None]:
    """Give the owner of what is dealt now, and the cookie to set when the owner is new."""
    if reader.owner is not None:
        return reader.owner, None
    cookie = secrets.token_urlsafe(32)
    return Owner(ids.digest(cookie.encode()), anonymous=True), cookie


def remember(response: Response, bench: Bench, cookie: str | None) -> None:
    """Give a new owner the cookie that owns the variants."""
    if cookie is not None:
        age = COOKIE_DAYS * 24 * 3600
        response.set_cookie(
            cookie_name(bench), cookie, max_age=age, httponly=True, samesite="lax", secure=bench.settings.https
        )
