"""Closures as walks in the graph of the mechanism: closed or not, independent or not, which sign is wrong."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import combinations

from graders.polygon.drawn import Drawn
from graders.polygon.mechanism import Mechanism
from graders.verdict import Code, Flaw

Walk = dict[str, float]  # how often each vector is walked, with its sense
PIVOT = 1e-6  # of rows scaled to one
MOST_TURNED = 2  # wrong signs that are looked for in one closure


@dataclass(frozen=True, slots=True)
class Walked:
    """The closures: as typed, as they close (None: they do not), which share is right, what is wrong."""

    own: tuple[Walk, ...]
    mended: tuple[Walk | None, ...]
    right: float
    flaws: tuple[Flaw, ...]


def walk(drawn: Drawn, mechanism: Mechanism) -> Walked:
    """Check the closures."""
    own = tuple(_scaled(dict(closure.walked)) for closure in drawn.closures)
    if not own:
        return Walked((), (), 0.0, (Flaw(Code.NO_CLOSURE),))
    ends = {v.label: (v.start, v.end) for v in drawn.vectors}
    flaws: list[Flaw] = []
    mended: list[Walk | None] = []
    whole: list[Walk] = []
    for at, walked in enumerate(own, 1):
        name = str(at) if len(own) > 1 else ""
        closed, found = _mend(walked, ends, name)
        mended.append(closed)
        if found:
            flaws += found
        elif rank(_edges(one, ends) for one in (*whole, walked)) > len(whole):
            whole.append(walked)
        else:
            flaws.append(Flaw(Code.DEPENDENT_LOOP, str(at)))
    if len(own) < mechanism.loops:
        flaws.append(Flaw(Code.MISSING_LOOP, str(mechanism.loops)))
    return Walked(own, tuple(mended), len(whole) / max(len(own), mechanism.loops), tuple(flaws))


def _scaled(walked: Walk) -> Walk:
    """Divide by the one factor that all vectors share, so that each is walked once."""
    least = min(map(abs, walked.values()), default=1.0)
    return {label: factor / least for label, factor in walked.items()}


def _mend(walked: Walk, ends: Mapping[str, tuple[str, str]], name: str) -> tuple[Walk | None, list[Flaw]]:
    """Close a walk by turning as few signs as it takes, that of the first vector last."""
    first = next(iter(walked), "")
    for count in range(min(len(walked) // 2, MOST_TURNED) + 1):
        for turned in sorted(combinations(walked, count), key=lambda labels: first in labels):
            tried = {label: -factor if label in turned else factor for label, factor in walked.items()}
            if not _gaps(tried, ends):
                return tried, [Flaw(Code.CLOSURE_SIGN, label, name) for label in turned]
    return None, [Flaw(Code.OPEN_POLYGON, ", ".join(_gaps(walked, ends)), name)]


def _gaps(walked: Walk, ends: Mapping[str, tuple[str, str]]) -> list[str]:
    """Give the nodes that are left or reached without the other."""
    balance: dict[str, float] = {}
    for label, factor in walked.items():
        start, end = ends[label]
        balance[start] = balance.get(start, 0.0) - factor
        balance[end] = balance.get(end, 0.0) + factor
    return sorted(node for node, left in balance.items() if left)


def _edges(walked: Walk, ends: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Write a walk over undirected edges: two vectors on one link are one edge."""
    found: dict[str, float] = {}
    for label, factor in walked.items():
        start, end = ends[label]
        edge = f"{min(start, end)} {max(start, end)}"
        found[edge] = found.get(edge, 0.0) + (factor if start < end else -factor)
    return found


def rank(rows: Iterable[Mapping[str, float]]) -> int:
    """Give how many rows are independent, by elimination with the largest pivot; each row is scaled to one."""
    left = [_unit(row) for row in rows]
    found = 0
    while left:
        row = max(left, key=lambda r: max(map(abs, r.values()), default=0.0))
        column, pivot = max(row.items(), key=lambda item: abs(item[1]), default=("", 0.0))
        if abs(pivot) < PIVOT:
            return found
        left.remove(row)
        left = [_without(other, row, column) for other in left]
        found += 1
    return found


def _unit(row: Mapping[str, float]) -> dict[str, float]:
    size = max(map(abs, row.values()), default=0.0)
    return {column: value / size for column, value in row.items()} if size else {}


def _without(other: Mapping[str, float], row: Mapping[str, float], column: str) -> dict[str, float]:
    factor = other.get(column, 0.0) / row[column]
    columns = [name for name in {**other, **row} if name != column]
    return {name: other.get(name, 0.0) - factor * row.get(name, 0.0) for name in columns}


def links(drawn: Drawn, mechanism: Mechanism) -> list[Flaw]:
    """Find the vectors that lie on no link."""
    joined = {frozenset(edge) for edge in mechanism.edges}
    return [Flaw(Code.NO_LINK, v.label) for v in drawn.vectors if frozenset((v.start, v.end)) not in joined]
