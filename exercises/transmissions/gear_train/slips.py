"""Lines of the known slips of a gear train; no lines where a slip has no occasion or another explains the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exercises.exercise import Steps
from exercises.transmissions.gear_train.wheels import Coaxial, Coupled, coaxial_line, each_mesh, kinds

if TYPE_CHECKING:
    from exercises.transmissions.gear_train import Givens


def sign(givens: Givens) -> str:
    """Give the sign of the ratio: one minus for each external mesh."""
    return "-" if kinds(givens.wheels).count("external") % 2 else ""


def ratio_inverted(givens: Givens) -> Steps:
    """Driving teeth over driven ones."""
    return {"u": "*".join(each_mesh(givens.wheels, lambda mesh: mesh.inverse))}


def last_inverted(givens: Givens) -> Steps:
    """The ratio of the last mesh alone upside down."""
    right = each_mesh(givens.wheels, lambda mesh: mesh.ratio)
    return {"u": "*".join([*right[:-1], each_mesh(givens.wheels, lambda mesh: mesh.inverse)[-1]])}


def sum_of_ratios(givens: Givens) -> Steps:
    """The ratios added, the sign right."""
    return {"u": f"{sign(givens)}({' + '.join(each_mesh(givens.wheels, lambda mesh: mesh.size))})"}


def ends_only(givens: Givens) -> Steps:
    """Only the first and the last wheel; right where every wheel between them is an idler."""
    if not any(isinstance(wheel, Coupled) for wheel in givens.wheels):
        return {}
    return {"u": f"{sign(givens)}z{len(givens.wheels)}/z1"}


def sign_by_wheels(givens: Givens) -> Steps:
    """One minus for each wheel; with an internal mesh, to forget its sense is the nearer slip."""
    external = kinds(givens.wheels)
    if "internal" in external or (len(external) - len(givens.wheels)) % 2 == 0:
        return {}
    return {"u": "-" + "*".join(each_mesh(givens.wheels, lambda mesh: mesh.ratio))}


def internal_as_external(givens: Givens) -> Steps:
    """Every mesh with a minus, the distance of its axes as of an external one."""
    if "internal" not in kinds(givens.wheels):
        return {}
    ratio = "*".join(each_mesh(givens.wheels, lambda mesh: mesh.ratio, "external"))
    return {**coaxial_line(givens.wheels, "external"), "u": ratio}


def axes_apart(givens: Givens) -> Steps:
    """The distance of the last mesh with the wrong sign, the sign of its ratio right."""
    last = givens.wheels[-1]
    if not isinstance(last, Coaxial):
        return {}
    return coaxial_line(givens.wheels, "internal" if last.type == "external" else "external")


def torque_divided(givens: Givens) -> Steps:
    """The torque reduced like the speed."""
    return {"M_out": f"M_in/u*eta^{len(kinds(givens.wheels))}"}
