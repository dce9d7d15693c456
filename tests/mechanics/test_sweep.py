"""The sweep itself: exact integration, and refusal where a condition settles nothing."""

from __future__ import annotations

import pytest

from mechanics.errors import SingularError
from mechanics.sweep import Station, carry, sweep


def test_state_is_integrated_exactly() -> None:
    """v = t + t^2 + t^3 + t^4 + t^5 at t = 1/2, with all its derivatives."""
    assert carry((0.0, 1.0, 2.0, 6.0), 0.5, 24.0, 120.0) == (0.96875, 3.5625, 10.5, 33.0)


@pytest.mark.parametrize(
    "stations",
    [
        [Station(0.0), Station(1.0, force=-1.0)],
        [Station(0.0, held=True), Station(1.0)],
        [Station(0.0), Station(1.0, held=True)],
    ],
)
def test_condition_that_settles_nothing_is_refused(stations: list[Station]) -> None:
    with pytest.raises(SingularError, match="settles nothing"):
        sweep(stations, [(1.0, 0.0, 0.0)])
