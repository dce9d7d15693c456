"""J. J. Craig, Introduction to Robotics: Mechanics and Control, 3rd edition, Pearson 2005, section 3.7, eq. (3.14).

Pose of the wrist of the PUMA 560, whose table is in the modified (proximal) convention; d3 and d4 stand in the row of
their joint, a2 and a3 in the next.
"""

from __future__ import annotations

from math import cos, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import chain, transform
from mechanics.chain import Chain
from mechanics.dh import Row
from tests.depth import amount

A2, A3, D3, D4 = 0.4318, 0.0203, 0.1244, 0.4318  # m
PUMA = (
    Row("R"),
    Row("R", alpha=-pi / 2),
    Row("R", a=A2, d=D3),
    Row("R", a=A3, d=D4, alpha=-pi / 2),
    Row("R", alpha=pi / 2),
    Row("R", alpha=-pi / 2),
)


def published(q: tuple[float, ...]) -> list[list[float]]:
    c1, c2, _, c4, c5, c6 = (cos(x) for x in q)
    s1, s2, _, s4, s5, s6 = (sin(x) for x in q)
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    first, second = c23 * (c4 * c5 * c6 - s4 * s6) - s23 * s5 * c6, s4 * c5 * c6 + c4 * s6
    third, fourth = c23 * (-c4 * c5 * s6 - s4 * c6) + s23 * s5 * s6, c4 * c6 - s4 * c5 * s6
    fifth = c23 * c4 * s5 + s23 * c5
    reach = A2 * c2 + A3 * c23 - D4 * s23
    return [
        [c1 * first + s1 * second, c1 * third + s1 * fourth, -c1 * fifth - s1 * s4 * s5, c1 * reach - D3 * s1],
        [s1 * first - c1 * second, s1 * third - c1 * fourth, -s1 * fifth + c1 * s4 * s5, s1 * reach + D3 * c1],
        [
            -s23 * (c4 * c5 * c6 - s4 * s6) - c23 * s5 * c6,
            -s23 * (-c4 * c5 * s6 - s4 * c6) + c23 * s5 * s6,
            s23 * c4 * s5 - c23 * c5,
            -A3 * s23 - A2 * s2 - D4 * c23,
        ],
    ]


@settings(max_examples=amount(8, 25), deadline=None)
@given(st.tuples(*[st.floats(-4, 4)] * 6))
def test_the_pose_is_the_published_one(q: tuple[float, ...]) -> None:
    expected = [x for row in published(q) for x in row]
    for T in (chain.pose(Chain(PUMA, "modified"), q), transform.chain_pose(PUMA, q, "modified")):
        assert [x for row in T[:3] for x in row] == pytest.approx(expected, abs=1e-12)
