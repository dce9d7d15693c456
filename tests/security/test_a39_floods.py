"""A39: no regular expression of ours backtracks without bound, hostile texts stay cheap, floods of requests wait."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from exercises.exercise import Submission
from exercises.grading import grade
from server import reader
from server.web.limits import Rate
from tests.graders.effort import effort
from tests.security.conftest import LONGEST, VARIANT

PARSER = import_module("re._parser")  # what the standard library reads a pattern with
ROOT = Path(__file__).parents[2]
PATTERN = re.compile(r'\bre\.compile\(\s*(?:r|rf|fr)?"((?:[^"\\]|\\.)*)"')
FLOOD = [
    "a" * 2000, "1" * 2000, "1," * 900, "-" * 2000, " " * 1999 + "x", "1e" * 900, "°" * 1500, "'" * 1500, "(" * 199,
    "l1_" * 600, "\\frac" * 300, "12 345 " * 250, "=" * 2000, "x 10^" * 350, "1.2.3." * 300, "⁻¹" * 700,
]  # fmt: skip


def nested(parsed: Any, inside: bool = False) -> bool:
    """Tell whether a repeat without bound holds another one: the shape that backtracks exponentially."""
    return any(_nests(str(operation), argument, inside) for operation, argument in parsed)


def _nests(name: str, argument: Any, inside: bool) -> bool:
    if name in ("MAX_REPEAT", "MIN_REPEAT"):
        _, most, body = argument
        endless = int(most) > 1000
        return (endless and inside) or nested(body, inside or endless)
    if name == "SUBPATTERN":
        return nested(argument[-1], inside)
    return name == "BRANCH" and any(nested(branch, inside) for branch in argument[1])


@pytest.mark.parametrize("room", ["graders", "exercises", "server", "cli", "reports"])
def test_no_pattern_repeats_inside_a_repeat(room: str) -> None:
    for file in (ROOT / room).rglob("*.py"):
        for found in PATTERN.finditer(file.read_text("utf-8")):
            try:
                parsed = PARSER.parse(found[1])
            except re.error:
                continue  # put together from parts
            assert not nested(parsed), f"{file}: {found[1]}"


def test_the_check_would_see_such_a_pattern() -> None:
    assert nested(PARSER.parse(r"(a+)+b")) and nested(PARSER.parse(r"(?:a|b*)*")) and not nested(PARSER.parse(r"a+b+"))


@pytest.mark.parametrize("text", FLOOD, ids=range(len(FLOOD)))
def test_a_flood_of_one_sign_is_cheap(text: str) -> None:
    flood = Submission(VARIANT, dict.fromkeys(("alpha2", "l3", "omega2", "v3", "omega2_formula"), text))
    assert effort(lambda: grade(flood), 1) < LONGEST


def test_a_flood_of_drafts_or_of_documents_waits(client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader, "OWNER", Rate(4, 1e-3))
    monkeypatch.setattr(reader, "DOCUMENTS", Rate(2, 1e-3))
    number, body = client.headers["x-variant"], {"answers": {"l3": "1 m"}, "revision": 0}
    drafts = [client.put(f"/api/v1/variants/{number}/draft", json=body) for _ in range(6)]
    reports = [client.get(f"/api/v1/reports/tmm2/{number}.md") for _ in range(4)]
    for replies, passed in ((drafts, 4), (reports, 2)):
        assert [reply.status_code == 429 for reply in replies] == [False] * passed + [True] * 2
        assert int(replies[-1].headers["retry-after"]) > 1
