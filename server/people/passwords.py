"""Passwords: argon2id, on threads of their own, with the same work whether there is an account or not."""

from __future__ import annotations

import asyncio
import secrets
import unicodedata
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property

from pwdlib import PasswordHash
from pwdlib.hashers.argon2 import Argon2Hasher

SHORTEST, LONGEST = 10, 200  # characters
THREADS = 2  # at once; each takes 64 MiB


class Passwords:
    """Hashes and checks passwords.

    Args:
        hasher: How much work it takes; the usual amount by default.
    """

    def __init__(self, hasher: Argon2Hasher | None = None) -> None:
        self._hash = PasswordHash((hasher or Argon2Hasher(),))
        self._threads = ThreadPoolExecutor(THREADS, "password")

    async def hashed(self, password: str) -> str:
        """Hash a password."""
        return await asyncio.get_running_loop().run_in_executor(self._threads, self._hash.hash, _plain(password))

    async def fits(self, password: str, kept: str | None) -> bool:
        """Whether a password is the one that was hashed; where none is kept, the same work is done for nothing."""
        return await asyncio.get_running_loop().run_in_executor(self._threads, self._fits, _plain(password), kept)

    def close(self) -> None:
        """Finish what is under way."""
        self._threads.shutdown()

    @cached_property
    def _nobody(self) -> str:
        return self._hash.hash(secrets.token_hex(16))

    def _fits(self, password: str, kept: str | None) -> bool:
        nobody = self._nobody  # made by the first who signs in, known or not
        return self._hash.verify(password, kept or nobody) and kept is not None


def usable(password: str, login: str) -> bool:
    """Whether a new password will do: long enough, and not the name it goes with."""
    return SHORTEST <= len(password) <= LONGEST and _plain(password).casefold() != login


def _plain(password: str) -> str:
    """The same password typed on another keyboard is the same; what nobody can type in full is cut."""
    return unicodedata.normalize("NFC", password[:LONGEST])
