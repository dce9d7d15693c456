"""The graphical methods: each against the coupler of a four-bar moved as bodies, and against one another."""

from __future__ import annotations

from math import atan2, dist, hypot, inf, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import acceleration, instant_centre, rotated_velocities, velocity, velocity_plan
from mechanics.drawing import Line, Point
from mechanics.errors import SingularError
from mechanics.newton_linkages import four_bar_motion
from mechanics.planar import Marker, Motion
from tests.depth import amount

quick = settings(max_examples=amount(8, 25), deadline=None)
BARS = (0.1, 0.26, 0.22, 0.3)
A, B, V_A = (0.0, 0.0), (0.4, 0.3), (2.0, 0.5)
V_B = velocity.decompose(A, B, V_A, 9.1).v_B
coordinates = st.floats(-1, 1)
vectors = st.tuples(coordinates, coordinates)


def coupler(angle: float = 1.0) -> tuple[Motion, dict[str, Marker]]:
    """Move a four-bar and mark joints B and C of its coupler and a point P beside."""
    markers = {"B": Marker(2), "C": Marker(2, BARS[1]), "P": Marker(2, 0.1, 0.07)}
    return four_bar_motion(*BARS, angle, 12.0, -8.0), markers


def moving(angle: float = 1.0) -> tuple[dict[str, Point], dict[str, Point], dict[str, Point], float, float]:
    """Give places, velocities, accelerations of the coupler's points, its omega and epsilon."""
    motion, markers = coupler(angle)
    found = {name: motion.point(marker) for name, marker in markers.items()}
    parts = [{name: one[k] for name, one in found.items()} for k in range(3)]
    return parts[0], parts[1], parts[2], motion.rates[2][2], motion.accelerations[2][2]


@pytest.mark.parametrize("angle", [0.4, 2.0, 4.0, 5.5])
def test_every_method_gives_the_velocity_that_the_bodies_have(angle: float) -> None:
    place, v, _, omega, _ = moving(angle)
    direction = atan2(v["C"][1], v["C"][0])
    projected = velocity.project(place["B"], place["C"], v["B"], direction)
    assert projected.v_B == pytest.approx(v["C"])
    assert projected.speed > 0 and projected.omega == pytest.approx(omega)
    assert velocity.decompose(place["B"], place["C"], v["B"], omega).v_B == pytest.approx(v["C"])
    turning = instant_centre.of_velocities(place["B"], place["C"], v["B"], v["C"])
    assert turning.omega == pytest.approx(omega)
    assert turning.velocity(place["P"]) == pytest.approx(v["P"])
    plan = velocity_plan.of_link(place, "B", "C", (v["B"], v["C"]))
    assert plan.vectors["P"] == pytest.approx(v["P"])
    assert rotated_velocities.by_parallel(place["B"], place["C"], v["B"], direction, 0.02) == pytest.approx(v["C"])


@pytest.mark.parametrize("angle", [0.4, 2.0, 4.0, 5.5])
def test_decomposition_plan_and_centre_give_the_acceleration_that_the_bodies_have(angle: float) -> None:
    place, _, a, omega, epsilon = moving(angle)
    found = acceleration.decompose(place["B"], place["P"], a["B"], omega, epsilon)
    assert found.a_B == pytest.approx(a["P"])
    plan = velocity_plan.of_accelerations(place, "B", a["B"], omega, epsilon)
    for name, vector in a.items():
        assert plan.vectors[name] == pytest.approx(vector)
    centre = acceleration.centre(place["B"], a["B"], omega, epsilon)
    still = acceleration.decompose(place["B"], centre.Q, a["B"], omega, epsilon).a_B
    assert still == pytest.approx((0, 0), abs=1e-12)
    ray = atan2(centre.Q[1] - place["P"][1], centre.Q[0] - place["P"][0])
    turned = ray - atan2(a["P"][1], a["P"][0]) - centre.angle
    assert (turned + pi) % (2 * pi) - pi == pytest.approx(0, abs=1e-12)


def test_the_instant_centre_of_the_coupler_is_where_crank_and_rocker_meet() -> None:
    place, v, _, _, _ = moving()
    turning = instant_centre.of_velocities(place["B"], place["C"], v["B"], v["C"])
    assert turning.S is not None
    for pivot, joint in (((0.0, 0.0), place["B"]), ((BARS[3], 0.0), place["C"])):
        across = (joint[0] - pivot[0]) * (turning.S[1] - pivot[1]) - (joint[1] - pivot[1]) * (turning.S[0] - pivot[0])
        assert across == pytest.approx(0, abs=1e-12)
    directions = [atan2(v[name][1], v[name][0]) for name in "BC"]
    assert instant_centre.of_directions(place["B"], place["C"], *directions) == pytest.approx(turning.S)


@quick
@given(first=vectors, second=vectors, v=vectors, omega=st.floats(-20, 20))
def test_a_rigid_link_keeps_its_projections_and_turns_about_its_centre(
    first: Point, second: Point, v: Point, omega: float
) -> None:
    if dist(first, second) < 0.05:
        return
    v_B = velocity.decompose(first, second, v, omega).v_B
    turning = instant_centre.of_velocities(first, second, v, v_B)
    assert turning.omega == pytest.approx(omega, abs=1e-9)
    assert turning.velocity(second) == pytest.approx(v_B, abs=1e-9)
    rotated = rotated_velocities.rotate(first, second, v, v_B, 0.03)
    (ax, ay), (bx, by) = rotated.ends["A"], rotated.ends["B"]
    dx, dy = second[0] - first[0], second[1] - first[1]
    assert (bx - ax, by - ay) == pytest.approx((rotated.ratio * dx, rotated.ratio * dy), abs=1e-9)
    assert rotated.ratio == pytest.approx(1 - 0.03 * omega)


def test_the_plan_is_similar_to_the_link_and_turned_by_a_right_angle() -> None:
    place, v, _, omega, _ = moving()
    plan = velocity_plan.of_link(place, "B", "C", (v["B"], v["C"]))
    for one, other in (("C", "B"), ("P", "B"), ("P", "C")):
        dx, dy = place[one][0] - place[other][0], place[one][1] - place[other][1]
        assert plan.relative(one, other) == pytest.approx((-omega * dy, omega * dx))
        assert plan.drawn(one, other, 5.0) == pytest.approx(abs(omega) * hypot(dx, dy) / 5.0)


def test_the_scale_of_the_mechanism_changes_nothing_in_the_plan() -> None:
    place, v, _, _, _ = moving()
    large = {name: (10 * x, 10 * y) for name, (x, y) in place.items()}
    one, other = (velocity_plan.of_link(points, "B", "C", (v["B"], v["C"])) for points in (place, large))
    assert one.vectors["P"] == pytest.approx(other.vectors["P"])


def test_plans_of_links_join_at_the_pole_where_shared_points_agree() -> None:
    crank = velocity_plan.Plan({"A": (0.0, 0.0), "B": (1.0, 2.0)})
    rod = velocity_plan.Plan({"B": (1.0, 2.0), "C": (3.0, 0.0)})
    assert velocity_plan.joined(crank, rod).vectors == {"A": (0.0, 0.0), "B": (1.0, 2.0), "C": (3.0, 0.0)}
    with pytest.raises(ValueError, match="point B moves"):
        velocity_plan.joined(crank, velocity_plan.Plan({"B": (1.0, 2.1)}))


def test_a_link_in_translation_has_no_centre() -> None:
    turning = instant_centre.of_velocities(A, B, V_A, V_A)
    assert turning.S is None and turning.omega == 0
    assert turning.velocity((5.0, -3.0)) == V_A
    assert rotated_velocities.rotate(A, B, V_A, V_A, 0.1).S is None
    with pytest.raises(SingularError, match="pure translation"):
        acceleration.centre(A, (1.0, 2.0), 0.0, 0.0)


def test_the_drawings_carry_vectors_in_their_scale_and_normals_to_the_centre() -> None:
    turning = instant_centre.of_velocities(A, B, V_A, V_B)
    drawn = turning.drawing(0.1)
    assert turning.S is not None and drawn.points["S"] == turning.S
    assert drawn.arrows[0].head == pytest.approx((0.2, 0.05))
    assert drawn.lines == (Line("normal at A", A, turning.S), Line("normal at B", B, turning.S))
    assert "S" not in instant_centre.of_velocities(A, B, V_A, V_A).drawing(0.1).points


def test_the_drawing_of_a_projection_has_equal_shadows_on_the_link() -> None:
    drawn = velocity.project(A, B, V_A, 1.75).drawing(0.1)
    shadows = [one for one in drawn.arrows if one.name.endswith("on AB")]
    lengths = [dist(one.tail, one.head) for one in shadows]
    assert lengths[0] == pytest.approx(lengths[1]) == pytest.approx(0.1 * abs(2.0 * 0.8 + 0.5 * 0.6))
    for normal, shadow in zip(drawn.lines, shadows, strict=True):
        dot = (normal.end[0] - normal.start[0]) * (shadow.head[0] - shadow.tail[0])
        dot += (normal.end[1] - normal.start[1]) * (shadow.head[1] - shadow.tail[1])
        assert dot == pytest.approx(0, abs=1e-12)


def test_the_drawings_of_decompositions_are_closed_head_to_tail() -> None:
    velocities = velocity.decompose(A, B, V_A, 4.0).drawing(0.1)
    assert velocities.arrows[2].tail == velocities.arrows[1].head
    assert velocities.arrows[2].head == pytest.approx(velocities.arrows[3].head)
    accelerations = acceleration.decompose(A, B, (1.0, -2.0), 4.0, -3.0).drawing(0.01)
    assert accelerations.arrows[3].head == pytest.approx(accelerations.arrows[4].head)
    assert [one.name for one in accelerations.arrows[2:4]] == ["a_BA normal", "a_BA tangential"]


def test_the_drawing_of_a_plan_starts_at_the_pole_and_names_the_ends() -> None:
    drawn = velocity_plan.Plan({"A": (1.0, 0.0), "B": (0.0, 2.0)}).drawing(10.0)
    assert drawn.points == {"O": (0.0, 0.0), "a": (0.1, 0.0), "b": (0.0, 0.2)}
    assert [one.name for one in drawn.arrows] == ["v_A", "v_B"]
    assert drawn.lines == (Line("ab", (0.1, 0.0), (0.0, 0.2)),)


def test_the_drawing_of_rotated_velocities_is_parallel_to_the_link() -> None:
    drawn = rotated_velocities.rotate(A, B, V_A, V_B, 0.05).drawing()
    (side,) = drawn.lines
    cross = (side.end[0] - side.start[0]) * 0.3 - (side.end[1] - side.start[1]) * 0.4
    assert cross == pytest.approx(0, abs=1e-12)
    assert drawn.arrows[0].head == pytest.approx((-0.05 * 0.5, 0.05 * 2.0))


def test_a_direction_perpendicular_to_the_link_gives_nothing() -> None:
    across = atan2(0.4, -0.3)
    with pytest.raises(SingularError, match="perpendicular to AB"):
        velocity.project(A, B, V_A, across)
    with pytest.raises(SingularError, match="does not cut the parallel"):
        rotated_velocities.by_parallel(A, B, V_A, across, 0.1)
    with pytest.raises(SingularError, match="parallel"):
        instant_centre.of_directions(A, B, 0.3, 0.3 + pi)


def test_velocities_that_stretch_the_link_are_refused_with_the_difference() -> None:
    with pytest.raises(ValueError, match=r"differ by -1\.9 m/s: a rigid link does not stretch"):
        instant_centre.of_velocities(A, B, V_A, (0.0, 0.0))


def test_points_that_coincide_and_names_that_are_unknown_are_refused() -> None:
    with pytest.raises(ValueError, match="one point"):
        velocity.project(A, A, V_A, 1.0)
    with pytest.raises(ValueError, match="one point"):
        velocity_plan.similarity(A, A, B)
    with pytest.raises(ValueError, match="no point 'C'"):
        velocity_plan.of_link({"A": A, "B": B}, "A", "C", (V_A, V_B))
    with pytest.raises(ValueError, match="no point 'C'"):
        velocity_plan.of_accelerations({"A": A, "B": B}, "C", V_A, 1.0, 1.0)


def test_values_that_are_not_finite_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match="v_A x"):
        velocity.decompose(A, B, (nan, 0.0), 1.0)
    with pytest.raises(ValueError, match="omega"):
        acceleration.decompose(A, B, V_A, inf, 1.0)
    with pytest.raises(ValueError, match="beta"):
        instant_centre.of_directions(A, B, 0.0, nan)
    with pytest.raises(ValueError, match="scale"):
        rotated_velocities.rotate(A, B, V_A, V_B, 0.0)
    with pytest.raises(ValueError, match="scale mu"):
        velocity_plan.Plan({"A": A}).drawing(-1.0)
