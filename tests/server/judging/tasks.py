"""What judges are told in tests; this module is small, since each judge loads it."""

from __future__ import annotations

import logging
import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn


def die(*args: object, **rules: object) -> NoReturn:
    """End the judge at once, as the system does where memory is short."""
    os.kill(os.getpid(), signal.SIGKILL)
    raise AssertionError


def die_once(flag: str) -> int:
    """End the first judge; gives the number of the process of the second."""
    if not Path(flag).exists():
        Path(flag).touch()
        die()
    return os.getpid()


class Stubborn(Exception):
    """An exception that cannot be read back where it goes."""

    def __init__(self, one: str, other: str) -> None:
        super().__init__(one)


def raise_stubborn() -> NoReturn:
    raise Stubborn("one", "other")


def note(words: str) -> None:
    logging.getLogger("grubler").error(words)


def interrupt() -> int:
    """What a terminal sends to all processes of the server."""
    os.kill(os.getpid(), signal.SIGINT)
    return os.getpid()


class Unreadable:
    """What can be written and not be read where it goes."""

    def __reduce__(self) -> tuple[Callable[..., object], tuple[object, ...]]:
        return int, ("not a number",)


def make_unreadable() -> Unreadable:
    return Unreadable()


def be_told_to_end() -> int:
    """What a supervisor sends to all processes of a group that is to end."""
    for one in (signal.SIGTERM, signal.SIGHUP):
        os.kill(os.getpid(), one)
    return os.getpid()
