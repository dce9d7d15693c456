"""Slips at a stepped shaft (SM-7, SM-8, SM-9; needs section 7): radius for diameter, J and W, degrees, prefixes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exercises.strength.stepped_shaft import lines
from exercises.strength.stepped_shaft.parts import Tube
from tests.slips.slip import Lines, S


def each_J(change: Callable[[str], str]) -> Lines:
    return lambda g: lines.per_segment(g, "J", lambda segment: change(segment.J))


def each_W(change: Callable[[str], str]) -> Lines:
    return lambda g: lines.per_segment(g, "W", lambda segment: change(segment.W))


def both(change: Callable[[str], str]) -> Lines:
    return lambda g: {**(each_J(change)(g) or {}), **(each_W(change)(g) or {})}


def by_radius(line: str) -> str:
    return line.replace("D{i}", "(D{i}/2)").replace("d{i}", "(d{i}/2)")


def bores_ignored(g: Any) -> Mapping[str, Any] | None:
    if not any(isinstance(segment, Tube) for segment in g.segments):
        return None
    found: dict[str, Any] = {}
    for i, segment in enumerate(g.segments, 1):
        d = f"D{i}" if isinstance(segment, Tube) else f"d{i}"
        found |= {f"J{i}": f"pi*{d}^4/32", f"W{i}": f"pi*{d}^3/16"}
    return found


def own_torque_left_out(g: Any) -> Mapping[str, Any]:
    """The torque next to the section left out: T taken over from the segment before."""
    names = list(lines.summed(g, lines.acting(g)))
    return {names[1]: names[0]}


def wrong_side(g: Any) -> Mapping[str, Any]:
    """Cut from the wrong end: the torques between the section and the wall."""
    numbers, acting = list(lines.order(g)), lines.acting(g)
    found = {}
    for at, number in enumerate(numbers):
        rest = [acting[n - 1] for n in numbers[at + 1 :]]
        found[f"T{number}"] = (" + ".join(rest) or "0*M1").replace("+ -", "- ")
    return found


def opposite_torques(g: Any) -> Mapping[str, Any]:
    turned = [term[1:] if term.startswith("-") else "-" + term for term in lines.acting(g)]
    return lines.summed(g, turned)


def one_sense(at: int) -> Lines:
    def changed(g: Any) -> Mapping[str, Any] | None:
        acting = lines.acting(g)
        numbers = list(lines.order(g))
        if at >= len(numbers):
            return None
        place = numbers[at] - 1
        turned = acting[place][1:] if acting[place].startswith("-") else "-" + acting[place]
        return lines.summed(g, [*acting[:place], turned, *acting[place + 1 :]])

    return changed


def twist(torque: str = "T{i}", form: str = "*l{i}/(G*J{i})", sign: str = "") -> Lines:
    def changed(g: Any) -> Mapping[str, Any]:
        terms = " + ".join(f"{torque}{form}".replace("{i}", str(i)) for i in range(1, len(g.segments) + 1))
        return {"phi": f"{sign}({terms})" if g.wall == "left" else f"-{sign}({terms})".replace("--", "")}

    return changed


def twist_of_free_end(g: Any) -> Mapping[str, Any] | None:
    i = lines.order(g)[0]
    if len(g.segments) > 2:
        return None
    sign = "" if g.wall == "left" else "-"
    return {"phi": f"{sign}T{i}*l{i}/(G*J{i})"}


def one_left_out(g: Any) -> Mapping[str, Any]:
    numbers = list(lines.order(g))[:-1]
    terms = " + ".join(f"T{i}*l{i}/(G*J{i})" for i in sorted(numbers))
    return {"phi": terms if g.wall == "left" else f"-({terms})"}


def two_T(change: Callable[[str], str]) -> Callable[[Any], Mapping[str, str]]:
    return lambda g: {f"T{i}": change(f"T{i}") for i in lines.order(g)}


def first_T(change: Callable[[str], str]) -> Callable[[Any], Mapping[str, str]]:
    return lambda g: {f"T{lines.order(g)[-1]}": change(f"T{lines.order(g)[-1]}")}


SLIPS = (
    # torques
    S("external torque read as T", "external_read", lines.read_as_inner),
    S("all torques added without their senses", "senses_ignored", lines.unsigned_torques),
    S("torques on the wrong side of the section", "wrong_side", wrong_side),
    S("all T with the opposite sign", "opposite_sign", {}, two_T(lambda t: f"-{t}")),
    S("all torques in the opposite sense", "opposite_sign all_opposite", opposite_torques),
    S("the first torque in the opposite sense", "term_sign opposite_sign senses_ignored", one_sense(0)),
    S("the second torque in the opposite sense", "term_sign senses_ignored", one_sense(1)),
    S("the third torque in the opposite sense", "term_sign senses_ignored", one_sense(2)),
    S("the torque at the section left out", "term_lost", own_torque_left_out),
    S("sign of the largest T at the wall, typed alone", "opposite_sign", {}, first_T(lambda t: f"-{t}")),
    S("T in kN m", "kilo_prefix factor_of_ten", {}, two_T(lambda t: f"{t}/1000")),
    S("T in N mm", "kilo_prefix factor_of_ten", {}, two_T(lambda t: f"{t}*1000")),
    S("T at the wall in kN m", "kilo_prefix factor_of_ten", {}, first_T(lambda t: f"{t}/1000")),
    S("T at the wall off by ten", "power_of_ten factor_of_ten", {}, first_T(lambda t: f"{t}*10")),
    S("T at the wall halved", "factor_two", {}, first_T(lambda t: f"{t}/2")),
    # section
    S("radius for diameter in J and W", "radius_for_diameter", both(by_radius)),
    S("radius for diameter in W", "radius_for_diameter diameter_radius", each_W(by_radius)),
    S("radius for diameter in J", "radius_for_diameter diameter_radius", each_J(by_radius)),
    S("axial moments for polar ones", "axial_moduli", both(lambda line: line + "/2")),
    S("axial W only", "axial_moduli factor_two", each_W(lambda line: line + "/2")),
    S("axial J only", "axial_moduli factor_two", each_J(lambda line: line + "/2")),
    S("bores left out", "bores_ignored", bores_ignored),
    S("W of a tube as a difference", "difference_of_moduli", lambda g: lines.difference(g) or None),
    S("J for W", "moment_for_modulus", lambda g: lines.per_segment(g, "W", lambda segment: segment.J)),
    S("W for J", "modulus_for_moment", lambda g: lines.per_segment(g, "J", lambda segment: segment.W)),
    S("pi left out in J and W", "pi_lost factor_lost", both(lambda line: line.replace("pi*", "1*"))),
    S("pi left out in W", "pi_lost factor_lost", each_W(lambda line: line.replace("pi*", "1*"))),
    # stress
    S("stress in Pa", "kilo_prefix factor_of_ten", {}, {"tau_max": "tau_max*1000000"}),
    S("stress in kPa", "kilo_prefix factor_of_ten", {}, {"tau_max": "tau_max*1000"}),
    S("stress off by ten", "power_of_ten factor_of_ten", {}, {"tau_max": "tau_max/10"}),
    S("negative stress", "opposite_sign", {}, {"tau_max": "-tau_max"}),
    S("stress doubled", "factor_two axial_moduli", {}, {"tau_max": "2*tau_max"}),
    S("stress eight times", "diameter_radius radius_for_diameter", {}, {"tau_max": "8*tau_max"}),
    S("stress by an eighth", "diameter_radius", {}, {"tau_max": "tau_max/8"}),
    S(
        "the smallest of the stresses",
        "other_function",
        lambda g: {"tau_max": lines.largest(g, "tau{i}").replace("max", "min")},
    ),
    # twist
    S("twists added without signs", "unsigned_twist", lambda g: lines.unsigned_twist(g) or None),
    S("twist with the opposite sign", "opposite_sign", {}, {"phi": "-phi"}),
    S("sign of the twist in formula and number", "opposite_sign", twist(sign="-")),
    S("twist in radians", "degrees_radians", {}, {"phi": "phi*pi/180"}),
    S("lengths left out", "factor_lost lengths_lost", twist(form="/(G*J{i})")),
    S("twist upside down in J", "upside_down", twist(form="*l{i}*J{i}/G")),
    S("twist of one segment only", "term_lost", twist_of_free_end),
    S("a segment left out", "term_lost", one_left_out),
    S("W for J in the twist", "modulus_for_moment", twist(form="*l{i}/(G*W{i})")),
    S("twist off by ten", "power_of_ten factor_of_ten", {}, {"phi": "phi*10"}),
    S("twist off by a thousand", "kilo_prefix factor_of_ten", {}, {"phi": "phi/1000"}),
    S("twist halved", "factor_two", {}, {"phi": "phi/2"}),
    S("external torques in the twist", "torques_for_inner exchanged", twist(torque="M{i}")),
    # design
    S("square root for cube root", "power", {"d_tau": "sqrt(16*T_max/(pi*tau_adm))"}),
    S("fourth root for cube root", "power", {"d_tau": "root(16*T_max/(pi*tau_adm); 4)"}),
    S("32 for 16", "bending_diameter factor_two", {"d_tau": "root(32*T_max/(pi*tau_adm); 3)"}),
    S("cube root for fourth root", "power", {"d_theta": "root(32*T_max/(pi*G*theta_adm); 3)"}),
    S("64 for 32", "factor_two", {"d_theta": "root(64*T_max/(pi*G*theta_adm); 4)"}),
    S("pi left out under the root", "factor_lost", {"d_tau": "root(16*T_max/tau_adm; 3)"}),
    S("degrees in the allowable twist", "degrees_for_radians", {"theta_adm": "theta_adm*180/pi"}),
    S("G left out", "factor_lost", {"d_theta": "root(32*T_max/(pi*theta_adm); 4)"}),
    S("the largest external torque for T", "largest_load", lambda g: lines.largest_load(g) or None),
    S("diameters in metres", "kilo_prefix factor_of_ten", {}, {"d_tau": "d_tau/1000", "d_theta": "d_theta/1000"}),
    S("one diameter in metres", "kilo_prefix factor_of_ten", {}, {"d_tau": "d_tau/1000"}),
    S("radius given for the diameter", "factor_two", {}, {"d_tau": "d_tau/2"}),
    S("both radii given", "factor_two", {}, {"d_tau": "d_tau/2", "d_theta": "d_theta/2"}),
    S("centimetres typed as mm", "power_of_ten factor_of_ten", {}, {"d_theta": "d_theta/10"}),
    S("radius for diameter and twist in radians", "radius_for_diameter", both(by_radius), {"phi": "phi*pi/180"}),
    S("senses ignored and stress in Pa", "senses_ignored", lines.unsigned_torques, {"tau_max": "tau_max*1000000"}),
)
