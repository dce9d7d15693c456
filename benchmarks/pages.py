"""The workspace as a student meets it: bytes and time of a first visit, waiting for previews and verdicts in a class.

A real browser opens a workspace with nothing cached; its own timing gives bytes and the moment when everything works
(all islands started). Then fifty clients type and hand in at the pace of people, each on its own variant, for a bounded
number of requests to this machine only. Run: ``uv run python benchmarks/pages.py``.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[0] = str(ROOT)  # else benchmarks/http.py would stand before the library's http

import argparse
import asyncio
import os
import shutil
import socket
import subprocess
import time
from statistics import median, quantiles
from tempfile import TemporaryDirectory

import httpx2
from playwright.sync_api import sync_playwright

EXERCISE = "simple_beam"
PROGRAM = """
import os
from server.run import serve
from server.settings import from_environment
serve(from_environment(os.environ))
"""
ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]
VISIT = """() => { const [page] = performance.getEntriesByType("navigation");
  const all = [page, ...performance.getEntriesByType("resource")];
  return [all.reduce((sum, entry) => sum + entry.transferSize, 0), page.domContentLoadedEventEnd]; }"""
TYPED = ("8,", "8,5", "8,57", "8,575 k", "8,575 kN")
PAUSE = 0.5  # s between two requests of one client
FEWEST = 20  # for a 95th percentile


def visits(url: str, number: int) -> None:
    """Open a workspace afresh, several times; prints bytes and milliseconds."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium-headless-shell") or shutil.which("chromium"), args=ARGUMENTS
        )
        seen = []
        for _ in range(number):
            context = browser.new_context(locale="pl")
            page = context.new_page()
            reply = page.request.post(f"{url}/exercises/{EXERCISE}", form={"seed": "7"}, max_redirects=0)
            page.goto(url + reply.headers["location"], wait_until="networkidle")
            seen.append(page.evaluate(VISIT))
            context.close()
        browser.close()
    print(f"workspace: {seen[0][0] / 1000:.0f} kB at the first visit, works after {median(t for _, t in seen):.0f} ms")


async def student(url: str, turn: int, rounds: int, waits: dict[str, list[float]]) -> None:
    """One student: types, looks, hands in; notes how long each answer took."""
    async with httpx2.AsyncClient(base_url=url, timeout=30) as client:
        dealt = (await client.post(f"/api/v1/exercises/{EXERCISE}/variants", json={"seed": turn})).json()
        path = f"/api/v1/variants/{dealt['id']}"
        for _ in range(rounds):
            for text in TYPED:
                await asyncio.sleep(PAUSE)
                await timed(client, f"{path}/preview", {"answer": "R_A", "text": text}, waits["preview"])
            await asyncio.sleep(PAUSE)
            await timed(client, f"{path}/submissions", {"answers": {"R_A": f"{turn} kN"}}, waits["submit"])


async def timed(client: httpx2.AsyncClient, path: str, body: object, waits: list[float]) -> None:
    """Post and note the wait."""
    begin = time.perf_counter()
    reply = await client.post(path, json=body)
    waits.append(1000 * (time.perf_counter() - begin))
    reply.raise_for_status()


async def class_of(url: str, clients: int, rounds: int) -> None:
    """Let a class work at once; prints the waits."""
    waits: dict[str, list[float]] = {"preview": [], "submit": []}
    await asyncio.gather(*(student(url, turn, rounds, waits) for turn in range(1, clients + 1)))
    for name, found in waits.items():
        late = quantiles(found, n=20)[-1] if len(found) >= FEWEST else max(found)
        print(f"{name}: median {median(found):.0f} ms, p95 {late:.0f} ms ({len(found)} by {clients} clients)")


def free_port() -> int:
    """Find a port that nobody listens at."""
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return int(found.getsockname()[1])


def wait_for(url: str) -> None:
    """Wait until the server answers."""
    for _ in range(300):
        try:
            httpx2.get(f"{url}/ready").raise_for_status()
            return
        except httpx2.HTTPError:
            time.sleep(0.1)
    raise SystemExit("the server does not start")


def main() -> None:
    """Read the command line, start a server, measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--visits", type=int, default=5)
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    port = free_port()
    with TemporaryDirectory() as folder:
        environ = {**os.environ, "GRUBLER_DATA_DIR": folder, "GRUBLER_PORT": str(port)}
        server = subprocess.Popen([sys.executable, "-c", PROGRAM], env=environ, cwd=ROOT, stdout=subprocess.DEVNULL)
        try:
            wait_for(f"http://127.0.0.1:{port}")
            visits(f"http://127.0.0.1:{port}", given.visits)
            asyncio.run(class_of(f"http://127.0.0.1:{port}", given.clients, given.rounds))
        finally:
            server.terminate()
            server.wait()


if __name__ == "__main__":
    main()
