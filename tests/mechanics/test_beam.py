"""Published beams, closed forms, laws of equilibrium, and refusals."""

from __future__ import annotations

import subprocess
import sys
from itertools import pairwise
from math import inf, nan

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics.beam import Beam, BeamResult, Distributed, Force, Load, Moment, Support, solve
from mechanics.errors import UnstableError
from mechanics.section import Circle, Rectangle, Ring
from tests.depth import amount
from tests.mechanics.structures import beams

EJ = 1814400.0  # of SM-12, N m^2
STEEL = 2.1e11  # Pa
J = EJ / STEEL


def beam_of(L: float, supports: tuple[Support, ...], *loads: Load, hinges: tuple[float, ...] = ()) -> Beam:
    return Beam(L, STEEL, supports, loads, hinges, I=J)


def simple(L: float, *loads: Load) -> Beam:
    return beam_of(L, (Support(0.0), Support(L, "roller")), *loads)


def solved(beam: Beam) -> BeamResult:
    try:
        return solve(beam)
    except UnstableError:
        assume(False)
        raise


def test_sm_11_reactions_shear_and_moment() -> None:
    found = solve(simple(4.0, Force(1.5, -6000.0), Distributed(0.0, 4.0, -2000.0, -2000.0), Moment(3.0, -1000.0)))
    assert [reaction.Fy for reaction in found.reactions] == pytest.approx([7500.0, 6500.0], rel=1e-12)
    assert [found.at(x).V for x in (0.0, 1.5, 4.0)] == pytest.approx([7500.0, 4500.0, -6500.0], rel=1e-12)
    assert pytest.approx(-1500.0, rel=1e-12) == found.pieces[1].V
    assert pytest.approx(9000.0, rel=1e-12) == found.at(1.5).M
    assert pytest.approx((4500.0, 5500.0), rel=1e-12) == (found.at(3.0).M, found.pieces[2].M)
    assert (found.M_max, found.x_M_abs_max) == pytest.approx((9000.0, 1.5), rel=1e-12)
    assert found.degree == 0


def test_sm_12_bending_stress() -> None:
    couple = Moment(2.0, 8000.0)
    found = solve(Beam(2.0, STEEL, (Support(0.0, "fixed"),), (couple,), section=Rectangle(0.06, 0.12)))
    assert found.sigma_max == pytest.approx(55555555.56, rel=1e-9)
    assert pytest.approx((8.64e-6, 0.000144), rel=1e-12) == (found.I, found.W)
    assert STEEL * found.I / found.M_abs_max == pytest.approx(226.8)
    assert pytest.approx(8000.0) == found.at(1.0).M


def test_sm_13_cantilever() -> None:
    found = solve(beam_of(2.0, (Support(0.0, "fixed"),), Force(2.0, -3000.0)))
    end, inside = found.at(2.0), found.at(1.2)
    assert (end.v, end.theta) == pytest.approx((-0.004409171076, -0.003306878307), rel=1e-9)
    assert (inside.v, inside.theta) == pytest.approx((-0.001904761905, -0.002777777778), rel=1e-9)
    assert (found.v_extreme, found.x_v_extreme) == (end.v, 2.0)
    assert pytest.approx(6000.0) == found.reactions[0].M


def test_sm_14_two_supports() -> None:
    found = solve(simple(4.0, Force(1.5, -6000.0), Distributed(0.0, 4.0, -2000.0, -2000.0)))
    assert [reaction.Fy for reaction in found.reactions] == pytest.approx([7750.0, 6250.0], rel=1e-12)
    assert found.at(0.0).theta == pytest.approx(-0.006297995664, rel=1e-9)
    assert found.at(0.0).theta * EJ == pytest.approx(-11427.08333, rel=1e-9)
    assert found.at(2.0).v == pytest.approx(-0.007704567166, rel=1e-9)
    assert (found.x_v_extreme, found.v_extreme) == pytest.approx((1.923550143, -0.007718437339), rel=1e-9)


def test_sm_17_propped_cantilever() -> None:
    supports = (Support(0.0, "fixed"), Support(3.0, "roller"))
    spread, central = Distributed(0.0, 3.0, -4000.0, -4000.0), Force(1.5, -5000.0)
    uniform, point = solve(beam_of(3.0, supports, spread)), solve(beam_of(3.0, supports, central))
    assert [reaction.Fy for reaction in uniform.reactions] == pytest.approx([7500.0, 4500.0], rel=1e-12)
    assert pytest.approx((-4500.0, 4500.0), rel=1e-12) == (uniform.at(0.0).M, uniform.reactions[0].M)
    assert uniform.M_max == pytest.approx(2531.25, rel=1e-12)
    assert pytest.approx(0.0, abs=1e-9) == uniform.at(1.875).V
    assert (uniform.M_abs_max, uniform.x_M_abs_max) == pytest.approx((4500.0, 0.0), rel=1e-12)
    assert point.reactions[1].Fy == pytest.approx(1562.5, rel=1e-12)
    assert pytest.approx(-2812.5, rel=1e-12) == point.at(0.0).M
    assert solve(beam_of(3.0, supports, spread, central)).reactions[1].Fy == pytest.approx(6062.5, rel=1e-12)
    assert uniform.degree == 1


def test_settlement_changes_the_prop_by_three_ej_delta_over_the_cube_of_the_span() -> None:
    found = solve(beam_of(3.0, (Support(0.0, "fixed"), Support(3.0, "roller", 0.002))))
    assert found.reactions[1].Fy == pytest.approx(3 * EJ * 0.002 / 27)
    assert found.at(3.0).v == pytest.approx(0.002)


def test_clamped_beam_under_a_triangular_load() -> None:
    """Fixed-end moments q L^2/30 and q L^2/20: Roark's Formulas, 7th ed., table 8.1, case 2d."""
    found = solve(beam_of(3.0, (Support(0.0, "fixed"), Support(3.0, "fixed")), Distributed(0.0, 3.0, 0.0, -2000.0)))
    assert pytest.approx(-2000 * 9 / 30) == found.at(0.0).M
    assert pytest.approx(-2000 * 9 / 20) == found.at(3.0).M
    assert found.degree == 2


def test_simple_beam_under_a_triangular_load_has_its_extreme_at_l_over_root_three() -> None:
    found = solve(simple(3.0, Distributed(0.0, 3.0, 0.0, -2000.0)))
    assert found.x_M_abs_max == pytest.approx(3 / 3**0.5, rel=1e-12)
    assert found.M_max == pytest.approx(2000 * 9 / (9 * 3**0.5), rel=1e-12)
    assert found.x_v_extreme == pytest.approx(3 * (1 - (8 / 15) ** 0.5) ** 0.5, rel=1e-9)


def test_couple_turned_counter_clockwise_lowers_the_moment() -> None:
    found = solve(simple(4.0, Moment(1.0, 800.0)))
    assert pytest.approx((200.0, -600.0)) == (found.at(1.0).M, found.pieces[1].M)
    assert (found.M_max, found.M_min, found.x_M_abs_max) == pytest.approx((200.0, -600.0, 1.0))


def test_gerber_beam_hangs_on_its_hinge() -> None:
    """The hung span is a simple beam: half its force goes to the hinge, and by it to the cantilever."""
    supports = (Support(0.0, "fixed"), Support(4.0, "roller"))
    found = solve(beam_of(4.0, supports, Force(3.0, -1000.0), hinges=(2.0,)))
    assert [reaction.Fy for reaction in found.reactions] == pytest.approx([500.0, 500.0])
    assert pytest.approx(1000.0) == found.reactions[0].M
    assert pytest.approx(0.0, abs=1e-9) == found.at(2.0).M
    assert found.at(2.0).v == pytest.approx(-500 * 8 / 3 / EJ)
    assert (found.degree, found.pieces[1].theta > found.at(2.0).theta) == (0, True)


def test_clamp_inside_the_beam_parts_it() -> None:
    found = solve(beam_of(3.0, (Support(1.0, "fixed"),), Force(0.0, -900.0), Force(3.0, -900.0)))
    assert found.reactions[0].Fy == pytest.approx(1800.0)
    assert pytest.approx(900.0) == found.reactions[0].M
    assert (found.at(0.0).v, found.at(3.0).v) == pytest.approx((-900 / 3 / EJ, -900 * 8 / 3 / EJ))


def test_loads_over_a_support_go_straight_into_it() -> None:
    found = solve(simple(2.0, Force(0.0, -700.0), Force(2.0, -300.0)))
    assert [reaction.Fy for reaction in found.reactions] == pytest.approx([700.0, 300.0])
    assert (found.M_abs_max, found.v_extreme) == pytest.approx((0.0, 0.0), abs=1e-12)


def test_unloaded_beam_is_at_rest() -> None:
    found = solve(simple(2.0))
    assert (found.M_abs_max, found.V_abs_max, found.v_extreme, found.x_v_extreme) == (0.0, 0.0, 0.0, 0.0)


def test_extreme_deflection_is_the_leftmost_of_two_equal_ones() -> None:
    supports = (Support(0.0), Support(2.0), Support(4.0))
    found = solve(beam_of(4.0, supports, Force(1.0, -1000.0), Force(3.0, -1000.0)))
    assert found.x_v_extreme < 2
    assert found.at(4.0 - found.x_v_extreme).v == pytest.approx(found.v_extreme)


@pytest.mark.parametrize("tilt", [0.0, 1e-15, 1e-13, -1e-12, 1e-9])
def test_tiny_leading_coefficient_loses_no_extreme(tilt: float) -> None:
    found = solve(simple(4.0, Distributed(0.0, 4.0, -2000.0, -2000.0 * (1 + tilt))))
    assert (found.x_M_abs_max, found.M_max) == pytest.approx((2.0, 4000.0), rel=1e-8)
    assert found.v_extreme == pytest.approx(-5 * 2000 * 4**4 / 384 / EJ, rel=1e-8)


def test_shear_is_extreme_inside_a_load_that_changes_sign() -> None:
    found = solve(beam_of(3.0, (Support(3.0, "fixed"),), Distributed(0.0, 3.0, 1200.0, -1200.0)))
    assert found.V_abs_max == pytest.approx(1200 * 1.5 / 2)
    assert pytest.approx(0.0, abs=1e-9) == found.at(3.0).V


def test_sixty_equal_spans_are_symmetric_and_in_equilibrium() -> None:
    supports = tuple(Support(float(x)) for x in range(61))
    found = solve(beam_of(60.0, supports, Distributed(0.0, 60.0, -1200.0, -1200.0)))
    forces = [reaction.Fy for reaction in found.reactions]
    assert sum(forces) == pytest.approx(1200 * 60, rel=1e-12)
    assert forces == pytest.approx(forces[::-1], rel=1e-10)
    assert pytest.approx(-100.0, rel=1e-10) == found.at(30.0).M  # q l^2/12 far from the ends
    assert found.degree == 59


def test_shear_stress_of_each_section_is_its_share_of_the_mean() -> None:
    """tau_max over V/A: 3/2 of a rectangle, 4/3 of a circle, 2 of a thin tube (Timoshenko, Strength of Materials)."""
    for section, share in ((Rectangle(0.03, 0.08), 1.5), (Circle(0.05), 4 / 3), (Ring(0.05, 0.04999), 2.0)):
        found = solve(Beam(1.0, STEEL, (Support(0.0, "fixed"),), (Force(1.0, -900.0),), section=section))
        assert found.tau_max == pytest.approx(share * 900 / section.area, rel=1e-3)


def test_stress_needs_a_section() -> None:
    found = solve(simple(1.0, Force(0.5, -1.0)))
    assert (found.W, found.sigma_max, found.tau_max) == (None, None, None)


@settings(max_examples=amount(11, 35))
@given(beams())
def test_loads_and_reactions_are_in_equilibrium(beam: Beam) -> None:
    found = solved(beam)
    forces = [(reaction.x, reaction.Fy) for reaction in found.reactions]
    couples = [reaction.M for reaction in found.reactions]
    for load in beam.loads:
        if isinstance(load, Force):
            forces.append((load.x, load.F))
        elif isinstance(load, Moment):
            couples.append(load.M)
        else:
            h = load.x2 - load.x1
            forces.append((load.x1 + h / 3, load.w1 * h / 2))
            forces.append((load.x2 - h / 3, load.w2 * h / 2))
    scale = sum(abs(F) for _, F in forces) + sum(map(abs, couples)) / beam.L
    assert sum(F for _, F in forces) == pytest.approx(0.0, abs=1e-9 * scale)
    assert sum(F * x for x, F in forces) + sum(couples) == pytest.approx(0.0, abs=1e-9 * scale * beam.L)


@settings(max_examples=amount(11, 35))
@given(beams())
def test_right_end_is_free_beyond_its_support_and_load(beam: Beam) -> None:
    found = solved(beam)
    end = found.at(beam.L)
    V = end.V + sum(r.Fy for r in found.reactions if r.x == beam.L)
    V += sum(load.F for load in beam.loads if isinstance(load, Force) and load.x == beam.L)
    M = end.M - sum(r.M for r in found.reactions if r.x == beam.L)
    M -= sum(load.M for load in beam.loads if isinstance(load, Moment) and load.x == beam.L)
    scale = found.V_abs_max + max(abs(r.Fy) for r in found.reactions) + 1
    assert pytest.approx(0.0, abs=1e-9 * scale) == V
    assert pytest.approx(0.0, abs=1e-9 * scale * beam.L + 1e-9 * found.M_abs_max) == M


@settings(max_examples=amount(11, 35))
@given(beams(), st.floats(0.05, 0.95))
def test_each_curve_is_the_integral_of_the_next(beam: Beam, share: float) -> None:
    """Gauss' three points integrate degree five exactly, so the differences hold to rounding."""
    found = solved(beam)
    nodes = ((0.5 - 0.15**0.5, 5 / 18), (0.5, 4 / 9), (0.5 + 0.15**0.5, 5 / 18))
    for piece in found.pieces:
        h = share * (piece.x2 - piece.x1)
        scale = found.V_abs_max * beam.L + found.M_abs_max + 1e-9
        shear = sum(weight * h * piece.shear(t * h) for t, weight in nodes)
        moment = sum(weight * h * piece.moment(t * h) for t, weight in nodes)
        slope = sum(weight * h * piece.slope(t * h) for t, weight in nodes)
        assert piece.moment(h) - piece.moment(0.0) == pytest.approx(shear, abs=1e-11 * scale)
        assert (piece.slope(h) - piece.slope(0.0)) * piece.EI == pytest.approx(moment, abs=1e-10 * scale * beam.L)
        sag = scale * beam.L**2 + abs(found.v_extreme) * piece.EI + abs(piece.theta) * beam.L * piece.EI
        assert (piece.deflection(h) - piece.deflection(0.0)) * piece.EI == pytest.approx(
            slope * piece.EI, abs=1e-10 * sag
        )


@settings(max_examples=amount(11, 35))
@given(beams())
def test_no_sample_passes_an_extreme(beam: Beam) -> None:
    found = solved(beam)
    for step in range(101):
        sample = found.at(beam.L * step / 100)
        slack = 1 + 1e-9
        assert found.M_max + 1e-9 * found.M_abs_max >= sample.M
        assert found.M_min - 1e-9 * found.M_abs_max <= sample.M
        assert abs(sample.V) <= found.V_abs_max * slack
        assert abs(sample.v) <= abs(found.v_extreme) * slack


@settings(max_examples=amount(11, 35))
@given(beams())
def test_deflection_is_continuous_and_meets_the_supports(beam: Beam) -> None:
    found = solved(beam)
    room = 1e-9 * (abs(found.v_extreme) + found.M_abs_max * beam.L**2 / beam.E / beam.second_moment)
    for left, right in pairwise(found.pieces):
        assert left.deflection(left.x2 - left.x1) == pytest.approx(right.v, abs=room)
    for support in beam.supports:
        assert found.at(support.x).v == pytest.approx(support.settlement, abs=room)
    for x in beam.hinges:
        assert pytest.approx(0.0, abs=1e-9 * (found.M_abs_max + found.V_abs_max * beam.L)) == found.at(x).M


@pytest.mark.parametrize(
    ("supports", "hinges", "reason"),
    [
        ((), (), "can move up and down and turn"),
        ((Support(1.0),), (), r"can turn about the point x = 1\.0 m"),
        ((Support(0.0), Support(4.0)), (2.0,), r"right of the hinge at x = 2\.0 m can turn about the point x = 4\.0 m"),
        ((Support(2.0), Support(4.0)), (2.0,), r"left of the hinge at x = 2\.0 m can turn about that point"),
        ((Support(3.0), Support(4.0)), (2.0,), r"left of the hinge at x = 2\.0 m has too few supports"),
        ((Support(0.0), Support(1.0)), (2.0,), r"right of the hinge at x = 2\.0 m can turn about the point x = 2\.0 m"),
        ((Support(0.0), Support(3.5), Support(4.0)), (1.0, 2.0), "has too few supports"),
        ((Support(0.0), Support(1.0), Support(2.0 + 1e-7)), (2.0,), r"can turn about the point x = 2\.0 m"),
        ((Support(2.0 - 1e-7), Support(3.0), Support(4.0)), (2.0,), "can turn about that point"),
    ],
)
def test_unstable_beam_is_refused_and_the_moving_part_named(
    supports: tuple[Support, ...], hinges: tuple[float, ...], reason: str
) -> None:
    with pytest.raises(UnstableError, match=f"unstable beam: .*{reason}"):
        solve(beam_of(4.0, supports, Force(1.0, -1.0), hinges=hinges))


def test_answer_beyond_floating_point_is_refused() -> None:
    with pytest.raises(ValueError, match="leaves the range of floats"):
        solve(simple(4.0, Force(1.0, 1.7e308), Force(2.0, 1.7e308)))


@pytest.mark.parametrize("x", [-0.1, 4.1, nan, inf])
def test_sample_off_the_beam_is_refused(x: float) -> None:
    with pytest.raises(ValueError, match=r"sample at x = .* m must lie on the member"):
        solve(simple(4.0)).at(x)


def test_beam_is_light_to_import() -> None:
    script = "import sys, mechanics.beam, mechanics.shaft, mechanics.frame; print('numpy' in sys.modules)"
    answer = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert answer.stdout.strip() == "False"
