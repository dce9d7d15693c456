"""Slips at the POO manipulator of laboratory TMM-2."""

from __future__ import annotations

from exercises.manipulators.tmm2_poo import steps
from tests.slips.arms import slips

SLIPS = slips(steps, coriolis=False)
