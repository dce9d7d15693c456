"""Equality of two formulas as functions on the true states of a system.

Doubles choose where to look; balls decide. `different` is proved at a named point; `equal` is zero to 30 digits,
relative to the larger side, at several points and on both sides of everything that turns; anything else is undecided.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from graders.equality.deciding import Finding
from graders.equality.pair import Comparison, Pair
from graders.equality.rounding import Rounded, rounded
from graders.judge import Domain, Formula, States
from graders.language.doubles import UndefinedError, domain_test
from graders.language.tree import Tree
from graders.states import drawn, spread

LEAST = 8  # points at which a formula that turns has a value


def compare(answer: Tree, reference: Formula, figures: int = 0) -> Comparison:
    """Compare an answer with a reference on the states of the reference.

    Args:
        answer: What was typed.
        reference: What it should be equal to.
        figures: The significant figures to which the decimals of the answer may be rounded, at least; 0: none may.
    """
    if answer == reference.tree:
        return Comparison(Finding.EQUAL)
    found = Pair(answer, reference, mutual=False).compared()
    if not figures or found.finding is not Finding.DIFFERENT:
        return found
    fitting = rounded(answer, reference, figures)
    return found if fitting is None else _fitted(fitting, reference.states)


def rounds(answer: Tree, reference: Formula, figures: int) -> bool:
    """Tell whether an answer would be equal to a reference if its decimals were rounded to so many figures."""
    fitting = rounded(answer, reference, figures)
    return fitting is not None and _fitted(fitting, reference.states).finding is Finding.EQUAL


def _fitted(fitting: Rounded, states: States) -> Comparison:
    """Ask at every point whether the rounded answer holds the reference."""
    findings = set()
    for point in states.points:
        finding = fitting.at(point)
        if finding is Finding.DIFFERENT:
            return Comparison(finding, tuple(zip(states.names, point, strict=True)))
        findings.add(finding)
    return Comparison(Finding.EQUAL if findings - {Finding.NOWHERE} == {Finding.EQUAL} else Finding.UNDECIDED)


def between(a: Tree, b: Tree, box: Mapping[str, Domain], chance: bytes = b"") -> Comparison:
    """Compare two formulas on a box; where only one of them has a value they differ.

    Args:
        a: One formula.
        b: The other.
        box: The domain of each symbol.
        chance: What the points depend on.
    """
    pair = Pair(b, Formula(a, spread_over(tuple(box.items()), chance)), mutual=True)
    if pair.smooth:
        return pair.compared()
    found = pair.at_once() or (pair.compared() if not pair.turns or pair.values >= LEAST else None)
    if found is not None:
        return found
    one, other = domain_test(a, tuple(box), ()), domain_test(b, tuple(box), ())
    try:
        states = drawn(box, chance, lambda point: one(point) or other(point))
    except UndefinedError:
        return pair.compared()
    return Pair(b, Formula(a, states), mutual=True).compared()


@lru_cache(maxsize=256)
def spread_over(box: tuple[tuple[str, Domain], ...], chance: bytes) -> States:
    """Draw points of a box once."""
    return spread(dict(box), chance)
