"""Linkages in closed form, as bodies by Newton's method, and the class III unit; a peer has the four-bar."""

from __future__ import annotations

from benchmarks.solvers.row import Row, Task
from mechanics import four_bar, inverted_slider, manipulator, planar, six_bar, slider_crank, velocity_plan
from mechanics.class_iii import Unit, assemblies
from mechanics.newton_linkages import four_bar_joints, four_bar_motion

BARS = (0.1, 0.26, 0.22, 0.3)
DRIVE = (1.0, 12.0, -8.0)  # angle, angular velocity, angular acceleration of the crank
NEAR = four_bar_motion(*BARS, 0.9, 12.0).poses[1:]
LINK = {"A": (0.0, 0.0), "B": (0.4, 0.3), "C": (0.1, 0.35)}
VELOCITIES = ((2.0, 0.5), (-0.7299917638, 4.139989018))
UNIT = Unit(
    458 + 458j, 1925 + 955j, 700 + 750j, 2096 + 1300j,
    l_AB=1200, l_BC=1000, l_BE=1000, l_CE=1000, l_CD=1100, l_EF=1100, l_EH=821, l_FH=1039, l_FG=1110, l_HK=1230,
)  # fmt: skip


def pylinkage_four_bar() -> Task:
    """One step of a four-bar that turns on, with velocities and accelerations."""
    from pylinkage import Ground, Linkage, RRRDyad
    from pylinkage.actuators import Crank

    l1, l2, l3, l4 = BARS
    A, D = Ground(0.0, 0.0), Ground(l4, 0.0)
    crank = Crank(A, l1, angular_velocity=0.01, initial_angle=1.0)
    linkage = Linkage([A, D, crank, RRRDyad(crank.output, D, l2, l3, x=0.25, y=0.25)])
    linkage.set_input_velocity(crank, omega=12.0, alpha=-8.0)
    steps = linkage.step_with_derivatives(iterations=10**9)
    return lambda: next(steps)


def pylinkage_slider_crank() -> Task:
    """One step of a slider-crank that turns on, with velocities and accelerations."""
    from pylinkage import Ground, Linkage, RRPDyad
    from pylinkage.actuators import Crank

    A, one, other = Ground(0.0, 0.0), Ground(-1.0, 0.02), Ground(1.0, 0.02)
    crank = Crank(A, 0.1, angular_velocity=0.01, initial_angle=1.0)
    linkage = Linkage([A, one, other, crank, RRPDyad(crank.output, one, other, 0.3, x=0.35, y=0.02)])
    linkage.set_input_velocity(crank, omega=12.0, alpha=-8.0)
    steps = linkage.step_with_derivatives(iterations=10**9)
    return lambda: next(steps)


ROWS = [
    Row("slider-crank, position to acceleration", lambda: slider_crank.motion(0.1, 0.3, *DRIVE, 0.02), 1.5,
        {"pylinkage": pylinkage_slider_crank}),
    Row("slider-crank with a point of the rod, by name", lambda: slider_crank.solve(0.1, 0.3, *DRIVE, 0.02)),
    Row("four-bar, position to acceleration", lambda: four_bar.motion(*BARS, *DRIVE), 4,
        {"pylinkage": pylinkage_four_bar}),
    Row("four-bar with a coupler point, by name", lambda: four_bar.solve(*BARS, *DRIVE, coupler_point=(0.1, 0.05))),
    Row("inverted slider, by name", lambda: inverted_slider.solve(0.15, *DRIVE, (0.0, -0.4), 0.6)),
    Row("six-bar, by name", lambda: six_bar.solve(*BARS, 1.0, (0.4, 0.2), 0.3, 0.28, 12.0, -8.0)),
    Row("manipulator RPR, by name", lambda: manipulator.solve("RPR", (0.5, 0.2, 0.8), (0.5, 0.4), (1, 0.1, -0.5))),
    Row(
        "any planar mechanism: a four-bar from the position before",
        lambda: planar.solve(four_bar_joints(*BARS, *DRIVE), NEAR),
    ),
    Row("class III unit, all 16 assemblies", lambda: assemblies(UNIT), 20_000),
    Row("plan of velocities of a link", lambda: velocity_plan.of_link(LINK, "A", "B", VELOCITIES)),
]  # fmt: skip
