"""Theorems on the curve that a point of the coupler of a four-bar draws.

S. Roberts, "On three-bar motion in plane space", Proceedings of the London Mathematical Society 7 (1875), pp. 14-23:
three four-bars draw the same curve. With k = (P - B)/(C - B), the second has the bars |k| (l2, l1, l3, l4) and the
frame turned by arg k; its crank turns as the coupler of the first.
P. L. Chebyshev, "Théorie des mécanismes connus sous le nom de parallélogrammes" (1854): with rockers 5, coupler 2 and
frame 4, crossed, the middle of the coupler passes three points of a straight line (right triangles 3, 4, 5).
"""

from __future__ import annotations

from cmath import exp
from math import asin, pi

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import four_bar
from mechanics.errors import AssemblyError, SingularError
from mechanics.four_bar import Mode
from mechanics.linkage import LinkageMotion, principal
from tests.depth import amount

modes: st.SearchStrategy[Mode] = st.sampled_from(["C_left_of_BD", "C_right_of_BD"])
BARS = (0.1, 0.26, 0.22, 0.3)


def points(motion: LinkageMotion) -> list[complex]:
    return [complex(values["P_x"], values["P_y"]) for values in motion[:3]]


@settings(max_examples=amount(13, 40), deadline=None)
@given(
    angle=st.floats(-3, 3), omega=st.floats(-20, 20), epsilon=st.floats(-20, 20), u=st.floats(-0.3, 0.3),
    v=st.floats(0.02, 0.3), mode=modes,
)  # fmt: skip
def test_a_cognate_four_bar_draws_the_same_curve_at_the_same_pace(
    angle: float, omega: float, epsilon: float, u: float, v: float, mode: Mode
) -> None:
    first = four_bar.solve(*BARS, angle, omega, epsilon, mode, (u, v))
    assume(first.singular.measure > 0.05)
    k = complex(u, v) / BARS[1]
    l1, l2, l3, l4 = (abs(k) * bar for bar in BARS)
    crank = first.pos["alpha2"], first.vel["alpha2"], first.acc["alpha2"]
    arm = l1 / k
    found = []
    sides: tuple[Mode, ...] = ("C_left_of_BD", "C_right_of_BD")
    for side in sides:
        try:
            second = four_bar.solve(l2, l1, l3, l4, *crank, mode=side, coupler_point=(arm.real, arm.imag))
        except (AssemblyError, SingularError):
            continue
        if abs(principal(second.pos["alpha3"] - first.pos["alpha3"])) < 1e-6:
            found.append(second)
    assume(found and found[0].singular.measure > 0.05)
    turn = k / abs(k)
    for one, other in zip(points(first), points(found[0]), strict=True):
        assert turn * other == pytest.approx(one, rel=1e-8, abs=1e-9 * (1 + omega**2 + abs(epsilon)))


def middle(angle: float) -> complex:
    """Give the middle of the coupler of Chebyshev's linkage for an angle of its first rocker."""
    found = four_bar.position(5.0, 2.0, 5.0, 4.0, angle, "C_right_of_BD")
    return 5 * exp(1j * angle) + exp(1j * found.coupler_angle)


@pytest.mark.parametrize(("angle", "x"), [(asin(4 / 5), 2.0), (asin(3 / 5), 4.0), (pi / 2, 0.0)])
def test_chebyshev_s_linkage_passes_three_points_of_its_line(angle: float, x: float) -> None:
    assert middle(angle) == pytest.approx(complex(x, 4.0), abs=1e-7)


def test_chebyshev_s_linkage_stays_near_its_line_between_them() -> None:
    low, high = asin(3 / 5), pi / 2
    for k in range(1, 40):
        place = middle(low + (high - low) * k / 40)
        assert 0 < place.real < 4 and abs(place.imag - 4.0) < 0.02
