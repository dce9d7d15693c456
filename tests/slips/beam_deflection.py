"""Slips at the elastic line (SM-11, SM-14): brackets, constants, signs, coefficients, prefixes."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from exercises.exercise import each
from exercises.strength._beam import members
from exercises.strength._beam.lines import added, half_beam, other_reaction, reaction, slipped
from exercises.strength.beam_deflection.lines import bending, deflection
from tests.slips.simple_beam import about_B, negative, of
from tests.slips.slip import Lines, S


def typed(name: str, change: Callable[[str], str]) -> Lines:
    """A slip in the typed function alone."""

    def texts(g: Any) -> Mapping[str, str] | None:
        true = bending(g) if name == "M" else deflection(g, "x")
        return {name: "=" + change(true)} if change(true) != true else None

    return texts


def open_brackets(line: str) -> str:
    return re.sub(r"macaulay\(([^;]+); (\d)\)", r"(\1)^\2", line)


def one_open(line: str) -> str:
    return re.sub(r"macaulay\(([^;]+); (\d)\)", r"(\1)^\2", line, count=1)


def not_ended(line: str) -> str:
    return re.sub(r"\((macaulay\([^;]+; \d\)) - macaulay\([^;]+; \d\)\)", r"\1", line)


def without(kind: type) -> Callable[[Any, str, str], str]:
    def line(g: Any, what: str, x: str) -> str:
        return added(
            text for text, m in zip(each(g, lambda m: getattr(m, what), x), (*g.supports, *g.loads), strict=True)
            if not isinstance(m, kind)
        )  # fmt: skip

    return line


def left_out(kind: type) -> Lines:
    """A kind of member left out of M(x)."""

    def texts(g: Any) -> Mapping[str, str] | None:
        if not any(isinstance(m, kind) for m in (*g.supports, *g.loads)):
            return None
        return {"M": "=" + without(kind)(g, "moment", "x")}

    return texts


def left_out_of_v(kind: type) -> Lines:
    def texts(g: Any) -> Mapping[str, str] | None:
        if not any(isinstance(m, kind) for m in (*g.supports, *g.loads)):
            return None
        return {"v": f"=({without(kind)(g, 'sag', 'x')} + C*x)/EI"}

    return texts


def from_the_end(g: Any) -> Mapping[str, str] | None:
    if not isinstance(g.supports[1], members.InsetB):
        return None
    return {"f_B": added(each(g, lambda m: m.sag, "L")), "C": "-f_B/L"}


def place_B(g: Any) -> str:
    return str(g.supports[1].place).replace("{i}", "2")


SLIPS = (
    # the reaction
    S("the resultant of q at the middle of the beam", "lever_half_beam", lambda g: half_beam(g) or None),
    S("a couple in the other sense", "couple_sense term_sign", lambda g: slipped(g, members.OPPOSITE) or None),
    S(
        "a couple forgotten in the moments",
        "term_lost",
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
    S("an upward force counted downwards", "term_sign", of(members.Lift, negative)),
    S(
        "q not multiplied by its length",
        "factor_lost",
        of(members.Uniform, lambda line: line.split("*(")[0] + "*(" + line.split("*(", 2)[2]),
    ),
    S("moments about the wrong support", "reactions_exchanged", lambda g: other_reaction(g)),
    S("not divided by the span", "factor_lost", lambda g: {"R_A": reaction(g).rpartition("/")[0]}),
    S("R_A in newtons", "kilo_prefix factor_of_ten", {}, {"R_A": "R_A*1000"}),
    S("sign of R_A", "opposite_sign", {}, {"R_A": "-R_A"}),
    S("R_A off by ten", "power_of_ten factor_of_ten", {}, {"R_A": "R_A*10"}),
    S(
        "the whole beam's length for the span",
        "exchanged whole_length",
        lambda g: {"R_A": reaction(g).rpartition("/")[0] + "/L"} if isinstance(g.supports[1], members.InsetB) else None,
    ),
    # the bending moment
    S("sign of M", "opposite_sign", {}, typed("M", lambda line: f"-({line})")),
    S(
        "brackets open in M and v",
        "open_brackets",
        lambda g: {
            "M": open_brackets(bending(g)),
            "v": open_brackets(deflection(g, "x")),
            "v_m": open_brackets(deflection(g, "x_m")),
        },
    ),
    S(
        "brackets open in M alone",
        "everywhere open_too_early stretch from_here not_covered",
        {},
        typed("M", open_brackets),
    ),
    S("the first bracket open in M", "open_too_early stretch from_here", {}, typed("M", one_open)),
    S(
        "the uniform load not ended in M and v",
        "load_not_ended from_here",
        lambda g: {
            "M": not_ended(bending(g)),
            "v": not_ended(deflection(g, "x")),
            "v_m": not_ended(deflection(g, "x_m")),
        },
    ),
    S("the uniform load not ended in M", "from_here", {}, typed("M", not_ended)),
    S(
        "half forgotten at q in M",
        "from_here stretch everywhere",
        {},
        typed("M", lambda line: line.replace("/2*(", "*(")),
    ),
    S("q to the first power in M", "from_here stretch", {}, typed("M", lambda line: line.replace("; 2)", "; 1)"))),
    S("uniform load left out of M", "from_here stretch", {}, left_out(members.Uniform)),
    S("force left out of M", "from_here stretch", {}, left_out(members.Force)),
    S(
        "couple left out of M",
        "from_here stretch",
        {},
        lambda g: left_out(members.Clockwise)(g) or left_out(members.Counterclockwise)(g),
    ),
    S("reaction B left out of M", "from_here stretch", {}, left_out(members.InsetB)),
    S("reaction A left out of M", "everywhere", {}, left_out(members.LeftEnd)),
    S("M halved", "factor", {}, typed("M", lambda line: f"({line})/2")),
    S("M a thousand times", "factor", {}, typed("M", lambda line: f"1000*({line})")),
    # the constant
    S("the constant lost", "constant_lost", {"C": "0"}, {}, "C"),
    S("the constant from the free end", "constant_from_the_end", from_the_end),
    S("sign of the constant", "opposite_sign term_sign", {}, {"C": "-C"}),
    S("minus lost in the constant", "opposite_sign term_sign", lambda g: {"C": f"f_B/{place_B(g)}"}),
    S("the constant not divided by the span", "factor_lost", {"C": "-f_B"}),
    S("the constant in N m^2", "kilo_prefix factor_of_ten", {}, {"C": "C*1000"}),
    S("the constant off by ten", "power_of_ten factor_of_ten", {}, {"C": "C/10"}),
    S(
        "the reaction to the second power in the constant",
        "power",
        lambda g: {
            "f_B": added(
                each(g.supports[:1], lambda s: s.sag, place_B(g)) + each(g.loads, lambda load: load.sag, place_B(g))
            ).replace("^3/6", "^2/6")
        },
    ),
    S(
        "uniform load left out of the constant",
        "term_lost",
        lambda g: {
            "f_B": added(
                [s.sag.replace("{x}", place_B(g)) for s in g.supports[:1]]
                + [
                    line
                    for line, load in zip(each(g.loads, lambda load: load.sag, place_B(g)), g.loads, strict=True)
                    if not isinstance(load, members.Uniform)
                ]
            )
        },
    ),
    S("the constant halved", "factor_two", {}, {"C": "C/2"}),
    # the elastic line
    S(
        "downwards positive",
        "positive_down opposite_sign",
        lambda g: {"v": f"-{deflection(g, 'x')}", "v_m": f"-{deflection(g, 'x_m')}"},
    ),
    S("downwards positive in the function alone", "opposite_sign", {}, typed("v", lambda line: f"-({line})")),
    S(
        "the constant's term left out of v",
        "constant everywhere",
        {},
        typed("v", lambda line: line.replace(" + C*x", "")),
    ),
    S("the constant without x", "constant everywhere", {}, typed("v", lambda line: line.replace("C*x", "C"))),
    S(
        "sign of the constant's term",
        "constant everywhere",
        {},
        typed("v", lambda line: line.replace("+ C*x", "- C*x")),
    ),
    S("EI left out", "factor everywhere", {}, typed("v", lambda line: line.replace("/EI", ""))),
    S("R_A x^3 by three", "everywhere", {}, typed("v", lambda line: line.replace("R_A*x^3/6", "R_A*x^3/3"))),
    S("R_A x squared", "everywhere", {}, typed("v", lambda line: line.replace("R_A*x^3/6", "R_A*x^2/2"))),
    S(
        "twenty-fourth part of q forgotten",
        "from_here stretch",
        {},
        typed("v", lambda line: line.replace("/24*", "/6*")),
    ),
    S("uniform load left out of v", "from_here stretch", {}, left_out_of_v(members.Uniform)),
    S("force left out of v", "from_here stretch", {}, left_out_of_v(members.Force)),
    S("brackets open in v alone", "everywhere open_too_early stretch", {}, typed("v", open_brackets)),
    # numbers from it
    S("deflection at K in metres", "kilo_prefix factor_of_ten", {}, {"v_K": "v_K/1000"}),
    S("sign of the deflection at K", "opposite_sign positive_down", {}, {"v_K": "-v_K"}),
    S("deflection at K off by ten", "power_of_ten factor_of_ten", {}, {"v_K": "v_K*10"}),
    S("both deflections in metres", "kilo_prefix factor_of_ten", {}, {"v_K": "v_K/1000", "v_m": "v_m/1000"}),
    S("both deflections downwards", "opposite_sign", {}, {"v_K": "-v_K", "v_m": "-v_m"}),
    S("largest deflection in the middle", "middle", lambda g: {"x_m": f"{place_B(g)}/2"}),
    S("place of the largest deflection in mm", "kilo_prefix factor_of_ten", {}, {"x_m": "x_m*1000"}),
    S("place measured from B", "other_end", {}, {"x_m": "L - x_m"}),
    S("largest deflection in metres", "kilo_prefix factor_of_ten", {}, {"v_m": "v_m/1000"}),
    S("largest deflection halved", "factor_two", {}, {"v_m": "v_m/2"}),
    S("deflections exchanged", "fields_exchanged", {}, {"v_K": "v_m", "v_m": "v_K"}),
    S(
        "lever of half the beam and v_K in metres",
        "lever_half_beam",
        lambda g: half_beam(g) or None,
        {"v_K": "v_K/1000"},
    ),
)
