"""Structure of mechanisms: counting pairs, mobility by formula, independent loops, kinds of chains (domain STR-1..7).

The class of a pair is the number of freedoms it removes (revolute, prismatic: 5; cam contact in the plane: 4). The
frame is the link "0"; n counts the moving links only.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

FRAME = "0"
CLASSES = {  # class of each pair by its letter: the number of freedoms removed in space (STR-1)
    "R": 5,  # revolute
    "P": 5,  # prismatic
    "H": 5,  # screw
    "C": 4,  # cylindrical
    "U": 4,  # universal, sphere with a pin
    "S": 3,  # spherical
    "E": 3,  # planar
    "L": 2,  # cylinder on a plane
    "B": 1,  # ball on a plane
}
FREEDOMS_IN_SPACE = 6


def freedoms(kind: str) -> int:
    """Give the freedoms a spatial pair leaves, 6 less its class (STR-1).

    Raises:
        ValueError: The letter is no key of `CLASSES`.
    """
    if kind not in CLASSES:
        raise ValueError(f"pair {kind!r} is none of {', '.join(CLASSES)}")
    return FREEDOMS_IN_SPACE - CLASSES[kind]


@dataclass(frozen=True, slots=True)
class Pair:
    """A simple pair of two links; class 5 or 4 in the plane, 1 to 5 in space."""

    one: str
    other: str
    klass: int = 5


def expanded(links: Sequence[str], klass: int = 5) -> tuple[Pair, ...]:
    """Expand a joint where m links meet into m - 1 simple pairs on its first link (STR-4).

    Args:
        links: The links that meet; at least two, none twice.
        klass: Class of each simple pair.

    Raises:
        ValueError: Fewer than two links, or one of them twice.
    """
    if len(links) < 2 or len(set(links)) != len(links):
        raise ValueError(f"a joint needs two or more different links, not {', '.join(links) or 'none'}")
    return tuple(Pair(links[0], other, klass) for other in links[1:])


def planar_mobility(moving: int, p5: int, p4: int = 0) -> int:
    """Count the mobility of a planar mechanism, F = 3n - 2 p5 - p4 (STR-3).

    Args:
        moving: Number n of moving links.
        p5: Pairs of one freedom, multiple joints expanded.
        p4: Pairs of two freedoms (cam, gear tooth).

    Raises:
        ValueError: A count is negative.
    """
    _counts(moving, p5, p4)
    return 3 * moving - 2 * p5 - p4


def spatial_mobility(moving: int, pairs: Mapping[int, int]) -> int:
    """Count the mobility of a spatial mechanism, F = 6n - sum of class times number (STR-2).

    Args:
        moving: Number n of moving links.
        pairs: Number of pairs by class, 1 to 5.

    Raises:
        ValueError: A count is negative or a class unknown.
    """
    _counts(moving, *pairs.values())
    strange = sorted(klass for klass in pairs if not 1 <= klass <= 5)
    if strange:
        raise ValueError(f"no pair has class {strange[0]}: classes are 1 to 5")
    return 6 * moving - sum(klass * number for klass, number in pairs.items())


def _counts(*numbers: int) -> None:
    for number in numbers:
        if number < 0:
            raise ValueError(f"{number} links or pairs: a count is not negative")


def count_loops(pairs: Sequence[Pair]) -> int:
    """Count the independent loops of a connected chain, k = p - n_all + 1 (STR-6, Euler).

    Raises:
        ValueError: The pairs do not connect all links.
    """
    links = _links(pairs)
    if pairs and len(_tree(pairs)) != len(links) - 1:
        raise ValueError("the pairs do not connect all links: loops are counted part by part")
    return len(pairs) - len(links) + 1 if pairs else 0


def fundamental_loops(pairs: Sequence[Pair]) -> tuple[tuple[int, ...], ...]:
    """Give an independent set of loops: each closes the spanning tree by one pair left out of it.

    Returns:
        For each loop the numbers of its pairs in the order walked, starting with the closing pair.
    """
    tree = _tree(pairs)
    return tuple((at, *_path(pairs, tree, pair.other, pair.one)) for at, pair in enumerate(pairs) if at not in tree)


def incidence_matrix(pairs: Sequence[Pair]) -> tuple[tuple[int, ...], ...]:
    """Give the incidence matrix, a row a link in the order met, a column a pair: -1 at its first link, +1 at its other.

    A loop, with signs for the sense in which its pairs are walked, is a combination of columns that vanishes, so the
    number of independent loops is that of pairs less the rank (STR-6).
    """
    return tuple(tuple((pair.other == link) - (pair.one == link) for pair in pairs) for link in _links(pairs))


def independent(loops: Iterable[Iterable[int]]) -> bool:
    """Tell whether loops, given by the numbers of their pairs, are independent (rank over GF(2)) (STR-6)."""
    basis: list[int] = []
    for loop in loops:
        row = sum(1 << pair for pair in set(loop))
        for known in basis:
            row = min(row, row ^ known)
        if not row:
            return False
        basis.append(row)
    return True


def _links(pairs: Sequence[Pair]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(link for pair in pairs for link in (pair.one, pair.other)))


def _tree(pairs: Sequence[Pair]) -> frozenset[int]:
    """Choose the pairs of a spanning forest, earliest first."""
    part = {link: link for link in _links(pairs)}

    def root(link: str) -> str:
        while part[link] != link:
            link = part[link]
        return link

    chosen = []
    for at, pair in enumerate(pairs):
        one, other = root(pair.one), root(pair.other)
        if one != other:
            part[one] = other
            chosen.append(at)
    return frozenset(chosen)


def _path(pairs: Sequence[Pair], tree: frozenset[int], start: str, end: str) -> tuple[int, ...]:
    """Walk the tree from one link to another; the numbers of the pairs passed."""
    came: dict[str, tuple[str, int]] = {start: (start, -1)}
    pending = [start]
    while end not in came:
        link = pending.pop()
        for at in tree:
            pair = pairs[at]
            if link in (pair.one, pair.other):
                neighbour = pair.other if link == pair.one else pair.one
                if neighbour not in came:
                    came[neighbour] = (link, at)
                    pending.append(neighbour)
    passed = []
    while end != start:
        end, at = came[end]
        passed.append(at)
    return tuple(reversed(passed))


@dataclass(frozen=True, slots=True)
class Chain:
    """Kind of a kinematic chain (STR-7): `compound` if a link carries more than two pairs; `form` by its loose ends."""

    compound: bool
    form: str  # "open", "closed" or "mixed"


def chain_of(pairs: Sequence[Pair]) -> Chain:
    """Classify a chain as simple or compound, and as open, closed or mixed (STR-7)."""
    carried = {link: sum(link in (p.one, p.other) for p in pairs) for link in _links(pairs)}
    loose = any(number == 1 for number in carried.values())
    form = "closed" if not loose else "mixed" if count_loops(pairs) else "open"
    return Chain(any(number > 2 for number in carried.values()), form)


def manoeuvrability(joints: int, planar: bool = False) -> int:
    """Give the mobility left to an open chain of one-freedom joints whose gripper is held: W - 6, plane W - 3 (STR-9).

    Raises:
        ValueError: The number of joints is negative.
    """
    _counts(joints)
    return max(0, joints - (3 if planar else 6))
