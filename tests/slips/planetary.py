"""Slips at an epicyclic train (TR-5): fixed axes, 1 - u and 1 - 1/u, signs of meshes, reciprocals, the planet."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exercises.transmissions.planetary import planet_speed, ratio, to_carrier
from exercises.transmissions.planetary.wheels import Outer, inversion
from tests.slips.slip import Lines, S


def single(line: str, step: str = "u0") -> Lines:
    return lambda g: {step: line} if len(g.wheels) == 3 else None


def block(outer: str, ring: str, step: str = "u0") -> Lines:
    return lambda g: {step: outer if isinstance(g.wheels[-1], Outer) else ring} if len(g.wheels) == 4 else None


def held(line: str) -> Lines:
    """A line for the ratio of the free wheel to the carrier."""
    return lambda g: {"u": ratio(g, line)}


def of_held(first: str, last: str) -> Lines:
    return lambda g: {"u": ratio(g, first if g.held == "first" else last)}


def driven(wheel: str, carrier: str, step: str = "u") -> Lines:
    return lambda g: {step: wheel if g.driver == "wheel" else carrier}


def planet(change: Callable[[str], str]) -> Lines:
    def lines(g: Any) -> Mapping[str, str] | None:
        true = planet_speed(g)
        return {"n_2": change(true)} if change(true) != true else None

    return lines


SLIPS = (
    # the ratio seen from the carrier
    S(
        "sign of the internal mesh lost",
        "internal_as_external opposite_sign term_sign",
        lambda g: {"u0": inversion(g.wheels)[1:]} if inversion(g.wheels).startswith("-") else None,
    ),
    S("two external meshes with one minus", "external_once opposite_sign", block("-z2*z4/(z1*z3)", "z2*z4/(z1*z3)")),
    S("the number u0 without its sign", "opposite_sign", {}, {"u0": "-u0"}),
    S("u0 upside down", "inverted_ratio", {}, {"u0": "1/u0"}),
    S("u0 and its formula upside down", "inverted_ratio upside_down", lambda g: {"u0": f"1/({inversion(g.wheels)})"}),
    S("teeth of the planet for those of the sun", "planet_kept", single("-z3/z2")),
    S("planet over sun", "one_mesh_only", single("-z2/z1")),
    S("teeth of the planet counted twice", "planet_twice", single("-z3*z2/z1")),
    S("sun over ring", "inverted_ratio", single("-z1/z3")),
    S("ring and sun added", "sum_for_ratio", single("-(z3 + z1)/z1")),
    S("one stage of the block left out", "one_mesh_only", block("-z2/z1", "-z2/z1")),
    S("the other stage of the block left out", "one_mesh_only", block("-z4/z3", "z4/z3")),
    S("the second stage upside down", "upside_down exchanged", block("z2*z3/(z1*z4)", "-z2*z3/(z1*z4)")),
    S("the first stage upside down", "upside_down exchanged", block("z1*z4/(z2*z3)", "-z1*z4/(z2*z3)")),
    S("rims of the block exchanged", "exchanged", block("z3*z4/(z1*z2)", "-z3*z4/(z1*z2)")),
    S("outer wheels only", "exchanged factor_lost", block("z4/z1", "-z4/z1")),
    # the ratio with one wheel held
    S("the ratio seen from the carrier given", "fixed_axes", of_held("1/u0", "u0")),
    S("1 - u0 and 1 - 1/u0 exchanged", "wrong_member_held", of_held("1 - u0", "1 - 1/u0")),
    S("the number u upside down", "inverted_ratio", {}, {"u": "1/u"}),
    S("driven over driver", "ratio_inverted inverted_ratio", lambda g: {"u": f"1/({ratio(g, to_carrier(g))})"}),
    S("plus for minus", "term_sign", of_held("1 + 1/u0", "1 + u0")),
    S("one left out", "term_lost", of_held("-1/u0", "-u0")),
    S("minus one", "opposite_sign", of_held("1/u0 - 1", "u0 - 1")),
    S("sign of u", "opposite_sign", {}, {"u": "-u"}),
    S("reciprocal of u0 alone", "inverted_ratio fixed_axes fixed_reciprocal", of_held("u0", "1/u0")),
    S("twice the ratio", "factor_two", {}, {"u": "2*u"}),
    S("u off by ten", "power_of_ten", {}, {"u": "u*10"}),
    # the speeds
    S("speed multiplied", "upside_down", {"n_out": "n_in*u"}),
    S("sign of the speed", "opposite_sign", {}, {"n_out": "-n_out"}),
    S("speed without its sign", "opposite_sign", lambda g: {"n_out": "n_in/abs(u)"}),
    S("the speed in rad/s", "turns_radians", {}, {"n_out": "n_out*pi/30"}),
    S("the speed in turns a second", "turns_radians", {}, {"n_out": "n_out/60"}),
    S("the speed off by ten", "power_of_ten factor_of_ten", {}, {"n_out": "n_out*10"}),
    S("the speed off by a thousand", "kilo_prefix factor_of_ten", {}, {"n_out": "n_out/1000"}),
    S("the speed halved", "factor_two", {}, {"n_out": "n_out/2"}),
    S("the input's speed given", "factor_lost", {"n_out": "n_in"}),
    S("by the ratio seen from the carrier", "by_u0 exchanged", {"n_out": "n_in/u0"}),
    # the planet
    S(
        "speed of the planet against the carrier",
        "planet_as_seen term_lost",
        planet(lambda line: "-" + line.partition(" - ")[2]),
    ),
    S("sign of the relative turn", "term_sign", planet(lambda line: line.replace(" - z1", " + z1"))),
    S(
        "planet over sun for sun over planet",
        "exchanged upside_down",
        planet(lambda line: line.replace("z1/z2", "z2/z1")),
    ),
    S("teeth left out", "factor_lost", planet(lambda line: line.replace("z1/z2*", "1*"))),
    S(
        "the carrier taken for fixed",
        "term_lost carrier_forgotten",
        planet(lambda line: "-z1/z2*" + line.partition("*(")[2].partition(" - ")[0].join(("(", ")"))),
    ),
    S(
        "the carrier's speed left out of the difference",
        "term_lost",
        planet(
            lambda line: line.partition("*(")[0] + "*" + line.partition("*(")[2].partition(" - ")[0].join(("(", ")"))
        ),
    ),
    S("difference with the other sign", "term_sign", planet(lambda line: line.replace(" - n_", " + n_"))),
    S("sign of the planet's speed", "opposite_sign", {}, {"n_2": "-n_2"}),
    S("the planet's speed in rad/s", "turns_radians", {}, {"n_2": "n_2*pi/30"}),
    S("the planet's speed off by ten", "power_of_ten factor_of_ten", {}, {"n_2": "n_2/10"}),
    S("the planet's speed doubled", "factor_two", {}, {"n_2": "n_2*2"}),
    S("the planet as fast as the carrier", "term_lost", planet(lambda line: line.partition(" - ")[0])),
    # several at once
    S("both speeds in rad/s", "turns_radians", {}, {"n_out": "n_out*pi/30", "n_2": "n_2*pi/30"}),
    S("both speeds with the opposite sign", "opposite_sign", {}, {"n_out": "-n_out", "n_2": "-n_2"}),
    S("all numbers with the opposite sign", "opposite_sign", {}, {"u0": "-u0", "u": "-u", "n_out": "-n_out"}),
    S(
        "wrong member held, the planet's speed in rad/s",
        "wrong_member_held",
        of_held("1 - u0", "1 - 1/u0"),
        {"n_2": "n_2*pi/30"},
    ),
    S("fixed axes, speed off by ten", "fixed_axes", of_held("1/u0", "u0"), {"n_out": "n_out*10"}),
    S("planet kept, speeds left empty", "planet_kept", single("-z3/z2"), {}, "n_out n_2"),
    S(
        "formula upside down, number right",
        "inverted_ratio",
        {},
        lambda g: {"u0_formula": f"=1/({inversion(g.wheels)})"},
    ),
    S(
        "formula without its sign, number right",
        "opposite_sign internal_as_external",
        {},
        lambda g: {"u0_formula": f"=-({inversion(g.wheels)})"},
    ),
    S(
        "formula of one stage, number right",
        "one_mesh_only factor_lost",
        {},
        lambda g: {"u0_formula": "=-z2/z1"} if len(g.wheels) == 4 else None,
    ),
)
