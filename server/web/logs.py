"""Log lines, one an event, each with the number of its request; what people typed never stands in them."""

from __future__ import annotations

import json
import logging
import sys
import traceback
from collections.abc import Iterator, Mapping
from contextvars import ContextVar
from datetime import UTC, datetime
from types import TracebackType
from typing import TypeAlias

log = logging.getLogger("grubler.requests")
REQUEST: ContextVar[str | None] = ContextVar("request", default=None)  # the number of the one that is being answered
Raised: TypeAlias = tuple[type[BaseException], BaseException, TracebackType | None] | tuple[None, None, None]


class Plain(logging.Formatter):
    """Writes a record for people. Of an exception it tells kind and place: its words may hold what somebody typed."""

    def format(self, record: logging.LogRecord) -> str:
        """Write a record."""
        number = REQUEST.get()
        return f"{number} {super().format(record)}" if number else super().format(record)

    def formatException(self, ei: Raised) -> str:  # logging calls it by this name
        """Write where an exception was raised, and the kinds of it and of its causes."""
        return place(ei[1]) if ei[1] is not None else ""


class Elsewhere(Exception):
    """The cause of what was raised in another process: its text is the place, as `place` writes it."""


def place(error: BaseException) -> str:
    """Write where an exception was raised, and the kinds of it and of its causes."""
    return "".join(traceback.format_tb(error.__traceback__)) + " from ".join(_kinds(error))


def _kinds(error: BaseException | None) -> Iterator[str]:
    while error is not None:
        yield f"elsewhere:\n{error}" if isinstance(error, Elsewhere) else type(error).__qualname__
        error = error.__cause__ or error.__context__


class Lines(Plain):
    """Writes a record as one line of JSON: line breaks and quotes of any text are escaped."""

    def format(self, record: logging.LogRecord) -> str:
        """Write a record."""
        line: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        number = REQUEST.get()
        fields = ({"request": number} if number else {}) | getattr(record, "fields", {})
        if record.exc_info:
            line["exception"] = self.formatException(record.exc_info)
        return json.dumps({**line, **fields}, ensure_ascii=False)


def install(kind: str) -> None:
    """Send the log to standard error: warnings as text, or every request as a line of JSON."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(Lines() if kind == "json" else Plain())
    root = logging.getLogger()
    root.handlers[:] = [handler]
    root.setLevel(logging.INFO if kind == "json" else logging.WARNING)


def answered(fields: Mapping[str, object]) -> None:
    """Note a request that was answered."""
    log.info("%s %s %s", fields["method"], fields["route"], fields["status"], extra={"fields": dict(fields)})
