"""Planar open chains of any word over R (revolute) and P (prismatic), in closed form (domain VP-6, VP-7, VP-8).

The base is the origin; the running direction starts along +X. A joint R turns the running direction and is followed by
its fixed link along it; a joint P adds a slide along the running direction turned by delta. Angles counter-clockwise.
A slide on a link that turns gives the Coriolis acceleration 2 L' w across it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import cos, hypot, sin
from typing import Literal, NamedTuple, get_args

from mechanics.checks import finite
from mechanics.linkage import LinkageMotion, Singular

Angles = Literal["relative", "absolute"]

DEAD_NAME = "the joints move the tip along one line only"


class Segment(NamedTuple):
    """A vector of the chain: its length, its direction, and the first and second rates of both."""

    length: float  # m
    direction: float  # rad
    speed: float  # m/s
    omega: float  # rad/s
    acceleration: float  # m/s^2
    epsilon: float  # rad/s^2


def solve(
    type: str,
    q: Sequence[float],
    lengths: Sequence[float],
    qd: Sequence[float] | None = None,
    qdd: Sequence[float] | None = None,
    delta: float = 0.0,
    angles: Angles = "relative",
) -> LinkageMotion:
    """Solve position, velocity and acceleration of the tip.

    Args:
        type: The word of joints from the base, such as RPR.
        q: Joint variables in the order of the word, ``(n,)``, radians for R, metres for P.
        lengths: The fixed link behind each R, in order, in metres.
        qd: Rates of q; zeros by default.
        qdd: Second rates of q; zeros by default.
        delta: Direction of a slide from the running direction (of a base slide from +X), in radians.
        angles: Whether the angle of an R is measured from the running direction or from +X.

    Returns:
        ``p_x``, ``p_y`` of the tip and their rates. The measure is 2 s1 s2/(s1^2 + s2^2) of the Jacobian with turns
        counted in lengths of the whole chain: 1 where the tip moves as easily in every direction.

    Raises:
        ValueError: A letter is neither R nor P, a list has another length than the word, a value is not finite, or the
            kind of angles unknown.

    Source:
        Domain VP-8, general engine: r = sum L e(a), v = sum (L' e + L w n),
        a = sum ((L'' - L w^2) e + (L eps + 2 L' w) n).
    """
    zeros = (0.0,) * len(type)
    qd, qdd = zeros if qd is None else qd, zeros if qdd is None else qdd
    _check(type, q, lengths, qd, qdd, delta, angles)
    x = y = vx = vy = ax = ay = 0.0
    for length, direction, along_v, omega, slide_a, epsilon in segments(type, q, lengths, qd, qdd, delta, angles):
        c, s = cos(direction), sin(direction)
        across_v = length * omega
        along_a, across_a = slide_a - length * omega**2, length * epsilon + 2 * along_v * omega
        x, y = x + length * c, y + length * s
        vx, vy = vx + along_v * c - across_v * s, vy + along_v * s + across_v * c
        ax, ay = ax + along_a * c - across_a * s, ay + along_a * s + across_a * c
    singular = _isotropy(type, q, lengths, _columns(type, q, lengths, delta, angles))
    return LinkageMotion({"p_x": x, "p_y": y}, {"p_x": vx, "p_y": vy}, {"p_x": ax, "p_y": ay}, singular)


def segments(
    type: str,
    q: Sequence[float],
    lengths: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    delta: float = 0.0,
    angles: Angles = "relative",
) -> Iterator[Segment]:
    """Give the vector polygon of the chain from base to tip; arguments as for `solve`, all lists complete."""
    direction = omega = epsilon = 0.0
    links = iter(lengths)
    for joint, value, rate, second in zip(type, q, qd, qdd, strict=True):
        if joint == "P":
            yield Segment(value, direction + delta, rate, omega, second, epsilon)
            continue
        if angles == "relative":
            direction, omega, epsilon = direction + value, omega + rate, epsilon + second
        else:
            direction, omega, epsilon = value, rate, second
        yield Segment(next(links), direction, 0.0, omega, 0.0, epsilon)


def jacobian(
    type: str, q: Sequence[float], lengths: Sequence[float], delta: float = 0.0, angles: Angles = "relative"
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Give the derivatives of the tip's place by the joint variables, ``(2, n)``; arguments as for `solve`.

    Source:
        Domain VP-6: a turn moves the tip across the way from the joint to the tip, a slide along the slide. An absolute
        angle turns only the vectors up to the next joint R, which has its own.
    """
    zeros = (0.0,) * len(type)
    _check(type, q, lengths, zeros, zeros, delta, angles)
    columns = _columns(type, q, lengths, delta, angles)
    return tuple(x for x, _ in columns), tuple(y for _, y in columns)


def _columns(
    type: str, q: Sequence[float], lengths: Sequence[float], delta: float, angles: Angles
) -> list[tuple[float, float]]:
    zeros = (0.0,) * len(type)
    found: list[tuple[float, float]] = []
    reach_x = reach_y = 0.0  # what the next angle towards the base turns
    chain = zip(type, segments(type, q, lengths, zeros, zeros, delta, angles), strict=True)
    for joint, segment in reversed(list(chain)):
        c, s = cos(segment.direction), sin(segment.direction)
        reach_x, reach_y = reach_x + segment.length * c, reach_y + segment.length * s
        found.append((c, s) if joint == "P" else (-reach_y, reach_x))
        if joint == "R" and angles == "absolute":
            reach_x = reach_y = 0.0
    found.reverse()
    return found


def _isotropy(
    type: str, q: Sequence[float], lengths: Sequence[float], columns: Sequence[tuple[float, float]]
) -> Singular:
    """Compare the ellipse of tip velocities with a circle; det(J J^T) as the sum over all pairs (Cauchy-Binet)."""
    slides = (abs(value) for joint, value in zip(type, q, strict=True) if joint == "P")
    whole = sum(slides) + sum(abs(length) for length in lengths) or 1.0
    even = [(x, y) if joint == "P" else (x / whole, y / whole) for joint, (x, y) in zip(type, columns, strict=True)]
    trace = sum(x * x + y * y for x, y in even)
    crosses = [x1 * y2 - y1 * x2 for (x1, y1), (x2, y2) in combinations(even, 2)]
    return Singular(2 * hypot(*crosses) / trace if trace else 0.0, DEAD_NAME)


def _check(
    type: str,
    q: Sequence[float],
    lengths: Sequence[float],
    qd: Sequence[float],
    qdd: Sequence[float],
    delta: float,
    angles: str,
) -> None:
    if not type or set(type) - {"R", "P"}:
        raise ValueError(f"type {type!r} must be a word over R and P, such as RPR")
    for name, values, count in (("q", q, len(type)), ("qd", qd, len(type)), ("qdd", qdd, len(type))):
        if len(values) != count:
            raise ValueError(f"{name} has {len(values)} values for the {count} joints of {type}")
        for place, value in enumerate(values, 1):
            finite(f"{name} {place}", value, "")
    if len(lengths) != type.count("R"):
        raise ValueError(f"lengths has {len(lengths)} values for the {type.count('R')} joints R of {type}")
    for place, value in enumerate(lengths, 1):
        finite(f"lengths {place}", value, "m")
    finite("delta", delta, "rad")
    if angles not in get_args(Angles):
        raise ValueError(f"angles must be {' or '.join(get_args(Angles))}, not {angles!r}")
