"""A12: later parts follow from the student's own early value only where that value is plausible."""

from __future__ import annotations

from math import asin, cos, degrees, sin

import pytest

from exercises.exercise import Submission
from exercises.grading import grade
from graders import Code
from graders.plausible import PLAUSIBLE
from tests.security.conftest import VARIANT

GIVENS = VARIANT.givens


def follow(rod: float, speed: float | None = None) -> dict[str, Code]:
    """Hand in an early value and what follows from it by the steps, done here by hand."""
    l1, l2, alpha1, omega1 = GIVENS.l1, GIVENS.l2, GIVENS.alpha1, GIVENS.omega1
    omega2 = -l1 * omega1 * cos(alpha1) / (l2 * cos(rod)) if speed is None else speed
    answers = {
        "alpha2": f"{degrees(rod):.15f}",
        "l3": f"{(l1 * cos(alpha1) + l2 * cos(rod)) * 1000:.12f}",
        "omega2": f"{omega2:.15e}",
        "v3": f"{-l1 * omega1 * sin(alpha1) - l2 * omega2 * sin(rod):.15e}",
    }
    return {name: verdict.code for name, verdict in grade(Submission(VARIANT, answers)).verdicts.items()}


def right_rod() -> float:
    return -asin(GIVENS.l1 * sin(GIVENS.alpha1) / GIVENS.l2)


def test_a_plausible_slip_is_followed() -> None:
    codes = follow(4 * right_rod())
    assert codes["alpha2"] not in (Code.RIGHT, Code.FOLLOWED)
    assert codes["l3"] is codes["omega2"] is codes["v3"] is Code.FOLLOWED


@pytest.mark.parametrize("factor", [0.0, 1e-9, -1e-12, 0.5 / PLAUSIBLE, -0.1 / PLAUSIBLE])
def test_a_trivial_early_value_is_not_followed(factor: float) -> None:
    codes = follow(factor * right_rod())
    assert codes["alpha2"] is not Code.RIGHT
    assert Code.FOLLOWED not in codes.values()


@pytest.mark.parametrize("speed", [0.0, 1e-6, 1e9, -1e12, 1e90])
def test_an_early_speed_that_swallows_or_drops_its_term_is_not_followed(speed: float) -> None:
    codes = follow(right_rod(), speed)
    assert codes["alpha2"] is codes["l3"] is Code.RIGHT
    assert codes["omega2"] is not Code.RIGHT
    assert codes["v3"] is not Code.FOLLOWED
