"""Random linkages of every kind, many in or near a dead position: solved, refused by name, the greatest residual.

Residuals are those of the closures and their two derivatives, as parts of their terms; a refusal is checked too. All
follows from the seed. Run: ``uv run python benchmarks/linkages.py [--count 10000] [--seed 1] [KIND …]``.
Exit code 1 where a residual exceeds 1e-9; anything but a solution or a named refusal stops the run.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import time

from tests.mechanics.hostile_linkages import KINDS, attack

LIMIT = 1e-9


def main() -> int:
    """Attack and report."""
    parser = argparse.ArgumentParser(description="Solve random linkages near dead positions.")
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=f"some of {', '.join(KINDS)}; else all")
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    worst = 0.0
    for kind in options.kinds or KINDS:
        start = time.process_time()
        found = attack(options.seed, options.count, kind)
        refused = ", ".join(f"{name} {count}" for name, count in found.refused.most_common()) or "none"
        seconds = time.process_time() - start
        print(f"{kind:22} solved {found.solved}, refused: {refused}; residual {found.worst:.1e} ({seconds:.0f} s)")
        worst = max(worst, found.worst)
    return int(worst > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
