"""J. J. Craig, Introduction to Robotics: Mechanics and Control, 3rd edition, Pearson 2005, section 6.7, eq. (6.58).

Planar arm of two links with point masses at their far ends, gravity against Y of the base.
"""

from __future__ import annotations

from math import cos, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import link_frames, newton_euler
from mechanics.chain import Chain
from mechanics.dh import Row
from mechanics.links import LinkMass
from mechanics.vectors import Vector
from tests.depth import amount
from tests.mechanics.chains import diagonal

POINT = diagonal(0, 0, 0)
angles = st.tuples(st.floats(-4, 4), st.floats(-4, 4))
sizes = st.floats(0.1, 2)


def published(
    l: tuple[float, float], m: tuple[float, float], q: tuple[float, ...], w: tuple[float, ...], e: tuple[float, ...]
) -> list[float]:
    (l1, l2), (m1, m2), (c1, c2, s2, c12) = l, m, (cos(q[0]), cos(q[1]), sin(q[1]), cos(q[0] + q[1]))
    g = 9.81
    first = (
        m2 * l2**2 * (e[0] + e[1])
        + m2 * l1 * l2 * c2 * (2 * e[0] + e[1])
        + (m1 + m2) * l1**2 * e[0]
        - m2 * l1 * l2 * s2 * w[1] ** 2
        - 2 * m2 * l1 * l2 * s2 * w[0] * w[1]
        + m2 * l2 * g * c12
        + (m1 + m2) * l1 * g * c1
    )
    second = m2 * l1 * l2 * c2 * e[0] + m2 * l1 * l2 * s2 * w[0] ** 2 + m2 * l2 * g * c12 + m2 * l2**2 * (e[0] + e[1])
    return [first, second]


@settings(max_examples=amount(8, 25), deadline=None)
@given(st.tuples(sizes, sizes), st.tuples(sizes, sizes), angles, angles, angles)
def test_both_conventions_give_the_published_torques(
    l: tuple[float, float],
    m: tuple[float, float],
    q: tuple[float, float],
    w: tuple[float, float],
    e: tuple[float, float],
) -> None:
    down: Vector = (0.0, -9.81, 0.0)
    proximal = Chain((Row("R"), Row("R", a=l[0])), "modified")
    distal = Chain((Row("R", a=l[0]), Row("R", a=l[1])))
    ends = [LinkMass(mass, (length, 0.0, 0.0), POINT) for mass, length in zip(m, l, strict=True)]
    origins = [LinkMass(mass, (0.0, 0.0, 0.0), POINT) for mass in m]
    expected = pytest.approx(published(l, m, q, w, e), rel=1e-9, abs=1e-9)
    assert newton_euler.solve(proximal, ends, q, w, e, down).tau == expected
    assert newton_euler.solve(distal, origins, q, w, e, down).tau == expected
    assert link_frames.drives(distal.rows, origins, q, w, e, down).tau == expected
