"""Random gear trains and drawn structures: solved and checked, or refused by name; counts and the slowest.

Run: ``uv run python benchmarks/machines.py [--number 10000] [--seed 1]``; ends 1 where one broke a law or raised
anything but a refusal.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/mechanics.py would stand before the room

import argparse
import time
from collections import Counter
from random import Random

from tests.mechanics import judged_machines


def main() -> int:
    """Judge and print."""
    reader = argparse.ArgumentParser(description="Solve random gear trains and structures.")
    reader.add_argument("--number", type=int, default=10_000)
    reader.add_argument("--seed", type=int, default=1)
    given, broken = reader.parse_args(), 0
    for judge in (judged_machines.train, judged_machines.structure):
        outcomes: Counter[str] = Counter()
        slowest = 0.0
        for number in range(given.number):
            start = time.process_time()
            try:
                outcomes[judge(Random(f"{given.seed}:{number}"))] += 1
            except Exception as error:  # a count of what went wrong is the purpose
                broken += 1
                print(f"{judge.__name__} {given.seed}:{number}: {type(error).__name__}: {error}"[:300])
            slowest = max(slowest, time.process_time() - start)
        print(f"{judge.__name__}: {dict(outcomes)}, slowest {1e3 * slowest:.0f} ms")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
