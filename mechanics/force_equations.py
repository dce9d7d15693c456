"""Force analysis of the slider-crank as one system of eight equations: the independent way to `kinetostatics`.

Unknowns R01x, R01y, R12x, R12y, R23x, R23y, N03, M1; for the crank and the rod two sums of forces and the moments
about the mass centre, for the slider the two sums of forces (domain DY-6).
"""

from __future__ import annotations

from collections.abc import Sequence

from mechanics import linear
from mechanics.kinetostatics import Link, Reactions


def solve(bodies: tuple[Link, Link, Link]) -> Reactions:
    """Solve the eight equations.

    Args:
        bodies: Crank, rod and slider cut free.

    Raises:
        SingularError: The rod is perpendicular to the guide.
    """
    crank, rod, slider = bodies
    rows = [*_forces(0, crank), *_forces(2, rod), *_forces(4, slider)[:2]]
    rows += [_moments(0, crank, drive=1.0), _moments(2, rod, drive=0.0)]
    rows[5][6] = 1.0  # N03 on the slider
    matrix, right = [row[:8] for row in rows], [row[8] for row in rows]
    x = linear.solve(matrix, right)
    return Reactions((x[0], x[1]), (x[2], x[3]), (x[4], x[5]), x[6], x[7])


def _forces(at: int, link: Link) -> tuple[list[float], list[float]]:
    """What comes from the link before minus what goes to the next, against the load; the slider passes none on."""
    rows = [0.0] * 8 + [-link.force[0]], [0.0] * 8 + [-link.force[1]]
    for axis, row in enumerate(rows):
        row[at + axis] = 1.0
        if at < 4:
            row[at + 2 + axis] = -1.0
    return rows


def _moments(at: int, link: Link, drive: float) -> list[float]:
    (nx, ny), (fx, fy) = _arms(link)
    row = [0.0] * 9
    row[at : at + 4] = [-ny, nx, fy, -fx]
    row[7], row[8] = drive, -link.moment
    return row


def _arms(link: Link) -> Sequence[tuple[float, float]]:
    return [(joint[0] - link.centre[0], joint[1] - link.centre[1]) for joint in (link.near, link.far)]
