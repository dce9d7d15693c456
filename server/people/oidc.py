"""Signing in with a university account: OpenID Connect, code flow with PKCE, one registered issuer."""

from __future__ import annotations

import base64
import secrets
import time
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from hmac import compare_digest
from hmac import digest as hmac
from typing import Any
from urllib.parse import urlencode

from joserfc import jwt
from joserfc.errors import JoseError
from joserfc.jwk import KeySet, OctKey
from starlette.concurrency import run_in_threadpool

from server.people import identity
from server.people.oidc_fetch import Unreachable, fetch, trusted
from server.settings import Provider
from server.storage.people import Person
from server.web import ids
from server.web.errors import Refused
from server.workbench import Bench

COOKIE = "grubler_oidc"
LASTS = 600  # s from leaving for the issuer to coming back
ALGORITHMS = ("RS256", "ES256")
LONGEST = 200  # characters of a subject, as the store holds it


@dataclass(frozen=True, slots=True)
class Journey:
    """What a browser takes along to the issuer and back, sealed in a cookie."""

    state: str
    nonce: str
    verifier: str
    onward: str
    person: str


async def leave(bench: Bench, onward: str, person: str) -> tuple[str, str]:
    """Begin signing in; gives the issuer's address and the cookie.

    Raises:
        Refused: 503, the issuer does not answer.
    """
    provider = provider_of(bench)
    state, nonce, verifier = (secrets.token_urlsafe(32) for _ in range(3))
    journey = Journey(state, nonce, verifier, onward, person)
    challenge = base64.urlsafe_b64encode(sha256(journey.verifier.encode()).digest()).rstrip(b"=").decode()
    asked = {
        "response_type": "code", "scope": "openid profile", "client_id": provider.client_id,
        "redirect_uri": _back(bench), "state": journey.state, "nonce": journey.nonce,
        "code_challenge": challenge, "code_challenge_method": "S256",
    }  # fmt: skip
    endpoint = _text((await _described(provider))["authorization_endpoint"])
    if not trusted(provider.issuer, endpoint):
        raise _down()
    return f"{endpoint}{'&' if '?' in endpoint else '?'}{urlencode(asked)}", _sealed(bench, journey)


async def arrive(bench: Bench, cookie: str, state: str, code: str) -> tuple[Person, str]:
    """Finish signing in; gives the person and where the journey leads.

    Raises:
        Refused: 401 for anything that does not fit together, 503 where the issuer does not answer.
    """
    journey, provider = _opened(bench, cookie), provider_of(bench)
    if journey is None or not code or not compare_digest(journey.state.encode(), state.encode()):
        raise Refused(401, "wrong_provider")
    claims = await _claims(bench, provider, journey, code)
    return await _person(bench, provider, journey, claims), journey.onward


def provider_of(bench: Bench) -> Provider:
    """Give the registered issuer; raises Refused where there is none."""
    if bench.settings.provider is None:
        raise Refused(404, "not_found")
    return bench.settings.provider


async def _claims(bench: Bench, provider: Provider, journey: Journey, code: str) -> dict[str, Any]:
    described = await _described(provider)
    form = {
        "grant_type": "authorization_code", "code": code, "redirect_uri": _back(bench),
        "client_id": provider.client_id, "code_verifier": journey.verifier,
    } | ({"client_secret": provider.client_secret} if provider.client_secret else {})  # fmt: skip
    given = await _fetched(provider, described["token_endpoint"], form)
    keys = await _fetched(provider, described["jwks_uri"])
    try:
        return _read(provider, journey, _text(given.get("id_token")), keys)
    except (JoseError, ValueError, TypeError, KeyError) as error:
        raise Refused(401, "wrong_provider") from error


def _read(provider: Provider, journey: Journey, token: str, keys: Any) -> dict[str, Any]:
    """Check the issuer's word: its signature, made for us, now, and in answer to this very question."""
    claims: dict[str, Any] = jwt.decode(token, KeySet.import_key_set(keys), algorithms=ALGORITHMS).claims
    jwt.JWTClaimsRegistry(
        leeway=30,
        iss={"essential": True, "value": provider.issuer},
        aud={"essential": True, "value": provider.client_id},
        exp={"essential": True},
        iat={"essential": True},
        nonce={"essential": True, "value": journey.nonce},
        sub={"essential": True},
    ).validate(claims)
    many = isinstance(claims["aud"], list) and len(claims["aud"]) > 1
    if (many or "azp" in claims) and claims.get("azp") != provider.client_id:
        raise ValueError("the token was made for somebody else")
    if not isinstance(claims["sub"], str) or not 1 <= len(claims["sub"]) <= LONGEST:
        raise ValueError("the subject is no short text")
    return claims


async def _person(bench: Bench, provider: Provider, journey: Journey, claims: dict[str, Any]) -> Person:
    """Find who this is: the one who asked from the account page, the one known by this subject, or somebody new."""
    subject: str = claims["sub"]
    if journey.person:
        if not await bench.people.vouch(journey.person, provider.issuer, subject):
            raise Refused(409, "taken_subject")
        found = await bench.people.person(journey.person)
    else:
        found = await bench.people.by_subject(provider.issuer, subject)
    if found is None and not journey.person:
        found = await _new(bench, provider, subject, claims)
    if found is None or not found.active:
        raise Refused(401, "wrong_provider")
    return found


async def _new(bench: Bench, provider: Provider, subject: str, claims: dict[str, Any]) -> Person | None:
    """Store somebody new, as a student: neither role nor e-mail is taken from the issuer's word."""
    try:
        name = identity.name_of(str(claims.get("name") or claims.get("preferred_username") or subject))
    except Refused:
        name = identity.name_of("person " + ids.new())
    person = Person(ids.new(), None, name, "student", datetime.now(UTC), issuer=provider.issuer, subject=subject)
    await bench.people.add(person)
    return await bench.people.by_subject(provider.issuer, subject)  # two windows at once make one person


async def _described(provider: Provider) -> dict[str, Any]:
    described = await _fetched(provider, provider.issuer.rstrip("/") + "/.well-known/openid-configuration")
    needed = ("authorization_endpoint", "token_endpoint", "jwks_uri")
    if described.get("issuer") != provider.issuer or not all(isinstance(described.get(key), str) for key in needed):
        raise _down()
    return described


async def _fetched(provider: Provider, url: str, form: dict[str, str] | None = None) -> dict[str, Any]:
    try:
        return await run_in_threadpool(fetch, provider.issuer, url, form)
    except Unreachable as error:
        raise _down() from error


def _down() -> Refused:
    return Refused(503, "provider_down", headers={"Retry-After": "30"})


def _back(bench: Bench) -> str:
    return f"{bench.settings.address}/oidc/callback"


def _sealed(bench: Bench, journey: Journey) -> str:
    claims = {name: getattr(journey, name) for name in Journey.__slots__}
    return jwt.encode({"alg": "HS256"}, claims | {"exp": int(time.time()) + LASTS}, _key(bench))


def _opened(bench: Bench, cookie: str) -> Journey | None:
    try:
        claims = jwt.decode(cookie[:4096], _key(bench), algorithms=["HS256"]).claims
        jwt.JWTClaimsRegistry(exp={"essential": True}).validate(claims)
        return Journey(*(claims[name] for name in Journey.__slots__))
    except (JoseError, ValueError, KeyError):
        return None


def _key(bench: Bench) -> OctKey:
    return OctKey.import_key(hmac(bench.secret, b"journeys to the issuer", "sha256"))


def _text(value: Any) -> str:
    return value if isinstance(value, str) else ""
