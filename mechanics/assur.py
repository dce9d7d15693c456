"""Structural (Assur) groups of a planar mechanism with pairs of class 5 (domain STR-8).

A group is the smallest chain of mobility zero that can be taken off: 3n - 2 p5 = 0. Groups farthest from the driver
come off first; what remains keeps the mobility.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

from mechanics.errors import AssemblyError
from mechanics.structure import FRAME, Pair

LARGEST = 6  # moving links of the largest group looked for: 2, 4 or 6
DYADS = ("RRR", "RRP", "RPR", "PRP", "RPP")
ROMAN = {1: "I", 2: "II", 3: "III", 4: "IV"}


@dataclass(frozen=True, slots=True)
class Group:
    """A structural group: its links, the numbers of its pairs (inner and outer), and its class."""

    links: frozenset[str]
    pairs: tuple[int, ...]
    klass: int


@dataclass(frozen=True, slots=True)
class Structure:
    """A mechanism taken apart: drivers, and groups in the order in which they are added to the drivers."""

    drivers: tuple[str, ...]
    groups: tuple[Group, ...]

    @property
    def klass(self) -> int:
        """Give the class of the mechanism: the highest class of its groups (I for a lone driver)."""
        return max((group.klass for group in self.groups), default=1)

    @property
    def formula(self) -> str:
        """Write the formation formula, `I(0,1) -> II(2,3) -> II(5,6)`."""
        first = "I(" + ",".join((FRAME, *self.drivers)) + ")"
        rest = (f"{ROMAN[group.klass]}({','.join(sorted(group.links))})" for group in self.groups)
        return " -> ".join((first, *rest))


def decompose(pairs: Sequence[Pair], drivers: Sequence[str]) -> Structure:
    """Take a planar mechanism apart into its drivers and structural groups.

    Args:
        pairs: All simple pairs, class 5, multiple joints expanded; the frame is the link "0".
        drivers: Links driven relative to the frame, one freedom each.

    Raises:
        ValueError: A pair is not of class 5, or a driver is no link of the mechanism.
        AssemblyError: What is left after the drivers is no sum of groups of at most six links; some links may be
            locked by too many pairs, or left with a freedom of their own.
    """
    if any(pair.klass != 5 for pair in pairs):
        raise ValueError("only pairs of class 5 form structural groups: replace a higher pair by a link first")
    links = {link for pair in pairs for link in (pair.one, pair.other)}
    unknown = sorted(set(drivers) - links)
    if unknown:
        raise ValueError(f"driver {unknown[0]} is no link of the mechanism")
    built = frozenset((FRAME, *drivers))
    groups = []
    while rest := links - built:
        group = _next_group(pairs, built, rest)
        groups.append(group)
        built |= group.links
    return Structure(tuple(drivers), tuple(groups))


def lower_pairs(pairs: Sequence[Pair]) -> tuple[Pair, ...]:
    """Replace each higher pair of the plane by a link with two pairs of class 5, which keeps the mobility.

    The new link of the pair between a and b is called "a~b" (3 - 2*2 = -1, as one pair of class 4).
    """
    found: list[Pair] = []
    for pair in pairs:
        link = f"{pair.one}~{pair.other}"
        found += [Pair(pair.one, link), Pair(link, pair.other)] if pair.klass == 4 else [pair]
    return tuple(found)


def dyad_form(outer: str, inner: str, other: str) -> str:
    """Name the form of a group of class II by the letters of its pairs, R or P, the inner one in the middle.

    Returns:
        One of RRR, RRP, RPR, PRP, RPP; read from either end it is the same form.

    Raises:
        ValueError: A letter is neither R nor P, or all are P: three slides hold nothing.
    """
    form = max(outer + inner + other, other + inner + outer)
    if form not in DYADS:
        raise ValueError(f"{outer}{inner}{other} is no dyad: the forms are {', '.join(DYADS)}")
    return form


def _next_group(pairs: Sequence[Pair], built: frozenset[str], rest: Iterable[str]) -> Group:
    """Find the smallest set of links that gains no freedom on what is built, and no part of which is locked."""
    ordered = sorted(rest)
    for size in range(2, LARGEST + 1, 2):
        for links in combinations(ordered, size):
            found = _pairs_of(pairs, built, frozenset(links))
            if len(found) * 2 == size * 3 and not _holds_locked(pairs, built, links):
                return Group(frozenset(links), found, _class_of(pairs, found, frozenset(links)))
    raise AssemblyError(
        f"links {', '.join(ordered)} form no structural group on the drivers: mobility or drivers differ"
    )


def _holds_locked(pairs: Sequence[Pair], built: frozenset[str], links: Sequence[str]) -> bool:
    """Tell whether some of the links are held by too many pairs, which the freedom of others makes up for."""
    parts = (part for size in range(1, len(links)) for part in combinations(links, size))
    return any(2 * len(_pairs_of(pairs, built, frozenset(part))) > 3 * len(part) for part in parts)


def _pairs_of(pairs: Sequence[Pair], built: frozenset[str], links: frozenset[str]) -> tuple[int, ...]:
    inside = built | links
    return tuple(
        at
        for at, pair in enumerate(pairs)
        if {pair.one, pair.other} <= inside and (pair.one in links or pair.other in links)
    )


def _class_of(pairs: Sequence[Pair], found: Sequence[int], links: frozenset[str]) -> int:
    """Class II: two links; IV: a closed contour of four inner pairs; III: links carrying three pairs."""
    if len(links) == 2:
        return 2
    inner = [pairs[at] for at in found if {pairs[at].one, pairs[at].other} <= links]
    return 4 if _has_contour(inner, 4) else 3


def _has_contour(inner: Sequence[Pair], length: int) -> bool:
    """Tell whether some of the inner pairs close a contour of this many links."""
    return any(_is_contour(chosen) for chosen in combinations(inner, length))


def _is_contour(chosen: Sequence[Pair]) -> bool:
    carried: dict[str, int] = {}
    for pair in chosen:
        for link in (pair.one, pair.other):
            carried[link] = carried.get(link, 0) + 1
    return len(carried) == len(chosen) and set(carried.values()) == {2}
