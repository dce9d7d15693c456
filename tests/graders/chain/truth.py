"""The true motion of the rod groups, made from their printed tables and point formulas, not by the judge."""

from __future__ import annotations

from math import cos, sin

from graders.chain.frames import axis_z, frame_of, origin
from graders.chain.motion import Axis, Motion
from mechanics import rod_groups
from mechanics.dh import Row
from mechanics.transform import chain_pose

TABLES = {
    "RRP": "[[q1; L1; 0; pi/2]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
    "RRR": "[[q1; L1; 0; pi/2]; [q2; 0; L2; 0]; [-q3; 0; 0; 0]]",
    "PRR": "[[pi/2; q1; L1; 0]; [-q2; 0; L2; 0]; [q3; 0; 0; 0]]",
    "RPP": "[[q1; 0; 0; 0]; [pi; q2; 0; pi/2]; [0; q3; 0; 0]]",
}
LENGTHS = {
    "RRP": {"L1": 0.5, "d": 0.1},
    "RRR": {"L1": 0.45, "L2": 0.52, "L3": 0.4},
    "PRR": {"L1": 0.2, "L2": 0.5, "L3": 0.4},
    "RPP": {"d": 0.12},
}
POINTS = [tuple((0.31 + 0.37 * k * i) % 2.9 - 0.8 for i in (1, 2, 3)) for k in range(1, 21)]


def motion(group: str) -> Motion:
    lengths, (rows, tool) = LENGTHS[group], rod_groups.table(group, LENGTHS[group])
    poses = [[frame_of(chain_pose(rows[:count], q[:count])) for count in (1, 2, 3)] for q in POINTS]
    base = frame_of(((1.0, 0, 0, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0), (0, 0, 0, 1.0)))
    return Motion(
        names=("q1", "q2", "q3", *lengths),
        points=tuple((*q, *lengths.values()) for q in POINTS),
        links=tuple(map(tuple, poses)),
        axes=tuple(tuple(Axis(origin(f), axis_z(f)) for f in (base, *frames[:2])) for frames in poses),
        tool=tool,
        targets=tuple(rod_groups.direct(group, lengths, q) for q in POINTS),
        table=TABLES[group],
    )


def modified() -> Motion:
    """The RRP arm in modified frames: z1 up at the shoulder, z2 level, z3 along the slide; M at (0, -d, 0)."""
    length, offset = 0.5, 0.1
    rows = (Row("R", d=length), Row("R", alpha=1.5707963267948966), Row("P", alpha=1.5707963267948966))
    poses = [[frame_of(chain_pose(rows[:n], q[:n], "modified")) for n in (1, 2, 3)] for q in POINTS]
    side = [(sin(q[0]), -cos(q[0]), 0.0) for q in POINTS]  # the second axis
    slide = [(sin(q[1]) * cos(q[0]), sin(q[1]) * sin(q[0]), -cos(q[1])) for q in POINTS]
    shoulder = (0.0, 0.0, length)
    return Motion(
        names=("q1", "q2", "q3", "L1", "d"),
        points=tuple((*q, length, offset) for q in POINTS),
        links=tuple(map(tuple, poses)),
        axes=tuple(
            (Axis((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)), Axis(shoulder, u), Axis(shoulder, w))
            for u, w in zip(side, slide, strict=True)
        ),
        tool=(0.0, -offset, 0.0),
        targets=tuple(rod_groups.direct("RRP", {"L1": length, "d": offset}, q) for q in POINTS),
        table="[[q1; L1; 0; 0]; [q2; 0; 0; pi/2]; [0; q3; 0; pi/2]]",
    )
