"""Serial chains: closed pair matrices and recursion against products of elementary matrices, U and V, differences."""

from __future__ import annotations

from math import nan, pi, radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import chain, transform
from mechanics.chain import Chain, ChainMotion, pair_matrix
from mechanics.dh import Convention, Row
from mechanics.vectors import Matrix, Vector
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

numbers = st.floats(-4, 4)
rows = st.builds(Row, st.sampled_from(["R", "P"]), numbers, numbers, numbers, numbers, st.sampled_from([1, -1]))
conventions: st.SearchStrategy[Convention] = st.sampled_from(["standard", "modified"])


@st.composite
def moving_chains(draw: st.DrawFn, most: int = 6) -> tuple[tuple[Row, ...], list[list[float]], Vector]:
    table = tuple(draw(st.lists(rows, min_size=1, max_size=most)))
    variables = st.lists(numbers, min_size=len(table), max_size=len(table))
    return table, [draw(variables) for _ in range(3)], draw(st.tuples(numbers, numbers, numbers))


def flat(matrix: Matrix) -> list[float]:
    return [entry for row in matrix for entry in row]


@quick
@given(moving_chains(), conventions)
def test_pose_is_the_product_of_elementary_matrices(
    drawn: tuple[tuple[Row, ...], list[list[float]], Vector], convention: Convention
) -> None:
    table, (q, _, _), _ = drawn
    by_elements = transform.chain_pose(table, q, convention)
    assert flat(chain.pose(Chain(table, convention), q)) == pytest.approx(flat(by_elements), abs=1e-11)
    pairs = [pair_matrix(*row.moved(x), row.a, row.alpha, convention) for row, x in zip(table, q, strict=True)]
    assert flat(transform.product(*pairs)) == pytest.approx(flat(by_elements), abs=1e-11)


@quick
@given(moving_chains(most=5), conventions)
def test_recursion_agrees_with_the_matrices_u_and_v(
    drawn: tuple[tuple[Row, ...], list[list[float]], Vector], convention: Convention
) -> None:
    table, (q, qd, qdd), point = drawn
    found = chain.solve(Chain(table, convention), q, qd, qdd, point)
    p, v, a = transform.point_motion(table, q, qd, qdd, point, convention)
    assert found.p == pytest.approx(p, abs=1e-10)
    assert found.v == pytest.approx(v, rel=1e-9, abs=1e-9)
    assert found.a == pytest.approx(a, rel=1e-9, abs=1e-8)


def _moved(
    table: tuple[Row, ...], convention: Convention, state: list[list[float]], time: float, r: Vector
) -> ChainMotion:
    q, qd, qdd = state
    rates = [w + e * time for w, e in zip(qd, qdd, strict=True)]
    places = [x + w * time + e * time**2 / 2 for x, w, e in zip(q, qd, qdd, strict=True)]
    return chain.solve(Chain(table, convention), places, rates, qdd, r)


@quick
@given(moving_chains(most=4), conventions)
def test_rates_are_the_slopes_of_positions_and_rates(
    drawn: tuple[tuple[Row, ...], list[list[float]], Vector], convention: Convention
) -> None:
    table, state, point = drawn
    h = 1e-6
    before, now, after = (_moved(table, convention, state, k * h, point) for k in (-1, 0, 1))
    for earlier, slope, later in (
        (before.p, now.v, after.p),
        (before.v, now.a, after.v),
        (before.omega, now.epsilon, after.omega),
    ):
        assert slope == pytest.approx(
            [(y - x) / (2 * h) for x, y in zip(earlier, later, strict=True)], rel=1e-5, abs=1e-3
        )


@quick
@given(moving_chains(), conventions)
def test_jacobian_times_joint_rates_is_the_motion_of_the_last_origin(
    drawn: tuple[tuple[Row, ...], list[list[float]], Vector], convention: Convention
) -> None:
    table, (q, qd, _), _ = drawn
    found = chain.solve(Chain(table, convention), q, qd)
    product = [sum(entry * rate for entry, rate in zip(row, qd, strict=True)) for row in found.J]
    assert [*found.v, *found.omega] == pytest.approx(product, abs=1e-9)
    assert chain.jacobian(Chain(table, convention), q) == found.J


def test_published_pair_matrix_holds() -> None:
    published = [
        [0.8191520443, -3.512142734e-17, -0.5735764364, 0.2047880111],
        [0.5735764364, 5.015859645e-17, 0.8191520443, 0.1433941091],
        [0.0, -1.0, 6.123233996e-17, 0.4],
        [0.0, 0.0, 0.0, 1.0],
    ]
    found = pair_matrix(theta=radians(35), d=0.4, a=0.25, alpha=radians(-90))
    assert flat(found) == pytest.approx([x for row in published for x in row], rel=1e-9, abs=1e-17)  # DH-2
    assert transform.moved_point(found, (0.1, 0.2, 0.3)) == pytest.approx((0.1146302846, 0.446497366, 0.2))  # DH-3


RRP = Chain((Row("R", 0, 0.5, 0, pi / 2), Row("R", 0, 0, 0, pi / 2), Row("P", 0, 0, 0, pi / 2)))  # DH-13
STATE = (0.6, 1.1, 0.8), (0.5, -0.4, 0.3), (0.2, 0.6, -0.7)


def test_published_recursion_in_base_axes_holds() -> None:
    origin, point = chain.solve(RRP, *STATE), chain.solve(RRP, *STATE, (0.0, 0.0, 0.1))
    assert origin.omega == pytest.approx((-0.2258569894, 0.330134246, 0.5))  # DH-8
    assert origin.epsilon == pytest.approx((0.1737183611, -0.6081298636, 0.2))
    assert origin.v == pytest.approx((-0.1004199497, 0.3632238447, -0.4212651916))
    assert origin.a == pytest.approx((-0.8158118107, -0.2372821048, 0.589467355))
    assert point.v == pytest.approx((-0.1416867304, 0.3349917211, -0.4212651916))
    assert point.a == pytest.approx((-0.8182024612, -0.2692083446, 0.589467355))


def test_published_recursion_in_link_axes_is_the_same_vectors() -> None:
    found = chain.solve(RRP, *STATE)
    axes = [column[:3] for column in list(zip(*found.T, strict=True))[:3]]

    def in_link(vector: Vector) -> list[float]:
        return [sum(a * b for a, b in zip(axis, vector, strict=True)) for axis in axes]

    assert in_link(found.omega) == pytest.approx([0.44560368, -0.2267980607, 0.4])  # DH-9
    assert in_link(found.epsilon) == pytest.approx([0.08752224773, -0.2689606963, -0.6])
    assert in_link(found.v) == pytest.approx([-0.32, 0.3, 0.356482944])
    assert in_link(found.a) == pytest.approx([0.1591503596, -0.9868501117, 0.2648046268])


def test_the_example_of_the_command_line_moves_as_a_turning_slide() -> None:
    arm = Chain((Row("R", 0, 0.4, 0, pi / 2), Row("P", 0, 0.1, 0.2, 0)))
    found = chain.solve(arm, (0.0, 0.2), (1.0, 0.1), tool_point=(0.05, 0.0, 0.0))
    assert found.p == pytest.approx((0.25, -0.3, 0.4))
    assert found.v == pytest.approx((0.3, 0.25 - 0.1, 0.0))
    assert found.a == pytest.approx((-0.25 + 0.2, 0.3, 0.0))
    assert flat(found.J) == pytest.approx([0.3, 0, 0.2, -1, 0, 0, 0, 0, 0, 0, 1, 0], abs=1e-15)


def test_rates_left_out_are_zero() -> None:
    assert chain.solve(RRP, STATE[0]).v == (0, 0, 0)
    assert chain.solve(RRP, STATE[0], STATE[1]) == chain.solve(RRP, *STATE[:2], (0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (((0.1, 0.2),), "q has 2 values for 3 joints"),
        (((0.1, nan, 0.2),), r"q\[1\]"),
        ((STATE[0], (1.0,)), "qd has 1 values"),
        ((STATE[0], STATE[1], (1.0, 2.0, nan)), r"qdd\[2\]"),
        ((*STATE, (0.0, 0.0)), "tool_point has 2"),
        ((*STATE, (0.0, 0.0, nan)), "tool_point"),
    ],
)
def test_vectors_that_do_not_fit_are_refused_by_name(values: tuple[tuple[float, ...], ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        chain.solve(RRP, *values)  # type: ignore[arg-type]


def test_a_pose_needs_as_many_variables_as_joints() -> None:
    with pytest.raises(ValueError, match="q has 2 values for 3 joints"):
        chain.pose(RRP, (0.1, 0.2))
