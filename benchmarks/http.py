"""Graded, durable submissions per second over HTTP, against the same server with only the grading taken out.

Both servers run the same application, middleware, schema and commit path; `NoGrading` is the whole difference. Every
submission is the first to a variant of its own, taken from the server just before, and its formula is spelled otherwise
than the reference: nothing is graded twice.
Rounds alternate, so that a busy machine slows both; the ratio by processor time hardly depends on what else it does.
Every second submission may hold a slip, which is then explained.
Run: ``uv run python benchmarks/http.py [--store postgres] [--slips]``; prints the ratio last.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else this file would stand before the library's http

import argparse
import asyncio
import json
import os
import subprocess
import time
from dataclasses import dataclass, replace
from statistics import median
from typing import Any, TypeAlias

import uvicorn

from benchmarks.stores import KINDS, cpu, settings, stores
from exercises import grading
from exercises.exercise import Grade, Submission
from exercises.variants import deal
from server.app import create_app
from server.judging.process import JudgingProcess
from server.run import Announced
from tests.server.stores import free_port

EXERCISE = "slider_crank"
SEED = 7
TYPED = {"omega2_formula": "-omega1*cos(alpha1)*l1/(cos(alpha2)*l2)"}  # right, and not letter by letter the reference


class NoGrading(JudgingProcess):
    """The no-op: a grade made beforehand, handed over without asking the judge."""

    def __init__(self) -> None:
        super().__init__()
        variant = deal(EXERCISE, SEED)
        self._made = grading.grade(Submission(variant, grading.reference(variant)))

    async def grade(self, submission: Submission, secret: bytes, **rules: Any) -> Grade:
        """Give the grade made beforehand."""
        return self._made


SLIP = {"l3": "-1 mm"}


def serve(port: int, graded: bool) -> None:
    """Serve in this process."""
    told = replace(settings(os.environ), port=port, limited=False)
    app = create_app(told, judging=JudgingProcess() if graded else NoGrading())
    server = Announced(uvicorn.Config(app, port=port, log_level="warning", access_log=False, server_header=False))
    server.address = f"port {port}"
    server.run()


@dataclass(frozen=True, slots=True)
class Target:
    """A server under load: its port, and the requests of each client in one round."""

    port: int
    requests: tuple[tuple[bytes, ...], ...]


async def call(port: int, request: bytes) -> tuple[bytes, bytes]:
    """Send one request on a connection of its own; gives head and body."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(request)
    answer = await receive(reader)
    writer.close()
    return answer


async def receive(reader: asyncio.StreamReader) -> tuple[bytes, bytes]:
    """Read one response."""
    head = await reader.readuntil(b"\r\n\r\n")
    length = next(line for line in head.lower().split(b"\r\n") if line.startswith(b"content-length:"))
    return head, await reader.readexactly(int(length.partition(b":")[2]))


def post(path: str, body: object, cookie: str = "") -> bytes:
    """Write a request."""
    content = json.dumps(body).encode()
    head = f"POST {path} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
    return f"{head}Content-Length: {len(content)}\r\nCookie: {cookie}\r\n\r\n".encode() + content


async def started(port: int) -> None:
    """Wait for a server."""
    for _ in range(1200):
        try:
            await take(port, SEED)
        except OSError:
            await asyncio.sleep(0.1)
            continue
        return
    raise SystemExit("the server does not start")


async def prepare(port: int, clients: int, requests: int, seed: int, slips: bool) -> Target:
    """Every client takes its variants of a round, from a seed upwards, and writes the answers to them."""
    own = requests // clients
    numbers = [[seed + client * own + number for number in range(own)] for client in range(clients)]
    taken = [[await take(port, number, slips and number % 2 == 1) for number in mine] for mine in numbers]
    return Target(port, tuple(map(tuple, taken)))


async def take(port: int, seed: int, slip: bool = False) -> bytes:
    """Take a variant; gives the request that hands in the answers to it, right unless one is a slip."""
    head, body = await call(port, post(f"/api/v1/exercises/{EXERCISE}/variants", {"seed": seed}))
    cookie = next(line for line in head.decode().split("\r\n") if line.lower().startswith("set-cookie:"))
    path = f"/api/v1/variants/{json.loads(body)['id']}/submissions"
    answers = grading.reference(deal(EXERCISE, seed)) | TYPED | (SLIP if slip else {})
    return post(path, {"answers": answers}, cookie.split(":", 1)[1].split(";")[0].strip())


async def load(target: Target) -> float:
    """Hand in as fast as the server answers; gives submissions per second."""
    begin = time.perf_counter()
    await asyncio.gather(*(one_client(target.port, own) for own in target.requests))
    return sum(map(len, target.requests)) / (time.perf_counter() - begin)


async def one_client(port: int, own: tuple[bytes, ...]) -> None:
    """One student's browser: one connection, one request after the other."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    for request in own:
        writer.write(request)
        head, body = await receive(reader)
        right = json.loads(body).get("score") == 1 or SLIP["l3"].encode() in request
        if not head.startswith(b"HTTP/1.1 201") or not right:
            raise SystemExit(f"not acknowledged as right: {head!r} {body!r}")
    writer.close()


Rounds: TypeAlias = dict[str, list[tuple[float, float]]]  # submissions per second; processor of the server for each, s


async def measure(ports: dict[str, int], processes: dict[str, int], given: argparse.Namespace) -> Rounds:
    """Load the servers in turn."""
    rounds: Rounds = {name: [] for name in ports}
    for port in ports.values():
        await started(port)
    for turn in range(given.rounds + 1):
        for name, port in ports.items():
            target = await prepare(port, given.clients, given.requests, SEED + turn * given.requests, given.slips)
            before = cpu(processes[name])
            rate = await load(target)
            rounds[name].append((rate, (cpu(processes[name]) - before) / given.requests))
    return {name: found[1:] for name, found in rounds.items()}  # the first round warms up


def compare(given: argparse.Namespace) -> None:
    """Start both servers, load them in turn, print rates and ratio."""
    ports = {"graded": free_port(), "no-op": free_port()}
    with stores(given.store, len(ports)) as laid:
        servers = {
            name: subprocess.Popen([sys.executable, __file__, "--serve", name, str(port)], env=os.environ | environment)
            for (name, port), environment in zip(ports.items(), laid, strict=True)
        }
        try:
            rounds = asyncio.run(measure(ports, {name: server.pid for name, server in servers.items()}, given))
        finally:
            for server in servers.values():
                server.terminate()
                server.wait()
    report(rounds, given)


def report(rounds: Rounds, given: argparse.Namespace) -> None:
    """Print rates, the processor time for each submission, and both ratios."""
    answered = "every second with a slip" if given.slips else "all right"
    print(f"store {given.store}, {answered}, load average {os.getloadavg()[0]:.1f}")
    middle: dict[str, tuple[float, float]] = {}
    for name, found in rounds.items():
        rates, work = zip(*found, strict=True)
        middle[name] = median(rates), median(work)
        print(
            f"{name}: {median(rates):.0f} submissions/s ({min(rates):.0f} to {max(rates):.0f} in {len(rates)} rounds), "
            f"{1e3 * median(work):.2f} ms of a processor for each in server and judge"
        )
    print(f"ratio by processor time {middle['no-op'][1] / middle['graded'][1]:.2f}")
    print(f"ratio {middle['graded'][0] / middle['no-op'][0]:.2f}")


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--requests", type=int, default=960)
    parser.add_argument("--clients", type=int, default=32)
    parser.add_argument("--store", choices=KINDS, default="sqlite")
    parser.add_argument("--slips", action="store_true", help="every second submission holds a slip")
    parser.add_argument("--serve", nargs=2, metavar=("WHICH", "PORT"))
    given = parser.parse_args()
    if given.serve:
        serve(int(given.serve[1]), given.serve[0] == "graded")
    else:
        compare(given)


if __name__ == "__main__":
    main()
