"""Linkages that move although the count of constraints forbids it.

G. T. Bennett, "A new mechanism", Engineering 76 (1903), pp. 777-778: four revolutes in space move when opposite links
have equal lengths a, b and twists alpha, beta with sin(alpha)/a = sin(beta)/b.
P. F. Sarrus, "Note sur la transformation des mouvements rectilignes alternatifs, en mouvements circulaires, et
réciproquement", Comptes rendus de l'Académie des sciences 36 (1853), pp. 1036-1038: two chains of three parallel
revolutes in planes across one another guide a plate along a straight line.
"""

from __future__ import annotations

from math import acos, asin, cos, sin, tan

import numpy as np
import pytest

from mechanics.mobility import Joint, space

CIRCLE = ("01", "12", "23", "30")


def bennett(stretch: float = 1.0) -> list[Joint]:
    """The loop built link by link: Rz(theta) Tx(length) Rx(twist), closed by the relation of its angles."""
    a, alpha, b = 1.0, 0.5, 1.6
    beta = asin(b * sin(alpha) / a)
    one = 1.1
    ratio = sin((beta + alpha) / 2) / sin((beta - alpha) / 2)  # tan(theta1/2) tan(theta2/2) of the closed loop
    other = 2 * np.arctan(ratio / tan(one / 2))
    frame, joints = np.eye(4), []
    for ends, angle, length, twist in zip(
        CIRCLE, (one, other, -one, -other), (a, b * stretch, a, b), (alpha, beta, alpha, beta), strict=True
    ):
        place, axis = frame[:3, 3], frame[:3, 2]
        joints.append(Joint("R", tuple(ends), tuple(map(float, place)), tuple(map(float, axis))))
        frame = frame @ _link(angle, length, twist)
    return joints


def _link(angle: float, length: float, twist: float) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    turn = np.array([[cos(angle), -sin(angle), 0, 0], [sin(angle), cos(angle), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    bend = np.array(
        [[1, 0, 0, length], [0, cos(twist), -sin(twist), 0], [0, sin(twist), cos(twist), 0], [0, 0, 0, 1]], dtype=float
    )
    return np.asarray(turn @ bend, dtype=np.float64)


def test_the_linkage_of_bennett_moves() -> None:
    found = space("0123", bennett())
    assert (found.formula, found.true, found.passive) == (-2, 1, 3)


@pytest.mark.parametrize("stretch", [0.9, 1.1])
def test_with_one_link_of_another_length_it_is_locked(stretch: float) -> None:
    assert space("0123", bennett(stretch)).true == 0


def test_the_linkage_of_sarrus_guides_a_plate_along_a_line() -> None:
    lean = acos(0.4)
    joints = []
    for (first, second), axis, across in ((("1", "2"), (0.0, 1.0, 0.0), 0), (("3", "4"), (1.0, 0.0, 0.0), 1)):
        out = [0.0, 0.0]
        out[across] = sin(lean)
        places = [(0.0, 0.0, 0.0), (out[0], out[1], cos(lean)), (0.0, 0.0, 2 * cos(lean))]
        for ends, place in zip((("0", first), (first, second), (second, "5")), places, strict=True):
            joints.append(Joint("R", ends, place, axis))
    found = space("012345", joints)
    assert (found.formula, found.true, found.passive) == (0, 1, 1)
