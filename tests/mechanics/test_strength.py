"""Bolts, pure bending, the method of sections and fans of bars, each by a law that is not its formula."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, inf, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics import bar_fan, bending, shearing
from mechanics.bar_fan import FanBar, three_bars
from mechanics.errors import UnstableError
from mechanics.internal_forces import PointLoad, internal_forces
from mechanics.section import Circle, Rectangle, Ring

forces = st.integers(-9000, 9000).map(float)
vectors = st.tuples(forces, forces, forces)
places = st.tuples(*[st.integers(-20, 20).map(lambda n: n / 10)] * 3)
bars = st.builds(
    FanBar,
    st.floats(0, 2 * pi),
    st.floats(0.2, 4),
    st.floats(1e6, 1e8),
    st.floats(-1e-3, 1e-3),
)


@given(st.lists(st.tuples(vectors, places, vectors), max_size=5), places)
def test_the_two_faces_of_a_cut_are_in_balance(
    loads: list[tuple[tuple[float, ...], ...]], centre: tuple[float, ...]
) -> None:
    """The reduced system must do the same work as the loads on every small rigid motion of the part."""
    found = internal_forces([PointLoad(*load) for load in loads], centre)  # type: ignore[arg-type]
    for axis in np.eye(3):
        force = sum(np.dot(axis, F) for F, _, _ in loads)
        assert float(np.dot(axis, (found.N, found.Qy, found.Qz))) == pytest.approx(force)
        turned = sum(np.dot(np.cross(axis, np.subtract(at, centre)), F) + np.dot(axis, M) for F, at, M in loads)
        assert float(np.dot(axis, (found.Mx, found.My, found.Mz))) == pytest.approx(turned, abs=1e-7)


def test_a_load_that_is_not_finite_is_named() -> None:
    with pytest.raises(ValueError, match="force y = nan N"):
        PointLoad((1.0, float("nan"), 0.0), (0.0, 0.0, 0.0))


@pytest.mark.parametrize("section", [Rectangle(0.06, 0.12), Circle(0.08), Ring(0.08, 0.05)])
def test_bending_stresses_add_up_to_the_moment(section: Rectangle | Circle | Ring) -> None:
    """Integrate -sigma y over the section by thin layers, their width taken as the slope of the first moment."""
    M, top = 8000.0, (section.h if isinstance(section, Rectangle) else getattr(section, "D", 0) or 0.08) / 2
    y = np.linspace(-top, top, 200_001)
    outer = 2 * np.sqrt(np.maximum(top**2 - y**2, 0))
    inner = 2 * np.sqrt(np.maximum((section.d / 2) ** 2 - y**2, 0)) if isinstance(section, Ring) else 0 * y
    width = np.full_like(y, section.b) if isinstance(section, Rectangle) else outer - inner
    stress = np.array([bending.normal_stress(M, -top, section)]) * (-y / top)
    assert float(np.trapezoid(-stress * y * width, y)) == pytest.approx(M, rel=1e-6)
    assert bending.normal_stress(M, -top, section) == pytest.approx(M / section.section_modulus)


@given(M=st.floats(-1e6, 1e6).filter(lambda M: abs(M) > 1), sigma=st.floats(1e6, 1e9), ratio=st.floats(0.05, 0.95))
def test_required_sections_bear_exactly_what_is_allowed(M: float, sigma: float, ratio: float) -> None:
    D, h = bending.required_diameter(M, sigma, ratio), bending.required_height(M, sigma, ratio)
    for section, depth in ((Ring(D, ratio * D), D), (Rectangle(ratio * h, h), h)):
        assert abs(bending.normal_stress(M, depth / 2, section)) == pytest.approx(sigma, rel=1e-9)
    assert bending.required_modulus(M, sigma) == pytest.approx(abs(M) / sigma)


def test_a_strip_bent_round_a_drum_has_the_strain_y_over_r() -> None:
    section, E = Rectangle(0.02, 0.001), 2.1e11
    radius = bending.curvature_radius(0.35, E * section.second_moment)
    assert bending.normal_stress(0.35, -0.0005, section) / E == pytest.approx(0.0005 / radius)
    assert bending.curvature_radius(0.0, 1.0) == inf


@given(force=forces, d=st.floats(1e-3, 0.1), planes=st.integers(1, 4), allow=st.floats(1e6, 1e9))
def test_bolts_bear_what_is_allowed_and_one_less_does_not(force: float, d: float, planes: int, allow: float) -> None:
    count = shearing.bolts_needed(force, d, allow, planes)
    assert abs(shearing.stress(force, d, planes, count)) <= allow * (1 + 1e-8)
    assert count == 1 or abs(shearing.stress(force, d, planes, count - 1)) > allow
    if force:
        needed = shearing.required_diameter(force, allow, planes)
        assert abs(shearing.stress(force, needed, planes)) == pytest.approx(allow)


def test_the_work_of_shear_is_half_force_times_shift() -> None:
    tau, G, height, d = shearing.stress(12e3, 0.012), 8e10, 0.01, 0.012
    energy = tau**2 / (2 * G) * pi * d * d / 4 * height
    assert energy == pytest.approx(12e3 * shearing.shift(tau, G, height) / 2)
    assert shearing.strain(tau, G) == pytest.approx(shearing.shift(tau, G, height) / height)


@given(st.lists(bars, min_size=2, max_size=5), forces, forces)
def test_a_fan_is_in_equilibrium_and_its_bars_still_meet(fan: list[FanBar], Fx: float, Fy: float) -> None:
    try:
        found = bar_fan.solve(fan, Fx, Fy)
    except UnstableError:
        spread = max(abs(sin(one.angle - other.angle)) for one in fan for other in fan)
        assert spread < 1e-4
        return
    size = 1 + abs(Fx) + abs(Fy) + sum(map(abs, found.N))
    pulls = [(N * cos(one.angle), N * sin(one.angle)) for N, one in zip(found.N, fan, strict=True)]
    assert sum(x for x, _ in pulls) + Fx == pytest.approx(0, abs=1e-8 * size)
    assert sum(y for _, y in pulls) + Fy == pytest.approx(0, abs=1e-8 * size)
    for N, one in zip(found.N, fan, strict=True):
        growth = -(found.ux * cos(one.angle) + found.uy * sin(one.angle))
        assert N * one.length / one.EA + one.free == pytest.approx(growth, abs=1e-12 + 1e-9 * abs(growth))


@given(P=forces, degrees=st.integers(0, 85), length=st.floats(0.2, 3), EA=st.floats(1e6, 1e8))
def test_three_bars_are_a_fan_and_spend_the_least_energy(P: float, degrees: int, length: float, EA: float) -> None:
    angle = radians(degrees)
    found, sides = three_bars(P, angle, length, EA), length / cos(angle)
    middle, left, right = (
        FanBar(pi / 2, length, EA),
        FanBar(pi / 2 + angle, sides, EA),
        FanBar(pi / 2 - angle, sides, EA),
    )
    if degrees > 0:
        fan = bar_fan.solve([left, middle, right], 0.0, -P)
        assert pytest.approx((found.N_side, found.N_middle, found.N_side), abs=1e-9 * (1 + abs(P))) == fan.N
        assert (fan.ux, fan.uy) == pytest.approx((0.0, -found.u), abs=1e-12 * (1 + abs(P) * length / EA))
    assert found.N_middle + 2 * found.N_side * cos(angle) == pytest.approx(P, abs=1e-9)

    def energy(N: float) -> float:
        side = (P - N) / (2 * cos(angle))
        return N * N * length / 2 / EA + side * side * sides / EA

    assert all(energy(found.N_middle) <= energy(found.N_middle + step) for step in (-1.0, 1.0))


REFUSED: list[tuple[Callable[[], object], str]] = [
    (lambda: three_bars(1e4, pi / 2, 1.0, 1e7), "angle 1.57"),
    (lambda: three_bars(1e4, -0.1, 1.0, 1e7), "angle -0.1"),
    (lambda: three_bars(inf, 0.1, 1.0, 1e7), "load P = inf N"),
    (lambda: three_bars(1.0, 0.1, 0.0, 1e7), "length l = 0.0 m"),
    (lambda: FanBar(0.0, 1.0, 0.0), "E A = 0.0 N"),
    (lambda: bar_fan.solve([FanBar(0.5, 1.0, 1e7), FanBar(0.5 + pi, 1.0, 1e7)], 1.0, 0.0), "2 bars lie on one line"),
    (lambda: bar_fan.solve([], 1.0, 0.0), "0 bars"),
    (lambda: shearing.stress(1.0, 0.0), "d = 0.0 m"),
    (lambda: shearing.stress(1.0, 0.01, 0), "0 shear planes"),
    (lambda: shearing.stress(1.0, 0.01, 1, 0), "0 bolts"),
    (lambda: shearing.bolts_needed(1e300, 1e-3, 1.0), "would take"),
    (lambda: shearing.shift(1.0, 8e10, 0.0), "height h = 0.0 m"),
    (lambda: bending.required_diameter(1.0, 1e6, 1.0), "bore ratio 1.0"),
    (lambda: bending.required_modulus(1.0, -1.0), "sigma_allow = -1.0 Pa"),
    (lambda: bending.curvature_radius(1.0, 0.0), "E I = 0.0"),
]


@pytest.mark.parametrize(("make", "said"), REFUSED)
def test_impossible_values_are_named(make: Callable[[], object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        make()
