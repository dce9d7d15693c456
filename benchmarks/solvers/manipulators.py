"""Serial chains of six joints, rod groups, reduction and force analysis; roboticstoolbox and Pinocchio do the same."""

from __future__ import annotations

from math import pi
from typing import Any

from benchmarks.solvers.row import Row, Task
from mechanics import accuracy, chain, kinetostatics, link_frames, newton_euler, reduction, rod_groups
from mechanics import dh as tables
from mechanics.links import LinkMass
from mechanics.motion_law import drive_law

SIX = tuple(tables.Row("R", 0.1 * i, 0.1 * i, 0.2 + 0.05 * i, 0.1 - pi / 2 * (i % 2)) for i in range(6))
ARM, Q = chain.Chain(SIX), (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
LINK = LinkMass(1.0, (0.1, 0.1, 0.1), ((0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))
LINKS, DOWN = [LINK] * 6, (0.0, 0.0, -9.81)
GROUP = {"L1": 0.45, "L2": 0.5, "L3": 0.4}
GROUP_ROWS, POINT = rod_groups.table("RRR", GROUP)
GROUP_CHAIN, GROUP_Q, M = chain.Chain(GROUP_ROWS), (0.6, 0.9, 0.7), (0.58, 0.4, 0.92)
ENGINE = kinetostatics.SliderCrank(0.1, 0.3, 0.5, 0.9, 1.5, 0.0006, 0.007, -300.0)
LAW = drive_law(2.0, 1.2, 4.0)


def toolbox(method: str) -> Task:
    """The same arm in roboticstoolbox, by one of its methods."""
    import numpy as np
    import roboticstoolbox as rtb

    links = [rtb.RevoluteDH(offset=r.theta, d=r.d, a=r.a, alpha=r.alpha, m=1.0, r=[0.1] * 3, I=[0.1] * 3) for r in SIX]
    robot, q = rtb.DHRobot(links), np.array(Q)
    owner: Any = robot.ets() if method in ("eval", "jacob0") else robot
    if method == "rne":
        return lambda: robot.rne(q, q, q)
    return lambda: getattr(owner, method)(q)


def pinocchio(task: str) -> Task:
    """The same arm in Pinocchio; each of its joints turns about z before the rest of the row."""
    import numpy as np
    import pinocchio as pin

    model, parent, place, still = pin.Model(), 0, pin.SE3.Identity(), np.zeros(3)
    for i, row in enumerate(SIX):
        start = pin.SE3(pin.utils.rotate("z", row.theta), still)
        parent = model.addJoint(parent, pin.JointModelRZ(), place * start, f"joint {i}")
        place = pin.SE3(pin.utils.rotate("x", row.alpha), np.array([row.a, 0.0, row.d]))
        inertia = pin.Inertia(1.0, np.full(3, 0.1), 0.1 * np.eye(3))
        model.appendBodyToJoint(parent, inertia, place)
    tip = model.addFrame(pin.Frame("tip", parent, 0, place, pin.FrameType.OP_FRAME))
    known, q = model.createData(), np.array(Q)

    def pose() -> object:
        pin.forwardKinematics(model, known, q)
        return pin.updateFramePlacement(model, known, tip)

    return {
        "pose": pose,
        "jacobian": lambda: pin.computeFrameJacobian(model, known, q, tip, pin.LOCAL_WORLD_ALIGNED),
        "drives": lambda: pin.rnea(model, known, q, q, q),
        "mass matrix": lambda: pin.crba(model, known, q),
    }[task]


ROWS = [
    Row("forward kinematics of six joints", lambda: chain.pose(ARM, Q), 8, {
        "roboticstoolbox, ETS.eval": lambda: toolbox("eval"),
        "roboticstoolbox, DHRobot.fkine": lambda: toolbox("fkine"),
        "pinocchio": lambda: pinocchio("pose"),
    }),
    Row("Jacobian of six joints", lambda: chain.jacobian(ARM, Q), 16, {
        "roboticstoolbox, ETS.jacob0": lambda: toolbox("jacob0"),
        "pinocchio": lambda: pinocchio("jacobian"),
    }),
    Row("pose, Jacobian, velocity and acceleration of six joints", lambda: chain.solve(ARM, Q, Q, Q)),
    Row("Newton-Euler drives of six joints, base axes", lambda: newton_euler.solve(ARM, LINKS, Q, Q, Q, DOWN), None, {
        "roboticstoolbox, rne": lambda: toolbox("rne"),
        "pinocchio": lambda: pinocchio("drives"),
    }),
    Row("Newton-Euler drives of six joints, link frames", lambda: link_frames.drives(SIX, LINKS, Q, Q, Q, DOWN)),
    Row("mass matrix of six joints", lambda: newton_euler.mass_matrix(ARM, LINKS, Q), None, {
        "pinocchio": lambda: pinocchio("mass matrix"),
    }),
    Row("inverse task of the RRR group, all four branches", lambda: rod_groups.inverse("RRR", GROUP, M)),
    Row("position error of the RRR group by vectors",
        lambda: accuracy.by_vectors(GROUP_CHAIN, GROUP_Q, (0.002, -0.001, 0.0015), POINT)),
    Row("force analysis of the slider-crank", lambda: kinetostatics.solve(ENGINE, 0.7, 20.0, 50.0)),
    Row("slider-crank reduced to its crank",
        lambda: reduction.slider_crank_machine(0.1, 0.3, 0.7, m2=0.9, m3=1.5, J1=0.002, J2=0.007, F3_x=-300.0)),
    Row("drive law at one time", lambda: LAW.at(0.2)),
]  # fmt: skip
