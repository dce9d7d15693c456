"""Homogeneous matrices: published entries and the laws of rigid transforms."""

from __future__ import annotations

from math import radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.dh import Convention, Row
from mechanics.transform import (
    IDENTITY,
    acceleration_matrix,
    chain_pose,
    joint_operator,
    moved_point,
    point_motion,
    product,
    rigid_inverse,
    rot_x,
    rot_z,
    total,
    trans_x,
    trans_z,
    velocity_matrix,
)
from mechanics.vectors import Matrix
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

numbers = st.floats(-4, 4)
rows = st.builds(Row, st.sampled_from(["R", "P"]), numbers, numbers, numbers, numbers, st.sampled_from([1, -1]))
conventions: st.SearchStrategy[Convention] = st.sampled_from(["standard", "modified"])
tables = st.lists(rows, min_size=1, max_size=4)


def flat(matrix: Matrix) -> list[float]:
    return [entry for row in matrix for entry in row]


def test_published_point_of_a_homogeneous_transform_holds() -> None:
    T = product(trans_x(1.0), rot_z(radians(90)), trans_x(2.0), rot_z(radians(-60)), trans_z(3.0))
    assert moved_point(T, (0.5, -0.2, 0.1)) == pytest.approx((1.533012702, 2.076794919, 3.1))  # DH-1


PAIR = Row("R", 0.0, 0.4, 0.25, radians(-90))
PUBLISHED_PAIR = [
    [0.8191520443, 0.0, -0.5735764364, 0.2047880111],
    [0.5735764364, 0.0, 0.8191520443, 0.1433941091],
    [0.0, -1.0, 0.0, 0.4],
    [0.0, 0.0, 0.0, 1.0],
]


def test_published_pair_matrix_and_point_hold() -> None:
    A = chain_pose([PAIR], [radians(35)])
    assert flat(A) == pytest.approx([x for row in PUBLISHED_PAIR for x in row], abs=1e-10)  # DH-2
    there = moved_point(A, (0.1, 0.2, 0.3))
    assert there == pytest.approx((0.1146302846, 0.446497366, 0.2))  # DH-3
    assert moved_point(rigid_inverse(A), there) == pytest.approx((0.1, 0.2, 0.3))
    inverse = [[0.8191520443, 0.5735764364, 0, -0.25], [0, 0, -1, 0.4], [-0.5735764364, 0.8191520443, 0, 0]]
    assert flat(rigid_inverse(A)[:3]) == pytest.approx([x for row in inverse for x in row], abs=1e-10)


def test_published_derivatives_of_the_pair_matrix_hold() -> None:
    by_turn = velocity_matrix([PAIR], [radians(35)], 1, 1)
    published = [[-0.5735764364, 0, -0.8191520443, -0.1433941091], [0.8191520443, 0, -0.5735764364, 0.2047880111]]
    assert flat(by_turn) == pytest.approx([*published[0], *published[1], *[0.0] * 8], abs=1e-10)  # DH-5
    slide = Row("P", radians(35), 0.0, 0.25, radians(-90))
    assert flat(velocity_matrix([slide], [0.4], 1, 1)) == [0.0] * 11 + [1.0] + [0.0] * 4


def test_square_of_the_operators_is_as_published() -> None:
    turn, slide = joint_operator("R", -1), joint_operator("P")
    assert flat(product(turn, turn)) == [-1.0, 0, 0, 0, 0, -1.0, 0, 0, *[0.0] * 8]  # DH-5
    assert flat(product(slide, slide)) == [0.0] * 16


RRR = [Row("R", 0, 0.45, 0, radians(90)), Row("R", 0, 0, 0.5), Row("R", sign=-1)]  # DH-15
RRR_Q = (0.6, 0.9, 0.7)
PUBLISHED_U = {
    1: [
        [-0.5533872166, 0.1121771423, 0.8253356149, -0.175493695],
        [0.8088838517, -0.1639688743, 0.5646424734, 0.2565184227],
        [0.0, 0.0, 0.0, 0.0],
    ],
    2: [
        [-0.1639688743, -0.8088838517, 0.0, -0.3232537983],
        [-0.1121771423, -0.5533872166, 0.0, -0.2211498219],
        [0.9800665778, -0.1986693308, 0.0, 0.3108049841],
    ],
    3: [
        [0.1639688743, 0.8088838517, 0.0, 0.0],
        [0.1121771423, 0.5533872166, 0.0, 0.0],
        [-0.9800665778, 0.1986693308, 0.0, 0.0],
    ],
}
PUBLISHED_V = {
    (1, 1): [
        [-0.8088838517, 0.1639688743, -0.5646424734, -0.2565184227],
        [-0.5533872166, 0.1121771423, 0.8253356149, -0.175493695],
        [0.0, 0.0, 0.0, 0.0],
    ],
    (1, 2): [
        [0.1121771423, 0.5533872166, 0.0, 0.2211498219],
        [-0.1639688743, -0.8088838517, 0.0, -0.3232537983],
        [0.0, 0.0, 0.0, 0.0],
    ],
    (2, 2): [
        [-0.8088838517, 0.1639688743, 0.0, -0.2565184227],
        [-0.5533872166, 0.1121771423, 0.0, -0.175493695],
        [-0.1986693308, -0.9800665778, 0.0, -0.3916634548],
    ],
    (3, 3): [
        [-0.8088838517, 0.1639688743, 0.0, 0.0],
        [-0.5533872166, 0.1121771423, 0.0, 0.0],
        [-0.1986693308, -0.9800665778, 0.0, 0.0],
    ],
}


@pytest.mark.parametrize("j", [1, 2, 3])
def test_published_velocity_matrices_hold(j: int) -> None:
    found = flat(velocity_matrix(RRR, RRR_Q, 3, j)[:3])
    assert found == pytest.approx([x for row in PUBLISHED_U[j] for x in row], abs=1e-9)  # DH-6


@pytest.mark.parametrize(("j", "k"), [(1, 1), (1, 2), (2, 1), (2, 2), (3, 3)])
def test_published_acceleration_matrices_hold(j: int, k: int) -> None:
    found = flat(acceleration_matrix(RRR, RRR_Q, 3, j, k)[:3])
    assert found == pytest.approx([x for row in PUBLISHED_V[min(j, k), max(j, k)] for x in row], abs=1e-9)  # DH-7


def test_published_velocity_and_acceleration_of_the_rrr_point_hold() -> None:
    _, v, a = point_motion(RRR, RRR_Q, (0.5, -0.4, 0.3), (0.2, 0.6, -0.7), (0.4, 0.0, 0.0))
    assert v == pytest.approx((-0.02321148668, 0.4099055103, -0.3987406354))  # DH-6
    assert a == pytest.approx((-0.8230575119, -0.1355498414, 0.5945122694))  # DH-7


def test_a_later_joint_does_not_move_an_earlier_link() -> None:
    assert flat(velocity_matrix(RRR, RRR_Q, 1, 2)) == [0.0] * 16
    assert flat(acceleration_matrix(RRR, RRR_Q, 2, 1, 3)) == [0.0] * 16


@quick
@given(tables, st.data(), conventions)
def test_derivative_matrices_are_the_slopes_of_the_pose(
    table: list[Row], data: st.DataObject, convention: Convention
) -> None:
    q = data.draw(st.lists(numbers, min_size=len(table), max_size=len(table)))
    n, j = len(table), data.draw(st.integers(1, len(table)))
    h = 1e-5
    ahead, behind = ([x + s * h * (i == j - 1) for i, x in enumerate(q)] for s in (1, -1))
    slope = total([chain_pose(table, x, convention) for x in (ahead, behind)], [1 / (2 * h), -1 / (2 * h)])
    assert flat(velocity_matrix(table, q, n, j, convention)) == pytest.approx(flat(slope), abs=1e-7)
    k = data.draw(st.integers(1, n))
    slope = total([velocity_matrix(table, x, n, k, convention) for x in (ahead, behind)], [1 / (2 * h), -1 / (2 * h)])
    assert flat(acceleration_matrix(table, q, n, j, k, convention)) == pytest.approx(flat(slope), abs=1e-7)


@quick
@given(tables, st.data(), conventions)
def test_pose_times_its_inverse_is_the_identity(table: list[Row], data: st.DataObject, convention: Convention) -> None:
    q = data.draw(st.lists(numbers, min_size=len(table), max_size=len(table)))
    T = chain_pose(table, q, convention)
    assert flat(product(rigid_inverse(T), T)) == pytest.approx(flat(IDENTITY), abs=1e-12)


@pytest.mark.parametrize(
    "matrix",
    [
        ((2.0, 0, 0, 0), *IDENTITY[1:]),
        ((-1.0, 0, 0, 0), *IDENTITY[1:]),
        ((1.0, 0.1, 0, 0), *IDENTITY[1:]),
        (*IDENTITY[:3], (0.0, 0.0, 1.0, 1.0)),
    ],
    ids=["stretched", "reflected", "sheared", "perspective"],
)
def test_a_matrix_that_is_not_rigid_has_no_rigid_inverse(matrix: Matrix) -> None:
    with pytest.raises(ValueError, match="not a rigid transform"):
        rigid_inverse(matrix)


def test_elementary_turns_carry_axes_into_axes() -> None:
    assert moved_point(rot_z(radians(90)), (1, 0, 0)) == pytest.approx((0, 1, 0), abs=1e-15)
    assert moved_point(rot_x(radians(90)), (0, 1, 0)) == pytest.approx((0, 0, 1), abs=1e-15)


def test_a_frame_outside_the_chain_is_refused() -> None:
    with pytest.raises(ValueError, match=r"1 \.\. 3"):
        velocity_matrix(RRR, RRR_Q, 4, 1)
    with pytest.raises(ValueError, match=r"1 \.\. 3"):
        velocity_matrix(RRR, RRR_Q, 3, 0)
