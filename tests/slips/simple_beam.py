"""Slips at a beam (SM-11, SM-12, SM-14; needs section 7): levers, signs, prefixes, W and I, constants of the line."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exercises.exercise import each
from exercises.strength._beam import members
from exercises.strength._beam.lines import added, half_beam, reaction, supported
from tests.slips.slip import Lines, S


def about_B(change: Callable[[str, Any], str | None]) -> Lines:
    """R_A from moments about B with the turns of some loads changed; no occasion where none is."""

    def lines(givens: Any) -> Mapping[str, str] | None:
        _, B, span = supported(givens)
        true = each(givens.loads, lambda load: load.turn, B)
        changed = [change(line, load) for line, load in zip(true, givens.loads, strict=True)]
        if changed == true:
            return None
        return {"R_A": f"({added(line for line in changed if line)})/{span}"}

    return lines


def of(kind: type, change: Callable[[str], str | None]) -> Lines:
    return about_B(lambda line, load: change(line) if type(load) is kind else line)


def negative(line: str) -> str:
    return line[1:] if line.startswith("-") else "-" + line


def total(change: Callable[[str, Any], str | None]) -> Lines:
    """R_B from the sum of forces with some loads changed."""

    def lines(givens: Any) -> Mapping[str, str] | None:
        true = each(givens.loads, lambda load: load.total)
        changed = [change(line, load) for line, load in zip(true, givens.loads, strict=True)]
        return {"R_B": f"{added(line for line in changed if line)} - R_A"} if changed != true else None

    return lines


def all_loads(givens: Any) -> str:
    return added(each(givens.loads, lambda load: load.total))


def lever_from_A(givens: Any) -> Mapping[str, str] | None:
    A, _, span = supported(givens)
    return {"R_A": f"-({added(each(givens.loads, lambda load: load.turn, A))})/{span}"}


def without_overhang(givens: Any) -> Mapping[str, str] | None:
    _, _, span = supported(givens)
    return {"R_A": reaction(givens).removesuffix(span) + "L"} if span != "L" else None


def middle(givens: Any) -> Mapping[str, str]:
    A, B, _ = supported(givens)
    return {"x_M": f"({A} + {B})/2"}


def at_force(givens: Any) -> Mapping[str, str]:
    found = [f"a{i}" for i, load in enumerate(givens.loads, 1) if isinstance(load, members.Force)]
    return {"x_M": found[0]}


SLIPS = (
    # the reactions
    S(
        "a couple turned the other way",
        "couple_sense term_sign",
        lambda g: of(members.Clockwise, negative)(g) or of(members.Counterclockwise, negative)(g),
    ),
    S(
        "a couple forgotten in the moments",
        "couple_forgotten term_lost",
        lambda g: of(members.Clockwise, lambda _: None)(g) or of(members.Counterclockwise, lambda _: None)(g),
    ),
    S(
        "a force forgotten in the moments",
        "term_lost",
        lambda g: about_B(
            lambda line, load: None if load is next(x for x in g.loads if isinstance(x, members.Force)) else line
        )(g),
    ),
    S("the uniform load forgotten in the moments", "term_lost", of(members.Uniform, lambda _: None)),
    S("the uniform load's resultant at the middle of the beam", "lever_half_beam", lambda g: half_beam(g) or None),
    S(
        "q not multiplied by its length",
        "factor_lost",
        of(members.Uniform, lambda line: line.split("*(")[0] + "*(" + line.split("*(", 2)[2]),
    ),
    S("q with half of its length", "factor_two", of(members.Uniform, lambda line: line + "/2")),
    S("an upward force counted downwards", "term_sign lift_down", of(members.Lift, negative)),
    S(
        "a downward force with the sign of the other side",
        "term_sign",
        lambda g: about_B(
            lambda line, load: (
                negative(line) if load is next(x for x in g.loads if isinstance(x, members.Force)) else line
            )
        )(g),
    ),
    S("moments about the wrong support", "reactions_exchanged", lever_from_A),
    S("R_A and R_B exchanged in the fields", "fields_exchanged reactions_exchanged", {}, {"R_A": "R_B", "R_B": "R_A"}),
    S("each support carries half", "equal_reactions", lambda g: {"R_A": f"({all_loads(g)})/2"}),
    S("the length of the beam for the distance of the supports", "whole_length exchanged", without_overhang),
    S("not divided by the span", "factor_lost", lambda g: {"R_A": reaction(g)[: -len("/" + supported(g)[2])]}),
    S("sign of R_A", "opposite_sign", {}, {"R_A": "-R_A"}),
    S("sign of R_B", "opposite_sign", {}, {"R_B": "-R_B"}),
    S("R_A in newtons typed as kN", "kilo_prefix factor_of_ten", {}, {"R_A": "R_A*1000"}),
    S("both reactions in newtons", "kilo_prefix factor_of_ten", {}, {"R_A": "R_A*1000", "R_B": "R_B*1000"}),
    S("R_A off by ten", "power_of_ten factor_of_ten", {}, {"R_A": "R_A/10"}),
    S(
        "R_B from the forces, the uniform load forgotten",
        "term_lost",
        total(lambda line, load: None if isinstance(load, members.Uniform) else line),
    ),
    S(
        "R_B from the forces, a force forgotten",
        "term_lost",
        lambda g: total(
            lambda line, load: None if load is next(x for x in g.loads if isinstance(x, members.Force)) else line
        )(g),
    ),
    S(
        "R_B from the forces, q not multiplied by its length",
        "factor_lost",
        total(lambda line, load: line.split("*")[0] if isinstance(load, members.Uniform) else line),
    ),
    S(
        "R_B: upward force counted down",
        "term_sign",
        total(lambda line, load: negative(line) if isinstance(load, members.Lift) else line),
    ),
    S("R_B: R_A added", "term_sign", lambda g: {"R_B": f"{all_loads(g)} + R_A"}),
    S("R_B: R_A forgotten", "term_lost", lambda g: {"R_B": all_loads(g)}),
    S("R_B equal to R_A", "reactions_equal", {"R_B": "R_A"}),
    S(
        "the formula of R_A alone with the couple turned",
        "couple_sense term_sign",
        {},
        lambda g: (lambda found: {"R_A_formula": "=" + found["R_A"]} if found else None)(
            of(members.Clockwise, negative)(g) or of(members.Counterclockwise, negative)(g)
        ),
    ),
    S(
        "the formula of R_A alone with its sign opposite",
        "opposite_sign",
        {},
        lambda g: {"R_A_formula": "=-(" + reaction(g) + ")"},
    ),
    # the bending moment
    S("largest moment taken in the middle", "middle", middle),
    S("largest moment taken under the first force", "first_force", at_force),
    S("place measured in mm", "kilo_prefix factor_of_ten", {}, {"x_M": "x_M*1000"}),
    S("sign of the moment", "opposite_sign", {}, {"M_max": "-M_max"}),
    S("moment in N m typed as kN m", "kilo_prefix factor_of_ten", {}, {"M_max": "M_max*1000"}),
    S("moment off by ten", "power_of_ten factor_of_ten", {}, {"M_max": "M_max*10"}),
    S(
        "couple's jump left out of M",
        "term_lost",
        lambda g: (
            {
                "M_max": added(
                    line
                    for line, m in zip(each(g, lambda m: m.moment, "x_M"), (*g.supports, *g.loads), strict=True)
                    if not isinstance(m, members.Clockwise | members.Counterclockwise)
                )
            }
            if any(isinstance(m, members.Clockwise | members.Counterclockwise) for m in g.loads)
            else None
        ),
    ),
    S(
        "uniform load without its half in M",
        "factor_lost factor_two",
        lambda g: {"M_max": added(each(g, lambda m: m.moment.replace("/2*", "*"), "x_M"))},
    ),
    S(
        "uniform load to the first power in M",
        "power",
        lambda g: {"M_max": added(each(g, lambda m: m.moment.replace("; 2)", "; 1)"), "x_M"))},
    ),
    S(
        "the uniform load left out of M",
        "term_lost",
        lambda g: {
            "M_max": added(
                line
                for line, m in zip(each(g, lambda m: m.moment, "x_M"), (*g.supports, *g.loads), strict=True)
                if not isinstance(m, members.Uniform)
            )
        },
    ),
    # the stress
    S("b and h exchanged in W and I", "section_exchanged", {"W": "h*b^2/6", "I": "h*b^3/12"}),
    S("b and h exchanged in W alone", "exchanged section_exchanged", {"W": "h*b^2/6"}),
    S("W without the square", "power", {"W": "b*h/6"}),
    S("W with a cube", "power", {"W": "b*h^3/6"}),
    S("I for W", "moment_for_modulus", {"W": "b*h^3/12"}),
    S("W with twelve", "half_height_lost factor_two", {"W": "b*h^2/12"}),
    S("W with three", "factor_two", {"W": "b*h^2/3"}),
    S("W of a circle of diameter h", "circle_for_rectangle", {"W": "pi*h^3/32"}),
    S("stress upside down", "upside_down", {"sigma_max": "W/abs(M_max)"}),
    S("stress in Pa", "kilo_prefix factor_of_ten", {}, {"sigma_max": "sigma_max*1000000"}),
    S("stress in kPa", "kilo_prefix factor_of_ten", {}, {"sigma_max": "sigma_max*1000"}),
    S("stress halved", "factor_two half_height_lost", {}, {"sigma_max": "sigma_max/2"}),
    S("stress off by ten", "power_of_ten factor_of_ten", {}, {"sigma_max": "sigma_max/10"}),
    # the deflection
    S("downwards counted positive", "positive_down opposite_sign", {}, {"v_K": "-v_K"}),
    S("constants left out", "clamped term_lost", {"C": "0"}),
    S("deflection in metres", "kilo_prefix factor_of_ten", {}, {"v_K": "v_K/1000"}),
    S("E in MPa", "kilo_prefix factor_of_ten", {}, {"v_K": "v_K*1000000"}),
    S("b and h exchanged in I alone", "exchanged section_exchanged", {"I": "h*b^3/12"}),
    S("I with a square", "power", {"I": "b*h^2/12"}),
    S("I with six", "factor_two", {"I": "b*h^3/6"}),
    S("I with three", "diameter_radius coefficient", {"I": "b*h^3/3"}),
    S("deflection off by ten", "power_of_ten factor_of_ten", {}, {"v_K": "v_K*10"}),
    S(
        "moments about the wrong support and stress in Pa",
        "reactions_exchanged",
        lever_from_A,
        {"sigma_max": "sigma_max*1000000"},
    ),
    S(
        "b and h exchanged and R_A in newtons",
        "section_exchanged",
        {"W": "h*b^2/6", "I": "h*b^3/12"},
        {"R_A": "R_A*1000"},
    ),
)
