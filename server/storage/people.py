"""People, what they sign in with, and what a store of them promises."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Protocol

from server.storage.audit import Entry


@dataclass(frozen=True, slots=True)
class Person:
    """Somebody who can sign in.

    Attributes:
        id: Number; it is also the number of the owner of this person's variants.
        login: Index number or e-mail, case folded; none for those who come from elsewhere alone.
        name: As the person writes it.
        role: On the whole server: student, lecturer or administrator.
        password: Its hash; none before the first link is used.
        issuer: Who else vouches for this person (OpenID Connect), and under which name.
        erased: When the person was erased; from then the name is the number.
    """

    id: str
    login: str | None
    name: str
    role: str
    created: datetime
    password: str | None = field(default=None, repr=False)
    language: str | None = None
    theme: str | None = None
    active: bool = True
    issuer: str | None = None
    subject: str | None = None
    erased: datetime | None = None

    @property
    def signed_up(self) -> bool:
        """Whether the person can sign in: nobody has been here under this number before."""
        return self.password is not None or self.issuer is not None


@dataclass(frozen=True, slots=True)
class Session:
    """One signing in; the cookie itself is stored nowhere."""

    digest: str
    person: str
    created: datetime
    last_used: datetime
    expires: datetime
    agent: str

    @property
    def number(self) -> str:
        """What it is called by when it is listed and ended."""
        return self.digest[:16]


@dataclass(frozen=True, slots=True)
class Link:
    """A link that lets one person in once; `purpose` is first, join or reset."""

    digest: str
    purpose: str
    person: str | None
    course: str | None
    created: datetime
    expires: datetime
    used: datetime | None = None


@dataclass(frozen=True, slots=True)
class Token:
    """A bearer token of a person, for programs: what it may do at most, and until when."""

    id: str
    person: str
    name: str
    role: str
    created: datetime
    expires: datetime
    revoked: datetime | None = None


class People(Protocol):
    """A store of people."""

    async def add(self, person: Person) -> bool:
        """Store a new person; False, and nothing stored, where the login or the subject is taken."""
        ...

    async def person(self, number: str) -> Person | None:
        """Give a person."""
        ...

    async def by_login(self, login: str) -> Person | None:
        """Give the person who signs in so."""
        ...

    async def by_subject(self, issuer: str, subject: str) -> Person | None:
        """Give the person somebody else vouches for."""
        ...

    async def vouch(self, number: str, issuer: str, subject: str) -> bool:
        """Note who else vouches for a person; False where that name is another person's."""
        ...

    async def prefer(self, number: str, language: str, theme: str) -> None:
        """Note how a person wants to be addressed."""
        ...

    async def set_password(self, number: str, password: str, keep: str) -> None:
        """Store the hash of a new password and end all sessions but one."""
        ...

    async def claim(self, number: str, course: str, password: str, now: datetime) -> bool:
        """Give a first password to a person of the roster of a course; False where there is one already."""
        ...

    async def unclaim(self, number: str, entry: Entry | None = None) -> None:
        """Take the password of a person away again, with all sessions, tokens and links."""
        ...

    async def begin(self, session: Session) -> None:
        """Store a session."""
        ...

    async def session(self, digest: str) -> tuple[Session, Person] | None:
        """Give a session and its person."""
        ...

    async def seen(self, digest: str, time: datetime) -> None:
        """Note that a session was used."""
        ...

    async def sessions(self, person: str) -> Sequence[Session]:
        """List the sessions of a person, newest first."""
        ...

    async def end(self, person: str, number: str) -> bool:
        """End a session of a person, named by its number."""
        ...

    async def keep_links(self, links: Sequence[Link], actor: str = "server") -> None:
        """Store links; older unused ones of the same people end."""
        ...

    async def link(self, digest: str) -> Link | None:
        """Give a link."""
        ...

    async def redeem(self, digest: str, now: datetime, password: str) -> Person | None:
        """Use a link up: its person has this password from now on, and no session that was open before."""
        ...

    async def redeem_first(self, digest: str, now: datetime, person: Person) -> bool:
        """Use the first link up by storing the first administrator."""
        ...

    async def has_administrator(self) -> bool:
        """Tell whether somebody administers this server."""
        ...

    async def find(self, text: str, skip: int, most: int) -> Sequence[Person]:
        """List people by name whose login begins so, or whose name holds it; all for an empty text."""
        ...

    async def set_role(self, number: str, role: str, entry: Entry) -> bool:
        """Give a person another role on the server; False where there is no such person."""
        ...

    async def set_active(self, number: str, active: bool, entry: Entry) -> bool:
        """Let a person sign in, or not; False where there is no such person."""
        ...

    async def end_all(self, number: str, now: datetime, entry: Entry) -> None:
        """End all sessions, tokens and unused links of a person."""
        ...

    async def keep_token(self, token: Token, entry: Entry | None = None) -> None:
        """Store a token."""
        ...

    async def token(self, number: str) -> tuple[Token, Person] | None:
        """Give a token and its person."""
        ...

    async def tokens(self, person: str) -> Sequence[Token]:
        """List the tokens of a person, newest first."""
        ...

    async def revoke(self, person: str, number: str, now: datetime, entry: Entry | None = None) -> bool:
        """End a token of a person."""
        ...
