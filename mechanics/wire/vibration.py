"""`solve vibration`: one mass under force or base excitation (`mechanics.vibration`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics import vibration
from mechanics.vibration import Oscillator
from mechanics.wire.fields import Number, Record
from mechanics.wire.refusal import Refusal

REQUEST = Record(
    "A mass on a spring and a viscous damper: under a force F0 cos(omega t), or on a base that moves by "
    "base_amplitude cos(omega t).",
    {
        "m": Number("mass", "kg", above=0),
        "c": Number("stiffness", "N/m", above=0),
        "b": Number("damping", "N s/m", default=0.0, least=0),
        "F0": Number("amplitude of the force on the mass", "N", default=None, above=0),
        "base_amplitude": Number("amplitude of the base, instead of F0", "m", default=None, above=0),
        "omega": Number("circular frequency of the excitation", "rad/s", least=0),
    },
)

ANSWER = {
    "amplitude": "amplitude of the mass, m",
    "transmissibility": "force to the base over F0; or amplitude of the mass over that of the base",
    "phase": "lag of the mass behind the force or the base, rad, positive",
    "omega0": "natural frequency, rad/s",
    "damping_ratio": "damping over the critical one",
    "force_to_base": "amplitude of the force on the base, N; under a force only",
    "relative_amplitude": "amplitude of the mass against the base, m; on a moving base only",
}

EXAMPLE = {"m": 20, "c": 50000, "b": 300, "F0": 100, "omega": 60}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Find the steady vibration; raises ValueError."""
    F0, moved = request["F0"], request["base_amplitude"]
    if (F0 is None) == (moved is None):
        code = "missing_field" if F0 is None else "contradictory"
        raise Refusal(code, "give either F0 (N) or base_amplitude (m), one of the two", "F0")
    body = Oscillator(request["m"], request["c"], request["b"])
    own = {"omega0": body.omega0, "damping_ratio": body.damping_ratio}
    found: vibration.Forced | vibration.Shaken
    if F0 is None:
        found = vibration.base(body, moved, request["omega"])
        last = {"relative_amplitude": found.relative}
    else:
        found = vibration.force(body, F0, request["omega"])
        last = {"force_to_base": found.force_to_base}
    first = {"amplitude": found.amplitude, "transmissibility": found.transmissibility, "phase": found.phase}
    return {**first, **own, **last}
