"""Dynamics (domain DY): each example computed from its inputs."""

from __future__ import annotations

from collections.abc import Sequence
from math import radians

from mechanics import inertia_force, kinetostatics, link_frames, newton_euler, reactions, reduction, rod_groups
from mechanics import slider_crank as mechanism
from mechanics.chain import Chain
from mechanics.dh import Row
from mechanics.links import Drives, LinkMass
from mechanics.reduction import Coordinate, Reduced
from mechanics.transfer import Transfer, of_unit_motion
from tests.mechanics.chains import diagonal
from tests.mechanics.examples.reading import Inputs, Outputs, Solve


def _stage(given: Inputs) -> float:
    """Speed of the crank by that of wheel 1, 1/u12."""
    sign = {"external": -1.0, "internal": 1.0}[given["mesh"]]
    return float(sign * given["z1"] / given["z2"])


def _links(given: Inputs, phi: float) -> dict[str, Transfer]:
    """Wheel 2 with the crank, the rod and the slider by the turn of wheel 1, from its drawn position."""
    stage, crank = _stage(given), radians(given["crank_angle_deg"])
    unit = mechanism.solve(
        given["r_AB"], given["l_BC"], crank + stage * phi, 1.0, point_S_fraction_of_l2=given["l_BK"] / given["l_BC"]
    )
    return {"crank": Transfer(stage), **{name: u.behind(stage) for name, u in of_unit_motion(unit).items()}}


def _coordinates(given: Inputs, u: dict[str, Transfer], motor: float = 0.0) -> dict[str, Coordinate]:
    """Force and moment act against the motion of the slider and of link 2 at the drawn position."""
    sign = -1 if u["slider_x"].u * given["omega1"] > 0 else 1
    against = 1 if u["crank"].u * given["omega1"] < 0 else -1
    return {
        "J1": Coordinate(Transfer(1.0), given["J1"], motor),
        "J2": Coordinate(u["crank"], given["J2"], against * given["M_on_2"]),
        "J3": Coordinate(u["alpha2"], given["J3"]),
        "Kx": Coordinate(u["S_x"], given["m3"]),
        "Ky": Coordinate(u["S_y"], given["m3"], -given["m3"] * given["g"]),
        "m4": Coordinate(u["slider_x"], given["m4"], sign * given["F"]),
    }


def _machine(given: Inputs, phi: float) -> Reduced:
    return reduction.reduce(list(_coordinates(given, _links(given, phi), given.get("M_motor", 0.0)).values()))


def reduced_torque(given: Inputs) -> Outputs:
    u, omega1 = _links(given, 0.0), given["omega1"]
    carried = _coordinates(given, u)
    force, weight, moment = (reduction.reduce([carried[name]]).M for name in ("m4", "Ky", "J2"))
    return {
        "u12": 1 / _stage(given),
        "omega2": u["crank"].rate(omega1),
        "omega3": u["alpha2"].rate(omega1),
        "vC": u["slider_x"].rate(omega1),
        "vKx": u["S_x"].rate(omega1),
        "vKy": u["S_y"].rate(omega1),
        "M_F": force,
        "M_G": weight,
        "M_M": moment,
        "M_r": _machine(given, 0.0).M,
    }


def reduced_inertia(given: Inputs) -> Outputs:
    carried = _coordinates(given, _links(given, 0.0))
    found = _machine(given, 0.0)
    return {
        "term_J2": reduction.reduce([carried["J2"]]).J,
        "term_J3": reduction.reduce([carried["J3"]]).J,
        "term_m3": reduction.reduce([carried["Kx"], carried["Ky"]]).J,
        "term_m4": reduction.reduce([carried["m4"]]).J,
        "J_r": found.J,
        "T": found.energy(given["omega1"]),
    }


def energy_form(given: Inputs) -> Outputs:
    end = radians(given["delta_phi1_deg"])

    def machine(phi: float) -> Reduced:
        return _machine(given, phi)

    return {
        "J_r0": machine(0.0).J,
        "J_r1": machine(end).J,
        "W": reduction.work(machine, 0.0, end),
        "omega1_end": reduction.speed_after(machine, 0.0, end, given["omega0"]),
    }


def differential_form(given: Inputs) -> Outputs:
    found = _machine(given, 0.0)
    return {"dJr_dphi": found.dJ, "M_r_total": found.M, "eps1": found.epsilon(given["omega1"])}


def inertia_of_a_link(given: Inputs) -> Outputs:
    J, omega = given["J"], given["omega"]
    return {
        "F_in": inertia_force.force(given["m"], given["a_S"]),
        "K": inertia_force.momentum(J, omega),
        "M_in": inertia_force.moment(J, omega, given["eps"]),
    }


def force_analysis(given: Inputs) -> Outputs:
    assert given["S"] == "mid-link"
    names = ("l1", "l2", "m1", "m2", "m3", "J_S1", "J_S2", "g")
    machine = kinetostatics.SliderCrank(F3_x=given["F_C"], **{name: given[name] for name in names})
    found = kinetostatics.solve(machine, radians(given["alpha1_deg"]), given["omega1"], given["eps1"])
    return {name: getattr(found, name) for name in ("R01", "R12", "R23", "N03", "M1")}


def _arm(given: Inputs) -> tuple[tuple[Row, ...], list[LinkMass]]:
    rows, _ = rod_groups.table("RRR", {name: given[name] for name in ("L1", "L2", "L3")})
    bodies = zip(given["m"], given["s_cm"], given["I_diag"], strict=True)
    return rows, [LinkMass(m, s, diagonal(*moments)) for m, s, moments in bodies]


def _state(given: Inputs) -> tuple[Sequence[float], Sequence[float], Sequence[float]]:
    return (given["q1"], given["q2"], given["q3"]), given["q_dot"], given["q_ddot"]


def newton_euler_in_base_axes(given: Inputs) -> Outputs:
    rows, masses = _arm(given)
    found = newton_euler.solve(Chain(rows), masses, *_state(given), given["g"], given["b"])
    return _printed(found, (1,))


def newton_euler_in_link_axes(given: Inputs) -> Outputs:
    rows, masses = _arm(given)
    return _printed(link_frames.drives(rows, masses, *_state(given), given["g"], given["b"]), (1, 3))


def _printed(found: Drives, links: tuple[int, ...]) -> Outputs:
    forces = {f"F{i}": found.forces[i - 1] for i in links}
    return {"tau": found.tau, **forces, **{f"N{i}": found.moments[i - 1] for i in links}}


def reaction_count(given: Inputs) -> Outputs:
    found = reactions.count(given["moving_links"], {5: given["revolute"] + given["prismatic"]}, given["planar"])
    return {
        "equations": found.equations,
        "unknown_reactions": found.reactions,
        "unknown_drives": found.drives,
        "spatial_reactions_per_1dof_pair": reactions.per_pair(5, planar=False),
    }


SOLVED: dict[str, Solve] = {
    "DY-1": reduced_torque,
    "DY-2": reduced_inertia,
    "DY-3": energy_form,
    "DY-4": differential_form,
    "DY-5": inertia_of_a_link,
    "DY-6": force_analysis,
    "DY-7": newton_euler_in_base_axes,
    "DY-8": newton_euler_in_link_axes,
    "DY-9": reaction_count,
}
