"""The class III unit: against a polynomial of degree 18, Newton's method, planar bodies and rearranged geometry."""

from __future__ import annotations

from cmath import phase
from math import inf, pi
from random import Random

import numpy as np
import pytest

from mechanics.class_iii import (
    BRANCHES,
    Angles,
    Assembly,
    Unit,
    assemblies,
    assembly,
    constraint,
    critical,
    newton,
)
from mechanics.errors import AssemblyError, SingularError
from mechanics.linkage import principal
from tests.depth import amount
from tests.mechanics.examples.higher_class import unit


def drawn(seed: int) -> tuple[Unit, float]:
    """Draw a unit that closes: its joints are drawn, its lengths follow. Also gives alpha5 of the drawn position."""
    random = Random(seed)
    A, D, G, K, B, C, E, F, H = (complex(random.uniform(-1, 1), random.uniform(-1, 1)) for _ in range(9))
    sigma2 = 1 if ((B - E).conjugate() * (C - E)).imag > 0 else -1
    sigma4 = 1 if ((H - F).conjugate() * (E - F)).imag > 0 else -1
    legs = (abs(A - B), abs(B - C), abs(B - E), abs(C - E), abs(C - D))
    return Unit(A, D, G, K, *legs, abs(E - F), abs(E - H), abs(F - H), abs(F - G), abs(H - K), sigma2, sigma4), phase(
        F - G
    )


def gaps(one: Unit, found: Assembly) -> list[float]:
    """Measure the three legs that hold the ternary links; GF is placed by its angle."""
    H = found.F + one.l_FH * complex(np.exp(1j * found.alpha4))
    B = found.E + one.l_BE * complex(np.exp(1j * found.alpha2))
    return [
        abs(H - one.K) - one.l_HK,
        abs(B - one.A) - one.l_AB,
        abs(found.C - one.D) - one.l_CD,
        abs(found.E - H) - one.l_EH,
        abs(found.C - B) - one.l_BC,
    ]


@pytest.mark.parametrize("seed", range(amount(4, 12)))
def test_the_drawn_position_is_found_and_every_assembly_closes(seed: int) -> None:
    one, alpha5 = drawn(seed)
    found = assemblies(one)
    assert min(abs(principal(each.alpha5 - alpha5)) for each in found) < 1e-8
    assert len(found) % 2 == 0
    for each in found:
        assert gaps(one, each) == pytest.approx([0.0] * 5, abs=1e-11)
        on_branch = constraint(one, each.alpha5, each.branch)
        assert on_branch == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("field", ["D", "l_AB", "l_CD", "l_HK"])
@pytest.mark.parametrize("scale", [1e3, 1e6])
def test_a_length_in_the_wrong_unit_closes_nowhere_and_does_not_count_as_moving(field: str, scale: float) -> None:
    assert assemblies(unit(**{field: scale * getattr(unit(), field)})) == ()


@pytest.mark.parametrize(("leg", "pivot"), [("l_CD", "D"), ("l_AB", "A"), ("l_FG", "G"), ("l_HK", "K")])
def test_the_end_of_a_very_long_leg_moves_as_on_a_straight_line(leg: str, pivot: str) -> None:
    """The longer the leg, the nearer are all assemblies to those of the line; none is lost on the way there."""

    def ends(length: float) -> list[complex]:
        one = unit(**{pivot: 1900 + length + 955j, leg: length + 500})
        found = assemblies(one)
        assert max(abs(gap) for each in found for gap in gaps(one, each)) < 1e-12 * length + 1e-9
        return sorted((each.E for each in found), key=lambda E: E.imag)

    near, far = ends(1e7), ends(1e8)
    assert len(near) >= 8
    assert far == pytest.approx(near, abs=2.0)  # mm


def polynomial(one: Unit) -> np.ndarray:
    """The product of the four branches, without their roots of squares: degree 18 in z = exp(i alpha5).

    Vectors and their mirror images are separate numbers, so the square roots may become imaginary.
    """
    z = np.exp(2j * np.pi * np.arange(64) / 64)
    F, product = one.G + one.l_FG * z, np.ones(64, complex)

    def ends(way: np.ndarray, back: np.ndarray, arm: float, leg: float, sign: int) -> tuple[np.ndarray, ...]:
        square = way * back
        along = (arm**2 + square - leg**2) / 2
        height = sign * 1j * np.sqrt((arm**2 * square - along**2).astype(complex))
        return way * (along + height) / (square * arm), back * (along - height) / (square * arm), square

    for e4, e2 in BRANCHES.values():
        u, u_back, square4 = ends(one.K - F, np.conj(one.K - F), one.l_FH, one.l_HK, e4)
        E, E_back = F + one.arm_E * u, np.conj(F) + np.conj(one.arm_E) * u_back
        v, v_back, square2 = ends(one.A - E, np.conj(one.A) - E_back, one.l_BE, one.l_AB, e2)
        cut, cut_back = E + one.arm_C * v - one.D, E_back + np.conj(one.arm_C) * v_back - np.conj(one.D)
        product *= cut * cut_back - one.l_CD**2
        if e2 == 1:
            product *= square2
    spectrum: np.ndarray = np.fft.fft(product * square4**3) / 64
    return spectrum


def test_the_polynomial_of_degree_eighteen_has_the_same_real_roots() -> None:
    spectrum = polynomial(unit())
    assert np.abs(spectrum[10:-9]).max() < 1e-11 * np.abs(spectrum).max()
    roots = np.roots([*spectrum[9::-1], *spectrum[:-10:-1]])
    assert len(roots) == 18
    real = sorted(np.angle(roots[np.abs(np.abs(roots) - 1) < 1e-6]) % (2 * pi))
    assert real == pytest.approx([each.alpha5 for each in assemblies(unit())], abs=1e-7)


def apart(angles: Angles, other: Assembly) -> float:
    return max(abs(principal(a - b)) for a, b in zip(angles, other[:3], strict=True))


@pytest.mark.parametrize("seed", range(3))
def test_random_starts_of_newton_s_method_find_no_other_assembly(seed: int) -> None:
    one, _ = drawn(seed)
    known, random = assemblies(one), Random(seed)
    reached: set[int] = set()
    for _ in range(60):
        start: Angles = (random.uniform(0, 2 * pi), random.uniform(0, 2 * pi), random.uniform(0, 2 * pi))
        try:
            angles = newton(one, start)[-1]
        except ValueError:
            continue
        near = [i for i, each in enumerate(known) if apart(angles, each) < 1e-6]
        assert len(near) == 1, angles
        reached |= set(near)
    assert len(reached) > 1


def test_two_assemblies_meet_at_a_critical_parameter_as_the_root_of_their_distance() -> None:
    meeting = critical(lambda x: unit(K=complex(x, 1300)), 2076.0, 2077.5)[0]
    assert (meeting.below, meeting.above) == (12, 14)
    apart_by: list[float] = []
    for beyond in (1e-4, 4e-4):
        found = assemblies(unit(K=complex(meeting.parameter + beyond, 1300)))
        pair = sorted(found, key=lambda each: apart(meeting.angles, each))[:2]
        assert all(each.measure < 2e-3 for each in pair)
        apart_by.append(abs(pair[0].alpha5 - pair[1].alpha5))
    assert apart_by[1] / apart_by[0] == pytest.approx(2, rel=1e-3)


def test_an_assembly_in_a_critical_position_has_measure_zero() -> None:
    meeting = critical(lambda x: unit(K=complex(x, 1300)), 2076.0, 2077.5)[0]
    found = assembly(unit(K=complex(meeting.parameter, 1300)), meeting.angles)
    assert found.measure < 1e-12
    assert gaps(unit(K=complex(meeting.parameter, 1300)), found) == pytest.approx([0.0] * 5, abs=1e-8)


def test_a_range_without_a_change_has_no_critical_parameter() -> None:
    assert critical(lambda x: unit(K=complex(x, 1300)), 2080.0, 2090.0) == []


def test_a_leg_too_short_leaves_no_assembly() -> None:
    assert assemblies(unit(l_CD=1e-3)) == ()
    assert assemblies(unit(l_HK=1e-3, l_FG=1e-3)) == ()


def test_a_unit_on_four_equal_parallel_legs_is_refused_as_one_that_moves() -> None:
    leg = 0.3 + 0.8j
    B, C, E, F, H = 0j, 1 + 0.4j, 0.5 + 0.9j, 1.6 + 0.7j, 1.9 + 0.1j
    sides = abs(B - C), abs(B - E), abs(C - E), abs(leg), abs(E - F), abs(E - H), abs(F - H)
    moving = Unit(B - leg, C - leg, F - leg, H - leg, abs(leg), *sides, abs(leg), abs(leg), 1, -1)
    with pytest.raises(SingularError, match="the unit moves"):
        assemblies(moving)


def test_a_branch_out_of_reach_has_no_constraint() -> None:
    assert [constraint(unit(), 3.3, branch) for branch in BRANCHES] == [None] * 4


def test_the_size_of_the_unit_does_not_matter() -> None:
    lengths = {name: 1e-3 * getattr(unit(), name) for name in Unit.__dataclass_fields__ if name.startswith("l_")}
    small = Unit(**{name: 1e-3 * getattr(unit(), name) for name in "ADGK"}, **lengths)
    angles = [each.alpha5 for each in assemblies(small)]
    assert angles == pytest.approx([each.alpha5 for each in assemblies(unit())], abs=1e-10)


@pytest.mark.parametrize(
    ("name", "value"), [("A", complex(inf, 0)), ("l_AB", 0.0), ("l_FH", inf), ("sigma2", 2), ("sigma4", 0)]
)
def test_impossible_values_are_refused_by_name(name: str, value: complex) -> None:
    with pytest.raises(ValueError, match=name):
        unit(**{name: value})


def test_sides_that_make_no_triangle_are_refused_with_the_gap() -> None:
    with pytest.raises(AssemblyError, match="B-C-E make no triangle: 1000 do not fit"):
        unit(l_BC=3000)


@pytest.mark.parametrize(
    ("near", "far", "across"), [(0.1, 0.2, 0.3), (0.3, 0.1, 0.2), (1.15, 0.3, 1.45), (0.7, 0.1, 0.6)]
)
def test_three_joints_in_line_are_a_ternary_link(near: float, far: float, across: float) -> None:
    """E between B and C, or beyond one of them: printed lengths add up but for a rounding."""
    one = unit(l_BE=near, l_CE=far, l_BC=across)
    straight = far if across < max(near, far) else -far
    assert one.arm_C == pytest.approx(straight, abs=1e-7)


def test_a_branch_must_be_known_and_an_angle_finite() -> None:
    with pytest.raises(ValueError, match="branch"):
        constraint(unit(), 1.0, "+")
    with pytest.raises(ValueError, match="alpha5"):
        constraint(unit(), inf, "++")
    with pytest.raises(ValueError, match="alpha4"):
        newton(unit(), (0.0, inf, 0.0))
