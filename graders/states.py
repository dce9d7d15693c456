"""Points of a box at which formulas are compared: evenly inside, near both ends of every symbol, and corners."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from hashlib import shake_256
from itertools import islice
from typing import TypeAlias

from graders.judge import Domain, States
from graders.language.doubles import UndefinedError
from graders.language.tree import Tree

INSIDE = 16
TRIES = 400
ENDS = (1e-3, 1e-6, 1e-9, 1e-4, 1e-8, 1e-5, 1e-7)  # distances from an end, as shares of the width

Point: TypeAlias = tuple[float, ...]


def drawn(
    box: Mapping[str, Domain],
    chance: bytes,
    defined: Callable[[Point], bool],
    lines: tuple[tuple[str, Tree], ...] = (),
) -> States:
    """Draw points of a box.

    Args:
        box: The domain of each symbol.
        chance: What the points depend on: a secret, the exercise, the seed.
        defined: Tells whether a point is a state: whether what is compared has a value there.
        lines: Formulas of earlier names, kept with the states.

    Returns:
        Sixteen points that fill the box evenly, two opposite corners, and one point near each end of each symbol, as
        far as they are states.

    Raises:
        UndefinedError: Fewer than sixteen points of 400 are states.
    """
    names, ranges = tuple(box), tuple(box.values())
    shares = _chance(chance, len(ranges))
    inside = list(islice(filter(defined, islice(_spread(ranges, shares), TRIES)), INSIDE))
    if len(inside) < INSIDE:
        raise UndefinedError(f"defined at {len(inside)} of {TRIES} points")
    borders = filter(defined, (*_corners(ranges, shares), *_ends(inside, ranges)))
    return States(names, (*inside, *dict.fromkeys(borders)), lines, ranges)


def spread(box: Mapping[str, Domain], chance: bytes) -> States:
    """Draw points of a box, wherever what is compared has a value."""
    return drawn(box, chance, lambda point: True)


def _chance(words: bytes, count: int) -> list[float]:
    block = shake_256(words).digest(8 * count)
    return [(int.from_bytes(block[at : at + 8], "big") >> 11) / (1 << 53) for at in range(0, 8 * count, 8)]


def _spread(ranges: Sequence[Domain], place: list[float]) -> Iterator[Point]:
    """Fill the box evenly from a drawn start.

    Source:
        Kronecker sequence of the powers of the generalized golden ratio: M. Roberts, The unreasonable effectiveness of
        quasirandom sequences, 2018.
    """
    steps = _golden(len(ranges))
    while True:
        yield tuple(map(_scaled, place, ranges))
        place = [(share + step) % 1.0 for share, step in zip(place, steps, strict=True)]


@lru_cache(maxsize=64)
def _golden(count: int) -> tuple[float, ...]:
    """Give the powers of 1/g, where g is the root of g^(count + 1) = g + 1."""
    ratio = 2.0
    for _ in range(64):
        ratio = (1 + ratio) ** (1 / (count + 1))
    return tuple(ratio**-power for power in range(1, count + 1))


def _scaled(share: float, domain: Domain) -> float:
    if domain.integer:
        return domain.low + float(int(share * (domain.high - domain.low + 1)))
    return domain.low + (domain.high - domain.low) * (0.001 + 0.998 * share)


def _corners(ranges: Sequence[Domain], shares: list[float]) -> Iterator[Point]:
    """Give two opposite corners, a little inside."""
    for opposite in (False, True):
        yield tuple(
            near_end(domain, (share < 0.5) is opposite, ENDS[at % len(ENDS)] * (1 + share))
            for at, (share, domain) in enumerate(zip(shares, ranges, strict=True))
        )


def _ends(inside: list[Point], ranges: Sequence[Domain]) -> Iterator[Point]:
    """Move each symbol in turn near both ends of its range: a bracket may open only there."""
    for at, domain in enumerate(ranges):
        for high in (False, True):
            point = inside[-1 - at % INSIDE] if high else inside[at % INSIDE]
            distance = ENDS[(2 * at + high) % len(ENDS)] * (1 + (point[at] - domain.low) / (domain.high - domain.low))
            yield (*point[:at], near_end(domain, high, distance), *point[at + 1 :])


def near_end(domain: Domain, high: bool, distance: float) -> float:
    """Give the value near an end of a domain, a share of its width inside; the end itself of whole numbers."""
    step = 0.0 if domain.integer else (domain.high - domain.low) * distance
    return domain.high - step if high else domain.low + step
