"""The stiffness method for beams and shafts: the independent second way beside `beam` and `shaft`
(domain SM-7, SM-11).

Displacements of nodes are the unknowns, K u = f, and element forces follow from them. Nothing of the formulas of
`beam`, `shaft` or the section moduli is used: sections enter by integrals over the fibres. Signs as there: x from the
left end, v, F and w positive up, rotations and couples counter-clockwise, V = sum of the upward forces left of x,
M > 0 sags, EI v'' = M; torques about +x, T = sum of the torques right of the section. At a node the value is the one
to its left, at x = 0 the one inside.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import cos, fsum, pi, sin, sqrt

from mechanics.checks import place
from mechanics.composed import Block, Part
from mechanics.members import Beam, Distributed, Force, Moment, Reaction
from mechanics.section import Circle, Rectangle, Ring
from mechanics.stiffness import settle
from mechanics.torsion_frame import FrameShaft, polar_moment, solve_shaft

__all__ = ["Element", "FrameBeam", "FrameShaft", "Node", "solve_beam", "solve_shaft"]

# Places closer than this part of the length are one node: an element between them would be all rounding.
_CLOSE = 1e-9


@dataclass(frozen=True, slots=True)
class Node:
    """The displacement of a node; at a hinge the two rotations differ."""

    x: float  # place, m
    v: float  # deflection, up, m
    theta_left: float  # rotation on its left, rad
    theta_right: float  # rotation on its right, rad


@dataclass(frozen=True, slots=True)
class Element:
    """A loaded beam element after solution; end forces act on it from its nodes."""

    x1: float  # start, m
    x2: float  # end, m
    w1: float  # load at the start, up, N/m
    w2: float  # load at the end, up, N/m
    ends: tuple[float, float, float, float]  # v1, theta1, v2, theta2: m, rad
    forces: tuple[float, float, float, float]  # F1 (N), M1 (N m), F2, M2: up, counter-clockwise

    def shear(self, x: float) -> float:
        """Return V (N) from the equilibrium of the part left of x."""
        t, s = x - self.x1, (x - self.x1) / (self.x2 - self.x1)
        return self.forces[0] + t * ((2 - s) * self.w1 + s * self.w2) / 2

    def moment(self, x: float) -> float:
        """Return M (N m) from the equilibrium of the part left of x."""
        t, s = x - self.x1, (x - self.x1) / (self.x2 - self.x1)
        return self.forces[0] * t - self.forces[1] + t * t * ((3 - s) * self.w1 + s * self.w2) / 6

    def shear_zeros(self) -> list[float]:
        """Return the places inside where V = 0, from the quadratic formula without cancellation."""
        h = self.x2 - self.x1
        a, b, c = (self.w2 - self.w1) * h / 2, self.w1 * h, self.forces[0]
        root = sqrt(max(b * b - 4 * a * c, 0.0))
        q = -(b + (root if b >= 0 else -root)) / 2
        fractions = [top / bottom for top, bottom in ((q, a), (c, q)) if abs(top) < abs(bottom)]
        return sorted(self.x1 + s * h for s in fractions if s > 0)

    def slope_polynomial(self, stiffness: float) -> list[float]:
        """Return theta by powers of s = (x - x1)/(x2 - x1): derivative of the Hermite cubic and clamped-load terms."""
        h = self.x2 - self.x1
        v1, o1, v2, o2 = self.ends
        rise, pull, grow = (v2 - v1) / h, self.w1 * h**3 / 24 / stiffness, (self.w2 - self.w1) * h**3 / 120 / stiffness
        return [
            o1,
            6 * rise - 4 * o1 - 2 * o2 + 2 * pull + 4 * grow,
            -6 * rise + 3 * o1 + 3 * o2 - 6 * pull - 9 * grow,
            4 * pull,
            5 * grow,
        ]

    def deflection(self, x: float, stiffness: float) -> float:
        """Return v (m): Hermite interpolation of the nodes plus the clamped element under its own load."""
        h = self.x2 - self.x1
        s = (x - self.x1) / h
        v1, o1, v2, o2 = self.ends
        hermite = (1 + 2 * s) * (1 - s) ** 2 * v1 + s * (1 - s) ** 2 * h * o1
        hermite += (3 - 2 * s) * s**2 * v2 - (1 - s) * s**2 * h * o2
        clamped = s**2 * (1 - s) ** 2 * h**4 * (5 * self.w1 + (self.w2 - self.w1) * (s + 2)) / 120 / stiffness
        return hermite + clamped


@dataclass(frozen=True, slots=True)
class FrameBeam:
    """A beam solved by the stiffness method."""

    nodes: tuple[Node, ...]
    elements: tuple[Element, ...]
    reactions: tuple[Reaction, ...]  # by rising x
    second_moment: float  # I, m^4
    stiffness: float  # E I, N m^2

    def element(self, x: float) -> Element:
        """Return the element that holds x (m), at a node the one to its left."""
        place("sample", x, self.elements[-1].x2)
        return self.elements[bisect_left(self.elements, x, key=lambda element: element.x2)]

    def shear(self, x: float) -> float:
        """Return V (N) at x (m)."""
        return self.element(x).shear(x)

    def moment(self, x: float) -> float:
        """Return M (N m) at x (m)."""
        return self.element(x).moment(x)

    def deflection(self, x: float) -> float:
        """Return v (m) at x (m)."""
        return self.element(x).deflection(x, self.stiffness)

    def slope(self, x: float) -> float:
        """Return theta (rad) at x (m)."""
        element = self.element(x)
        s = (x - element.x1) / (element.x2 - element.x1)
        return sum(c * s**power for power, c in enumerate(element.slope_polynomial(self.stiffness)))

    def normal_stress(self, x: float, y: float) -> float:
        """Return the bending stress (Pa) at x, y (m, up from the neutral axis), tension positive."""
        return -self.moment(x) * y / self.second_moment

    def extreme_shear(self) -> tuple[float, float]:
        """Return the place (m) and the signed value (N) of the largest |V|."""
        found = []
        for element in self.elements:
            places = [element.x1, element.x2]
            if (element.w1 < 0) != (element.w2 < 0):
                places.insert(1, element.x1 + (element.x2 - element.x1) * element.w1 / (element.w1 - element.w2))
            found += [(x, element.shear(x)) for x in places]
        return _farthest(found)

    def moments(self) -> list[tuple[float, float]]:
        """Return all places (m) where M may be extreme, with M (N m) there: element ends and zeros of V."""
        return [
            (x, element.moment(x))
            for element in self.elements
            for x in (element.x1, *element.shear_zeros(), element.x2)
        ]

    def extreme_moment(self) -> tuple[float, float]:
        """Return the place (m) and the signed value (N m) of the largest |M|, the leftmost on a tie."""
        return _farthest(self.moments())

    def extreme_deflection(self) -> tuple[float, float]:
        """Return the place (m) and the signed value (m) of the largest |v|, the leftmost on a tie."""
        import numpy as np

        found = []
        for element in self.elements:
            h = element.x2 - element.x1
            slope = np.array(element.slope_polynomial(self.stiffness)[::-1])
            # A leading coefficient lost beside the others moves no root inside, but overflows the far one.
            roots = np.roots(np.where(abs(slope) > 1e-15 * abs(slope).max(), slope, 0.0))
            inside = [element.x1 + h * float(s.real) for s in roots if abs(s.imag) < 1e-6 and 0 < s.real < 1]
            places = (element.x1, *sorted(inside), element.x2)
            found += [(x, element.deflection(x, self.stiffness)) for x in places]
        return _farthest(found)


def _farthest(found: Sequence[tuple[float, float]]) -> tuple[float, float]:
    largest = max(abs(value) for _, value in found)
    return next((x, value) for x, value in found if abs(value) >= largest * (1 - 1e-9))


def solve_beam(beam: Beam) -> FrameBeam:
    """Solve a beam by Euler-Bernoulli elements between supports, hinges and loads.

    Raises:
        UnstableError: The stiffness matrix is singular: the supports do not hold the beam.

    Source:
        Stiffness matrix and fixed-end forces of the prismatic element: Przemieniecki, Theory of Matrix Structural
        Analysis, McGraw-Hill 1968, chapters 5 and 10. Lengths are in parts of L, forces in EI/L^2, couples in EI/L.
    """
    second_moment = _second_moment(beam)
    stiffness, L = beam.E * second_moment, beam.L
    force, couple = stiffness / L / L, stiffness / L
    xs = _mesh(beam)
    codes = _codes(beam, xs)
    spreads = [(left, right, *_spread(beam, left, right)) for left, right in pairwise(xs)]
    matrices = [_matrix((right - left) / L) for left, right in pairwise(xs)]
    loads = _nodal_loads(beam, xs, codes)
    scaled = [load / (couple if number in _turns(codes) else force) for number, load in enumerate(loads)]
    held = [(support, _nearest(xs, support.x)) for support in sorted(beam.supports, key=lambda support: support.x)]
    given = {2 * i: support.settlement / L for support, i in held}
    given |= {2 * i + 1: 0.0 for support, i in held if support.type == "fixed"}
    u, surplus = settle(len(loads), zip(codes, matrices, strict=True), scaled, given)
    elements = tuple(
        _element(spread, matrix, [u[number] for number in code], beam.L, stiffness)
        for spread, matrix, code in zip(spreads, matrices, codes, strict=True)
    )
    reactions = tuple(
        Reaction(support.x, surplus[2 * i] * force, surplus[2 * i + 1] * couple if 2 * i + 1 in given else 0.0)
        for support, i in held
    )
    return FrameBeam(_displaced(xs, codes, u, L), elements, reactions, second_moment, stiffness)


def _mesh(beam: Beam) -> list[float]:
    """Nodes: supports first, then hinges, ends and loads that are not already beside a node."""
    wanted = [*(support.x for support in beam.supports), *beam.hinges, 0.0, beam.L]
    for load in beam.loads:
        wanted += [load.x1, load.x2] if isinstance(load, Distributed) else [load.x]
    found: list[float] = []
    for x in wanted:
        if all(abs(x - known) > _CLOSE * beam.L for known in found):
            found.append(x)
    return sorted(found)


def _nearest(xs: Sequence[float], x: float) -> int:
    return min(range(len(xs)), key=lambda i: abs(xs[i] - x))


def _codes(beam: Beam, xs: Sequence[float]) -> list[tuple[int, int, int, int]]:
    """Number the displacements: 2i deflection of node i, 2i + 1 its rotation; right of a hinge a new rotation."""
    hinges = sorted(_nearest(xs, x) for x in beam.hinges)
    right = {i: 2 * len(xs) + extra for extra, i in enumerate(hinges)}
    return [(2 * i, right.get(i, 2 * i + 1), 2 * i + 2, 2 * i + 3) for i in range(len(xs) - 1)]


def _turns(codes: Sequence[tuple[int, int, int, int]]) -> set[int]:
    return {number for code in codes for number in (code[1], code[3])}


def _spread(beam: Beam, left: float, right: float) -> tuple[float, float]:
    """Sum of the distributed loads at the two ends of an element."""
    w1 = w2 = 0.0
    for load in beam.loads:
        if isinstance(load, Distributed) and load.x1 < (left + right) / 2 < load.x2:
            share, other = ((x - load.x1) / (load.x2 - load.x1) for x in (left, right))
            w1 += (1 - share) * load.w1 + share * load.w2
            w2 += (1 - other) * load.w1 + other * load.w2
    return w1, w2


def _matrix(h: float) -> tuple[tuple[float, ...], ...]:
    """Stiffness of an element of length h for v1, theta1, v2, theta2, with EI = 1."""
    a, b, c, d = 12 / h**3, 6 / h**2, 4 / h, 2 / h
    return ((a, b, -a, b), (b, c, -b, d), (-a, -b, a, -b), (b, d, -b, c))


def _clamped(h: float, w1: float, w2: float) -> tuple[float, float, float, float]:
    """Forces from the clamps of an element under a linear load."""
    return (
        -h * (7 * w1 + 3 * w2) / 20,
        -h * h * (3 * w1 + 2 * w2) / 60,
        -h * (3 * w1 + 7 * w2) / 20,
        h * h * (2 * w1 + 3 * w2) / 60,
    )


def _nodal_loads(beam: Beam, xs: Sequence[float], codes: Sequence[tuple[int, int, int, int]]) -> list[float]:
    found = [0.0] * (2 * len(xs) + len(beam.hinges))
    for load in beam.loads:
        if isinstance(load, Force):
            found[2 * _nearest(xs, load.x)] += load.F
        elif isinstance(load, Moment):
            found[2 * _nearest(xs, load.x) + 1] += load.M
    for code, (left, right) in zip(codes, pairwise(xs), strict=True):
        for number, force in zip(code, _clamped(right - left, *_spread(beam, left, right)), strict=True):
            found[number] -= force
    return found


def _element(
    spread: tuple[float, float, float, float],
    matrix: Sequence[Sequence[float]],
    u: Sequence[float],
    L: float,
    stiffness: float,
) -> Element:
    x1, x2, w1, w2 = spread
    units = (stiffness / L / L, stiffness / L, stiffness / L / L, stiffness / L)
    forces = [
        unit * sum(k * displacement for k, displacement in zip(row, u, strict=True)) + clamp
        for unit, row, clamp in zip(units, matrix, _clamped(x2 - x1, w1, w2), strict=True)
    ]
    v1, theta1, v2, theta2 = u
    F1, M1, F2, M2 = forces
    return Element(x1, x2, w1, w2, (v1 * L, theta1, v2 * L, theta2), (F1, M1, F2, M2))


def _displaced(
    xs: Sequence[float], codes: Sequence[tuple[int, int, int, int]], u: Sequence[float], L: float
) -> tuple[Node, ...]:
    rights = [code[1] for code in codes] + [2 * len(xs) - 1]
    return tuple(Node(x, u[2 * i] * L, u[2 * i + 1], u[rights[i]]) for i, x in enumerate(xs))


def _second_moment(beam: Beam) -> float:
    """I as given, or by fibres: the rectangle's y^2 b by Simpson's rule, exact here; round ones from the rings."""
    section = beam.section
    if section is None:
        return beam.I or 0.0
    if isinstance(section, Rectangle):
        top = section.h / 2
        return 2 * section.b * top / 6 * (4 * (top / 2) ** 2 + top**2)
    if isinstance(section, Ring):
        return polar_moment(section.D, section.d) / 2
    if isinstance(section, Circle):
        return polar_moment(section.d, 0.0) / 2
    fibres = [fibre for part in section.parts for fibre in _fibres(part)]
    level = fsum(y * A for y, A in fibres) / fsum(A for _, A in fibres)
    return fsum((y - level) ** 2 * A for y, A in fibres)


def _fibres(part: Part) -> Iterator[tuple[float, float]]:
    """Heights (m) and areas (m^2) of a few fibres that integrate a square exactly: Gauss-Legendre for the rectangle,
    Gauss-Chebyshev of the second kind, whose weight is the chord, for the disc."""
    if isinstance(part, Block):
        shares = [(side / 3**0.5, 2 * part.b * part.half / 2) for side in (-1, 1)]
    else:
        turns = [pi / 4, pi / 2, 3 * pi / 4]
        shares = [(cos(turn), 2 * part.half**2 * pi / 4 * sin(turn) ** 2) for turn in turns]
    for share, area in shares:
        yield part.y + share * part.half, -area if part.hole else area
