"""The judge: a process that computes what it is told over a socket, one task after the other."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from contextlib import suppress
from io import BufferedRWPair
from socket import socket
from struct import Struct
from typing import Any, TypeAlias

from server.judging.apart import end_with_parent, leave_signals
from server.web import logs

Told: TypeAlias = tuple[str | None, Callable[..., Any], tuple[Any, ...], dict[str, Any]]
LENGTH = Struct("!I")  # bytes that follow


def sealed(content: object) -> bytes:
    """Write something as it goes over the line: its length, then itself."""
    told = pickle.dumps(content, pickle.HIGHEST_PROTOCOL)
    return LENGTH.pack(len(told)) + told


def opened(told: bytes) -> Any:
    """Read what came over the line, of which only the server and its judge have the ends."""
    return pickle.loads(told)


def judge(line: socket, log: str) -> None:
    """Compute until the server closes the line; a signal to all processes of a server is the server's to heed.

    Args:
        line: The judge's end.
        log: The kind of log of the server.
    """
    leave_signals()
    end_with_parent()
    logs.install(log)
    with suppress(ConnectionError), line, line.makefile("rwb") as ends:
        for told in _tasks(ends):
            ends.write(answered(told))
            ends.flush()


def _tasks(line: BufferedRWPair) -> Iterator[bytes]:
    while len(head := line.read(LENGTH.size)) == LENGTH.size:
        (length,) = LENGTH.unpack(head)
        told = line.read(length)
        if len(told) < length:
            return
        yield told


def answered(told: bytes) -> bytes:
    """Compute one task: what comes of it, or what it raises; the log names the request it is for."""
    request, compute, args, keywords = opened(told)
    token = logs.REQUEST.set(request)
    try:
        return sealed((compute(*args, **keywords), None, None))
    except Exception as error:  # whatever it is, the one who asked is to know
        return _raised(error)
    finally:
        logs.REQUEST.reset(token)


def _raised(error: Exception) -> bytes:
    """Write an exception and where it was raised; one that cannot travel is told by its kind."""
    place = logs.place(error)
    try:
        whole = sealed((None, error, place))
        opened(whole[LENGTH.size :])
    except Exception:  # an exception's own way of being written may fail in any way
        return sealed((None, RuntimeError(type(error).__qualname__), place))
    return whole
