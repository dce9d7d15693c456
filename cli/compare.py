"""`grubler compare`: compares two typed answers for each request, one JSON object or one a line."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from cli.lines import answered
from cli.secret import secret
from graders import comparison
from mechanics.wire import reading
from mechanics.wire.refusal import Refusal
from mechanics.wire.solvers import identified, without_id


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command: there are none."""


def run(options: Namespace) -> int:
    """Answer each request on standard input in its turn."""
    return answered(_answer)


def _answer(raw: bytes) -> dict[str, Any]:
    identity: dict[str, Any] = {}
    try:
        request = reading.read(raw)
        identity = identified(request)
        reading.distinct(request)
        return {**identity, **comparison.answer(without_id(request), secret())}
    except (Refusal, comparison.BadRequest) as refused:
        return {**identity, "error": {"code": refused.code, "message": refused.message}}
