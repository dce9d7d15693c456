"""Impossible beams, shafts, sections and numbers are refused with the value and its unit."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nan

import pytest

from mechanics.checks import finite, positive
from mechanics.members import Beam, Distributed, Force, Load, Moment, Segment, Shaft, Support, Torque
from mechanics.section import Circle, Rectangle, Ring

ENDS = (Support(0.0), Support(4.0))


def beam(
    *loads: Load,
    L: float = 4.0,
    E: float = 2.1e11,
    supports: tuple[Support, ...] = ENDS,
    hinges: tuple[float, ...] = (),
    section: Rectangle | None = None,
    I: float | None = 1e-6,
) -> Beam:
    return Beam(L, E, supports, loads, hinges, section, I)


def shaft(
    *torques: Torque, G: float = 8e10, support: str = "fixed_free", tau: float | None = None, ratio: float = 0.0
) -> Shaft:
    return Shaft(G, (Segment(0.5, 0.05),), torques, support, tau, None, ratio)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("build", "reason"),
    [
        (lambda: beam(L=0.0), r"length L = 0\.0 m must be positive and finite"),
        (lambda: beam(L=inf), r"length L = inf m must be positive"),
        (lambda: beam(L=10**400), r"length L = 10+ m must be positive and finite"),
        (lambda: beam(E=-1.0), r"Young's modulus E = -1\.0 Pa"),
        (lambda: beam(I=0.0), r"second moment of area I = 0\.0 m\^4"),
        (lambda: beam(I=nan), r"second moment of area I = nan m\^4"),
        (lambda: beam(E=1e300, I=1e300), r"bending stiffness E I = inf N m\^2"),
        (lambda: beam(section=Rectangle(1e-200, 1e-200), I=None), r"second moment of area I = 0\.0 m\^4"),
        (lambda: beam(I=None), "one of the two"),
        (lambda: beam(section=Rectangle(0.1, 0.1)), "one of the two"),
        (lambda: beam(supports=(Support(4.5),)), r"support at x = 4\.5 m must lie on the member, 0 \.\. 4\.0 m"),
        (lambda: beam(supports=(Support(1.0), Support(1.0))), r"supports at x = 1\.0 m and 1\.0 m must be at least"),
        (lambda: Support(1.0, "glue"), r"support type 'glue' at x = 1\.0 m must be pin, roller or fixed"),  # type: ignore[arg-type]
        (lambda: Support(nan), "support place x = nan m must be finite"),
        (lambda: Support(1.0, "pin", inf), r"settlement of the support at x = 1\.0 m, = inf m must be finite"),
        (lambda: beam(hinges=(0.0,)), r"hinge at x = 0\.0 m must lie inside the beam"),
        (lambda: beam(hinges=(nan,)), "hinge at x = nan m must lie inside the beam"),
        (lambda: beam(hinges=(1.0, 1.0)), "must be at different places"),
        (lambda: beam(supports=(Support(1.0, "fixed"),), hinges=(1.0,)), r"hinge at x = 1\.0 m is at a fixed support"),
        (lambda: beam(Moment(1.0, 5.0), hinges=(1.0,)), r"moment 5\.0 N m at x = 1\.0 m acts at a hinge"),
        (lambda: beam(Force(5.0, 1.0)), r"load at x = 5\.0 m must lie on the member"),
        (lambda: beam(Distributed(-1.0, 2.0, 1.0, 1.0)), r"distributed load start at x = -1\.0 m"),
        (lambda: beam(Distributed(1.0, 4.2, 1.0, 1.0)), r"distributed load end at x = 4\.2 m"),
        (lambda: Distributed(1.0, 1.0, 1.0, 1.0), r"from x1 = 1\.0 m must end to the right of it, not at 1\.0 m"),
        (lambda: Distributed(0.0, 1.0, nan, 1.0), "w1 = nan N/m must be finite"),
        (lambda: Distributed(0.0, 1.0, 1.0, inf), "w2 = inf N/m must be finite"),
        (lambda: Force(0.0, nan), "F = nan N must be finite"),
        (lambda: Moment(0.0, -inf), "M = -inf N m must be finite"),
        (lambda: shaft(G=0.0), r"shear modulus G = 0\.0 Pa"),
        (lambda: shaft(support="glued"), "shaft support 'glued' must be one of fixed_free"),
        (lambda: Shaft(8e10, (), ()), "at least one segment"),
        (lambda: shaft(Torque(0.6, 1.0)), r"torque at x = 0\.6 m must lie on the member, 0 \.\. 0\.5 m"),
        (lambda: Torque(nan, 1.0), "torque place x = nan m must be finite"),
        (lambda: Torque(0.1, nan), "T = nan N m must be finite"),
        (lambda: shaft(tau=0.0), r"tau_allow = 0\.0 Pa must be positive"),
        (lambda: Shaft(8e10, (Segment(1, 1),), (), theta_allow_rad_per_m=-1.0), r"theta_allow_rad_per_m = -1\.0 rad/m"),
        (lambda: shaft(ratio=1.0), r"design_bore_ratio = 1\.0 must be at least 0 and below 1"),
        (lambda: Segment(0.0, 0.05), r"segment length L = 0\.0 m"),
        (lambda: Segment(1.0, 0.05, 0.05), r"bore d = 0\.05 m must be at least 0 and below .* D = 0\.05 m"),
        (lambda: Ring(nan, 0.0), "outer diameter D = nan m"),
        (lambda: Ring(0.05, -0.01), r"bore d = -0\.01 m"),
        (lambda: Ring(0.05, nan), "bore d = nan m"),
        (lambda: Circle(0.0), r"diameter d = 0\.0 m"),
        (lambda: Rectangle(0.0, 1.0), r"width b = 0\.0 m"),
        (lambda: Rectangle(1.0, -1.0), r"height h = -1\.0 m"),
        (lambda: finite("ratio", nan, ""), "^ratio = nan must be finite$"),
        (lambda: positive("ratio", 0, ""), "^ratio = 0 must be positive and finite$"),
    ],
)
def test_impossible_input_is_refused_by_name(build: Callable[[], object], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        build()


def test_torque_a_rounding_from_the_end_of_a_segment_is_at_that_end() -> None:
    stepped = Shaft(8e10, (Segment(0.1, 0.05), Segment(0.2, 0.05)), (Torque(0.3, 5.0),))
    assert stepped.torques[0].x == stepped.ends[-1]
