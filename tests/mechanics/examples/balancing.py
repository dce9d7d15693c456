"""Balancing and vibration (domain BV): each example computed from its inputs."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, radians

from mechanics import balancing, vibration
from mechanics.balancing import FourBarLinks, Plane, PointMass, balance
from tests.mechanics.examples.reading import Inputs, Outputs, Solve

GRAVITY = 9.81  # m/s^2


def inertia_forces(given: Inputs) -> Outputs:
    force, moment = balancing.inertia_forces(given["m"], given["r"], given["a"])
    return {"F": list(force), "M_O": list(moment)}


def rotor(given: Inputs) -> Outputs:
    disc = balancing.unbalance([PointMass(given["m"], given["e_S"], 0.0)], given["omega"])
    point = balancing.unbalance([PointMass(given["m_point"], given["r"], 0.0, given["l"])], given["omega"])
    return {
        "D_st": abs(disc.static),
        "F": disc.force,
        "D_dyn_mass": abs(point.dynamic),
        "D_dyn_weight": abs(point.dynamic) * GRAVITY,
        "M": point.moment,
    }


def disc_in_one_plane(given: Inputs) -> Outputs:
    (found,) = balance(
        [PointMass(given["m"], given["r_S"], radians(given["angle_S_deg"]))], [Plane(0.0, given["r_P"])]
    ).corrections
    return {"m_P": found.m, "angle_P_deg": degrees(found.angle)}


def disc_between_two_planes(given: Inputs) -> Outputs:
    one, two = balancing.shared_by_planes(given["m"] * given["r_S"], given["l_I"], given["l_II"])
    return {"m_I": one / given["r_I"], "m_II": two / given["r_II"]}


def rotor_in_two_planes(given: Inputs) -> Outputs:
    rotor = [
        PointMass(m, r, radians(angle), x)
        for m, r, angle, x in zip(given["m"], given["r"], given["angle_deg"], given["x"], strict=True)
    ]
    first, second = Plane(given["x_I"], given["r_I"]), Plane(given["x_II"], given["r_II"])
    one, two = balance(rotor, [first, second]).corrections
    (stage,) = balance(rotor, [second]).corrections
    return {
        "D_I": _vector(one.unbalance),
        "D_II": _vector(two.unbalance),
        "m_I": one.m,
        "angle_I_deg": degrees(one.angle),
        "m_II": two.m,
        "angle_II_deg": degrees(two.angle),
        "stage1_D_C": _vector(stage.unbalance),
        "stage1_m_C": stage.m,
        "stage1_angle_C_deg": degrees(stage.angle),
        "stage2_D_D_II": _vector(two.unbalance - stage.unbalance),
    }


def _vector(unbalance: complex) -> Sequence[float]:
    return [unbalance.real, unbalance.imag]


def link_as_point_masses(given: Inputs) -> Outputs:
    two, three = balancing.two_points(**given), balancing.three_points(**given)
    return {
        "m_A": two.m_A,
        "m_B": two.m_B,
        "J_of_points": given["J_S"] - two.defect,
        "J_defect": two.defect,
        "three_m_A": three.m_A,
        "three_m_B": three.m_B,
        "three_m_S": three.m_S,
    }


def four_bar(given: Inputs) -> Outputs:
    names = ("l1", "l2", "l3", "l4", "m1", "m2", "m3", "AS1", "BS2", "DS3")
    links = FourBarLinks(*(given[name] for name in names))
    found = balancing.four_bar(links, given["AE"], given["DF"])
    (m1A, m1B), (m2B, m2C), (m3D, m3C) = links.shared()
    return {
        "m1A": m1A,
        "m1B": m1B,
        "m2B": m2B,
        "m2C": m2C,
        "m3C": m3C,
        "m3D": m3D,
        "m_k1": found.m1k,
        "m_k2": found.m2k,
        "m_I": found.m_I,
        "m_II": found.m_II,
        "x_S": found.x_S,
        "y_S": found.y_S,
    }


def polyharmonic(given: Inputs) -> Outputs:
    return {
        "octaves": vibration.octaves(given["f_low"], given["f_high"]),
        "x": vibration.polyharmonic(given["X0"], given["X"], given["omega1"], given["alpha"], given["t"]),
        "rms": vibration.rms(given["X0"], given["X"]),
    }


def force(given: Inputs) -> Outputs:
    machine = vibration.Oscillator(given["m"], given["c"], given["b"])
    found = vibration.force(machine, given["F0"], given["omega"])
    return {
        "omega0": machine.omega0,
        "n": machine.n,
        "zeta": machine.damping_ratio,
        "z": given["omega"] / machine.omega0,
        "X0": found.amplitude,
        "R0": found.force_to_base,
        "kR": found.transmissibility,
        "kX": found.amplitude * machine.c / given["F0"],
        "phase_lag_deg": degrees(found.phase),
        "omega_isolation_from": machine.isolates_from,
        "omega_resonance": machine.peak,
    }


def shaken_base(given: Inputs) -> Outputs:
    machine = vibration.Oscillator(given["m"], given["c"], given["b"])
    found = vibration.base(machine, given["xi0"], given["omega"])
    return {"X_abs": found.amplitude, "X_rel": found.relative, "kappa": found.transmissibility}


SOLVED: dict[str, Solve] = {
    "BV-1": inertia_forces,
    "BV-2": rotor,
    "BV-3": disc_in_one_plane,
    "BV-4": disc_between_two_planes,
    "BV-5": rotor_in_two_planes,
    "BV-6": link_as_point_masses,
    "BV-7": four_bar,
    "BV-8": polyharmonic,
    "BV-9": force,
    "BV-10": shaken_base,
}
