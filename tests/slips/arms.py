"""Slips at the arms of laboratory TMM-2 (VP-6, VP-7, VP-8, RP-2): kinds of angles, lost terms, signs, moduli, units."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from exercises.exercise import Steps
from tests.slips.slip import Lines, S

StepsOf = Callable[[Any], Steps]


def parts(line: str) -> list[str]:
    """Cut a sum into its terms with their signs."""
    return re.findall(r"[+-]?(?:[^+\-()]|\([^()]*\))+", line.replace(" ", ""))


def joined(terms: list[str]) -> str:
    return "".join(term if term[0] in "+-" else "+" + term for term in terms).removeprefix("+") or "0"


def flipped(term: str) -> str:
    return "+" + term[1:] if term[0] == "-" else "-" + term.removeprefix("+")


def turned(term: str) -> str:
    return term.replace("sin", "zzz").replace("cos", "sin").replace("zzz", "cos")


def changing(steps: StepsOf, name: str, at: int, change: Callable[[str], str | None]) -> Lines:
    """Change one term of a line; no occasion where the line has no such term or nothing changes."""

    def lines(g: Any) -> Mapping[str, Any] | None:
        terms = parts(str(steps(g)[name]))
        if not -len(terms) <= at < len(terms):
            return None
        place = at % len(terms)
        changed = change(terms[place])
        if changed == terms[place]:
            return None
        return {name: joined([*terms[:place], *([changed] if changed else []), *terms[place + 1 :]])}

    return lines


def holding(steps: StepsOf, name: str, mark: str, change: Callable[[str], str | None]) -> Lines:
    """Change the first term that holds a mark: `^2` of the centripetal ones, `2*` of Coriolis'."""

    def lines(g: Any) -> Mapping[str, Any] | None:
        terms = parts(str(steps(g)[name]))
        place = next((at for at, term in enumerate(terms) if mark in term), None)
        return None if place is None else changing(steps, name, place, change)(g)

    return lines


def slips(steps: StepsOf, coriolis: bool = True) -> tuple[S, ...]:
    """Give the slips of an arm; one whose slide is not turned has no term of Coriolis."""
    return tuple(slip for slip in _slips(steps) if coriolis or "Coriolis" not in slip.name)


def _slips(steps: StepsOf) -> tuple[S, ...]:

    def lost(_: str) -> None:
        return None

    def term(name: str, at: int, change: Callable[[str], str | None]) -> Lines:
        return changing(steps, name, at, change)

    def marked(name: str, mark: str, change: Callable[[str], str | None]) -> Lines:
        return holding(steps, name, mark, change)

    return (
        # the place of the gripper
        S("first link forgotten in x", "term_lost", term("x_D", 0, lost)),
        S("last link forgotten in x", "term_lost", term("x_D", -1, lost)),
        S("last link forgotten in y", "term_lost", term("y_D", -1, lost)),
        S("last link subtracted in x", "term_sign", term("x_D", -1, flipped)),
        S("last link subtracted in y", "term_sign", term("y_D", -1, flipped)),
        S("sine for cosine in x", "sine_cosine", term("x_D", -1, turned)),
        S("cosine for sine in y", "sine_cosine", term("y_D", -1, turned)),
        S("sine for cosine at the second term of x", "sine_cosine", term("x_D", 1, turned)),
        S("x in millimetres", "kilo_prefix factor_of_ten", {}, {"x_D": "x_D*1000"}),
        S("sign of y", "opposite_sign", {}, {"y_D": "-y_D"}),
        S("x and y exchanged", "fields_exchanged", {}, {"x_D": "y_D", "y_D": "x_D"}),
        S("direction of the last link in radians", "degrees_radians", {}, {"alpha3": "alpha3*pi/180"}),
        S("direction of the last link with the opposite sign", "opposite_sign", {}, {"alpha3": "-alpha3"}),
        S(
            "radians mode in x",
            "degrees_radians",
            {},
            lambda g: {"x_D": re.sub(r"(sin|cos)\(([^()]*)\)", r"\1(\2*180/pi)", str(steps(g)["x_D"]))},
        ),
        # turning
        S("angular velocity in turns a minute", "turns_radians", {}, {"omega3": "omega3*30/pi"}),
        S("angular velocity in degrees a second", "degrees_radians", {}, {"omega3": "omega3*180/pi"}),
        S("sign of the angular velocity", "opposite_sign", {}, {"omega3": "-omega3"}),
        S("sign of the angular acceleration", "opposite_sign", {}, {"epsilon3": "-epsilon3"}),
        S("angular acceleration in degrees", "degrees_radians", {}, {"epsilon3": "epsilon3*180/pi"}),
        S(
            "difference for a sum of the angular velocities",
            "term_sign",
            lambda g: (
                {"omega3": str(steps(g)["omega3"]).replace(" + ", " - ")} if " + " in str(steps(g)["omega3"]) else None
            ),
        ),
        # velocities
        S("first term forgotten in v_x", "term_lost", term("v_x", 0, lost)),
        S("second term forgotten in v_x", "term_lost", term("v_x", 1, lost)),
        S("last term forgotten in v_x", "term_lost", term("v_x", -1, lost)),
        S("last term forgotten in v_y", "term_lost", term("v_y", -1, lost)),
        S("sign of the last term in v_x", "term_sign", term("v_x", -1, flipped)),
        S("sign of the first term in v_y", "term_sign", term("v_y", 0, flipped)),
        S("sign of the last term in v_y", "term_sign", term("v_y", -1, flipped)),
        S("sine for cosine in the last term of v_y", "sine_cosine", term("v_y", -1, turned)),
        S("cosine for sine in the last term of v_x", "sine_cosine", term("v_x", -1, turned)),
        S(
            "rate forgotten in the last term of v_x",
            "factor_lost",
            term("v_x", -1, lambda t: t.replace("*omega3", "").replace("*Theta1_d", "")),
        ),
        S("v_x in mm/s", "kilo_prefix factor_of_ten", {}, {"v_x": "v_x*1000"}),
        S("sign of v_y", "opposite_sign", {}, {"v_y": "-v_y"}),
        S("v_x and v_y exchanged", "fields_exchanged", {}, {"v_x": "v_y", "v_y": "v_x"}),
        S(
            "formula of v_x with a sign, number right",
            "term_sign",
            {},
            lambda g: {"v_x_formula": "=" + str((term("v_x", -1, flipped)(g) or {})["v_x"])},
        ),
        S(
            "formula of v_y with a term lost, number right",
            "term_lost",
            {},
            lambda g: {"v_y_formula": "=" + str((term("v_y", -1, lost)(g) or {})["v_y"])},
        ),
        S(
            "components of the velocity added",
            "components_added",
            {"v_D": "abs(v_x) + abs(v_y)", "a_D": "abs(a_x) + abs(a_y)"},
        ),
        S("components of the velocity added with their signs", "power components_added", {"v_D": "abs(v_x + v_y)"}),
        S("root forgotten in v_D", "power", {"v_D": "v_x^2 + v_y^2"}),
        S("difference of squares in v_D", "term_sign", {"v_D": "sqrt(abs(v_x^2 - v_y^2))"}),
        S("v_D in mm/s", "kilo_prefix factor_of_ten", {}, {"v_D": "v_D*1000"}),
        S("speed of the pin upside down in the ratio", "inverted_ratio", {}, {"k_v": "1/k_v"}),
        S("ratio doubled", "factor_two", {}, {"k_v": "2*k_v"}),
        # accelerations
        S("a centripetal term forgotten in a_x", "term_lost", marked("a_x", "^2", lost)),
        S("a centripetal term forgotten in a_y", "term_lost", marked("a_y", "^2", lost)),
        S("sign of a centripetal term in a_x", "term_sign", marked("a_x", "^2", flipped)),
        S("square forgotten in a_x", "power", marked("a_x", "^2", lambda t: t.replace("^2", ""))),
        S("square forgotten in a_y", "power", marked("a_y", "^2", lambda t: t.replace("^2", ""))),
        S("sine for cosine in a centripetal term", "sine_cosine", marked("a_x", "^2", turned)),
        S("Coriolis' term forgotten in a_x", "term_lost", marked("a_x", "2*h", lost)),
        S(
            "Coriolis' two forgotten in a_x",
            "factor_two factor_lost",
            marked("a_x", "2*h", lambda t: t.replace("2*h", "h")),
        ),
        S("sign of Coriolis' term in a_y", "term_sign", marked("a_y", "2*h", flipped)),
        S("first term forgotten in a_x", "term_lost push_lost", term("a_x", 0, lost)),
        S("sign of the first term in a_y", "term_sign", term("a_y", 0, flipped)),
        S("last term forgotten in a_y", "term_lost", term("a_y", -1, lost)),
        S("sine for cosine in the first term of a_y", "sine_cosine", term("a_y", 0, turned)),
        S("sign of a_x", "opposite_sign", {}, {"a_x": "-a_x"}),
        S("a_y in mm/s^2", "kilo_prefix factor_of_ten", {}, {"a_y": "a_y*1000"}),
        S("root forgotten in a_D", "power", {"a_D": "a_x^2 + a_y^2"}),
        S("a_D off by ten", "power_of_ten factor_of_ten", {}, {"a_D": "a_D*10"}),
        S("acceleration of the slide's foot off by a thousand", "kilo_prefix factor_of_ten", {}, {"a_C": "a_C*1000"}),
        S("speed of the slide's foot with the opposite sign", "opposite_sign", {}, {"v_C": "-v_C"}),
    )
