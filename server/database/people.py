"""People, their sessions, links and tokens."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime
from typing import Any

from sqlalchemy import ColumnElement, Connection, RowMapping, bindparam, delete, func, insert, or_, select, update

from server.alphabet import alphabetical
from server.database.audit import note, noting
from server.database.connections import Connections
from server.database.once import insert_once
from server.storage.audit import Action, Entry
from server.storage.people import Link, Person, Session, Token
from server.tables import api_tokens, links, memberships, owners, persons, sessions

SESSION = (
    select(sessions, persons)
    .join(persons, sessions.c.person == persons.c.id)
    .where(sessions.c.digest == bindparam("digest"))
)


class People:
    """The people of one store."""

    def __init__(self, connections: Connections) -> None:
        self._connections = connections

    async def add(self, person: Person) -> bool:
        """Store a new person; False, and nothing stored, where the login or the subject is taken."""
        return await self._connections.write(lambda connection: add_person(connection, person))

    async def person(self, number: str) -> Person | None:
        """Give a person."""
        return await self._one(persons.c.id == number)

    async def by_login(self, login: str) -> Person | None:
        """Give the person who signs in so."""
        return await self._one(persons.c.login == login)

    async def by_subject(self, issuer: str, subject: str) -> Person | None:
        """Give the person somebody else vouches for."""
        return await self._one((persons.c.issuer == issuer) & (persons.c.subject == subject))

    async def vouch(self, number: str, issuer: str, subject: str) -> bool:
        """Note who else vouches for a person; False where that name is another person's."""
        return await self._connections.write(lambda connection: _vouch(connection, number, issuer, subject))

    async def prefer(self, number: str, language: str, theme: str) -> None:
        """Note how a person wants to be addressed."""
        await self._change(persons.c.id == number, language=language, theme=theme)

    async def set_password(self, number: str, password: str, keep: str) -> None:
        """Store the hash of a new password and end all sessions but one."""
        await self._connections.write(lambda connection: _set_password(connection, number, password, keep))

    async def claim(self, number: str, course: str, password: str, now: datetime) -> bool:
        """Give a first password to a person of the roster of a course; False where there is one already."""
        return await self._connections.write(lambda connection: _claim(connection, number, course, password, now))

    async def unclaim(self, number: str, entry: Entry | None = None) -> None:
        """Take the password of a person away again, with all sessions, tokens and links."""
        await self._connections.write(noting(lambda connection: _unclaim(connection, number), entry))

    async def begin(self, session: Session) -> None:
        """Store a session."""
        values = {column.name: getattr(session, column.name) for column in sessions.columns}
        await self._connections.write(lambda connection: connection.execute(insert(sessions), values))

    async def session(self, digest: str) -> tuple[Session, Person] | None:
        """Give a session and its person."""
        return await self._connections.read(lambda connection: _session(connection, digest))

    async def seen(self, digest: str, time: datetime) -> None:
        """Note that a session was used."""
        change = update(sessions).where(sessions.c.digest == digest).values(last_used=time)
        await self._connections.write(lambda connection: connection.execute(change))

    async def sessions(self, person: str) -> Sequence[Session]:
        """List the sessions of a person, newest first."""
        query = select(sessions).where(sessions.c.person == person).order_by(sessions.c.created.desc())
        rows = await self._connections.read(lambda connection: connection.execute(query).mappings().all())
        return [Session(**row) for row in rows]

    async def end(self, person: str, number: str) -> bool:
        """End a session of a person, named by its number."""
        theirs = sessions.c.person == person, sessions.c.digest.startswith(number, autoescape=True)
        gone = delete(sessions).where(*theirs)
        return await self._connections.write(lambda connection: connection.execute(gone).rowcount > 0)

    async def keep_links(self, made: Sequence[Link], actor: str = "server") -> None:
        """Store links; older unused ones of the same people end."""
        await self._connections.write(lambda connection: _keep_links(connection, made, actor))

    async def link(self, digest: str) -> Link | None:
        """Give a link."""
        query = select(links).where(links.c.digest == digest)
        row = await self._connections.read(lambda connection: connection.execute(query).mappings().first())
        return Link(**row) if row else None

    async def redeem(self, digest: str, now: datetime, password: str) -> Person | None:
        """Use a link up: its person has this password from now on, and no session that was open before."""
        return await self._connections.write(lambda connection: _redeem(connection, digest, now, password))

    async def redeem_first(self, digest: str, now: datetime, person: Person) -> bool:
        """Use the first link up by storing the first administrator."""
        return await self._connections.write(lambda connection: _redeem_first(connection, digest, now, person))

    async def has_administrator(self) -> bool:
        """Tell whether somebody administers this server."""
        return await self._one(persons.c.role == "administrator") is not None

    async def find(self, text: str, skip: int, most: int) -> Sequence[Person]:
        """List people by name whose login begins so, or whose name holds it; all for an empty text."""
        return await self._connections.read(lambda connection: _find(connection, text, skip, most))

    async def set_role(self, number: str, role: str, entry: Entry) -> bool:
        """Give a person another role on the server; False where there is no such person."""
        return await self._change(persons.c.id == number, entry, role=role)

    async def set_active(self, number: str, active: bool, entry: Entry) -> bool:
        """Let a person sign in, or not; False where there is no such person."""
        return await self._change(persons.c.id == number, entry, active=active)

    async def end_all(self, number: str, now: datetime, entry: Entry) -> None:
        """End all sessions, tokens and unused links of a person."""
        await self._connections.write(noting(lambda connection: _end_all(connection, number, now), entry))

    async def keep_token(self, token: Token, entry: Entry | None = None) -> None:
        """Store a token."""
        values = {column.name: getattr(token, column.name) for column in api_tokens.columns}
        keep = insert(api_tokens).values(values)
        await self._connections.write(noting(lambda connection: connection.execute(keep).rowcount, entry))

    async def token(self, number: str) -> tuple[Token, Person] | None:
        """Give a token and its person."""
        return await self._connections.read(lambda connection: _token(connection, number))

    async def tokens(self, person: str) -> Sequence[Token]:
        """List the tokens of a person, newest first."""
        query = select(api_tokens).where(api_tokens.c.person == person).order_by(api_tokens.c.created.desc())
        rows = await self._connections.read(lambda connection: connection.execute(query).mappings().all())
        return [Token(**row) for row in rows]

    async def revoke(self, person: str, number: str, now: datetime, entry: Entry | None = None) -> bool:
        """End a token of a person."""
        theirs = api_tokens.c.person == person, api_tokens.c.id == number, api_tokens.c.revoked.is_(None)
        change = update(api_tokens).where(*theirs).values(revoked=now)
        return await self._connections.write(noting(lambda connection: connection.execute(change).rowcount == 1, entry))

    async def _one(self, which: ColumnElement[bool]) -> Person | None:
        return await self._connections.read(lambda connection: _person(connection, which))

    async def _change(self, which: ColumnElement[bool], entry: Entry | None = None, **values: Any) -> bool:
        change = update(persons).where(which).values(**values)
        return await self._connections.write(noting(lambda connection: connection.execute(change).rowcount == 1, entry))


def add_person(connection: Connection, person: Person) -> bool:
    """Store a new person and the owner of the same number; False where the login or the subject is taken."""
    insert_once(connection, owners, {"id": person.id, "anonymous": False, "created": person.created})
    values = {column.name: getattr(person, column.name) for column in persons.columns}
    if insert_once(connection, persons, values):
        return True
    connection.execute(delete(owners).where(owners.c.id == person.id))
    return False


def person_of(row: RowMapping) -> Person:
    """Make a person of a row that holds the columns of `persons`."""
    return Person(**{column.name: row[column] for column in persons.columns})


def _person(connection: Connection, which: ColumnElement[bool]) -> Person | None:
    row = connection.execute(select(persons).where(which).limit(1)).mappings().first()
    return person_of(row) if row else None


def _unclaimed(number: str) -> ColumnElement[bool]:
    bare = persons.c.password.is_(None) & persons.c.issuer.is_(None)
    return (persons.c.id == number) & (persons.c.role == "student") & bare


def _vouch(connection: Connection, number: str, issuer: str, subject: str) -> bool:
    other = _person(connection, (persons.c.issuer == issuer) & (persons.c.subject == subject))
    if other is not None:
        return other.id == number
    change = update(persons).where(persons.c.id == number).values(issuer=issuer, subject=subject)
    return connection.execute(change).rowcount == 1


def _set_password(connection: Connection, number: str, password: str, keep: str) -> None:
    connection.execute(update(persons).where(persons.c.id == number).values(password=password))
    connection.execute(delete(sessions).where(sessions.c.person == number, sessions.c.digest != keep))


def _session(connection: Connection, digest: str) -> tuple[Session, Person] | None:
    row = connection.execute(SESSION, {"digest": digest}).mappings().first()
    if row is None:
        return None
    return Session(**{column.name: row[column] for column in sessions.columns}), person_of(row)


def _token(connection: Connection, number: str) -> tuple[Token, Person] | None:
    query = select(api_tokens, persons).join(persons, api_tokens.c.person == persons.c.id)
    row = connection.execute(query.where(api_tokens.c.id == number)).mappings().first()
    if row is None:
        return None
    return Token(**{column.name: row[column] for column in api_tokens.columns}), person_of(row)


def _claim(connection: Connection, number: str, course: str, password: str, now: datetime) -> bool:
    if connection.execute(update(persons).where(_unclaimed(number)).values(password=password)).rowcount != 1:
        return False
    mine = memberships.c.course == course, memberships.c.person == number
    connection.execute(update(memberships).where(*mine).values(claimed=now))
    _note_everywhere(connection, Entry(number, Action.PLACE_CLAIMED, number, course))
    return True


def _find(connection: Connection, text: str, skip: int, most: int) -> list[Person]:
    """No store sorts as people do, so names alone are read and sorted, and of one page the people."""
    called = connection.execute(select(persons.c.id, persons.c.name).where(_called(text)))
    listed = sorted(called, key=lambda one: (alphabetical(one.name), one.id))
    numbers = [one.id for one in listed[skip : skip + most]]
    rows = connection.execute(select(persons).where(persons.c.id.in_(numbers))).mappings()
    found = {row["id"]: person_of(row) for row in rows}
    return [found[number] for number in numbers if number in found]


def _called(text: str) -> ColumnElement[bool]:
    """A name may be typed in small letters: lower() of SQLite knows ASCII alone, so the capital is tried besides."""
    said = " ".join(text.split())
    names = (persons.c.name.contains(one, autoescape=True) for one in (said, said.title()))
    low = func.lower(persons.c.name).contains(said.lower(), autoescape=True)
    return or_(persons.c.login.startswith(said.casefold(), autoescape=True), low, *names)


def _end_all(connection: Connection, number: str, now: datetime) -> None:
    connection.execute(delete(sessions).where(sessions.c.person == number))
    theirs = api_tokens.c.person == number, api_tokens.c.revoked.is_(None)
    connection.execute(update(api_tokens).where(*theirs).values(revoked=now))
    connection.execute(delete(links).where(links.c.person == number, links.c.used.is_(None)))


def _unclaim(connection: Connection, number: str) -> None:
    connection.execute(update(persons).where(persons.c.id == number).values(password=None))
    connection.execute(update(memberships).where(memberships.c.person == number).values(claimed=None))
    connection.execute(delete(sessions).where(sessions.c.person == number))
    connection.execute(delete(api_tokens).where(api_tokens.c.person == number))
    connection.execute(delete(links).where(links.c.person == number, links.c.used.is_(None)))


def _keep_links(connection: Connection, made: Sequence[Link], actor: str) -> None:
    for link in made:
        older = links.c.used.is_(None), links.c.person.is_not_distinct_from(link.person)
        connection.execute(delete(links).where(*older))
        connection.execute(insert(links), {column.name: getattr(link, column.name) for column in links.columns})
        made_for = link.person or "the first administrator"
        entry = Entry(actor, Action.LINK_MADE, made_for, link.course, {"purpose": link.purpose})
        _note_everywhere(connection, entry)


def _note_everywhere(connection: Connection, entry: Entry) -> None:
    """Note an act on a person in all courses of that person: it concerns each of them."""
    query = select(memberships.c.course).where(memberships.c.person == entry.object).order_by(memberships.c.course)
    for course in connection.execute(query).scalars().all() or [entry.course]:
        note(connection, replace(entry, course=course))


def _use(connection: Connection, digest: str, now: datetime) -> Link | None:
    """Use a link up; of two who try at once, one succeeds."""
    fresh = links.c.digest == digest, links.c.used.is_(None), links.c.expires > now
    if connection.execute(update(links).where(*fresh).values(used=now)).rowcount != 1:
        return None
    return Link(**connection.execute(select(links).where(links.c.digest == digest)).mappings().one())


def _redeem(connection: Connection, digest: str, now: datetime, password: str) -> Person | None:
    link = _use(connection, digest, now)
    if link is None or link.person is None:
        return None
    _set_password(connection, link.person, password, keep="")
    entry = Entry(link.person, Action.LINK_USED, link.person, link.course, {"purpose": link.purpose})
    _note_everywhere(connection, entry)
    return _person(connection, persons.c.id == link.person)


def _redeem_first(connection: Connection, digest: str, now: datetime, person: Person) -> bool:
    link = _use(connection, digest, now)
    if link is None or link.purpose != "first" or _person(connection, persons.c.role == "administrator"):
        return False
    if not add_person(connection, person):
        connection.execute(update(links).where(links.c.digest == digest).values(used=None))
        return False
    note(connection, Entry(person.id, Action.LINK_USED, person.id, None, {"purpose": link.purpose}))
    return True
