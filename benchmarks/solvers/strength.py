"""Beams with exact extremes, shafts, bars; the peers solve the same beam and give its extremes as they can."""

from __future__ import annotations

from benchmarks.solvers.row import Row, Task
from mechanics import bar, bar_fan, beam, shaft
from mechanics.bar import AxialForce, Bar, BarSegment
from mechanics.beam import Beam, Distributed, Force, Moment, Support
from mechanics.composed import i_section
from mechanics.section import Rectangle
from mechanics.shaft import Segment, Shaft, Torque
from mechanics.stress import StressState
from mechanics.wire import solvers

L, E, I = 4.0, 2.1e11, 5.76e-6
P, a, q = 5000.0, 1.5, 2000.0  # down
ENDS = (Support(0.0), Support(L, "roller"))
SIMPLE = Beam(L, E, ENDS, (Force(a, -P), Distributed(0.0, L, -q, -q)), I=I)
SETTLED = Beam(
    L,
    E,
    (Support(0.0), Support(L, "roller", -0.001)),
    (Force(a, -P), Moment(2.0, 1200.0), Distributed(1.0, 3.0, -q, -2 * q)),
    section=Rectangle(0.04, 0.12),
)
SPANS = Beam(12.0, E, tuple(Support(3.0 * i) for i in range(5)), (Distributed(0.0, 12.0, -q, -q),), I=I)
SHAFT = Shaft(
    8e10,
    (Segment(0.5, 0.05), Segment(0.4, 0.04, 0.02)),
    (Torque(0.5, 900), Torque(0.9, -300)),
    "fixed_free",
    6e7,
    8.7e-3,
)
BETWEEN = Shaft(8e10, SHAFT.segments, (Torque(0.5, 900.0),), "fixed_fixed")
BAR = Bar((BarSegment(0.8, 4e-4, E, 1.2e-5, 30.0),), (AxialForce(0.8, 2e4),), "fixed_gap", 5e-4)
WALLS = Bar(
    (BarSegment(0.5, 5e-4, E, 1.2e-5, 40), BarSegment(0.9, 8e-4, E, 1.2e-5, 40)), (AxialForce(0.5, 6e4),), "fixed_fixed"
)
STRESS = StressState(((80e6, 30e6, 0.0), (30e6, -20e6, 10e6), (0.0, 10e6, 40e6)))
FAN = [bar_fan.FanBar(angle, 1.2, 4.2e7) for angle in (1.0, 1.6, 2.2)]


def pynite() -> Task:
    """PyNite: build, analyse, ask for the extremes, which it finds piece by piece (those of v by sampling)."""
    from Pynite import FEModel3D

    def solve() -> object:
        model = FEModel3D()
        for name, x in (("A", 0.0), ("B", L)):
            model.add_node(name, x, 0, 0)
        model.add_material("steel", E, 8e10, 0.3, 7850)
        model.add_section("s", 4.8e-3, I, I, 1e-6)
        model.add_member("m", "A", "B", "steel", "s")
        model.def_support("A", True, True, True, True, False, False)
        model.def_support("B", False, True, True, False, False, False)
        model.add_member_pt_load("m", "Fy", -P, a)
        model.add_member_dist_load("m", "Fy", -q, -q, 0, L)
        model.analyze(check_statics=False)
        member = model.members["m"]
        return member.max_moment("Mz"), member.min_moment("Mz"), member.max_shear("Fy"), member.min_deflection("dy")

    return solve


def anastruct() -> Task:
    """Anastruct: build, solve, read the sampled extremes."""
    from anastruct import SystemElements

    def solve() -> object:
        system = SystemElements(EI=E * I, EA=1e9)
        system.add_element([[0, 0], [a, 0]])
        system.add_element([[a, 0], [L, 0]])
        system.add_support_hinged(1)
        system.add_support_roll(3)
        system.point_load(2, Fy=-P)
        system.q_load(-q, 1)
        system.q_load(-q, 2)
        system.solve()
        return system.get_element_results()

    return solve


def sympy() -> Task:
    """SymPy's Beam: reactions, then M and v as formulas in x; no extremes, which would take seconds more."""
    from sympy import symbols
    from sympy.physics.continuum_mechanics.beam import Beam as SymbolicBeam

    def solve() -> object:
        left, right = symbols("R_A R_B")
        made = SymbolicBeam(4, 210 * 10**9, I)
        made.apply_load(left, 0, -1)
        made.apply_load(right, 4, -1)
        made.apply_load(-5000, 1.5, -1)
        made.apply_load(-2000, 0, 0, end=4)
        made.bc_deflection = [(0, 0), (4, 0)]
        made.solve_for_reaction_loads(left, right)
        return made.bending_moment(), made.deflection()

    return solve


ROWS = [
    Row(
        "beam on two supports, exact extremes",
        lambda: beam.solve(SIMPLE),
        50,
        {"PyNite": pynite, "anastruct (sampled)": anastruct, "SymPy (no extremes)": sympy},
    ),
    Row("beam with a settlement and three kinds of load", lambda: beam.solve(SETTLED)),
    Row("beam of four spans", lambda: beam.solve(SPANS)),
    Row(
        "the beam of the contract from JSON values to answer",
        lambda: solvers.solve("beam", solvers.load("beam").EXAMPLE),
    ),
    Row("shaft with sizes", lambda: shaft.solve(SHAFT), 30),
    Row("shaft between walls", lambda: shaft.solve(BETWEEN), 30),
    Row("bar with a gap, heated", lambda: bar.solve(BAR), 30),
    Row("bar between walls, heated", lambda: bar.solve(WALLS), 30),
    Row("I-section", lambda: i_section(0.1, 0.2, 0.0085, 0.0056)),
    Row("principal stresses and directions", lambda: (STRESS.principal, STRESS.directions)),
    Row("fan of three bars", lambda: bar_fan.solve(FAN, 1e3, -4e4)),
]
