"""Random formulas that turn, the same ones written in another way, and a search without what makes the judge fast."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

from graders.equality import Comparison
from graders.equality.pair import Pair
from graders.equality.probing import open_turns
from graders.equality.turns import Joint, Places, Turn
from graders.judge import Domain
from graders.language.intervals import Interval, side_of_zero
from graders.language.tree import Binary, Call, Name, Number, Tree, children, mapped, walk

SYMBOLS = ("x", "y", "a", "b")
ENDS = ((0, 1), (-1, 1), (1, 2), (-2, 3), (0.1, 4), (-1, 0), (-1e-5, 1e-5))
ONE_ARGUMENT = ("abs", "sqrt", "ln", "sign", "sin", "cos", "atan", "asin", "acos", "exp", "tan")
TWO_ARGUMENTS = ("max", "min", "atan2")
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

    def _narrowed(
        self, where: Places, found: list[Turn], slots: Sequence[Interval], signed: frozenset[int]
    ) -> tuple[Places, list[Turn]]:
        return where, found


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


def box(rng: Random) -> dict[str, Domain]:
    """Draw domains for all symbols."""
    return {name: Domain(*rng.choice(ENDS)) for name in SYMBOLS}
