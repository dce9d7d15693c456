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
from collections.abc import Callable, Sequence
from pathlib import Path
from random import Random

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/http.py would stand before the library's http

from graders.equality import Comparison, Finding  # noqa: E402
from graders.equality.pair import Pair  # noqa: E402
from graders.equality.probing import open_turns  # noqa: E402
from graders.equality.turns import Joint, Turn  # noqa: E402
from graders.judge import Domain, Formula  # noqa: E402
from graders.language.intervals import Interval, side_of_zero  # noqa: E402
from graders.language.text import text_of  # noqa: E402
from graders.language.tree import Binary, Call, Name, Number, Tree, children, mapped, walk  # noqa: E402
from graders.states import spread  # noqa: E402

SYMBOLS = ("x", "y", "a", "b")
ENDS = ((0, 1), (-1, 1), (1, 2), (-2, 3), (0.1, 4), (-1, 0), (-1e-5, 1e-5))
ONE_ARGUMENT = ("abs", "sqrt", "ln", "sign", "sin", "cos", "atan", "asin", "acos", "exp", "tan")
TWO_ARGUMENTS = ("max", "min", "atan2")
SIDES = {Finding.EQUAL: "equal", Finding.DIFFERENT: "different", Finding.UNDEFINED: "different"}
TWO = Number("2")


class PlainSearch(Pair):
    """A pair whose verdict comes from the search alone."""

    __slots__ = ()

    def _in_every_case(self) -> Comparison | None:
        return None

    def _all_met(self, groups: Sequence[Joint]) -> bool:
        return False

    def _opened(self, found: Sequence[Turn]) -> tuple[list[Turn], list[Interval], frozenset[int]]:
        _, slots, signed = open_turns(self._with(found), self.states.box, found)
        kept = [turn for turn in found if not side_of_zero(slots[turn.slot]) and (turn.edge or slots[turn.slot][0] < 0)]
        return kept, slots, signed


def drawn(rng: Random, depth: int) -> Tree:
    """Draw a formula."""
    if depth == 0:
        return Name(rng.choice(SYMBOLS)) if rng.random() < 0.8 else Number(str(rng.randint(1, 3)))
    kind, inside = rng.random(), drawn(rng, depth - 1)
    if kind < 0.45:
        return Binary(rng.choice("++--**/"), inside, drawn(rng, rng.randrange(depth)))
    if kind < 0.55:
        return Call("macaulay", (inside, Number(str(rng.randint(0, 3)))))
    if kind < 0.75:
        return Call(rng.choice(TWO_ARGUMENTS), (inside, drawn(rng, rng.randrange(depth))))
    return Call(rng.choice(ONE_ARGUMENT), (inside,)) if kind < 0.92 else Binary("^", inside, TWO)


def _half(function: str, angle: Tree) -> Tree:
    return Call(function, (Binary("/", angle, TWO),))


REWRITTEN: dict[str, Callable[..., Tree]] = {  # the same wherever the one has a value, and nowhere else
    "+": lambda a, b: Binary("+", b, a),
    "-": lambda a, b: Binary("+", Binary("*", Binary("-", Number("0"), Number("1")), b), a),
    "*": lambda a, b: Binary("*", b, a),
    "/": lambda a, b: Binary("*", a, Binary("/", Number("1"), b)),
    "^": lambda a, _: Binary("*", a, a),
    "abs": lambda a: Call("max", (a, Binary("-", Number("0"), a))),
    "max": lambda a, b: Binary("/", Binary("+", Binary("+", a, b), Call("abs", (Binary("-", a, b),))), TWO),
    "min": lambda a, b: Binary("-", Binary("+", a, b), Call("max", (b, a))),
    "sin": lambda a: Binary("*", TWO, Binary("*", _half("sin", a), _half("cos", a))),
    "acos": lambda a: Binary("-", Binary("/", Name("pi"), TWO), Call("asin", (a,))),
    "asin": lambda a: Call("atan2", (a, Call("sqrt", (Binary("-", Number("1"), Binary("^", a, TWO)),)))),
}


def rewritten(rng: Random, tree: Tree, share: float) -> Tree:
    """Write some parts of a formula in another way."""

    def change(node: Tree) -> Tree:
        name = node.operator if isinstance(node, Binary) else node.function if isinstance(node, Call) else ""
        return REWRITTEN[name](*children(node)) if name in REWRITTEN and rng.random() < share else node

    return mapped(tree, change)


def changed(rng: Random, tree: Tree) -> Tree:
    """Change one part."""
    parts = list(walk(tree))
    chosen, other = rng.choice(parts), drawn(rng, 1)
    done: list[Tree] = []

    def change(node: Tree) -> Tree:
        if node is chosen and not done:
            done.append(node)
            return other
        return node

    return mapped(tree, change)


def judged(kind: type[Pair], a: Tree, b: Tree, box: dict[str, Domain]) -> tuple[Finding, float]:
    """Give a verdict and the processor time of it."""
    start = time.thread_time()
    found = kind(b, Formula(a, spread(box, b"equality")), mutual=True).compared().finding
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
        box = {name: Domain(*rng.choice(ENDS)) for name in SYMBOLS}
        tree, same = drawn(rng, rng.randint(1, 4)), rng.random() < 0.5
        other = rewritten(rng, tree if same else changed(rng, tree), 0.4)
        found = [judged(kind, tree, other, box) for kind in (Pair, PlainSearch)]
        seconds = [sum(both) for both in zip(seconds, (time for _, time in found), strict=True)]
        sides = [SIDES.get(finding, finding.value) for finding, _ in found]
        counts[" / ".join(sides)] += 1
        if {"equal", "different"} <= {*sides} or (same and "different" in sides):
            wrong += 1
            print(f"{number}: {' / '.join(sides)}: {text_of(tree)} | {text_of(other)} on {box}")
    print(f"pairs {arguments.pairs}, disagreements {wrong}")
    print("judge / plain search:", "; ".join(f"{name} {count}" for name, count in counts.most_common()))
    print(f"processor time, judge over plain search: {seconds[0] / seconds[1]:.2f}")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
