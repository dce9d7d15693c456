"""Log lines as JSON, one an event, each with the number of its request; what people typed never stands in them."""

from __future__ import annotations

import json
import logging
import sys
from collections.abc import Mapping
from datetime import UTC, datetime

log = logging.getLogger("grubler.requests")


class Lines(logging.Formatter):
    """Writes a record as one line of JSON: line breaks and quotes of any text are escaped."""

    def format(self, record: logging.LogRecord) -> str:
        """Write a record."""
        line: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        fields = getattr(record, "fields", {})
        if record.exc_info:
            line["exception"] = self.formatException(record.exc_info)
        return json.dumps({**line, **fields}, ensure_ascii=False)


def install(kind: str) -> None:
    """Send the log to standard error: warnings as text, or every request as a line of JSON."""
    handler = logging.StreamHandler(sys.stderr)
    if kind == "json":
        handler.setFormatter(Lines())
    root = logging.getLogger()
    root.handlers[:] = [handler]
    root.setLevel(logging.INFO if kind == "json" else logging.WARNING)


def answered(fields: Mapping[str, object]) -> None:
    """Note a request that was answered."""
    log.info("%s %s %s", fields["method"], fields["route"], fields["status"], extra={"fields": dict(fields)})
