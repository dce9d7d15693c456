"""A37, A38: there is no LTI surface, and no room calls another host but where a sign-in provider is registered."""

from __future__ import annotations

import re
from pathlib import Path

from server.policy import POLICIES

ROOT = Path(__file__).parents[2]
CLIENTS = {"httpx", "httpx2", "requests", "aiohttp", "urllib3", "socket", "http", "ftplib", "smtplib", "telnetlib"}
IMPORTED = re.compile(r"^ *(?:import|from) ([\w.]+)", re.M)
ALLOWED = {
    "cli/serve.py", "server/run.py",  # they listen, they do not call
    "server/judging/judge.py", "server/judging/process.py",  # the two ends of a pair of sockets
}  # fmt: skip
PROVIDERS = "oidc"  # in the name of the module that speaks with a registered issuer


def test_there_is_no_lti_and_no_webhook() -> None:
    assert not [path for _, path in POLICIES if "lti" in path.lower() or "hook" in path.lower()]


def test_no_room_opens_a_connection_of_its_own() -> None:
    for room in ("cli", "server", "reports", "exercises", "graders", "mechanics", "figures"):
        for file in (ROOT / room).rglob("*.py"):
            name = str(file.relative_to(ROOT))
            if name in ALLOWED or PROVIDERS in file.stem:
                continue
            used = set(IMPORTED.findall(file.read_text("utf-8")))
            assert not {one.split(".")[0] for one in used} & CLIENTS and "urllib.request" not in used, name
