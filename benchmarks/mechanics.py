"""The reference solvers: median time of one call beside what was asked and beside other people's solvers, in one run.

Run: ``uv run python benchmarks/mechanics.py [CHAPTER …]``; with the peers: ``uv run --extra peers python …``.
Rounds of ours and of the peers alternate, so that a busy machine slows all; times are of this process alone. A peer
that is not installed is named as left out. Then come the import time of every module of `mechanics` and, where no
chapter is named, the figures of `benchmarks/laws.py`: residuals over a cycle, random machines, worked examples.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[0] = str(ROOT)  # else this file would stand before the room it measures

import argparse
import gc
import subprocess
import time
from collections.abc import Iterator
from importlib import import_module
from itertools import chain
from statistics import median

from benchmarks import laws
from benchmarks.solvers.row import Row, Task

CHAPTERS = sorted(
    path.stem for path in (ROOT / "benchmarks/solvers").glob("*.py") if path.stem not in ("__init__", "row")
)
ROUNDS, ROUND, LONGEST = 15, 0.01, 4.0  # rounds, seconds a round, seconds after which no further round starts
MODULES = sorted(path.stem for path in (ROOT / "mechanics").glob("*.py") if path.stem != "__init__")
IMPORT = "import time; t = time.process_time(); {}; print(time.process_time() - t); import sys; print(*sys.modules)"


def calls(task: Task) -> int:
    """Find how many calls fill a round."""
    count = 1
    while (taken := batch(task, count)) < ROUND / 4:
        count *= 4
    return max(1, round(count * ROUND / taken))


def batch(task: Task, count: int) -> float:
    """Time a number of calls."""
    start = time.process_time()
    for _ in range(count):
        task()
    return time.process_time() - start


def medians(tasks: dict[str, Task]) -> dict[str, float]:
    """Time tasks in turns; seconds a call."""
    counts = {name: calls(task) for name, task in tasks.items()}
    times: dict[str, list[float]] = {name: [] for name in tasks}
    for _ in range(ROUNDS):
        for name, task in tasks.items():
            if not times[name] or sum(times[name]) * counts[name] < LONGEST:
                times[name].append(batch(task, counts[name]) / counts[name])
    return {name: median(found) for name, found in times.items()}


def measured(row: Row) -> Iterator[str]:
    """Say one row, then one line a peer."""
    tasks, left_out = {"": row.run}, []
    for name, make in row.peers.items():
        try:
            tasks[name] = make()
        except ImportError:
            left_out.append(name)
    found = medians(tasks)
    ours = found.pop("")
    asked = "" if row.limit is None else f" (asked ≤ {row.limit:g}{'' if 1e6 * ours <= row.limit else ', MISSED'})"
    yield f"{row.name:58}{1e6 * ours:11.2f} µs{asked}"
    for name, taken in found.items():
        yield f"    {name:54}{1e6 * taken:11.2f} µs = {taken / ours:.1f} times ours"
    for name in left_out:
        yield f"    {name} is not installed: left out"


def import_time() -> str:
    """Time the import of the whole room in a fresh Python, and name what heavy came with it."""
    code = IMPORT.format("; ".join(f"import mechanics.{module}" for module in MODULES))
    times, loaded = [], ""
    for _ in range(ROUNDS):
        done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
        taken, loaded = done.stdout.splitlines()
        times.append(float(taken))
    heavy = {"sympy", "numpy", "scipy"} & set(loaded.split())
    with_it = ", ".join(sorted(heavy)) or "neither SymPy nor NumPy"
    return f"import of all {len(MODULES)} modules: {1e3 * median(times):.0f} ms of processor time, with it {with_it}"


def main() -> None:
    """Measure the chapters and print."""
    reader = argparse.ArgumentParser(description="Measure the reference solvers beside their peers.")
    reader.add_argument("chapters", nargs="*", metavar="CHAPTER", help=f"some of {', '.join(CHAPTERS)}; else all")
    asked = reader.parse_args().chapters
    gc.disable()
    for chapter in asked or CHAPTERS:
        print(f"{chapter}:")
        for row in import_module(f"benchmarks.solvers.{chapter}").ROWS:
            print(*measured(row), sep="\n", flush=True)
    print(import_time())
    if not asked:
        gc.enable()
        for line in chain([laws.examples()], laws.cycles(), laws.random_machines()):
            print(line, flush=True)


if __name__ == "__main__":
    main()
