"""Random beams, shafts and bars, many nearly singular: solved, refused by name, the greatest residual of the laws.

Beams are also solved in fractions, and reactions, moments and deflections compared. All follows from the seed. Run:
``uv run python benchmarks/structures.py [--count 10000] [--exact 1000] [--seed 1]``.
Exit code 1 where a residual or an error exceeds 1e-9.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

import argparse
import time
from random import Random

from tests.mechanics.hostile import KINDS, attack, exact_error, random_beam

LIMIT = 1e-9


def compare(seed: int, wanted: int) -> tuple[int, float]:
    """Solve beams in fractions until so many are compared; give how many, and the greatest error."""
    compared, worst, number = 0, 0.0, 0
    while compared < wanted:
        number += 1
        try:
            worst = max(worst, exact_error(random_beam(Random(f"{seed}/exact/{number}"))))
        except ValueError:
            continue
        compared += 1
    return compared, worst


def main() -> int:
    """Attack and report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--exact", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    worst = 0.0
    for kind in KINDS:
        start = time.perf_counter()
        found = attack(options.seed, options.count, kind)
        refused = ", ".join(f"{name} {count}" for name, count in found.refused.most_common()) or "none"
        seconds = time.perf_counter() - start
        print(f"{kind:6} solved {found.solved}, refused: {refused}; residual {found.worst:.1e} ({seconds:.0f} s)")
        worst = max(worst, found.worst)
    compared, error = compare(options.seed, options.exact)
    print(f"beam   {compared} against fractions: error {error:.1e}")
    return int(max(worst, error) > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
