"""Stress and strain by the laws of tensors: eigenvalues by NumPy, turned axes, Mohr's circles, Hooke there and back."""

from __future__ import annotations

from math import atan2, cos, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics import tensor
from mechanics.strain import Material, StrainState, strain_of, stress_of
from mechanics.stress import PlaneStress, StressState
from mechanics.tensor import Matrix

components = st.lists(st.integers(-300, 300), min_size=6, max_size=6)
angles = st.floats(-4, 4)
STEEL = Material(2.1e11, 0.3)
materials = st.builds(Material, st.floats(1e9, 4e11), st.floats(-0.9, 0.49))


def state(six: list[int]) -> Matrix:
    x, y, z, xy, yz, zx = map(float, six)
    return (x, xy, zx), (xy, y, yz), (zx, yz, z)


@given(components)
def test_principal_stresses_are_eigenvalues_in_perpendicular_directions(six: list[int]) -> None:
    found = StressState(state(six))
    S, scale = np.array(found.components), 1 + max(map(abs, six))
    assert found.principal == pytest.approx(np.linalg.eigvalsh(S)[::-1], abs=1e-12 * scale)
    V = np.array(found.directions)
    assert pytest.approx(np.eye(3), abs=1e-12) == V @ V.T
    assert np.linalg.det(V) == pytest.approx(1)
    assert pytest.approx(np.diag(found.principal), abs=1e-11 * scale) == V @ S @ V.T


@given(components)
def test_the_invariants_are_those_of_the_principal_stresses(six: list[int]) -> None:
    found = StressState(state(six))
    s1, s2, s3 = found.principal
    scale = 1 + max(map(abs, six))
    I1, I2, I3 = found.invariants
    assert pytest.approx(s1 + s2 + s3, abs=1e-12 * scale) == I1
    assert pytest.approx(s1 * s2 + s2 * s3 + s3 * s1, abs=1e-12 * scale**2) == I2
    assert pytest.approx(np.linalg.det(np.array(found.components)), abs=1e-11 * scale**3) == I3
    assert found.von_mises**2 == pytest.approx(I1 * I1 - 3 * I2, abs=1e-11 * scale**2)


@given(components, st.tuples(angles, angles))
def test_no_plane_carries_more_than_the_extremes_and_mohr_s_region_holds(
    six: list[int], turn: tuple[float, float]
) -> None:
    found, eps = StressState(state(six)), 1e-9 * (1 + max(map(abs, six)))
    a, b = turn
    acting = found.on((3 * cos(a) * cos(b), 3 * sin(a) * cos(b), 3 * sin(b)))
    s1, _, s3 = found.principal
    assert s3 - eps <= acting.normal <= s1 + eps and acting.shear <= found.tau_max + eps
    (outer, R), *inner = found.circles
    assert (acting.normal - outer) ** 2 + acting.shear**2 <= R**2 + eps * (1 + R)
    assert all((acting.normal - c) ** 2 + acting.shear**2 >= r**2 - eps * (1 + R) for c, r in inner)
    assert found.tresca == pytest.approx(2 * R)


def test_the_largest_shear_acts_half_way_between_the_first_and_the_third_direction() -> None:
    found = StressState(((80e6, 30e6, 0), (30e6, -20e6, 10e6), (0, 10e6, 40e6)))
    first, _, third = found.directions
    assert found.on([x + z for x, z in zip(first, third, strict=True)]).shear == pytest.approx(found.tau_max)
    assert found.on(first).shear == pytest.approx(0, abs=1e-6)


@given(st.integers(-300, 300), st.integers(-300, 300), st.integers(-300, 300), angles)
def test_plane_stress_is_the_turned_tensor(x: int, y: int, xy: int, angle: float) -> None:
    plane, turned = PlaneStress(x, y, xy), PlaneStress(x, y, xy).turned(angle)
    R = np.array([[cos(angle), sin(angle)], [-sin(angle), cos(angle)]])
    wanted = R @ np.array([[x, xy], [xy, y]]) @ R.T
    assert (turned.x, turned.xy, turned.y) == pytest.approx((wanted[0, 0], wanted[0, 1], wanted[1, 1]), abs=1e-9)
    own = plane.turned(plane.angle)
    assert (own.x, own.y, own.xy) == pytest.approx((*plane.principal, 0), abs=1e-9)
    assert -pi / 2 < plane.angle <= pi / 2
    # Mohr: the plane turned by the angle stands on the circle turned by twice the angle.
    if plane.radius > 1:
        on_circle = atan2(turned.xy, turned.x - turned.centre)
        assert cos(on_circle - 2 * (plane.angle - angle)) == pytest.approx(1)


@given(components, materials)
def test_hooke_s_law_there_and_back_gives_the_stress(six: list[int], material: Material) -> None:
    stress = StressState(state([value * 10**6 for value in six]))
    strain = strain_of(stress, material)
    back = stress_of(strain, material).components
    scale = 1e6 * (1 + max(map(abs, six)))
    assert np.array(back) == pytest.approx(np.array(stress.components), abs=1e-10 * scale)
    assert strain.volumetric == pytest.approx(stress.invariants[0] / (3 * material.K), abs=1e-10 * scale / material.K)
    assert strain.shear[0] == pytest.approx(stress.components[0][1] / material.G, rel=1e-12)
    assert np.array(strain.directions[0]) @ np.array(stress.components) @ np.array(strain.directions[0]) == (
        pytest.approx(stress.principal[0], abs=1e-9 * scale)
    )


def test_uniaxial_pull_stretches_by_sigma_over_e_and_narrows_by_nu() -> None:
    strain = strain_of(StressState(((2.1e8, 0, 0), (0, 0, 0), (0, 0, 0))), STEEL)
    assert [strain.components[i][i] for i in range(3)] == pytest.approx([1e-3, -3e-4, -3e-4])
    assert strain.principal == pytest.approx((1e-3, -3e-4, -3e-4))


@given(materials)
def test_the_elastic_constants_agree(material: Material) -> None:
    E, nu, G, K, lame = material.E, material.nu, material.G, material.K, material.lame
    assert pytest.approx(9 * K * G / (3 * K + G), rel=1e-9) == E
    assert pytest.approx((3 * K - 2 * G) / (2 * (3 * K + G)), rel=1e-9, abs=1e-9) == nu
    assert pytest.approx(K - 2 * G / 3, rel=1e-9, abs=1e-9 * G) == lame


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        (((1, 2, 3), (2, 1, 0)), "three rows"),
        (((1, 2), (2, 1), (3, 0)), "three rows"),
        (((1, 2, 0), (3, 1, 0), (0, 0, 1)), "symmetric: xy = 2"),
        (((1, 2, 0), (2, float("nan"), 0), (0, 0, 1)), "must be finite"),
    ],
)
def test_what_is_no_stress_is_refused(rows: Matrix, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        StressState(rows)
    with pytest.raises(ValueError, match=said):
        StrainState(rows)


@pytest.mark.parametrize("normal", [(0, 0, 0), (1, 2), (float("inf"), 0, 0)])
def test_what_is_no_normal_is_refused(normal: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="normal"):
        StressState(state([1, 2, 3, 4, 5, 6])).on(normal)


@pytest.mark.parametrize("nu", [-1.0, 0.5, 0.7, float("nan")])
def test_an_impossible_ratio_is_named(nu: float) -> None:
    with pytest.raises(ValueError, match=f"nu = {nu}"):
        Material(2.1e11, nu)


def test_a_sphere_of_equal_stresses_has_no_shear() -> None:
    found = StressState(((5e6, 0, 0), (0, 5e6, 0), (0, 0, 5e6)))
    assert found.tau_max == found.von_mises == 0
    assert tensor.principal(((0, 0, 0), (0, 0, 0), (0, 0, 0)))[0] == (0, 0, 0)
    assert found.on((1, 1, 1)).normal == pytest.approx(5e6) and found.on((1, 1, 1)).shear == pytest.approx(0, abs=1e-6)
    assert PlaneStress(0, 0, 1e6).principal == pytest.approx((1e6, -1e6))
    assert PlaneStress(0, 0, 1e6).angle == pytest.approx(pi / 4)
    assert StressState(((0, 1e6, 0), (1e6, 0, 0), (0, 0, 0))).von_mises == pytest.approx(sqrt(3) * 1e6)
