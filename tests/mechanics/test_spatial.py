"""Slopes of the gaps of spatial pairs against central differences, at any displacement."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.spatial import SpatialPair, closure, spatial_pair
from mechanics.structure import CLASSES
from tests.depth import amount

parts = st.lists(st.floats(-1.5, 1.5), min_size=12, max_size=12)
H = 1e-6


def differences(pair: SpatialPair, at: list[float]) -> Any:
    columns = []
    for i in range(12):
        before, after = at.copy(), at.copy()
        before[i], after[i] = at[i] - H, at[i] + H
        columns.append((closure([pair], 2, after)[0] - closure([pair], 2, before)[0]) / (2 * H))
    return np.array(columns).T


@settings(max_examples=amount(8, 15), deadline=None)
@given(st.sampled_from(sorted(set(CLASSES) - {"H"})), parts)
def test_slopes_are_those_of_the_gaps(kind: str, at: list[float]) -> None:
    pair = spatial_pair(kind, (1, 2), (0.3, -0.2, 0.5), (1.0, 2.0, -1.0), (2.0, -1.0, 0.0))
    gaps, slopes = closure([pair], 2, at)
    assert gaps.shape == (CLASSES[kind],)
    assert slopes == pytest.approx(differences(pair, at), abs=1e-7)


def test_slopes_of_a_screw_are_those_of_its_gaps_where_its_axes_agree() -> None:
    pair = spatial_pair("H", (1, 2), (0.3, -0.2, 0.5), (0.0, 0.0, 1.0), pitch=0.4)
    for at in ([0.0] * 12, [0.0] * 5 + [0.7] + [0.0] * 6):
        assert closure([pair], 2, at)[1] == pytest.approx(differences(pair, at), abs=1e-7)


def test_a_screw_advances_by_its_pitch_in_a_turn() -> None:
    pair = spatial_pair("H", (0, 1), (0.3, -0.2, 0.5), (0.0, 0.0, 2.0), pitch=0.4)
    turned = [0.3 - 0.2, -0.2 - 0.3, 0.1, 0.0, 0.0, pi / 2]  # a quarter about the axis through the place
    assert closure([pair], 1, turned)[0] == pytest.approx(np.zeros(5), abs=1e-12)


def test_the_drawn_position_closes_every_pair() -> None:
    for kind, klass in CLASSES.items():
        pair = spatial_pair(kind, (1, 2), (0.3, -0.2, 0.5), (1.0, 2.0, -1.0), (2.0, 1.0, 0.5), 0.2)
        gaps, _ = closure([pair], 2, [0.0] * 12)
        assert gaps == pytest.approx(np.zeros(klass), abs=1e-12)
