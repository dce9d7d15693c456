"""Bearer tokens: HS256 under a key of this server only, for this audience, for a limited time."""

from __future__ import annotations

import secrets
import time
from hmac import digest as hmac
from typing import Any

from joserfc import jwt
from joserfc.errors import JoseError
from joserfc.jwk import OctKey

from server.policy import Role

AUDIENCE = "grubler"
ALGORITHM = "HS256"
HOURS = 12
LONGEST = 2048  # characters
PERSONAL = "token:"  # begins the subject of a token that a person has made

_CLAIMS = jwt.JWTClaimsRegistry(
    leeway=0,
    aud={"essential": True, "value": AUDIENCE},
    exp={"essential": True},
    sub={"essential": True},
    role={"essential": True, "values": [role.name.lower() for role in Role]},
)


class BadToken(ValueError):
    """The token is not one of ours, or no longer."""


def issue(role: str, secret: bytes, *, subject: str | None = None, hours: float = HOURS) -> str:
    """Make a bearer token.

    Args:
        role: Name of the role, such as ``lecturer``.
        secret: The server's secret.
        subject: Whose token it is; a fresh name where none is given.
        hours: How long it is valid.

    Raises:
        ValueError: There is no such role.
    """
    if role.upper() not in Role.__members__:
        raise ValueError(f"no role {role!r}; there are {', '.join(known.name.lower() for known in Role)}")
    now = int(time.time())
    claims = {"sub": subject or secrets.token_hex(8), "role": role.lower(), "aud": AUDIENCE, "iat": now}
    return jwt.encode({"alg": ALGORITHM}, claims | {"exp": now + int(hours * 3600)}, _key(secret))


def read(token: str, secret: bytes) -> tuple[Role, str]:
    """Give the role and the subject of a token.

    Raises:
        BadToken: Another algorithm, key or audience, expired, or no token at all.
    """
    if len(token) > LONGEST:
        raise BadToken("the token is too long")
    try:
        claims: dict[str, Any] = jwt.decode(token, _key(secret), algorithms=[ALGORITHM]).claims
        _CLAIMS.validate(claims)
    except (JoseError, ValueError, TypeError) as error:
        raise BadToken(str(error)) from error
    if not isinstance(claims["sub"], str) or not isinstance(claims["role"], str):
        raise BadToken("subject and role are texts")
    return Role[claims["role"].upper()], claims["sub"]


def of_person(number: str, role: Role, secret: bytes, hours: float) -> str:
    """Make the bearer token of a person; the store knows it by its number and can revoke it."""
    return issue(role.name, secret, subject=PERSONAL + number, hours=hours)


def number_of(subject: str) -> str | None:
    """Give the number of a person's token, or none where the subject is no such token."""
    return subject.removeprefix(PERSONAL) if subject.startswith(PERSONAL) else None


def _key(secret: bytes) -> OctKey:
    return OctKey.import_key(hmac(secret, b"bearer tokens", "sha256"))
