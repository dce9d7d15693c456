"""Accounts from the command line: the first administrator, somebody new, a lost password."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from datetime import UTC, datetime
from typing import Any, TypeVar

from server.audit.acts import COMMAND_LINE
from server.database import Database
from server.people import identity, personal
from server.settings import Settings
from server.storage.people import People, Person
from server.web import ids
from server.web.errors import Refused

T = TypeVar("T")


class AccountError(ValueError):
    """The account cannot be made or found; the message is the code of the reason."""


def first_link(settings: Settings) -> str | None:
    """Make the link for the first administrator; none, where there is one already."""
    return _with(settings, lambda database: _first(database.people, settings))


def reset(settings: Settings, login: str | None) -> str:
    """Make a one-time link for somebody who has lost theirs; without a login for the first administrator.

    Raises:
        AccountError: Nobody has this login, or none was given and there is an administrator.
    """
    return _with(settings, lambda database: _reset(database.people, settings, login))


def add(settings: Settings, login: str, name: str, role: str) -> str:
    """Make an account; gives the one-time link with which its password is set.

    Raises:
        AccountError: The login is taken, or login or name cannot be used.
    """
    return _with(settings, lambda database: _add(database.people, settings, login, name, role))


def data(settings: Settings, who: str) -> dict[str, Any]:
    """Give all that is kept of a person, by login or number, and note that it was given.

    Raises:
        AccountError: There is no such person.
    """
    return _with(settings, lambda database: _data(database, who))


def erase(settings: Settings, who: str) -> str:
    """Erase a person, by login or number; gives the number under which the marks stay.

    Raises:
        AccountError: There is no such person, or it is an administrator.
    """
    return _with(settings, lambda database: _erase(database, who))


def _with(settings: Settings, work: Callable[[Database], Awaitable[T]]) -> T:
    async def done() -> T:
        return await work(database)

    database = Database(settings.store_url)
    try:
        return asyncio.run(done())
    finally:
        database.close()


async def _first(people: People, settings: Settings) -> str | None:
    if await people.has_administrator():
        return None
    return await identity.make_link(people, settings, "first", COMMAND_LINE)


async def _reset(people: People, settings: Settings, login: str | None) -> str:
    if login is None:
        link = await _first(people, settings)
        if link is None:
            raise AccountError("login_wanted")
        return link
    person = await people.by_login(login.strip().casefold())
    if person is None:
        raise AccountError("unknown_login")
    return await identity.make_link(people, settings, "reset", COMMAND_LINE, person)


async def _add(people: People, settings: Settings, login: str, name: str, role: str) -> str:
    try:
        person = Person(ids.new(), identity.login_of(login), identity.name_of(name), role, datetime.now(UTC))
    except Refused as refused:
        raise AccountError(refused.code) from None
    if not await people.add(person):
        raise AccountError("taken_login")
    return await identity.make_link(people, settings, "join", COMMAND_LINE, person)


async def _data(database: Database, who: str) -> dict[str, Any]:
    number = await _number(database.people, who)
    found = await personal.collected(database.personal, database.sets, number)
    await database.audit.note(personal.exported(number, COMMAND_LINE))
    return found


async def _erase(database: Database, who: str) -> str:
    number = await _number(database.people, who)
    try:
        await personal.erased(database.people, database.personal, number, COMMAND_LINE)
    except Refused as refused:
        raise AccountError(refused.code) from None
    return number


async def _number(people: People, who: str) -> str:
    person = await people.by_login(who.strip().casefold()) or await people.person(who.strip().upper())
    if person is None:
        raise AccountError("unknown_login")
    return person.id
