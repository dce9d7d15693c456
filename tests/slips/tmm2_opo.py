"""Slips at the OPO manipulator of laboratory TMM-2."""

from __future__ import annotations

from exercises.manipulators.tmm2_opo import steps
from tests.slips.arms import slips

SLIPS = slips(steps)
