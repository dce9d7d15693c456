"""Random serial chains and inverse tasks, many of them nearly singular: solved to 1e-9 or refused by name.

A chain is solved by recursion and by the matrices U and V, its drives in base axes, in link frames and by Lagrange.
An inverse task starts from joint variables near a stretched arm, a folded one, or an axis the point lies on; every
branch must carry the point back. Residuals are relative to the size of the arm and its rates.
Run: ``uv run python benchmarks/chains.py [--count 10000] [--seed 1]``.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from math import dist, pi
from pathlib import Path
from random import Random

sys.path[0] = str(Path(__file__).resolve().parents[1])

from mechanics import chain, lagrange, link_frames, newton_euler, rod_groups, transform
from mechanics.chain import Chain
from mechanics.dh import Row
from mechanics.errors import AssemblyError, SingularError
from mechanics.links import LinkMass
from mechanics.vectors import Vector

GRAVITY: Vector = (0.0, 0.0, -9.81)


def gap(one: object, other: object) -> float:
    """Give the largest difference of two equal shapes of numbers, relative to the largest of them or 1."""
    pairs = list(zip(flat(one), flat(other), strict=True))
    return max(abs(x - y) for x, y in pairs) / max(1.0, *(abs(y) for _, y in pairs))


def flat(value: object) -> list[float]:
    """List the numbers of nested sequences."""
    return [x for part in value for x in flat(part)] if isinstance(value, list | tuple) else [float(value)]  # type: ignore[arg-type]


def drawn_chain(rng: Random) -> tuple[tuple[Row, ...], list[LinkMass]]:
    """Draw a table of two to four joints, many of their angles right, and the masses of its links."""
    rows, masses = [], []
    for _ in range(rng.randint(2, 4)):
        alpha = rng.choice([0.0, pi / 2, -pi / 2, rng.uniform(-pi, pi)])
        d, a = rng.uniform(-1, 1), rng.choice([0.0, rng.uniform(-1, 1)])
        rows.append(Row(rng.choice("RRP"), rng.uniform(-pi, pi), d, a, alpha, rng.choice([1, -1])))  # type: ignore[arg-type]
        x, y, z = (rng.uniform(0.01, 1) for _ in range(3))
        tensor = ((y + z, 0.0, 0.0), (0.0, z + x, 0.0), (0.0, 0.0, x + y))
        masses.append(
            LinkMass(rng.uniform(0.1, 5), (rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)), tensor)
        )
    return tuple(rows), masses


def chain_residual(rng: Random) -> float:
    """Solve one chain both ways, and its drives three ways."""
    rows, masses = drawn_chain(rng)
    convention = rng.choice(["standard", "modified"])
    q, qd, qdd = ([rng.uniform(-3, 3) for _ in rows] for _ in range(3))
    table, point = Chain(rows, convention), (rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1))  # type: ignore[arg-type]
    motion = chain.solve(table, q, qd, qdd, point)
    by_matrices = transform.point_motion(rows, q, qd, qdd, point, table.convention)
    drives = newton_euler.solve(table, masses, q, qd, qdd, GRAVITY).tau
    found = [
        gap((motion.p, motion.v, motion.a), by_matrices),
        gap(drives, lagrange.torques(rows, masses, q, qd, qdd, GRAVITY, table.convention)),
    ]
    if convention == "standard":
        found.append(gap(drives, link_frames.drives(rows, masses, q, qd, qdd, GRAVITY).tau))
    return max(found)


def near(rng: Random, place: float) -> float:
    """Draw a number near a place, at it, or anywhere."""
    return rng.choice([place, place + rng.choice([1, -1]) * 10 ** rng.uniform(-17, -1), rng.uniform(-pi, pi)])


def inverse_residual(rng: Random) -> float:
    """Bring a point of a rod group back through every branch, relative to the size of the arm."""
    word = rng.choice(list(rod_groups.GROUPS))
    scale = 10 ** rng.uniform(-4, 4)
    lengths = {name: scale * rng.choice([1.0, rng.uniform(0.05, 2)]) for name in rod_groups.GROUPS[word].lengths}
    if "d" in lengths:
        lengths["d"] *= rng.choice([0.0, -1.0, 1.0])
    kinds = zip(word, (near(rng, rng.choice([0.0, pi / 2, pi])) for _ in word), strict=True)
    q = [x if kind == "R" else scale * x for kind, x in kinds]
    M = rod_groups.direct(word, lengths, q)
    if rng.random() < 0.3:  # a point from anywhere, perhaps just out of reach
        M = (M[0] * (1 + near(rng, 0.0)), M[1], M[2] * (1 + near(rng, 0.0)))
    size = max(scale, *map(abs, M))
    return max(dist(rod_groups.direct(word, lengths, x), M) for x in rod_groups.inverse(word, lengths, M)) / size


def main() -> int:
    """Solve them all and print the worst residuals and the refusals; end 1 above 1e-9."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rng, refusals = Random(given.seed), Counter[str]()
    worst = {"chains": 0.0, "inverse tasks": 0.0}
    for _ in range(given.count):
        worst["chains"] = max(worst["chains"], chain_residual(rng))
        try:
            worst["inverse tasks"] = max(worst["inverse tasks"], inverse_residual(rng))
        except (AssemblyError, SingularError) as refusal:
            refusals[type(refusal).__name__] += 1
    for name, residual in worst.items():
        print(f"{given.count} {name}: largest residual {residual:.1e}")
    print("refused by name: " + ", ".join(f"{name} {count}" for name, count in sorted(refusals.items())))
    return int(max(worst.values()) > 1e-9)


if __name__ == "__main__":
    sys.exit(main())
