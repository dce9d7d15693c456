"""Slips at the table of the RRP arm (DH-2, DH-3, DH-13): rows, signs, the other convention, product, the point M."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exercises.manipulators.rrp_table import THETA
from tests.slips.rrr_matrices import CRAIG, STANDARD, entries, form, pairs, point, transposed
from tests.slips.slip import S

EXCHANGED = STANDARD.replace("sin", "zzz").replace("cos", "sin").replace("zzz", "cos")


def table(
    one: str = "q1; L1; 0; pi/2", two: str = "{theta}; 0; 0; pi/2", three: str = "0; q3; 0; {side}", order: str = "123"
) -> Callable[[Any], dict[str, str]]:
    """Type a table; the matrices and the point stay as in the right one."""

    def typed(g: Any) -> dict[str, str]:
        side = "pi/2" if g.side == "left" else "-pi/2"
        rows = {"1": one, "2": two, "3": three}
        text = ", ".join(f"[{rows[at]}]" for at in order)
        return {"P": "=[" + text.format(theta=THETA[g.measure], side=side, other="-" + side.replace("--", "")) + "]"}

    return typed


def columns(*order: int) -> Callable[[Any], dict[str, str]]:
    def typed(g: Any) -> dict[str, str]:
        side = "pi/2" if g.side == "left" else "-pi/2"
        rows = [["q1", "L1", "0", "pi/2"], [THETA[g.measure], "0", "0", "pi/2"], ["0", "q3", "0", side]]
        return {"P": "=[" + ", ".join("[" + "; ".join(row[at] for at in order) + "]" for row in rows) + "]"}

    return typed


def of_measure(measures: str, theta: str) -> Callable[[Any], dict[str, str] | None]:
    return lambda g: table(two=theta + "; 0; 0; pi/2")(g) if g.measure in measures.split() else None


SLIPS = (
    # the table
    S("sign of alpha1", "table_alpha_sign", {}, table(one="q1; L1; 0; -pi/2")),
    S("sign of alpha2", "table_alpha_sign", {}, table(two="{theta}; 0; 0; -pi/2")),
    S("sign of alpha3", "table_alpha_sign table_tool", {}, table(three="0; q3; 0; {other}")),
    S("alpha1 left at zero", "table_alpha table_alpha_sign", {}, table(one="q1; L1; 0; 0")),
    S("alpha2 left at zero", "table_alpha", {}, table(two="{theta}; 0; 0; 0")),
    S("alpha3 left at zero", "table_alpha table_tool", {}, table(three="0; q3; 0; 0")),
    S("height along x", "table_swapped", {}, table(one="q1; 0; L1; pi/2")),
    S("slide along x", "table_swapped table_place", {}, table(three="0; 0; q3; {side}")),
    S("height forgotten", "table_length", {}, table(one="q1; 0; 0; pi/2")),
    S("height with a minus", "table_length_sign", {}, table(one="q1; -L1; 0; pi/2")),
    S("offset d in the last row", "table_length table_tool", {}, table(three="0; q3; d; {side}")),
    S("q1 forgotten", "table_variable", {}, table(one="0; L1; 0; pi/2")),
    S("q2 forgotten", "table_variable", {}, table(two="0; 0; 0; pi/2")),
    S("q3 forgotten", "table_variable", {}, table(three="0; 0; 0; {side}")),
    S("sign of q1", "table_variable_sign", {}, table(one="-q1; L1; 0; pi/2")),
    S("sign of q3", "table_variable_sign table_length_sign", {}, table(three="0; -q3; 0; {side}")),
    S("zero of q2 not minded", "table_offset", {}, of_measure("level_up", "q2")),
    S(
        "zero and sense of q2 not minded",
        "table_offset table_variable_sign table_row",
        {},
        of_measure("level_down", "q2"),
    ),
    S("sense of q2 not minded", "table_variable_sign table_offset", {}, of_measure("up", "pi + q2")),
    S("q2 with the opposite sign", "table_variable_sign", {}, of_measure("down", "-q2")),
    S("quarter turn too many in q2", "table_offset", {}, of_measure("down", "q2 + pi/2")),
    S("half turn too many in q2", "table_offset", {}, of_measure("level_up", "q2 + 3*pi/2")),
    S(
        "plain degrees in alpha",
        "table_degrees",
        {},
        table(one="q1; L1; 0; 90", two="{theta}; 0; 0; 90", three="0; q3; 0; {side}"),
    ),
    S("pi/2 rounded to 1.57", "table_rounded", {}, table(one="q1; L1; 0; 1.57")),
    S(
        "rows of the modified convention",
        "table_convention",
        {},
        table(one="q1; L1; 0; 0", two="{theta}; 0; 0; pi/2", three="0; q3; 0; pi/2"),
    ),
    S("columns a, alpha, d, theta", "table_columns", {}, columns(2, 3, 1, 0)),
    S("columns in the reverse order", "table_columns", {}, columns(3, 2, 1, 0)),
    S("columns s and a exchanged", "table_swapped", {}, columns(0, 2, 1, 3)),
    S("rows 1 and 2 exchanged", "table_rows", {}, table(order="213")),
    S("rows 2 and 3 exchanged", "table_rows", {}, table(order="132")),
    # the matrices
    S("matrices of the modified convention", "factors_of_craig", pairs(CRAIG)),
    S("the turn about x the other way", "turned_other_way", pairs(STANDARD.replace("sin({k})", "(-sin({k}))"))),
    S(
        "rotations transposed",
        "rotation_transposed rows_for_columns",
        {},
        lambda g: {**transposed("A1"), **transposed("A2"), **transposed("A3")},
    ),
    S("rotation of A2 transposed", "rows_for_columns", {}, transposed("A2")),
    S("radians mode", "degrees_as_radians degrees_radians", pairs(STANDARD.replace("{t}", "({t}*180/pi)"))),
    S("radians mode in A1 alone", "degrees_radians", pairs(STANDARD.replace("{t}", "({t}*180/pi)"), (1,))),
    S("sine for cosine in A1", "sine_cosine", pairs(EXCHANGED, (1,))),
    S("sine for cosine in A2", "sine_cosine", pairs(EXCHANGED, (2,))),
    S("sign in the third row of A1", "term_sign opposite_sign", pairs(form("[0; sin({k})", "[0; -sin({k})"), (1,))),
    S(
        "sign of sin theta sin alpha in A2",
        "term_sign opposite_sign",
        pairs(form("; sin({t})*sin({k});", "; -sin({t})*sin({k});"), (2,)),
    ),
    S(
        "sign of cos theta sin alpha in A1",
        "term_sign opposite_sign",
        pairs(form("; -cos({t})*sin({k});", "; cos({t})*sin({k});"), (1,)),
    ),
    S("height in millimetres in A1", "kilo_prefix", {}, entries("A1", "*1000", (3,))),
    S("slide in millimetres in A3", "kilo_prefix", {}, entries("A3", "*1000", (3,))),
    S(
        "height in the first row of A1",
        "exchanged",
        {"A1": STANDARD.format(t="P[1;1]", s="P[1;3]", a="P[1;2]", k="P[1;4]")},
    ),
    S("A1 and A2 exchanged", "fields_exchanged", {}, {"A1": "A2", "A2": "A1"}),
    # the product
    S("product in the reverse order", "product_reversed", {"T": "A3*A2*A1"}),
    S("first two in the reverse order", "exchanged", {"T": "A2*A1*A3"}),
    S("last two in the reverse order", "exchanged", {"T": "A1*A3*A2"}),
    S("A3 left out", "factor_lost", {"T": "A1*A2"}),
    S("A1 left out", "factor_lost", {"T": "A2*A3"}),
    S("origin of T in millimetres", "kilo_prefix", {}, entries("T", "*1000", (1, 2, 3))),
    S("rotation of T transposed", "rows_for_columns", {}, transposed("T")),
    # the point
    S("the point forgotten", "point_forgotten", point("T[{row};4]")),
    S("the point along x", "point_along_x", point("d*T[{row};1] + T[{row};4]")),
    S("the point on the other side", "point_behind", point("T[{row};4] - d*T[{row};3]")),
    S("the origin forgotten", "term_lost", point("d*T[{row};3]")),
    S("d left out", "factor_lost", point("T[{row};3] + T[{row};4]")),
    S("x and y exchanged", "fields_exchanged", {}, {"x_M": "y_M", "y_M": "x_M"}),
    S("sign of y", "opposite_sign", {}, {"y_M": "-y_M"}),
    S("z in millimetres", "kilo_prefix factor_of_ten", {}, {"z_M": "z_M*1000"}),
    S("all in millimetres", "kilo_prefix factor_of_ten", {}, {"x_M": "x_M*1000", "y_M": "y_M*1000", "z_M": "z_M*1000"}),
    S("x in centimetres", "power_of_ten factor_of_ten", {}, {"x_M": "x_M*100"}),
    S("product reversed and z in millimetres", "product_reversed", {"T": "A3*A2*A1"}, {"z_M": "z_M*1000"}),
)
