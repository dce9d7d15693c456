"""Open chains of any word: against Newton's method, differences, the Jacobian, and known places."""

from __future__ import annotations

from itertools import product
from math import inf, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.manipulator import Angles, jacobian, solve
from mechanics.newton_linkages import manipulator_motion
from mechanics.planar import Marker
from tests.depth import amount
from tests.mechanics.motions import moved_apart, off_slopes

values = st.floats(-2, 2)


@st.composite
def chains(draw: st.DrawFn) -> tuple[str, list[float], list[float], list[float], list[float], float, bool]:
    word = draw(st.text("RP", min_size=1, max_size=5))
    q, qd, qdd = (draw(st.lists(values, min_size=len(word), max_size=len(word))) for _ in range(3))
    lengths = draw(st.lists(st.floats(0, 1), min_size=word.count("R"), max_size=word.count("R")))
    return word, q, qd, qdd, lengths, draw(values), draw(st.booleans())


@settings(max_examples=amount(10, 30), deadline=None)
@given(chain=chains())
def test_closed_form_agrees_with_newton(
    chain: tuple[str, list[float], list[float], list[float], list[float], float, bool],
) -> None:
    word, q, qd, qdd, lengths, delta, absolute = chain
    closed = solve(word, q, lengths, qd, qdd, delta, "absolute" if absolute else "relative")
    newton = manipulator_motion(word, q, qd, qdd, lengths, delta, absolute)
    assert moved_apart(closed, "p", newton, Marker(len(word) + 1)) == []


@pytest.mark.parametrize("angles", ["relative", "absolute"])
@pytest.mark.parametrize("word", ["".join(letters) for letters in product("RP", repeat=3)])
def test_every_word_of_three_has_rates_that_are_slopes_and_the_jacobian_times_the_rates(
    word: str, angles: Angles
) -> None:
    q, qd, qdd, lengths = (0.4, 0.7, -0.9), (0.8, -0.5, 0.3), (0.3, 0.4, -0.2), (0.5, 0.4, 0.3)[: word.count("R")]

    def at(t: float) -> list[float]:
        return [x + v * t + a * t * t / 2 for x, v, a in zip(q, qd, qdd, strict=True)]

    def motion(t: float) -> list[float]:
        return [v + a * t for v, a in zip(qd, qdd, strict=True)]

    assert off_slopes(lambda t: solve(word, at(t), lengths, motion(t), qdd, 0.6, angles)) == []
    found = solve(word, q, lengths, qd, delta=0.6, angles=angles)
    for row, name in zip(jacobian(word, q, lengths, 0.6, angles), ("p_x", "p_y"), strict=True):
        assert sum(slope * rate for slope, rate in zip(row, qd, strict=True)) == pytest.approx(found.vel[name])


def test_only_a_slide_on_a_turning_link_has_coriolis_acceleration() -> None:
    """A slide in front of all turns has none: its part of the acceleration is the slide's own."""
    base = solve("PRR", (0.2, 0.5, 0.8), (0.5, 0.4), (0.1, 0.8, -0.5), delta=pi / 2)
    still = solve("PRR", (0.2, 0.5, 0.8), (0.5, 0.4), (0.0, 0.8, -0.5), delta=pi / 2)
    assert base.acc == pytest.approx(still.acc)
    moving, held = (solve("RP", (0.5, 0.2), (0.5,), (2.0, rate)) for rate in (0.3, 0.0))
    turned = [moving.acc[name] - held.acc[name] for name in ("p_x", "p_y")]
    assert abs(complex(*turned)) == pytest.approx(2 * 2.0 * 0.3)


def test_a_stretched_arm_moves_its_tip_along_one_line_only() -> None:
    assert solve("RR", (0.4, 0.0), (0.5, 0.4)).singular.measure == pytest.approx(0, abs=1e-15)
    assert solve("R", (0.4,), (0.5,)).singular.measure == 0
    assert solve("R", (0.4,), (0.0,)).singular.measure == 0


def test_two_slides_at_a_right_angle_move_the_tip_as_easily_in_every_direction() -> None:
    found = solve("PRP", (0.2, pi / 2, 0.3), (0.0,))
    first, second = 1 + (0.3 / 0.5) ** 2, 1.0  # squares of s: the turn adds to the first slide
    assert found.singular.measure == pytest.approx(2 * (first * second) ** 0.5 / (first + second))
    assert solve("RP", (0.3, 0.4), (0.0,)).singular.measure == pytest.approx(1)


@pytest.mark.parametrize(
    ("values", "word"),
    [
        ({"type": "RXP"}, "word over R and P"),
        ({"type": ""}, "word over R and P"),
        ({"q": (1.0, 2.0)}, "q has 2 values"),
        ({"qd": (1.0,)}, "qd has 1 values"),
        ({"qdd": ()}, "qdd has 0 values"),
        ({"lengths": (0.5,)}, "lengths has 1 values for the 2 joints R"),
        ({"q": (1.0, nan, 0.0)}, "q 2"),
        ({"lengths": (0.5, inf)}, "lengths 2"),
        ({"delta": inf}, "delta"),
        ({"angles": "polar"}, "angles must be relative or absolute"),
    ],
)
def test_impossible_values_are_refused_by_name(values: dict[str, object], word: str) -> None:
    given_ = {"type": "RRP", "q": (0.1, 0.2, 0.3), "lengths": (0.5, 0.4)} | values
    with pytest.raises(ValueError, match=word):
        solve(**given_)  # type: ignore[arg-type]
