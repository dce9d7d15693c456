"""Power cuts: clients hand in, the server is killed at random, and every acknowledged receipt must still be answered.

Run: ``uv run python benchmarks/kill.py --cycles 1000 [--store postgres]``; prints acknowledged and lost submissions.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import json
import os
import random
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from http.client import HTTPConnection, HTTPException
from multiprocessing import get_context
from multiprocessing.process import BaseProcess
from threading import Event, Thread
from typing import Any

# A judge imports this module too: what it does not need is imported where it is used.
PROCESSES = get_context("forkserver")  # what a server imports is imported once, so a life costs no more than a start
PROCESSES.set_forkserver_preload(["benchmarks.kill", "benchmarks.stores", "server.run", "tests.server.stores"])
START = 180.0  # s
CLIENTS = 4
LONGEST_LIFE = 1.0  # s that a server lives at most after its judge has dealt a task, before it is killed
OLD = 20  # receipts of earlier cycles that are looked up again in each cycle


def quietly(environment: Mapping[str, str], port: int) -> None:
    """Serve without limits by address and without a word."""
    from benchmarks.stores import settings
    from server.run import serve

    with open(os.devnull, "w") as sys.stdout:
        serve(replace(settings({**os.environ, **environment, "GRUBLER_PORT": str(port)}), limited=False))


@dataclass
class Server:
    """The server that is killed again and again."""

    environment: Mapping[str, str]
    port: int
    process: BaseProcess | None = None

    def start(self) -> None:
        """Start it and wait until it serves."""
        self.process = PROCESSES.Process(target=quietly, args=(self.environment, self.port))
        self.process.start()
        deadline = time.monotonic() + START
        while not self._ready():
            if not self.process.is_alive() or time.monotonic() > deadline:
                self.kill()
                raise SystemExit("the server does not start again")
            time.sleep(0.02)

    def _ready(self) -> bool:
        try:
            return call(self.port, "GET", "/ready")[0] == 200
        except (OSError, HTTPException):
            return False

    def kill(self) -> None:
        """End it as a power cut would."""
        assert self.process is not None
        self.process.kill()
        self.process.join()


@dataclass
class Client:
    """A student who hands in as fast as the server answers."""

    port: int
    variant: str
    cookie: str
    receipts: list[dict[str, Any]] = field(default_factory=list)

    def hand_in(self, stop: Event) -> None:
        """Hand in until told to stop or until the server is gone; keep what was acknowledged."""
        while not stop.is_set():
            body = {"answers": {"l3": f"{len(self.receipts)} mm"}}
            try:
                status, answered, _ = call(
                    self.port, "POST", f"/api/v1/variants/{self.variant}/submissions", body, self.cookie
                )
            except (OSError, HTTPException):
                return
            if status == 201:
                self.receipts.append(answered)

    def lost(self, receipts: list[dict[str, Any]]) -> int:
        """Count the receipts that the server no longer answers as it did."""
        return sum(self._answered(one["receipt"]["id"]) != one for one in receipts)

    def _answered(self, receipt: str) -> Any:
        return call(self.port, "GET", f"/api/v1/submissions/{receipt}", cookie=self.cookie)[1]


def call(port: int, method: str, path: str, body: Any = None, cookie: str = "") -> tuple[int, Any, str]:
    """Send one request; gives status, body and the cookie that was set."""
    connection = HTTPConnection("127.0.0.1", port, timeout=30)
    content = None if body is None else json.dumps(body)
    connection.request(method, path, content, {"Content-Type": "application/json", "Cookie": cookie})
    reply = connection.getresponse()
    answered = reply.status, json.loads(reply.read()), (reply.getheader("set-cookie") or "").split(";")[0]
    connection.close()
    return answered


def new_client(port: int) -> Client:
    """A client with a variant of its own."""
    _, variant, cookie = call(port, "POST", "/api/v1/exercises/slider_crank/variants", {"seed": 7})
    return Client(port, variant["id"], cookie)


def cycle(server: Server, clients: list[Client], chance: random.Random) -> int:
    """One life of the server: load, kill at a random moment, start, look up; gives the number lost."""
    stop, before = Event(), [len(client.receipts) for client in clients]
    threads = [Thread(target=client.hand_in, args=(stop,)) for client in clients]
    for thread in threads:
        thread.start()
    new_client(server.port)  # the judge is up
    time.sleep(chance.uniform(0, LONGEST_LIFE))
    server.kill()
    stop.set()
    for thread in threads:
        thread.join()
    server.start()
    lost = 0
    for client, known in zip(clients, before, strict=True):
        old = client.receipts[:known]
        lost += client.lost(client.receipts[known:] + chance.sample(old, min(OLD // CLIENTS, len(old))))
    return lost


def main() -> None:
    """Run the cycles and print what was acknowledged and what was lost."""
    from benchmarks.stores import stores
    from tests.server.stores import free_port

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cycles", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--store", choices=("sqlite", "postgres"), default="sqlite")
    given = parser.parse_args()
    port, chance, lost = free_port(), random.Random(given.seed), 0
    with stores(given.store) as (environment,):
        server = Server(environment, port)
        server.start()
        clients = [new_client(port) for _ in range(CLIENTS)]
        for _ in range(given.cycles):
            lost += cycle(server, clients, chance)
        lost_at_the_end = sum(client.lost(client.receipts) for client in clients)
        server.kill()
    acknowledged = sum(len(client.receipts) for client in clients)
    print(f"store {given.store}: acknowledged {acknowledged} in {given.cycles} kills")
    print(f"lost {max(lost, lost_at_the_end)}")
    sys.exit(1 if lost or lost_at_the_end else 0)


if __name__ == "__main__":
    main()
