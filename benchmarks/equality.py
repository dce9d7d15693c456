"""The judge of formulas beside a plain search: verdicts on random pairs that turn, and what either needs for them.

The plain search knows no cases, no signs that follow from one another, no patterns that are all met: it looks for both
sides of everything that may turn. Half of the pairs are one formula written in two ways, half have one part changed.
Run: ``uv run python benchmarks/equality.py [--pairs 20000] [--seed 1]``.
Exit code 1 when one calls equal what the other calls different, or a rewritten formula is called different.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from pathlib import Path
from random import Random

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

from graders.equality import Finding
from graders.equality.pair import Pair
from graders.judge import Domain, Formula
from graders.language.text import text_of
from graders.language.tree import Tree
from graders.states import spread
from tests.graders.rewriting import PlainSearch, box, changed, drawn, rewritten

SIDES = {Finding.EQUAL: "equal", Finding.DIFFERENT: "different", Finding.UNDEFINED: "different"}


def judged(kind: type[Pair], a: Tree, b: Tree, domains: dict[str, Domain]) -> tuple[Finding, float]:
    """Give a verdict and the processor time of it."""
    start = time.thread_time()
    found = kind(b, Formula(a, spread(domains, b"equality")), mutual=True).compared().finding
    return found, time.thread_time() - start


def main() -> int:
    """Run the comparison."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pairs", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    wrong, counts, seconds = 0, Counter[str](), [0.0, 0.0]
    for number in range(arguments.pairs):
        rng = Random(f"{arguments.seed}:{number}")
        domains = box(rng)
        tree, same = drawn(rng, rng.randint(1, 4)), rng.random() < 0.5
        other = rewritten(rng, tree if same else changed(rng, tree), 0.4)
        found = [judged(kind, tree, other, domains) for kind in (Pair, PlainSearch)]
        seconds = [sum(both) for both in zip(seconds, (time for _, time in found), strict=True)]
        sides = [SIDES.get(finding, finding.value) for finding, _ in found]
        counts[" / ".join(sides)] += 1
        if {"equal", "different"} <= {*sides} or (same and "different" in sides):
            wrong += 1
            print(f"{number}: {' / '.join(sides)}: {text_of(tree)} | {text_of(other)} on {domains}")
    print(f"pairs {arguments.pairs}, disagreements {wrong}")
    print("judge / plain search:", "; ".join(f"{name} {count}" for name, count in counts.most_common()))
    print(f"processor time, judge over plain search: {seconds[0] / seconds[1]:.2f}")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
