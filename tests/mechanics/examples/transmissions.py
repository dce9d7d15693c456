"""Transmissions (domain TR): each example computed from its inputs."""

from __future__ import annotations

from math import degrees, radians

from mechanics import gear_train, geneva, hooke_joint, willis
from mechanics.gear_pair import GearPair, MeshType
from mechanics.gear_train import Mesh, Train
from mechanics.geneva import Geneva
from mechanics.rack import Rack
from mechanics.screw import Screw
from mechanics.willis import Stage
from tests.mechanics.examples.reading import Inputs, Outputs, Solve


def rack(given: Inputs) -> Outputs:
    one = Rack("1", given["z1"], given["m"])
    found = gear_train.solve(Train(("1",), input_omega={"1": given["omega1"]}, output="rack", rack=one))
    return {"r1": one.radius * 1e3, "v2": (found.v or 0) * 1e3, "s2": one.travel(given["phi_rad"]) * 1e3}


def screw(given: Inputs) -> Outputs:
    one = Screw("1", given["pitch"] / 1e3, given["starts"], "left")  # the example counts the nut's advance positive
    speed = one.speed(given["omega"])
    return {
        "lead": one.lead * 1e3,
        "s": one.travel(given["phi_rad"]) * 1e3,
        "v": speed * 1e3,
        "u_omega_over_v": given["omega"] / (speed * 1e3),
        "M": one.moment(given["F"], given["eta"]),
    }


def gear_pair(given: Inputs) -> Outputs:
    outer, inner = (GearPair(given["z1"], given["z2"], given["m"] / 1e3, kind) for kind in ("external", "internal"))
    train = Train(("1", "2"), (Mesh("1", "2", given["z1"], given["z2"]),), input_omega={"1": given["n1"]})
    return {
        "u12_ext": float(outer.ratio),
        "u12_int": float(inner.ratio),
        "n2_ext": gear_train.solve(train).omega["2"],
        "r1": outer.radii[0] * 1e3,
        "r2": outer.radii[1] * 1e3,
        "a_ext": outer.centre_distance * 1e3,
        "a_int": inner.centre_distance * 1e3,
        "p": outer.pitch * 1e3,
    }


def coaxial_stages(given: Inputs) -> Outputs:
    first, driving = Stage(given["z1"], given["z2"]), given["z2p"]
    kinds: tuple[MeshType, MeshType] = ("external", "internal")
    outer, inner = (willis.coaxial_wheel(first, driving, kind) for kind in kinds)
    return {
        "z3_ext": outer,
        "u13_ext_ext": _two_stages(given, driving, outer, "external"),
        "z3_int": inner,
        "u13_ext_int": _two_stages(given, driving, inner, "internal"),
        "u_if_z2p_20_z3_40": _two_stages(given, 20, 40, "external"),
    }


def _two_stages(given: Inputs, z2p: int, z3: int, kind: MeshType) -> float:
    meshes = Mesh("1", "2", given["z1"], given["z2"]), Mesh("2", "3", z2p, z3, kind)
    return _ratio(Train(("1", "2", "3"), meshes, input_omega={"1": 1}, output="3"))


def _ratio(train: Train) -> float:
    ratio = gear_train.solve(train).ratio
    return ratio.value if ratio else 0.0


def planetary(given: Inputs) -> Outputs:
    block = [Stage(given["z1"], given["z2"]), Stage(given["z2p"], given["z3"])]
    sun, planet, ring = (given["ring_case"][f"z_{name}"] for name in ("sun", "planet", "ring"))
    meshes = Mesh("s", "p", sun, planet, "external", "H"), Mesh("p", "r", planet, ring, "internal", "H")
    held = Train(("s", "p", "r", "H"), meshes, ("r",), {"s": 1}, "H")
    seen, speeds = willis.fixed_axis_ratio(block), gear_train.solve(held).omega_exact
    return {
        "u13_H": float(seen),
        "u31_H": float(1 / seen),
        "u_3H": float(willis.planetary_ratio(block, "first")),
        "u_H3": float(1 / willis.planetary_ratio(block, "first")),
        "ring_fixed_u_sunH": _ratio(held),
        "sun_fixed_u_ringH": _ratio(Train(("s", "p", "r", "H"), meshes, ("s",), {"r": 1}, "H")),
        "planet_over_carrier_ring_fixed": float(speeds["p"] / speeds["H"]),
    }


def differential(given: Inputs) -> Outputs:
    sun, ring = given["z_sun"], given["z_ring"]
    planet = (ring - sun) // 2
    meshes = Mesh("s", "p", sun, planet, "external", "H"), Mesh("p", "r", planet, ring, "internal", "H")
    driven = {"s": given["omega_sun"], "r": given["omega_ring"]}
    return {
        "u_sr_H": float(willis.fixed_axis_ratio([Stage(sun, planet), Stage(planet, ring, "internal")])),
        "omega_H": gear_train.solve(Train(("s", "p", "r", "H"), meshes, input_omega=driven)).omega["H"],
    }


def cardan(given: Inputs) -> Outputs:
    beta = radians(given["beta_deg"])
    found = hooke_joint.solve(beta, radians(given["gamma1_deg"]), given["omega1"], given["eps1"])
    whole = hooke_joint.ratio_range(beta)
    return {
        "gamma2_deg": degrees(found.pos["gamma2"]),
        "omega2": found.vel["gamma2"],
        "eps2": found.acc["gamma2"],
        "ratio_max": whole.greatest,
        "ratio_min": whole.least,
        "nonuniformity": whole.nonuniformity,
    }


def double_cardan(given: Inputs) -> Outputs:
    beta1, beta2, gamma1 = (radians(given[key]) for key in ("beta1_deg", "beta2_deg", "gamma1_deg"))
    whole, wrong = (
        hooke_joint.double_ratio_range(beta1, beta2),
        hooke_joint.double_ratio_range(beta1, beta1, radians(90)),
    )
    return {
        "ratio_equal_beta30": hooke_joint.double(beta1, beta1, gamma1, 1.0).vel["gamma3"],
        "ratio_at_gamma1": hooke_joint.double(beta1, beta2, gamma1, 1.0).vel["gamma3"],
        "ratio_max_unequal": whole.greatest,
        "ratio_min_unequal": whole.least,
        "wrong_phase_max_beta30": wrong.greatest,
        "wrong_phase_min_beta30": wrong.least,
    }


def maltese_cross(given: Inputs) -> Outputs:
    drive = Geneva(given["slots"], given["a"] / 1e3)
    found = geneva.solve(drive.slots, drive.centre_distance, radians(given["theta_deg"]), given["omega1"])
    return {
        "r1": drive.crank * 1e3,
        "r2": drive.reach * 1e3,
        "theta0_deg": degrees(drive.engaged_within),
        "phi_deg": degrees(found.pos["phi"]),
        "omega2": found.vel["phi"],
        "eps2": found.acc["phi"],
        "ratio_max": drive.greatest_ratio,
        "motion_fraction": drive.motion_share,
        "eps_ratio_entry": drive.entry_acceleration,
    }


SOLVED: dict[str, Solve] = {
    "TR-1": rack,
    "TR-2": screw,
    "TR-3": gear_pair,
    "TR-4": coaxial_stages,
    "TR-5": planetary,
    "TR-6": differential,
    "TR-7": cardan,
    "TR-8": double_cardan,
    "TR-9": maltese_cross,
}
