"""Rod groups: point formulas against matrices, every inverse branch against the direct task, published numbers."""

from __future__ import annotations

from collections.abc import Mapping
from math import nan, pi

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics import rod_groups, transform
from mechanics.errors import AssemblyError, SingularError
from mechanics.vectors import Vector
from tests.depth import amount

quick = settings(max_examples=amount(13, 40), deadline=None)

LENGTHS: Mapping[str, Mapping[str, float]] = {
    "PPP": {"d": 0.15},
    "RPP": {"d": 0.12},
    "RRP": {"d": 0.1, "L1": 0.5},
    "PRR": {"L1": 0.2, "L2": 0.5, "L3": 0.4},
    "RRR": {"L1": 0.45, "L2": 0.5, "L3": 0.4},
    "PRP": {"d": 0.12},
}
PUBLISHED = [  # DH-11 to DH-16: q, M, det
    ("PPP", (0.9, 0.35, 0.25), (0.35, 0.25, 0.75), 1.0),
    ("RPP", (0.6, 0.7, 0.55), (-0.3105533604, 0.4539345882, 0.82), 0.55),
    ("RRP", (0.6, 1.1, 0.8), (0.5319718923, 0.485104384, 0.1371231029), 0.5703727104),
    ("PRR", (0.3, 0.9, 0.7), (0.4711311871, 0.9028316153, 0.3), -0.1288435374),
    ("RRR", (0.6, 0.9, 0.7), (0.5800719634, 0.3968485816, 0.9211311871), -0.09055531154),
    ("PRP", (0.4, 0.6, 0.55), (-0.3105533604, 0.4539345882, 0.52), -0.55),
]
PUBLISHED_SOLUTIONS = {  # DH-21 to DH-26
    "PPP": [(0.9, 0.35, 0.25)],
    "RPP": [(0.6, 0.7, 0.55)],
    "RRP": [(0.6, 1.1, 0.8), (-2.262892423, -1.1, 0.8)],
    "PRR": [(0.3, 0.9, 0.7), (0.3, 0.2810730075, -0.7)],
    "RRR": [
        (0.6, 0.9, 0.7),
        (0.6, 0.2810730075, -0.7),
        (-2.541592654, 2.860519646, 0.7),
        (-2.541592654, 2.241592654, -0.7),
    ],
    "PRP": [(0.4, 0.6, 0.55)],
}
PUBLISHED_T = {
    "PPP": [[0, -1, 0, 0.35], [0, 0, 1, 0.25], [-1, 0, 0, 0.9]],
    "RPP": [
        [-0.8253356149, 0, -0.5646424734, -0.3105533604],
        [-0.5646424734, 0, 0.8253356149, 0.4539345882],
        [0, 1, 0, 0.7],
    ],
    "RRP": [
        [0.3743690338, 0.7355451745, -0.5646424734, 0.5884361396],
        [0.2561196359, 0.5032135281, 0.8253356149, 0.4025708225],
        [0.8912073601, -0.4535961214, 0.0, 0.1371231029],
    ],
    "PRR": [
        [0.1986693308, -0.9800665778, 0.0, 0.3916634548],
        [0.9800665778, 0.1986693308, 0.0, 0.5108049841],
        [0.0, 0.0, 1.0, 0.3],
    ],
    "RRR": [
        [0.8088838517, -0.1639688743, 0.5646424734, 0.2565184227],
        [0.5533872166, -0.1121771423, -0.8253356149, 0.175493695],
        [0.1986693308, 0.9800665778, 0.0, 0.8416634548],
    ],
    "PRP": [
        [0.8253356149, 0, -0.5646424734, -0.3105533604],
        [0.5646424734, 0, 0.8253356149, 0.4539345882],
        [0, -1, 0, 0.4],
    ],
}
groups = st.sampled_from(sorted(LENGTHS))
variables = st.tuples(*[st.floats(-3, 3)] * 3)


@pytest.mark.parametrize(("group", "q", "M", "determinant"), PUBLISHED)
def test_published_direct_and_inverse_tasks_hold(group: str, q: Vector, M: Vector, determinant: float) -> None:
    lengths = LENGTHS[group]
    assert rod_groups.direct(group, lengths, q) == pytest.approx(M)
    assert rod_groups.determinant(group, lengths, q) == pytest.approx(determinant)
    found = rod_groups.inverse(group, lengths, M)
    assert len(found) == len(PUBLISHED_SOLUTIONS[group])
    for solution, published in zip(found, PUBLISHED_SOLUTIONS[group], strict=True):
        assert solution == pytest.approx(published, abs=1e-8)
    rows, _ = rod_groups.table(group, lengths)
    T = transform.chain_pose(rows, q)
    assert [x for row in T[:3] for x in row] == pytest.approx([x for row in PUBLISHED_T[group] for x in row], abs=1e-9)


@quick
@given(groups, variables)
def test_the_point_formula_is_the_table_multiplied_out(group: str, q: Vector) -> None:
    rows, point = rod_groups.table(group, LENGTHS[group])
    by_matrices = transform.moved_point(transform.chain_pose(rows, q), point)
    assert rod_groups.direct(group, LENGTHS[group], q) == pytest.approx(by_matrices, abs=1e-12)


@quick
@given(groups, variables)
def test_the_determinant_is_that_of_the_columns_u_r(group: str, q: Vector) -> None:
    rows, point = rod_groups.table(group, LENGTHS[group])
    (a, b, c), (d, e, f), (g, h, i) = (
        transform.moved_point(transform.velocity_matrix(rows, q, 3, j), point) for j in (1, 2, 3)
    )
    by_matrices = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    assert rod_groups.determinant(group, LENGTHS[group], q) == pytest.approx(by_matrices, abs=1e-11)


@quick
@given(groups, variables)
def test_every_branch_reproduces_the_point_and_one_is_where_it_came_from(group: str, q: Vector) -> None:
    lengths = LENGTHS[group]
    assume(abs(rod_groups.determinant(group, lengths, q)) > 1e-3)
    M = rod_groups.direct(group, lengths, q)
    found = rod_groups.inverse(group, lengths, M)
    assert len(found) == len(PUBLISHED_SOLUTIONS[group])
    assert len(set(found)) == len(found)
    for solution in found:
        assert rod_groups.direct(group, lengths, solution) == pytest.approx(M, abs=1e-12)
    if q[2] > 0 or group in ("PRR", "RRR", "PPP"):  # a slide is given positive, the angle then turned by pi
        assert any(solution == pytest.approx(q, abs=1e-9) for solution in found)


@quick
@given(st.tuples(*[st.floats(-1.5, 1.5)] * 3))
def test_a_point_of_the_rrr_arm_is_refused_exactly_when_it_is_out_of_reach(M: Vector) -> None:
    lengths = LENGTHS["RRR"]
    distance = (M[0] ** 2 + M[1] ** 2 + (M[2] - 0.45) ** 2) ** 0.5
    assume(abs(distance - 0.9) > 1e-9 and abs(distance - 0.1) > 1e-9 and abs(M[0]) > 1e-6)
    if 0.1 < distance < 0.9:
        for solution in rod_groups.inverse("RRR", lengths, M):
            assert rod_groups.direct("RRR", lengths, solution) == pytest.approx(M, abs=1e-12)
    else:
        with pytest.raises(AssemblyError, match=r"cannot reach the point at .* are missing"):
            rod_groups.inverse("RRR", lengths, M)


near_zero = st.one_of(st.just(0.0), st.floats(-17, -1).map(lambda power: 10**power))
near_singular = st.tuples(st.sampled_from([0.0, pi / 2, -pi / 2, pi]), near_zero).map(sum)


@settings(max_examples=amount(66, 200), deadline=None)
@given(groups, st.tuples(*[st.one_of(near_singular, st.floats(-3, 3))] * 3), st.floats(-4, 4), near_zero)
def test_near_a_singular_position_a_branch_is_right_or_the_task_is_refused_by_name(
    group: str, q: Vector, power: float, out: float
) -> None:
    scale = 10**power
    lengths = {name: scale * length for name, length in LENGTHS[group].items()}
    at = tuple(x if kind == "R" else scale * x for kind, x in zip(group, q, strict=True))
    x, y, z = rod_groups.direct(group, lengths, at)
    M = (x * (1 + out), y, z)
    try:
        found = rod_groups.inverse(group, lengths, M)
    except (AssemblyError, SingularError) as refusal:
        assert "missing" in str(refusal) or "arbitrary" in str(refusal)
        return
    size = max(scale, *map(abs, M))
    for solution in found:
        assert rod_groups.direct(group, lengths, solution) == pytest.approx(M, abs=1e-11 * size)


def test_branches_that_coincide_are_given_once() -> None:
    for elbow in (0.0, pi):
        M = rod_groups.direct("PRR", LENGTHS["PRR"], (0.3, 0.9, elbow))
        (solution,) = rod_groups.inverse("PRR", LENGTHS["PRR"], M)
        assert solution == pytest.approx((0.3, 0.9, elbow), abs=1e-7)
    (solution,) = rod_groups.inverse("RRP", LENGTHS["RRP"], (0.0, 0.1, 0.3))
    assert solution == pytest.approx((0.0, 0.0, 0.2))


def test_half_a_turn_is_given_as_plus_pi() -> None:
    (solution,) = rod_groups.inverse("RPP", LENGTHS["RPP"], (0.0, -0.5, 0.2))
    assert solution[0] == pi
    faces = {q[0] for q in rod_groups.inverse("RRR", LENGTHS["RRR"], (0.6, 0.0, 0.5))}
    assert faces == {0.0, pi}


@pytest.mark.parametrize(
    ("group", "lengths", "M", "joint"),
    [
        ("RPP", LENGTHS["RPP"], (0.0, 0.0, 1.0), "1"),
        ("PRP", LENGTHS["PRP"], (0.0, 0.0, 1.0), "2"),
        ("RRP", {"d": 0.0, "L1": 0.5}, (0.0, 0.0, 1.0), "1"),
        ("RRP", {"d": 0.1, "L1": 0.5}, (0.0, 0.1, 0.5), "2"),
        ("RRR", LENGTHS["RRR"], (0.0, 0.0, 0.9), "1"),
        ("PRR", {"L1": 0.2, "L2": 0.5, "L3": 0.5}, (0.0, 0.2, 0.0), "2"),
    ],
)
def test_an_arbitrary_joint_is_named(group: str, lengths: Mapping[str, float], M: Vector, joint: str) -> None:
    with pytest.raises(SingularError, match=f"joint {joint} is arbitrary"):
        rod_groups.inverse(group, lengths, M)


def test_a_point_too_near_the_axis_of_the_rrp_group_is_refused() -> None:
    with pytest.raises(AssemblyError, match=r"0\.05 m are missing"):
        rod_groups.inverse("RRP", LENGTHS["RRP"], (0.05, 0.0, 0.3))


@pytest.mark.parametrize(
    ("group", "lengths", "q", "message"),
    [
        ("RRH", {}, (0, 0, 0), "group 'RRH' must be one of"),
        ("RRR", {"L1": 0.1, "L2": 0.1}, (0, 0, 0), "L1, L2, L3, not L1, L2"),
        ("PPP", {}, (0, 0, 0), "not none"),
        ("RRR", {"L1": 0.1, "L2": 0.0, "L3": 0.1}, (0, 0, 0), "L2"),
        ("PPP", {"d": nan}, (0, 0, 0), "d = nan"),
        ("PPP", {"d": 0.1}, (0, 0), "3 values, not 2"),
        ("PPP", {"d": 0.1}, (0, 0, nan), "must be finite"),
    ],
)
def test_what_is_no_group_is_refused(group: str, lengths: dict[str, float], q: Vector, message: str) -> None:
    for task in (rod_groups.direct, rod_groups.determinant, rod_groups.inverse):
        with pytest.raises(ValueError, match=message):
            task(group, lengths, q)
