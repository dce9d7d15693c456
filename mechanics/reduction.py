"""Reduction of a machine to one link, and its equation of motion (domain DY-1..4).

Every link follows the reduction coordinate phi: each of its coordinates (x and y of the mass centre or of a force's
point, its angle) carries an inertia (kg or kg m^2) and a load (N or N m, signed along the coordinate).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, copysign, fsum, isfinite, sqrt

from mechanics import slider_crank, transfer
from mechanics.checks import finite, summed
from mechanics.errors import SingularError
from mechanics.slider_crank import Branch
from mechanics.transfer import Transfer

PANEL = 0.05  # longest piece of an integral, rad
LONGEST = 1e4  # turn over which the work is summed, rad
_NODES = ((-sqrt(0.6), 5 / 9), (0.0, 8 / 9), (sqrt(0.6), 5 / 9))  # Gauss's rule of three points, exact to degree 5


@dataclass(frozen=True, slots=True)
class Coordinate:
    """One coordinate of a link, with what it carries."""

    transfer: Transfer  # by the reduction coordinate
    inertia: float = 0.0  # mass of a shift, kg; moment of inertia of a turn, kg m^2
    load: float = 0.0  # force, N, or moment, N m

    def __post_init__(self) -> None:
        if not 0 <= self.inertia < float("inf"):
            raise ValueError(f"inertia = {self.inertia} (kg or kg m^2) must be finite and not negative")
        finite("load", self.load, "(N or N m)")


@dataclass(frozen=True, slots=True)
class Reduced:
    """A machine seen from its reduction link; for a sliding link read kg, N and m/s^2."""

    J: float  # reduced moment of inertia, kg m^2
    dJ: float  # its derivative by phi, kg m^2/rad
    M: float  # reduced moment, N m

    def epsilon(self, omega: float) -> float:
        """Angular acceleration from J eps + J' omega^2/2 = M, in rad/s^2 (domain DY-4).

        Raises:
            SingularError: No inertia is reduced, so that no acceleration is determined.
        """
        if not self.J > 0:
            raise SingularError("the reduced moment of inertia is 0: the acceleration is not determined")
        return (self.M - self.dJ * omega**2 / 2) / self.J

    def energy(self, omega: float) -> float:
        """Kinetic energy of the machine, in J."""
        return self.J * omega**2 / 2


def reduce(coordinates: Sequence[Coordinate]) -> Reduced:
    """Reduce inertias and loads: equal energy and equal power.

    Raises:
        ValueError: The answer is beyond the range of floats.

    Source:
        Domain DY-1, DY-2: J = sum inertia u^2, M = sum load u; J' = sum 2 inertia u u'.
    """
    pairs = [(one, one.transfer) for one in coordinates]
    return Reduced(
        J=summed(one.inertia * t.u * t.u for one, t in pairs),
        dJ=summed(2 * one.inertia * t.u * t.u_prime for one, t in pairs),
        M=summed(one.load * t.u for one, t in pairs),
    )


def work(machine: Callable[[float], Reduced], start: float, end: float) -> float:
    """Integrate the reduced moment over a turn from one position to another (rad), in J.

    Raises:
        ValueError: The turn is not finite, or of more than ten thousand radians.
    """
    return fsum(gained for _, gained in _panels(machine, start, end))


def _panels(machine: Callable[[float], Reduced], start: float, end: float) -> Iterator[tuple[float, float]]:
    """Give piece by piece of a turn its end and the work done over it, by Gauss's rule of three points."""
    if not abs(end - start) <= LONGEST:
        raise ValueError(f"the turn from {start} rad to {end} rad must be finite and at most {LONGEST:g} rad")
    count = max(1, ceil(abs(end - start) / PANEL))
    half = (end - start) / count / 2
    for i in range(count):
        middle = start + half * (2 * i + 1)
        yield middle + half, half * fsum(weight * machine(middle + half * node).M for node, weight in _NODES)


def speed_after(machine: Callable[[float], Reduced], start: float, end: float, omega0: float) -> float:
    """Find the angular velocity after a turn by the energy form of the equation of motion.

    Args:
        machine: Gives the reduced machine at a position phi.
        start: First position, in radians.
        end: Last position, in radians.
        omega0: Angular velocity at the start, in rad/s, of the sign of the turn.

    Raises:
        ValueError: The machine stops on the way, turns the other way at the start, or the turn is too long.
        SingularError: No inertia is reduced at the end.

    Source:
        Domain DY-3: J omega^2/2 - J0 omega0^2/2 = integral of M.
    """
    if not isfinite(omega0) or omega0 * (end - start) < 0:
        raise ValueError(f"omega0 = {omega0} rad/s must be finite and of the sense of the turn, {end - start:g} rad")
    energy = machine(start).energy(omega0)
    for phi, gained in _panels(machine, start, end):
        energy += gained
        if energy < 0:
            raise ValueError(f"the machine stops before {phi:g} rad: {-energy:.4g} J are missing")
    last = machine(end).J
    if not last > 0:
        raise SingularError("the reduced moment of inertia is 0: the speed is not determined")
    return copysign(sqrt(2 * energy / last), end - start or omega0)


def slider_crank_machine(
    l1: float,
    l2: float,
    alpha1: float,
    offset: float = 0.0,
    branch: Branch = "slider_right",
    point_S_fraction_of_l2: float = 0.5,
    m2: float = 0.0,
    m3: float = 0.0,
    J1: float = 0.0,
    J2: float = 0.0,
    F3_x: float = 0.0,
    M1: float = 0.0,
    gravity: float = 0.0,
) -> Reduced:
    """Reduce a slider-crank to its crank.

    Args:
        l1: Crank length, in metres.
        l2: Connecting-rod length, in metres.
        alpha1: Crank angle, in radians.
        offset: Ordinate of the guide, in metres.
        branch: The assembly, as for `slider_crank.position`.
        point_S_fraction_of_l2: Place of the rod's mass centre, 0 at the crank pin, 1 at the slider.
        m2: Mass of the rod, in kg.
        m3: Mass of the slider, in kg.
        J1: Moment of inertia of the crank about its axis, in kg m^2.
        J2: Moment of inertia of the rod about its mass centre, in kg m^2.
        F3_x: Force on the slider along +X, in N.
        M1: Moment on the crank, counter-clockwise, in N m.
        gravity: Acceleration along -Y that weighs on the rod, in m/s^2.

    Raises:
        ValueError: A value is not finite, or a length, mass or inertia not fit.
        AssemblyError: The rod cannot reach the guide.
        SingularError: The rod is perpendicular to the guide.

    Source:
        Domain DY-1, DY-2, DY-4.
    """
    motion = slider_crank.solve(l1, l2, alpha1, 1.0, 0.0, offset, branch, point_S_fraction_of_l2)
    u = transfer.of_unit_motion(motion)
    return reduce(
        [
            Coordinate(Transfer(1.0), J1, M1),
            Coordinate(u["alpha2"], J2),
            Coordinate(u["S_x"], m2),
            Coordinate(u["S_y"], m2, -m2 * gravity),
            Coordinate(u["slider_x"], m3, F3_x),
        ]
    )
