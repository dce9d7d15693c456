"""Gear trains, shaft joints, structure, balancing and vibration; no peer has gear trains or passive constraints."""

from __future__ import annotations

from benchmarks.solvers.row import Row
from mechanics import balancing, gear_train, geneva, hooke_joint, vibration, willis
from mechanics.assur import decompose
from mechanics.gear_train import Mesh, Train
from mechanics.mobility import Joint, plane
from mechanics.structure import Pair
from mechanics.willis import Stage

STAGES = [Stage(20, 25), Stage(25, 70, "internal")]
TRAIN = Train(
    ("1", "2", "3", "H"),
    (Mesh("1", "2", 20, 25, "external", "H"), Mesh("2", "3", 25, 70, "internal", "H")),
    ("3",),
    {"1": 100},
    "H",
)
SIX_LINKS = [Pair(*ends) for ends in ("01", "12", "23", "30", "34", "45", "50")]
PLACES = {"01": (0.0, 0.0), "12": (0.3, 0.4), "23": (1.5, 0.4), "30": (1.2, 0.0), "04": (0.6, 0.0), "42": (0.9, 0.4)}
CRANKS = [Joint("R", tuple(ends), at) for ends, at in PLACES.items()]
ROTOR = [balancing.PointMass(0.2, 0.05, 0.7, 0.1), balancing.PointMass(0.1, 0.06, 2.5, 0.3)]
PLANES = [balancing.Plane(0.0, 0.08), balancing.Plane(0.4, 0.08)]
MACHINE = vibration.Oscillator(20, 50000, 300)

ROWS = [
    Row("planetary ratio, exact, by inversion", lambda: willis.planetary_ratio(STAGES, "last"), 5),
    Row("planetary train, exact, all members", lambda: gear_train.solve(TRAIN)),
    Row("Cardan joint, position to acceleration", lambda: hooke_joint.solve(0.5, 0.9, 100.0)),
    Row("Geneva drive, position to acceleration", lambda: geneva.solve(6, 0.12, 0.35, 5.0)),
    Row("Assur groups of a six-link mechanism", lambda: decompose(SIX_LINKS, ["1"])),
    Row("true mobility of a parallelogram with three cranks", lambda: plane("01234", CRANKS)),
    Row("rotor in two planes", lambda: balancing.balance(ROTOR, PLANES)),
    Row("vibration under a force", lambda: vibration.force(MACHINE, 100.0, 60.0)),
]
