"""Requests on standard input, answers on standard output: one JSON object, or one a line, each answered in its turn.

A line that is no request gets an answer that says so, and the next one is read. An object may also be written over
several lines if it stands alone.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from typing import Any

from cli.problems import Unusable
from mechanics.wire.reading import LARGEST, is_cut_off, is_json

Answer = Callable[[bytes], dict[str, Any]]
FAULT = {"error": {"code": "our_fault", "message": "this is a fault of the program, not of your input"}}


def answered(answer: Answer) -> int:
    """Answer all of standard input.

    Returns:
        0, whatever the answers are; 3 where one of them is our fault.

    Raises:
        Unusable: It cannot be read.
    """
    code = 0
    for request in _requests(_lines()):
        try:
            found = answer(request)
        except Exception as error:  # one request must not cost the others theirs
            sys.excepthook(type(error), error, error.__traceback__)
            found, code = FAULT, 3
        print(json.dumps(found, allow_nan=False), flush=True)
    return code


def _requests(lines: Iterator[bytes]) -> Iterator[bytes]:
    first = next(lines, b"")
    held = [first] if first else []
    if is_cut_off(first):  # the whole is one object, or this line is a broken one
        for line in lines:
            held.append(line)
            if sum(map(len, held)) > LARGEST:
                break
        if is_json(b"".join(held)):
            held = [b"".join(held)]
    yield from held
    yield from lines


def _lines() -> Iterator[bytes]:
    """Give the lines that are not blank; of one that is too long only so much that this shows."""
    while line := _read_line():
        if len(line) > LARGEST and not line.endswith(b"\n"):
            while (rest := _read_line()) and not rest.endswith(b"\n"):
                pass
        if line.strip():
            yield line


def _read_line() -> bytes:
    try:
        return sys.stdin.buffer.readline(LARGEST + 1)
    except (OSError, ValueError, AttributeError) as error:  # a folder, a closed stream, none at all
        raise Unusable("unreadable_input", why=str(error)) from None
