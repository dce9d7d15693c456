"""Position errors three ways, against finite displacements and turns."""

from __future__ import annotations

from math import hypot, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import accuracy, chain, rod_groups, slider_crank, transform
from mechanics.chain import Chain
from mechanics.dh import Convention
from mechanics.errors import AssemblyError, SingularError
from mechanics.slider_crank import Branch
from tests.depth import amount
from tests.mechanics.chains import Moving, conventions, moving, vectors
from tests.mechanics.test_rod_groups import LENGTHS, groups, variables

quick = settings(max_examples=amount(8, 25), deadline=None)
SMALL = st.tuples(*[st.floats(-1e-3, 1e-3)] * 3)


@quick
@given(groups, variables, SMALL)
def test_the_three_ways_agree_for_the_rod_groups(
    group: str, q: tuple[float, float, float], dq: tuple[float, float, float]
) -> None:
    rows, point = rod_groups.table(group, LENGTHS[group])
    by_partials = accuracy.linear(rod_groups.partials(group, LENGTHS[group], q), dq)
    by_vectors = accuracy.by_vectors(Chain(rows), q, dq, point)
    assert by_partials.dr == pytest.approx(accuracy.by_matrices(rows, q, dq, point), abs=1e-14)
    for one, other in zip(by_partials.terms, by_vectors.terms, strict=True):
        assert one == pytest.approx(other, abs=1e-14)


@quick
@given(moving(), conventions, vectors, st.data())
def test_vectors_and_matrices_agree_for_any_chain(
    drawn: Moving, convention: Convention, point: tuple[float, float, float], data: st.DataObject
) -> None:
    dq = data.draw(st.tuples(*[st.floats(-1e-3, 1e-3)] * len(drawn.q)))
    by_vectors = accuracy.by_vectors(Chain(drawn.rows, convention), drawn.q, dq, point)
    assert by_vectors.dr == pytest.approx(accuracy.by_matrices(drawn.rows, drawn.q, dq, point, convention), abs=1e-13)


@quick
@given(groups, variables, SMALL)
def test_the_error_is_the_displacement_up_to_second_order(
    group: str, q: tuple[float, float, float], dq: tuple[float, float, float]
) -> None:
    lengths = LENGTHS[group]
    found = accuracy.linear(rod_groups.partials(group, lengths, q), dq)
    there = rod_groups.direct(group, lengths, [x + e for x, e in zip(q, dq, strict=True)])
    moved = [b - a for a, b in zip(rod_groups.direct(group, lengths, q), there, strict=True)]
    assert found.dr == pytest.approx(moved, abs=20 * hypot(*dq) ** 2 + 1e-15)
    assert found.size == pytest.approx(hypot(*found.dr))
    for error, worst, rms in zip(found.dr, found.worst, found.rms, strict=True):
        assert abs(error) <= worst + 1e-18 and rms <= worst + 1e-18


@quick
@given(moving(), conventions, st.data())
def test_the_small_turn_is_the_finite_one_up_to_second_order(
    drawn: Moving, convention: Convention, data: st.DataObject
) -> None:
    table = Chain(drawn.rows, convention)
    dq = data.draw(st.tuples(*[st.floats(-1e-4, 1e-4)] * len(drawn.q)))
    found = accuracy.angular(table, drawn.q, dq)
    programmed = chain.pose(table, drawn.q)
    real = chain.pose(table, [x + e for x, e in zip(drawn.q, dq, strict=True)])
    assert accuracy.turn_between(programmed, real) == pytest.approx(found.angle, abs=1e-7)
    assert chain.turned(chain.frames(table, drawn.q)[-1], found.gripper) == pytest.approx(found.base, abs=1e-15)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-3, 1.0, 3.0, pi])
def test_a_turn_is_measured_from_nothing_to_half_a_turn(angle: float) -> None:
    start = transform.product(transform.rot_x(0.4), transform.rot_z(1.1))
    turned = transform.product(transform.rot_x(0.7), transform.rot_z(angle), transform.rot_x(-0.7), start)
    assert accuracy.turn_between(start, turned) == pytest.approx(angle, abs=1e-15 if angle < 1 else 1e-12)


angles = st.floats(-10, 10)
branches: st.SearchStrategy[Branch] = st.sampled_from(["slider_right", "slider_left"])


@quick
@given(angles, st.floats(1.5, 6), st.floats(-0.4, 0.4), branches)
def test_coefficients_of_the_slider_are_slopes_of_its_position(
    alpha: float, rod: float, offset: float, branch: Branch
) -> None:
    found = accuracy.slider(1.0, rod, alpha, 1e-3, -2e-3, 3e-4, 5e-4, offset, branch)
    h = 1e-6

    def slope(dl1: float, dl2: float, da: float, dh: float) -> float:
        ahead, behind = (
            slider_crank.position(1.0 + k * dl1, rod + k * dl2, alpha + k * da, offset + k * dh, branch).slider
            for k in (h, -h)
        )
        return (ahead - behind) / (2 * h)

    slopes = slope(1, 0, 0, 0), slope(0, 1, 0, 0), slope(0, 0, 1, 0), slope(0, 0, 0, 1)
    assert (found.c_l1, found.c_l2, found.c_alpha, found.c_offset) == pytest.approx(slopes, rel=1e-6, abs=1e-8)
    terms = [c * e for c, e in zip(slopes, (1e-3, -2e-3, 3e-4, 5e-4), strict=True)]
    assert found.dl3 == pytest.approx(sum(terms), rel=1e-5, abs=1e-10)
    assert found.worst == pytest.approx(sum(map(abs, terms)), rel=1e-5)
    assert found.rms == pytest.approx(sum(t * t for t in terms) ** 0.5, rel=1e-5)


def test_a_rod_across_the_guide_has_no_error_coefficients() -> None:
    with pytest.raises(SingularError, match="perpendicular"):
        accuracy.slider(0.1, 0.1, pi / 2)
    with pytest.raises(AssemblyError, match="cannot reach"):
        accuracy.slider(0.2, 0.1, pi / 2)


def test_what_does_not_fit_is_refused_by_name() -> None:
    table = Chain(rod_groups.table("RRR", LENGTHS["RRR"])[0])
    with pytest.raises(ValueError, match="dq has 2 values for 3 joints"):
        accuracy.by_vectors(table, (0.1, 0.2, 0.3), (0.1, 0.2))
    with pytest.raises(ValueError, match=r"dq\[0\]"):
        accuracy.angular(table, (0.1, 0.2, 0.3), (nan, 0.2, 0.1))
    with pytest.raises(ValueError, match="point has 2 components"):
        accuracy.by_matrices(table.rows, (0.1, 0.2, 0.3), (0.0, 0.0, 0.0), (0.0, 0.0))  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="dq has 1 values for 2 partial derivatives"):
        accuracy.linear([(1.0, 0.0, 0.0)] * 2, [0.1])
    with pytest.raises(ValueError, match=r"partials\[0\] y = nan"):
        accuracy.linear([(1.0, nan, 0.0)], [0.1])
    with pytest.raises(ValueError, match="dl2 = nan m"):
        accuracy.slider(0.1, 0.3, 0.5, dl2=nan)


@quick
@given(groups, variables)
def test_partial_derivatives_are_slopes_and_make_the_determinant(group: str, q: tuple[float, float, float]) -> None:
    lengths = LENGTHS[group]
    a, b, c = rod_groups.partials(group, lengths, q)
    h = 1e-6
    for j, slope in enumerate((a, b, c)):
        ahead, behind = (
            rod_groups.direct(group, lengths, [x + k * h * (i == j) for i, x in enumerate(q)]) for k in (1, -1)
        )
        assert slope == pytest.approx([(y - x) / (2 * h) for x, y in zip(behind, ahead, strict=True)], abs=1e-8)
    volume = (
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    )
    assert rod_groups.determinant(group, lengths, q) == pytest.approx(volume, abs=1e-12)


def test_a_slide_turns_nothing() -> None:
    rows, _ = rod_groups.table("PPP", LENGTHS["PPP"])
    assert accuracy.angular(Chain(rows), (0.1, 0.2, 0.3), (0.1, 0.1, 0.1)).angle == 0


def test_parallel_axes_add_their_errors_as_numbers() -> None:
    rows, _ = rod_groups.table("PRR", LENGTHS["PRR"])
    found = accuracy.angular(Chain(rows), (0.1, 0.2, 0.3), (5.0, 0.002, 0.003))
    assert found.base == pytest.approx((0, 0, 0.003 - 0.002), abs=1e-17)
