"""Motion laws (domain ML): each example computed from its inputs."""

from __future__ import annotations

from math import degrees, radians

import pytest

from mechanics import finite_differences, slider_crank, transfer
from mechanics.motion_law import constant_output, drive_law, fastest_extension
from tests.mechanics.examples.reading import Inputs, Outputs, Solve

CUBE = -0.1  # of t^3 in the sampled 0.9 + 0.6 t - 0.1 t^2 - 0.1 t^3: the central formula errs by CUBE tau^2
LATE = 0.15  # the second time is so long before the end, s
SHORT = 0.3  # the second travel of the example, shorter than the limit


def drive(given: Inputs) -> Outputs:
    law = drive_law(given["dq"], given["v_max"], given["a_max"])
    short = drive_law(SHORT, given["v_max"], given["a_max"])
    assert law.t_total - LATE == pytest.approx(given["t_brake"], abs=5e-10)  # printed rounded
    early, late = law.at(given["t"]), law.at(law.t_total - LATE)
    return {
        "t_acc": law.t_acc,
        "t_total": law.t_total,
        "t_cruise": law.t_cruise,
        "q_t": early.q,
        "qd_t": early.q_dot,
        "qdd_t": early.q_ddot,
        "q_brake": late.q,
        "qd_brake": late.q_dot,
        "qdd_brake": late.q_ddot,
        "dq_limit": law.v_peak * law.t_acc,
        "short_dq": short.travel,
        "short_vpeak": short.v_peak,
        "short_t_total": short.t_total,
    }


def differences(given: Inputs) -> Outputs:
    tau = given["tau"]
    rates = {name: finite_differences.first(given[name], tau)[1] for name in ("alpha", "beta")}
    bends = {name: finite_differences.second(given[name], tau)[0] for name in ("alpha", "beta")}
    link = finite_differences.coupling_link(given["alpha"], given["beta"], tau)
    return {
        "alpha_dot": rates["alpha"],
        "alpha_ddot": bends["alpha"],
        "beta_dot": rates["beta"],
        "beta_ddot": bends["beta"],
        "omega_c": link.omega[0],
        "eps_c": link.epsilon[0],
        "alpha_dot_exact": rates["alpha"] - CUBE * tau**2,
        "alpha_ddot_exact": bends["alpha"],
    }


def steady_output(given: Inputs) -> Outputs:
    beta = radians(given["beta0_deg"]) + given["omega"] * given["t"]
    found = constant_output(given["AC"], given["BC"], beta, given["omega"])
    fastest, speed = fastest_extension(given["AC"], given["BC"], given["omega"])
    return {
        "beta_deg": degrees(beta),
        "AB": found.length,
        "AB_dot": found.rate,
        "AB_ddot": found.acceleration,
        "beta_fastest_deg": degrees(fastest),
        "AB_dot_max": speed,
    }


def transfer_functions(given: Inputs) -> Outputs:
    u = transfer.of_unit_motion(slider_crank.solve(given["l1"], given["l2"], radians(given["q_deg"]), 1.0))
    slider, rod = u["slider_x"], u["alpha2"]
    return {
        "u": slider.u,
        "u_prime": slider.u_prime,
        "v": slider.rate(given["q_dot"]),
        "p": slider.acceleration(given["q_dot"], given["q_ddot"]),
        "u_phi": rod.u,
        "u_phi_prime": rod.u_prime,
    }


SOLVED: dict[str, Solve] = {
    "ML-1": drive,
    "ML-2": differences,
    "ML-3": steady_output,
    "ML-4": transfer_functions,
}
