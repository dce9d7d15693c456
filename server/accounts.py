"""Accounts from the command line: the first administrator, somebody new, a lost password."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from datetime import UTC, datetime
from typing import TypeVar

from server import identity, ids
from server.audit import COMMAND_LINE
from server.database import Database
from server.errors import Refused
from server.settings import Settings
from server.storage.people import People, Person

T = TypeVar("T")


class AccountError(ValueError):
    """The account cannot be made or found; the message is the code of the reason."""


def first_link(settings: Settings) -> str | None:
    """Make the link for the first administrator; none, where there is one already."""
    return _with(settings, lambda people: _first(people, settings))


def reset(settings: Settings, login: str | None) -> str:
    """Make a one-time link for somebody who has lost theirs; without a login for the first administrator.

    Raises:
        AccountError: Nobody has this login, or none was given and there is an administrator.
    """
    return _with(settings, lambda people: _reset(people, settings, login))


def add(settings: Settings, login: str, name: str, role: str) -> str:
    """Make an account; gives the one-time link with which its password is set.

    Raises:
        AccountError: The login is taken, or login or name cannot be used.
    """
    return _with(settings, lambda people: _add(people, settings, login, name, role))


def _with(settings: Settings, work: Callable[[People], Awaitable[T]]) -> T:
    async def done() -> T:
        return await work(database.people)

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
