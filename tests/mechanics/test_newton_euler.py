"""Drives by recursion in base axes against link frames, Lagrange in U and V, energy and power."""

from __future__ import annotations

from dataclasses import replace
from math import inf, nan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics import chain, lagrange, link_frames, newton_euler
from mechanics.chain import Chain
from mechanics.dh import Convention, Row
from mechanics.links import LinkMass, ToolLoad
from mechanics.vectors import Vector, add, dot, scaled, subtract, times
from tests.depth import amount
from tests.mechanics.chains import Moving, conventions, diagonal, moving, vectors

quick = settings(max_examples=amount(8, 25), deadline=None)
G: Vector = (1.5, -2.0, -9.81)  # leaning, so that no axis is spared


def torques(drawn: Moving, convention: Convention = "standard", gravity: Vector = G) -> tuple[float, ...]:
    table = Chain(drawn.rows, convention)
    return newton_euler.solve(table, drawn.masses, drawn.q, drawn.qd, drawn.qdd, gravity).tau


@quick
@given(moving(), conventions)
def test_newton_and_euler_agree_with_lagrange(drawn: Moving, convention: Convention) -> None:
    by_energy = lagrange.torques(drawn.rows, drawn.masses, drawn.q, drawn.qd, drawn.qdd, G, convention)
    assert torques(drawn, convention) == pytest.approx(by_energy, rel=1e-9, abs=1e-8)


@quick
@given(moving(), vectors, vectors)
def test_link_frames_give_the_same_drives_and_the_same_reactions(drawn: Moving, force: Vector, moment: Vector) -> None:
    table, damping = Chain(drawn.rows), [0.3] * len(drawn.rows)
    frames = chain.frames(table, drawn.q)
    in_last = ToolLoad(force, moment)
    in_base = ToolLoad(chain.turned(frames[-1], force), chain.turned(frames[-1], moment))
    state = drawn.masses, drawn.q, drawn.qd, drawn.qdd, G, damping
    base, local = newton_euler.solve(table, *state, in_base), link_frames.drives(drawn.rows, *state, in_last)
    assert base.tau == pytest.approx(local.tau, rel=1e-9, abs=1e-8)
    for actions, local_actions in ((base.forces, local.forces), (base.moments, local.moments)):
        for at, action, local_action in zip(frames, actions, local_actions, strict=True):
            assert action == pytest.approx(chain.turned(at, local_action), rel=1e-9, abs=1e-8)


@quick
@given(moving(), conventions)
def test_motion_in_link_frames_is_that_in_base_axes(drawn: Moving, convention: Convention) -> None:
    table = Chain(drawn.rows, convention)
    state = drawn.q, drawn.qd, drawn.qdd
    pairs = zip(
        chain.frames(table, drawn.q),
        chain.link_motions(table, *state),
        link_frames.motions(drawn.rows, *state, convention),
        strict=True,
    )
    for at, base, local in pairs:
        for name in ("omega", "epsilon", "v", "a"):
            turned = chain.turned(at, getattr(local, name))
            assert getattr(base, name) == pytest.approx(turned, rel=1e-9, abs=1e-8)


@quick
@given(moving(), conventions)
def test_mass_matrix_is_symmetric_and_gives_the_kinetic_energy(drawn: Moving, convention: Convention) -> None:
    M = newton_euler.mass_matrix(Chain(drawn.rows, convention), drawn.masses, drawn.q)
    assert tuple(zip(*M, strict=True)) == M
    by_energy = lagrange.mass_matrix(drawn.rows, drawn.masses, drawn.q, convention)
    for row, other in zip(M, by_energy, strict=True):
        assert row == pytest.approx(other, rel=1e-9, abs=1e-9)
    momentum = [sum(m * w for m, w in zip(row, drawn.qd, strict=True)) for row in M]
    doubled = sum(w * p for w, p in zip(drawn.qd, momentum, strict=True))
    assert doubled / 2 == pytest.approx(kinetic_energy(drawn, convention), rel=1e-9, abs=1e-12)


def kinetic_energy(drawn: Moving, convention: Convention) -> float:
    table, energy = Chain(drawn.rows, convention), 0.0
    motions = chain.link_motions(table, drawn.q, drawn.qd, drawn.qdd)
    for at, motion, link in zip(chain.frames(table, drawn.q), motions, drawn.masses, strict=True):
        v, _ = motion.point(chain.turned(at, link.centre))
        local = tuple(dot(at[3 * k : 3 * k + 3], motion.omega) for k in range(3))
        energy += link.mass * dot(v, v) / 2 + dot(local, times(link.inertia, local)) / 2  # type: ignore[arg-type]
    return energy


def potential_energy(drawn: Moving, convention: Convention) -> float:
    frames = chain.frames(Chain(drawn.rows, convention), drawn.q)
    places = [add(at[9:], chain.turned(at, link.centre)) for at, link in zip(frames, drawn.masses, strict=True)]
    return -sum(link.mass * dot(G, place) for link, place in zip(drawn.masses, places, strict=True))


@quick
@given(moving(), conventions)
def test_accelerations_and_weights_enter_through_mass_matrix_and_gravity(drawn: Moving, convention: Convention) -> None:
    table, rest = Chain(drawn.rows, convention), (0.0,) * len(drawn.q)
    held = newton_euler.gravity_torques(table, drawn.masses, drawn.q, G)
    assert held == pytest.approx(torques(replace(drawn, qd=rest, qdd=rest), convention), rel=1e-9, abs=1e-9)
    M = newton_euler.mass_matrix(table, drawn.masses, drawn.q)
    started = torques(replace(drawn, qd=rest), convention)
    inertia = [sum(m * e for m, e in zip(row, drawn.qdd, strict=True)) for row in M]
    assert started == pytest.approx([i + g for i, g in zip(inertia, held, strict=True)], rel=1e-9, abs=1e-8)


@quick
@given(moving(most=3), conventions)
def test_power_of_the_drives_is_the_rate_of_the_energy(drawn: Moving, convention: Convention) -> None:
    power = sum(t * w for t, w in zip(torques(drawn, convention), drawn.qd, strict=True))
    h = 1e-5
    before, after = (
        kinetic_energy(there, convention) + potential_energy(there, convention)
        for there in (drawn.after(-h), drawn.after(h))
    )
    assert power == pytest.approx((after - before) / (2 * h), rel=1e-5, abs=1e-3)


@quick
@given(moving(), conventions, vectors, vectors)
def test_a_tool_load_reaches_the_drives_through_the_jacobian(
    drawn: Moving, convention: Convention, force: Vector, moment: Vector
) -> None:
    table = Chain(drawn.rows, convention)
    state = drawn.masses, drawn.q, drawn.qd, drawn.qdd, G
    free, loaded = newton_euler.solve(table, *state), newton_euler.solve(table, *state, tool=ToolLoad(force, moment))
    columns = zip(*chain.jacobian(table, drawn.q), strict=True)
    shares = [sum(j * f for j, f in zip(column, (*force, *moment), strict=True)) for column in columns]
    assert loaded.tau == pytest.approx([t + s for t, s in zip(free.tau, shares, strict=True)], rel=1e-9, abs=1e-8)


@quick
@given(moving())
def test_the_base_carries_the_momentum_of_the_whole_chain(drawn: Moving) -> None:
    found = newton_euler.solve(Chain(drawn.rows), drawn.masses, drawn.q, drawn.qd, drawn.qdd, G)
    h, whole = 1e-4, (0.0, 0.0, 0.0)
    frames = [chain.frames(Chain(drawn.rows), drawn.after(time).q) for time in (-h, 0, h)]
    for i, link in enumerate(drawn.masses):
        before, here, after = (add(at[i][9:], chain.turned(at[i], link.centre)) for at in frames)
        bend = scaled(1 / h**2, subtract(add(before, after), scaled(2, here)))
        whole = add(whole, scaled(link.mass, subtract(bend, G)))
    assert found.forces[0] == pytest.approx(whole, rel=1e-4, abs=1e-2)


def test_a_lift_carries_weight_and_inertia() -> None:
    lift = Chain((Row("P"),))
    load = LinkMass(3.0, (0.2, 0.0, 0.0), diagonal(0.1, 0.1, 0.1))
    found = newton_euler.solve(lift, [load], [0.5], [2.0], [1.19], friction=[10.0])
    assert found.tau == pytest.approx([3.0 * (9.81 + 1.19) + 20.0])
    assert found.moments[0] == pytest.approx((0.0, -0.2 * 33.0, 0.0))


ARM = Chain((Row("R"), Row("R")))
LINK = LinkMass(1.0, (0.0, 0.0, 0.0), diagonal(0.1, 0.1, 0.1))
STATE = (0.1, 0.2), (0.0, 0.0), (0.0, 0.0)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"masses": [LINK]}, "1 masses for 2 links"),
        ({"q": (0.1,)}, "q has 1 values for 2 joints"),
        ({"qd": (nan, 0.0)}, r"qd\[0\]"),
        ({"qdd": (0.0, 0.0, 0.0)}, "qdd has 3"),
        ({"gravity": (0.0, -9.81)}, "gravity has 2 components"),
        ({"gravity": (0.0, 0.0, inf)}, "gravity z = inf"),
        ({"friction": (0.1,)}, "friction has 1"),
    ],
)
def test_what_does_not_fit_the_chain_is_refused_by_name(changes: dict[str, object], message: str) -> None:
    values = {"masses": [LINK, LINK], "q": STATE[0], "qd": STATE[1], "qdd": STATE[2], "gravity": G} | changes
    with pytest.raises(ValueError, match=message):
        newton_euler.solve(ARM, **values)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=message):
        link_frames.drives(ARM.rows, **values)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"mass": -1.0}, "mass = -1.0 kg"),
        ({"mass": nan}, "mass = nan"),
        ({"centre": (0.0, 0.0)}, "centre of mass has 2 components"),
        ({"centre": (0.0, inf, 0.0)}, "centre of mass y = inf m"),
        ({"inertia": diagonal(1, 1, 1)[:2]}, "3 rows of 3"),
        ({"inertia": ((1, 0), (0, 1), (0, 0))}, "3 rows of 3"),
        ({"inertia": diagonal(1, nan, 1)}, "inertia = nan"),
        ({"inertia": ((1, 0.5, 0), (0, 1, 0), (0, 0, 1))}, "symmetric"),
        ({"inertia": diagonal(1, 1, -1)}, "no negative moment"),
        ({"inertia": ((1, 2, 0), (2, 1, 0), (0, 0, 1))}, "no negative moment"),
        ({"inertia": ((1, -0.9, -0.9), (-0.9, 1, -0.9), (-0.9, -0.9, 1))}, "no negative moment"),
    ],
)
def test_a_link_that_is_no_body_is_refused(changes: dict[str, object], message: str) -> None:
    values = {"mass": 1.0, "centre": (0.0, 0.0, 0.0), "inertia": diagonal(1, 1, 1)} | changes
    with pytest.raises(ValueError, match=message):
        LinkMass(**values)  # type: ignore[arg-type]


@given(st.floats(0.001, 100))
def test_a_body_may_be_flat_or_a_point(size: float) -> None:
    for tensor in (diagonal(0, 0, 0), diagonal(size, size, 2 * size), diagonal(0, size, size)):
        assert LinkMass(0.0, (0.0, 0.0, 0.0), tensor).inertia == tensor


def test_a_load_of_the_tool_is_three_finite_numbers() -> None:
    with pytest.raises(ValueError, match="tool force z = inf N must be finite"):
        ToolLoad(force=(0.0, 0.0, inf))
    with pytest.raises(ValueError, match="tool moment x = nan N m must be finite"):
        ToolLoad(moment=(nan, 0.0, 0.0))
