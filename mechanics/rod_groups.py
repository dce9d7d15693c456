"""The six rod functional groups: three joints that carry a point M (domain DH-11 to DH-16, DH-21 to DH-26).

Standard Denavit-Hartenberg frames, angles in radians, lengths in metres; q = (q1, q2, q3) in the order of the pairs,
M = (x, y, z) in base axes. Direct and inverse task use the printed point formulas, not matrices.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin, sqrt

from mechanics.checks import finite, positive
from mechanics.dh import Row
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import principal
from mechanics.vectors import Vector

Lengths = Mapping[str, float]
Slopes = tuple[Vector, Vector, Vector]
Solutions = tuple[Vector, ...]

REACH = 1e-12  # a gap below this part of the reach is rounding, not distance
ROUNDING = 4e-15
HALF, ELBOWS = pi / 2, (1.0, -1.0)


@dataclass(frozen=True, slots=True)
class Group:
    """One group: its lengths by name, its table and point M in the last frame, and both tasks."""

    id: str
    lengths: tuple[str, ...]
    table: Callable[[Lengths], tuple[tuple[Row, ...], Vector]]
    direct: Callable[[Lengths, Sequence[float]], Vector]
    partials: Callable[[Lengths, Sequence[float]], Slopes]
    determinant: Callable[[Lengths, Sequence[float]], float]
    inverse: Callable[[Lengths, Vector], list[Vector]]


def table(group: str, lengths: Lengths) -> tuple[tuple[Row, ...], Vector]:
    """Give the Denavit-Hartenberg rows of a group and the point M in its last frame (m).

    Args:
        group: Word over R and P: PPP, RPP, RRP, PRR, RRR or PRP.
        lengths: Lengths of the group by name (`d`, or `L1`, `L2`, `L3`), in metres.

    Raises:
        ValueError: Unknown group, a length missing, unknown, or not fit.
    """
    return _checked(group, lengths).table(lengths)


def direct(group: str, lengths: Lengths, q: Sequence[float]) -> Vector:
    """Find the point M of a group.

    Args:
        group: Word over R and P, as for `table`.
        lengths: Lengths of the group by name, in metres.
        q: Joint variables, ``(3,)``, radians or metres.

    Returns:
        M in base axes, in metres.

    Raises:
        ValueError: Unknown group, lengths or number of variables, or a value not finite.

    Source:
        Domain DH-11 to DH-16, last column.
    """
    found = _checked(group, lengths)
    _check_three("q", q)
    return found.direct(lengths, q)


def determinant(group: str, lengths: Lengths, q: Sequence[float]) -> float:
    """Find det dM/dq, zero in a singular position; arguments and errors as for `direct`."""
    found = _checked(group, lengths)
    _check_three("q", q)
    return found.determinant(lengths, q)


def partials(group: str, lengths: Lengths, q: Sequence[float]) -> Slopes:
    """Find dM/dq1, dM/dq2, dM/dq3, in m/rad or 1; arguments and errors as for `direct`."""
    found = _checked(group, lengths)
    _check_three("q", q)
    return found.partials(lengths, q)


def inverse(group: str, lengths: Lengths, M: Vector) -> Solutions:
    """Find all joint variables that carry M to a point (inverse kinematics).

    Args:
        group: Word over R and P, as for `table`.
        lengths: Lengths of the group by name, in metres.
        M: The point in base axes, ``(3,)``, in metres.

    Returns:
        Every solution (q1, q2, q3), angles in (-pi, pi]; branches that coincide are given once.

    Raises:
        ValueError: Unknown group, lengths or number of coordinates, or a value not finite.
        AssemblyError: The point is out of reach; the message has the gap.
        SingularError: An angle is arbitrary, so that there is no end of solutions.

    Source:
        Domain DH-21 to DH-26; the elbow angle by half-angles, which keeps its digits near the stretched arm.
    """
    found = _checked(group, lengths)
    _check_three("M", M)
    solutions: list[Vector] = []
    for q in found.inverse(lengths, M):
        if not any(max(abs(a - b) for a, b in zip(q, other, strict=True)) < REACH for other in solutions):
            solutions.append(q)
    return tuple(solutions)


def _checked(group: str, lengths: Lengths) -> Group:
    found = GROUPS.get(group)
    if found is None:
        raise ValueError(f"group {group!r} must be one of {', '.join(GROUPS)}")
    if set(lengths) != set(found.lengths):
        raise ValueError(
            f"group {group} has the lengths {', '.join(found.lengths)}, not {', '.join(lengths) or 'none'}"
        )
    for name, value in lengths.items():
        finite(name, value, "m")
        if name in ("L2", "L3"):
            positive(name, value, "m")
    return found


def _check_three(name: str, values: Sequence[float]) -> None:
    if len(values) != 3:
        raise ValueError(f"{name} must have 3 values, not {len(values)}")
    for value in values:
        finite(name, value, "(m or rad)")


def _angle(y: float, x: float, size: float, joint: str) -> float:
    """atan2, refused where both sides vanish against a size: the angle is then free."""
    if hypot(x, y) <= REACH * size:
        raise SingularError(f"joint {joint} is arbitrary: M lies on its axis")
    return principal(atan2(y, x))


def _elbow(along: float, across: float, l2: float, l3: float, sign: float) -> tuple[float, float]:
    """th2 from the direction `along` and th3 of a two-link arm, th2 - th3 the direction of its second link.

    DH-24, DH-25: cos th3 = (r^2 - L2^2 - L3^2)/(2 L2 L3); th2 = direction + atan2(L3 sin th3, L2 + L3 cos th3).
    """
    r = hypot(along, across)
    reach, least = l2 + l3, abs(l2 - l3)
    gap = max(r - reach, least - r)
    if gap > REACH * reach:
        raise AssemblyError(f"links {l2:g} m and {l3:g} m cannot reach the point at {r:g} m: {gap:.4g} m are missing")
    th3 = sign * 2 * atan2(_root(reach, r), _root(r, least))
    direction = _angle(across, along, reach, "2")
    return principal(direction + atan2(l3 * sin(th3), l2 + l3 * cos(th3))), principal(th3)


def _root(larger: float, smaller: float) -> float:
    """sqrt(larger^2 - smaller^2), zero where rounding alone parts them: else one branch would count as two."""
    difference = larger - smaller
    return sqrt(difference) * sqrt(larger + smaller) if difference > ROUNDING * larger else 0.0


def _ppp_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    rows = Row("P", HALF, 0, 0, HALF), Row("P", -HALF, 0, 0, -HALF), Row("P")
    return rows, (n["d"], 0.0, 0.0)


def _ppp_direct(n: Lengths, q: Sequence[float]) -> Vector:
    return q[1], q[2], q[0] - n["d"]


def _ppp_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    return (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def _ppp_inverse(n: Lengths, M: Vector) -> list[Vector]:
    return [(M[2] + n["d"], M[0], M[1])]


def _rpp_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    return (Row("R"), Row("P", pi, 0, 0, HALF), Row("P")), (0.0, n["d"], 0.0)


def _rpp_direct(n: Lengths, q: Sequence[float]) -> Vector:
    return -q[2] * sin(q[0]), q[2] * cos(q[0]), q[1] + n["d"]


def _rpp_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    c1, s1 = cos(q[0]), sin(q[0])
    return (-q[2] * c1, -q[2] * s1, 0.0), (0.0, 0.0, 1.0), (-s1, c1, 0.0)


def _rpp_inverse(n: Lengths, M: Vector) -> list[Vector]:
    x, y, z = M
    size = max(map(abs, M))
    return [(_angle(-x, y, size, "1"), z - n["d"], hypot(x, y))]


def _rrp_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    rows = Row("R", 0, n["L1"], 0, HALF), Row("R", 0, 0, 0, HALF), Row("P", 0, 0, 0, HALF)
    return rows, (0.0, 0.0, n["d"])


def _rrp_direct(n: Lengths, q: Sequence[float]) -> Vector:
    c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
    d = n["d"]
    return q[2] * s2 * c1 - d * s1, q[2] * s2 * s1 + d * c1, n["L1"] - q[2] * c2


def _rrp_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
    x, y, _ = _rrp_direct(n, q)
    return (-y, x, 0.0), (q[2] * c2 * c1, q[2] * c2 * s1, q[2] * s2), (s2 * c1, s2 * s1, -c2)


def _rrp_inverse(n: Lengths, M: Vector) -> list[Vector]:
    (x, y, z), d = M, n["d"]
    r, below = hypot(x, y), n["L1"] - z
    if abs(d) - r > REACH * abs(d):
        raise AssemblyError(f"M at {r:g} m from the axis of joint 1 cannot be reached: {abs(d) - r:.4g} m are missing")
    side = _root(r, abs(d))
    size = max(abs(d), r, abs(n["L1"]), abs(z))
    solutions = []
    for rho in (side, -side) if side else (0.0,):
        th1 = _angle(rho * y - d * x, rho * x + d * y, r * size, "1")
        solutions.append((th1, _angle(rho, below, size, "2"), hypot(rho, below)))
    return solutions


def _prr_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    rows = Row("P", HALF, 0, n["L1"]), Row("R", 0, 0, n["L2"], sign=-1), Row("R")
    return rows, (n["L3"], 0.0, 0.0)


def _prr_direct(n: Lengths, q: Sequence[float]) -> Vector:
    psi = q[1] - q[2]
    return n["L3"] * sin(psi) + n["L2"] * sin(q[1]), n["L3"] * cos(psi) + n["L2"] * cos(q[1]) + n["L1"], q[0]


def _prr_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    psi = q[1] - q[2]
    dx, dy = n["L3"] * cos(psi), -n["L3"] * sin(psi)
    return (0.0, 0.0, 1.0), (dx + n["L2"] * cos(q[1]), dy - n["L2"] * sin(q[1]), 0.0), (-dx, -dy, 0.0)


def _prr_inverse(n: Lengths, M: Vector) -> list[Vector]:
    x, y, z = M
    return [(z, *_elbow(y - n["L1"], x, n["L2"], n["L3"], sign)) for sign in ELBOWS]


def _rrr_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    rows = Row("R", 0, n["L1"], 0, HALF), Row("R", 0, 0, n["L2"]), Row("R", sign=-1)
    return rows, (n["L3"], 0.0, 0.0)


def _rrr_direct(n: Lengths, q: Sequence[float]) -> Vector:
    psi = q[1] - q[2]
    rho = n["L3"] * cos(psi) + n["L2"] * cos(q[1])
    return cos(q[0]) * rho, sin(q[0]) * rho, n["L3"] * sin(psi) + n["L2"] * sin(q[1]) + n["L1"]


def _rrr_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    psi, c1, s1 = q[1] - q[2], cos(q[0]), sin(q[0])
    x, y, z = _rrr_direct(n, q)
    up, across = n["L3"] * sin(psi), n["L3"] * cos(psi)
    rise = z - n["L1"]
    return (-y, x, 0.0), (-c1 * rise, -s1 * rise, across + n["L2"] * cos(q[1])), (c1 * up, s1 * up, -across)


def _rrr_inverse(n: Lengths, M: Vector) -> list[Vector]:
    x, y, z = M
    reach, above = n["L2"] + n["L3"], z - n["L1"]
    solutions = []
    for face in (1.0, -1.0):
        elbows = [_elbow(face * hypot(x, y), above, n["L2"], n["L3"], sign) for sign in ELBOWS]
        th1 = _angle(face * y, face * x, reach, "1")
        solutions += [(th1, *elbow) for elbow in elbows]
    return solutions


def _rrr_determinant(n: Lengths, q: Sequence[float]) -> float:
    rho = n["L3"] * cos(q[1] - q[2]) + n["L2"] * cos(q[1])
    return -n["L2"] * n["L3"] * rho * sin(q[2])


def _prp_table(n: Lengths) -> tuple[tuple[Row, ...], Vector]:
    return (Row("P"), Row("R", 0, 0, 0, -HALF), Row("P")), (0.0, -n["d"], 0.0)


def _prp_direct(n: Lengths, q: Sequence[float]) -> Vector:
    return -q[2] * sin(q[1]), q[2] * cos(q[1]), q[0] + n["d"]


def _prp_partials(n: Lengths, q: Sequence[float]) -> Slopes:
    c2, s2 = cos(q[1]), sin(q[1])
    return (0.0, 0.0, 1.0), (-q[2] * c2, -q[2] * s2, 0.0), (-s2, c2, 0.0)


def _prp_inverse(n: Lengths, M: Vector) -> list[Vector]:
    x, y, z = M
    return [(z - n["d"], _angle(-x, y, max(map(abs, M)), "2"), hypot(x, y))]


GROUPS: Mapping[str, Group] = {
    "PPP": Group("DH-11", ("d",), _ppp_table, _ppp_direct, _ppp_partials, lambda n, q: 1.0, _ppp_inverse),
    "RPP": Group("DH-12", ("d",), _rpp_table, _rpp_direct, _rpp_partials, lambda n, q: q[2], _rpp_inverse),
    "RRP": Group(
        "DH-13", ("d", "L1"), _rrp_table, _rrp_direct, _rrp_partials, lambda n, q: q[2] ** 2 * sin(q[1]), _rrp_inverse
    ),
    "PRR": Group(
        "DH-14",
        ("L1", "L2", "L3"),
        _prr_table,
        _prr_direct,
        _prr_partials,
        lambda n, q: -n["L2"] * n["L3"] * sin(q[2]),
        _prr_inverse,
    ),
    "RRR": Group("DH-15", ("L1", "L2", "L3"), _rrr_table, _rrr_direct, _rrr_partials, _rrr_determinant, _rrr_inverse),
    "PRP": Group("DH-16", ("d",), _prp_table, _prp_direct, _prp_partials, lambda n, q: -q[2], _prp_inverse),
}
