"""Plans of velocities and accelerations: vectors of the points of a mechanism from one pole (domain VM-4).

The figure of a link in the plan is similar to the link: for velocities turned by 90 degrees in the sense of omega.
Metres, m/s, m/s^2. A scale mu is the value of one drawn metre: a drawn length is the vector over mu.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from math import hypot

from mechanics import acceleration, velocity
from mechanics.checks import positive
from mechanics.drawing import Drawing, Line, Point, arrow, check


@dataclass(frozen=True, slots=True)
class Plan:
    """Absolute vectors of named points, all from the pole at the origin."""

    vectors: Mapping[str, Point]  # m/s or m/s^2

    def relative(self, of: str, to: str) -> Point:
        """Give the vector of one point relative to another: from the end of the second to the end of the first."""
        (x, y), (from_x, from_y) = self.vectors[of], self.vectors[to]
        return x - from_x, y - from_y

    def drawn(self, of: str, to: str, mu: float) -> float:
        """Give the drawn length between the ends of two vectors, in metres.

        Raises:
            ValueError: The scale is not positive and finite.
        """
        positive("scale mu", mu, "")
        return hypot(*self.relative(of, to)) / mu

    def drawing(self, mu: float, symbol: str = "v") -> Drawing:
        """Draw all vectors from the pole O, and the sides of the figure of their ends in small letters.

        Args:
            mu: The value of one drawn metre, positive.
            symbol: Letter of the vectors.

        Raises:
            ValueError: The scale is not positive and finite.
        """
        positive("scale mu", mu, "")
        arrows = tuple(arrow(f"{symbol}_{name}", (0.0, 0.0), vector, 1 / mu) for name, vector in self.vectors.items())
        ends = {name.lower(): one.head for name, one in zip(self.vectors, arrows, strict=True)}
        sides = tuple(Line(f"{a}{b}", ends[a], ends[b]) for a, b in combinations(ends, 2))
        return Drawing({"O": (0.0, 0.0), **ends}, arrows, sides)


def of_link(points: Mapping[str, Point], first: str, second: str, known: tuple[Point, Point]) -> Plan:
    """Make the plan of velocities of one link from the velocities of two of its points.

    Args:
        points: Points of the link by name, in metres.
        first: A point whose velocity is known.
        second: Another.
        known: Their velocities, in m/s.

    Raises:
        ValueError: A name is unknown, a value not finite, the two points coincide, or the velocities would stretch
            the link.

    Source:
        Domain VM-4, in complex numbers: v_C = v_A + (C - A)/(B - A) (v_B - v_A).
    """
    for name in (first, second):
        if name not in points:
            raise ValueError(f"the link has no point {name!r}; it has {', '.join(points)}")
    check("m", **points)
    velocity.angular_velocity(points[first], points[second], *known)
    v_A, v_B = (complex(*one) for one in known)
    found: dict[str, Point] = {}
    for name, point in points.items():
        v = v_A + similarity(points[first], points[second], point) * (v_B - v_A)
        found[name] = (v.real, v.imag)
    return Plan(found)


def of_accelerations(points: Mapping[str, Point], first: str, a_first: Point, omega: float, epsilon: float) -> Plan:
    """Make the plan of accelerations of one link from one of its points and its rotation.

    Args:
        points: Points of the link by name, in metres.
        first: The point whose acceleration is known.
        a_first: Its acceleration, in m/s^2.
        omega: Angular velocity of the link, in rad/s.
        epsilon: Angular acceleration of the link, in rad/s^2.

    Raises:
        ValueError: The name is unknown, or a value not finite.

    Source:
        Domain VM-5: the figure of the ends is the link, enlarged by sqrt(epsilon^2 + omega^4) and turned by
        180 degrees - mu.
    """
    if first not in points:
        raise ValueError(f"the link has no point {first!r}; it has {', '.join(points)}")
    check("m", **points)
    made = (acceleration.decompose(points[first], point, a_first, omega, epsilon) for point in points.values())
    return Plan({name: one.a_B for name, one in zip(points, made, strict=True)})


def joined(*plans: Plan) -> Plan:
    """Join the plans of the links of a mechanism at their common pole.

    Raises:
        ValueError: A point that links share moves differently in them.
    """
    found: dict[str, Point] = {}
    for plan in plans:
        for name, vector in plan.vectors.items():
            known = found.setdefault(name, vector)
            if hypot(known[0] - vector[0], known[1] - vector[1]) > velocity.RIGID * (hypot(*known) + hypot(*vector)):
                raise ValueError(f"point {name} moves by {known} in one link and by {vector} in another")
    return Plan(found)


def similarity(A: Point, B: Point, C: Point) -> complex:
    """Give (C - A)/(B - A), the shape of the triangle ABC.

    Raises:
        ValueError: A and B coincide.
    """
    base = complex(*B) - complex(*A)
    if not base:
        raise ValueError(f"A and B = {A} m are one point: they give no figure")
    return (complex(*C) - complex(*A)) / base
