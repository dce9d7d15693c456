"""Strength of materials (domain SM): each example computed from its inputs."""

from __future__ import annotations

from math import degrees, radians

from mechanics import bar, bar_fan, beam, bending, shaft, shearing
from mechanics.bar import AxialForce, Bar, BarSegment
from mechanics.beam import Beam, BeamResult, Distributed, Force, Moment, Support
from mechanics.internal_forces import PointLoad, internal_forces
from mechanics.section import Circle, Rectangle, Ring
from mechanics.shaft import Segment, Shaft, ShaftResult, Torque
from mechanics.strain import Material, strain_of
from mechanics.stress import PlaneStress, StressState
from tests.mechanics.examples.reading import Inputs, Outputs, Solve


def method_of_sections(given: Inputs) -> Outputs:
    found = internal_forces([PointLoad(tuple(given["P"]), tuple(given["point"]))], (given["section_x"], 0.0, 0.0))
    return {name: getattr(found, name) for name in ("N", "Qy", "Qz", "Mx", "My", "Mz")}


def axial_bar(given: Inputs) -> Outputs:
    area = Circle(given["d"]).area
    found = bar.solve(Bar((BarSegment(given["l"], area, given["E"]),), (AxialForce(given["l"], given["P"]),)))
    (piece,) = found.pieces
    state = strain_of(StressState(((piece.sigma1, 0, 0), (0, 0, 0), (0, 0, 0))), Material(given["E"], given["nu"]))
    lateral = state.components[1][1]
    return {
        "F": area,
        "sigma": piece.sigma1,
        "strain": state.components[0][0],
        "dl": found.u[-1].u,
        "strain_lat": lateral,
        "dd": lateral * given["d"],
        "n_safety": given["sigma_adm"] / piece.sigma1,
        "d_min": bar.required_diameter(given["P"], given["sigma_adm"]),
    }


def stepped_bar(given: Inputs) -> Outputs:
    segments = tuple(BarSegment(L, A, given["E"]) for L, A in zip(given["l"], given["F"], strict=True))
    ends = Bar(segments).ends[1:]
    forces = tuple(AxialForce(x, F) for x, F in zip(ends, given["P"], strict=True))
    found = bar.solve(Bar(segments, forces))
    return {
        "N": [piece.N1 for piece in found.pieces],
        "sigma": [piece.sigma1 for piece in found.pieces],
        "dl": [piece.elongation for piece in found.pieces],
        "u_end": found.u[-1].u,
    }


def bar_between_walls(given: Inputs) -> Outputs:
    def segments(dT: float) -> tuple[BarSegment, ...]:
        sizes = ((given["a"], given["F1"]), (given["b"], given["F2"]))
        return tuple(BarSegment(L, A, given["E"], given["alpha_T"], dT) for L, A in sizes)

    loaded = bar.solve(Bar(segments(0.0), (AxialForce(given["a"], given["P"]),), "fixed_fixed"))
    warmed = bar.solve(Bar(segments(given["dT"]), (), "fixed_fixed"))
    one, two = loaded.pieces
    return {
        "N1": one.N1,
        "N2": two.N1,
        "u": loaded.u[1].u,
        "sigma1": one.sigma1,
        "sigma2": two.sigma1,
        "N_thermal": warmed.pieces[0].N1,
        "sigma1_thermal": warmed.pieces[0].sigma1,
    }


def elastic_constants(given: Inputs) -> Outputs:
    found = Material(given["E"], given["nu"])
    return {"G": found.G, "K": found.K}


def bolt(given: Inputs) -> Outputs:
    tau = shearing.stress(given["Q"], given["d"], given["shear_planes"])
    return {
        "F": Circle(given["d"]).area,
        "tau": tau,
        "gamma": shearing.strain(tau, given["G"]),
        "ds": shearing.shift(tau, given["G"], given["h"]),
        "bolts_needed": shearing.bolts_needed(given["Q"], given["d"], given["tau_adm"], given["shear_planes"]),
    }


def round_shaft(given: Inputs) -> Outputs:
    full, hollow = Circle(given["d"]), Ring(given["d"], 0.03)
    found, bored = (
        shaft.solve(Shaft(given["G"], (Segment(given["l"], given["d"], bore),), (Torque(given["l"], given["T"]),)))
        for bore in (0.0, 0.03)
    )
    phi = found.phi[-1].phi
    return {
        "J_p": full.torsion_constant,
        "W_p": full.torsion_modulus,
        "tau_max": found.tau_abs_max,
        "tau_rho": found.tau_abs_max * given["rho"] / (given["d"] / 2),
        "theta": found.pieces[0].twist_per_m,
        "phi": phi,
        "phi_deg": degrees(phi),
        "hollow_d_in": hollow.d,
        "J_p_hollow": hollow.torsion_constant,
        "tau_max_hollow": bored.tau_abs_max,
    }


def torque_diagram(given: Inputs) -> Outputs:
    """The example counts T from the left, its torques turned the other way round: T is minus their sum on the right."""
    lengths = (0.6, 0.8)

    def turned(order: list[float]) -> ShaftResult:
        places = (0.0, lengths[0], sum(lengths))
        torques = tuple(Torque(x, -M) for x, M in zip(places, order, strict=True))
        return shaft.solve(Shaft(8e10, tuple(Segment(L, 0.05) for L in lengths), torques, "free_free"))

    found, other = turned(given["M"]), turned(given["alt_order"])
    return {
        "T": [piece.T for piece in found.pieces],
        "T_max_abs": found.T_abs_max,
        "T_alt": [piece.T for piece in other.pieces],
        "T_max_abs_alt": other.T_abs_max,
        "phi_l": list(lengths),
        "phi_total_d50_G80": found.phi[-1].phi,
    }


def shaft_design(given: Inputs) -> Outputs:
    limits = (given["tau_adm"], radians(given["theta_adm_deg_per_m"]))
    design = shaft.solve(
        Shaft(given["G"], (Segment(1.0, 0.05),), (Torque(1.0, given["T"]),), "fixed_free", *limits)
    ).design
    assert design is not None
    return {
        "d_strength": design.D_strength,
        "d_stiffness": design.D_stiffness,
        "d_required": design.D_required,
        "governs": "stiffness" if design.D_required == design.D_stiffness else "strength",
    }


def shaft_between_walls(given: Inputs) -> Outputs:
    segments = (Segment(given["a"], given["d1"]), Segment(given["b"], given["d2"]))
    found = shaft.solve(Shaft(given["G"], segments, (Torque(given["a"], given["M"]),), "fixed_fixed"))
    one, two = found.pieces
    return {
        "T_A": -found.reactions.left,
        "T_B": -found.reactions.right,
        "phi_C": found.phi[1].phi,
        "tau1": one.tau_max,
        "tau2": two.tau_max,
    }


def simple(L: float, *loads: Force | Moment | Distributed, EJ: float = 1814400.0, held: str = "pin") -> BeamResult:
    first = Support(0.0, "fixed") if held == "fixed" else Support(0.0)
    return beam.solve(Beam(L, 2.1e11, (first, Support(L, "roller")), loads, I=EJ / 2.1e11))


def diagrams(given: Inputs) -> Outputs:
    L, a, x_M0 = given["L"], given["a"], given["x_M0"]
    spread = Distributed(0.0, L, -given["q"], -given["q"])
    found = simple(L, Force(a, -given["P"]), spread, Moment(x_M0, -given["M0"]))
    after_P, after_M0 = found.pieces[1], found.pieces[2]
    left, right = found.reactions
    return {
        "R_A": left.Fy,
        "R_B": right.Fy,
        "Q_0": found.at(0.0).V,
        "Q_a_minus": found.at(a).V,
        "Q_a_plus": after_P.V,
        "Q_L": found.at(L).V,
        "M_at_P": found.at(a).M,
        "M_3_minus": found.at(x_M0).M,
        "M_3_plus": after_M0.M,
        "x_Q0": None,  # V jumps over zero at P and is zero nowhere
        "M_max": found.M_max,
        "x_M_max": found.x_M_abs_max,
    }


def bending_stress(given: Inputs) -> Outputs:
    section, flat = Rectangle(given["b"], given["h"]), Rectangle(given["h"], given["b"])
    M, allowed = given["M"], given["sigma_adm"]
    return {
        "J": section.second_moment,
        "W": section.section_modulus,
        "sigma_max": bending.normal_stress(M, -given["h"] / 2, section),
        "sigma_y": bending.normal_stress(M, -given["y"], section),
        "rho_curv": bending.curvature_radius(M, 2.1e11 * section.second_moment),
        "W_required": bending.required_modulus(M, allowed),
        "d_required": bending.required_diameter(M, allowed),
        "wrong_flat_W": flat.section_modulus,
    }


def cantilever(given: Inputs) -> Outputs:
    L = given["L"]
    made = Beam(L, 2.1e11, (Support(0.0, "fixed"),), (Force(L, -given["P"]),), I=given["EJ"] / 2.1e11)
    found = beam.solve(made)
    end, inside = found.at(L), found.at(given["x"])
    return {"z_end": end.v, "theta_end": end.theta, "z_x": inside.v, "theta_x": inside.theta}


def two_supports(given: Inputs) -> Outputs:
    L, q, EJ = given["L"], given["q"], given["EJ"]
    found = simple(L, Force(given["a"], -given["P"]), Distributed(0.0, L, -q, -q), EJ=EJ)
    left, right = found.reactions
    start = found.at(0.0).theta
    return {
        "R_A": left.Fy,
        "R_B": right.Fy,
        "C1": EJ * start,
        "theta_A": start,
        "z_mid": found.at(given["x"]).v,
        "x_max": found.x_v_extreme,
        "z_max": found.v_extreme,
    }


def stress_state(given: Inputs) -> Outputs:
    state = StressState(given["sigma_MPa"])
    acting = state.on(given["n"])
    (x, xy, _), (_, y, _), _ = state.components
    plane = PlaneStress(x, y, xy)
    I1, I2, I3 = state.invariants
    return {
        "I1": I1,
        "I2": I2,
        "I3": I3,
        "principal": state.principal,
        "tau_max": state.tau_max,
        "von_mises": state.von_mises,
        "p_n": acting.p,
        "sigma_n": acting.normal,
        "tau_n": acting.shear,
        "plane_sigma1": plane.principal[0],
        "plane_sigma2": plane.principal[1],
        "plane_angle_deg": degrees(plane.angle),
    }


def strain_state(given: Inputs) -> Outputs:
    found = strain_of(StressState(given["sigma_MPa"]), Material(given["E_MPa"], given["nu"]))
    gamma_xy, gamma_yz, gamma_zx = found.shear
    return {
        "strain": found.components,
        "gamma_xy": gamma_xy,
        "gamma_yz": gamma_yz,
        "gamma_zx": gamma_zx,
        "volumetric": found.volumetric,
    }


def propped_cantilever(given: Inputs) -> Outputs:
    L, q = given["L"], given["q"]
    spread, middle = Distributed(0.0, L, -q, -q), Force(L / 2, -given["P_mid"])
    uniform, point = (simple(L, load, EJ=given["EJ"], held="fixed") for load in (spread, middle))
    both = simple(L, spread, middle, EJ=given["EJ"], held="fixed")
    (piece,) = uniform.pieces
    return {
        "R_B": uniform.reactions[1].Fy,
        "R_A": uniform.reactions[0].Fy,
        "M_A": uniform.at(0.0).M,
        "M_max": uniform.M_max,
        "x_M_max": -piece.V / piece.w,
        "R_B_P": point.reactions[1].Fy,
        "M_A_P": point.at(0.0).M,
        "R_B_both": both.reactions[1].Fy,
    }


def three_bar_truss(given: Inputs) -> Outputs:
    found = bar_fan.three_bars(given["P"], radians(given["alpha_deg"]), given["l"], given["E"] * given["F"])
    sigma = found.N_middle / given["F"]
    return {"N_middle": found.N_middle, "N_side": found.N_side, "sigma_middle": sigma, "u": found.u}


SOLVED: dict[str, Solve] = {
    "SM-1": method_of_sections,
    "SM-2": axial_bar,
    "SM-3": stepped_bar,
    "SM-4": bar_between_walls,
    "SM-5": elastic_constants,
    "SM-6": bolt,
    "SM-7": round_shaft,
    "SM-8": torque_diagram,
    "SM-9": shaft_design,
    "SM-10": shaft_between_walls,
    "SM-11": diagrams,
    "SM-12": bending_stress,
    "SM-13": cantilever,
    "SM-14": two_supports,
    "SM-15": stress_state,
    "SM-16": strain_state,
    "SM-17": propped_cantilever,
    "SM-18": three_bar_truss,
}
