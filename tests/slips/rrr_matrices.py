"""Slips at the matrices of the RRR arm (DH-2, DH-3, DH-15): conventions, signs, order of products, the point M."""

from __future__ import annotations

from tests.slips.slip import Lines, S

STANDARD = """[[cos({t}); -sin({t})*cos({k}); sin({t})*sin({k}); {a}*cos({t})],
    [sin({t}); cos({t})*cos({k}); -cos({t})*sin({k}); {a}*sin({t})],
    [0; sin({k}); cos({k}); {s}], [0; 0; 0; 1]]"""
CRAIG = """[[cos({t}); -sin({t}); 0; {a}],
    [sin({t})*cos({k}); cos({t})*cos({k}); -sin({k}); -{s}*sin({k})],
    [sin({t})*sin({k}); cos({t})*sin({k}); cos({k}); {s}*cos({k})], [0; 0; 0; 1]]"""


def pairs(form: str, only: tuple[int, ...] = (1, 2, 3)) -> dict[str, str]:
    return {f"A{i}": form.format(t=f"P[{i};1]", s=f"P[{i};2]", a=f"P[{i};3]", k=f"P[{i};4]") for i in only}


def form(old: str, new: str) -> str:
    assert old in STANDARD, old
    return STANDARD.replace(old, new)


def table(one: str = "q1; L1; 0; pi/2", two: str = "q2; 0; L2; 0", three: str = "-q3; 0; 0; 0") -> dict[str, str]:
    return {"P": f"[[{one}], [{two}], [{three}]]"}


def point(line: str) -> dict[str, str]:
    return {f"{name}_M": line.format(row=row) for row, name in enumerate("xyz", 1)}


def formula(x: str, y: str, z: str) -> dict[str, str]:
    return {"x": x, "y": y, "z": z}


def for_x(line: str) -> Lines:
    """A formula of x alone, where x is asked for."""
    return lambda g: {"x": line} if g.coordinate == "x" else None


def for_z(line: str) -> Lines:
    return lambda g: {"z": line} if g.coordinate == "z" else None


def for_y(line: str) -> Lines:
    return lambda g: {"y": line} if g.coordinate == "y" else None


def entries(name: str, change: str = "", rows: tuple[int, ...] = (), columns: tuple[int, ...] = (4,)) -> dict[str, str]:
    """Type a matrix with some entries changed."""
    cells = [
        ["0", "0", "0", "1"] if row == 4 else [
            f"{name}[{row};{column}]{change if row in rows and column in columns else ''}" for column in (1, 2, 3, 4)
        ]
        for row in (1, 2, 3, 4)
    ]  # fmt: skip
    return {name: "[" + ", ".join("[" + "; ".join(row) + "]" for row in cells) + "]"}


def transposed(name: str) -> dict[str, str]:
    rows = [
        "[" + "; ".join(f"{name}[{column};{row}]" for column in (1, 2, 3)) + f"; {name}[{row};4]]" for row in (1, 2, 3)
    ]
    return {name: "[" + ", ".join(rows) + ", [0; 0; 0; 1]]"}


BOTH_SINES = {
    "A3": "[[A3[1;1]; -A3[1;2]; A3[1;3]; A3[1;4]], [-A3[2;1]; A3[2;2]; A3[2;3]; A3[2;4]],"
    " [A3[3;1]; A3[3;2]; A3[3;3]; A3[3;4]], [0; 0; 0; 1]]"
}
TURNED = (
    "["
    + ", ".join("[" + "; ".join(f"T[{column};{row}]" for column in (1, 2, 3, 4)) + "]" for row in (1, 2, 3, 4))
    + "]"
)

SLIPS = (
    # the table
    S("q3 with a plus", "theta3_sign some_entries opposite_sign", table(three="q3; 0; 0; 0")),
    S("alpha1 with a minus", "alpha1_sign opposite_sign", table(one="q1; L1; 0; -pi/2")),
    S("height along x", "height_along_x exchanged", table(one="q1; 0; L1; pi/2")),
    S("alpha1 forgotten", "alpha_forgotten", table(one="q1; L1; 0; 0")),
    S("link 2 along z", "exchanged", table(two="q2; L2; 0; 0")),
    S("length of link 3 in the table", "frame_at_point", {**table(three="-q3; 0; L3; 0"), **point("T[{row};4]")}),
    S("alpha2 taken for pi/2", "alpha2_turned", table(two="q2; 0; L2; pi/2")),
    S("rows 2 and 3 exchanged", "exchanged", table(two="-q3; 0; 0; 0", three="q2; 0; L2; 0")),
    S(
        "radians typed where degrees are asked for",
        "degrees_radians",
        {},
        table("q1*pi/180; L1; 0; pi/2*pi/180", "q2*pi/180; 0; L2; 0", "-q3*pi/180; 0; 0; 0"),
    ),
    S(
        "lengths of the table in millimetres",
        "kilo_prefix",
        {},
        {"P": "[[q1; L1*1000; 0; pi/2], [q2; 0; L2*1000; 0], [-q3; 0; 0; 0]]"},
    ),
    S(
        "signs of all angles opposite",
        "opposite_sign",
        {},
        {"P": "[[-q1; L1; 0; -pi/2], [-q2; 0; L2; 0], [q3; 0; 0; 0]]"},
    ),
    S(
        "q3 with a plus, the formula right",
        "opposite_sign theta3_sign some_entries",
        {},
        {"P": "[[q1; L1; 0; pi/2], [q2; 0; L2; 0], [q3; 0; 0; 0]]"},
    ),
    S(
        "alpha1 with a minus typed alone",
        "opposite_sign",
        {},
        {"P": "[[q1; L1; 0; -pi/2], [q2; 0; L2; 0], [-q3; 0; 0; 0]]"},
    ),
    # the pair matrices
    S("matrices of the modified convention", "factors_of_craig", pairs(CRAIG)),
    S("first matrix of the modified convention", "factors_of_craig one_of_craig", pairs(CRAIG, (1,))),
    S(
        "radians mode in the matrices",
        "degrees_as_radians degrees_radians",
        {
            f"A{i}": STANDARD.format(t=f"(P[{i};1]*180/pi)", s=f"P[{i};2]", a=f"P[{i};3]", k=f"P[{i};4]")
            for i in (1, 2, 3)
        },
    ),
    S(
        "radians mode in A2 alone",
        "degrees_radians",
        {"A2": STANDARD.format(t="(P[2;1]*180/pi)", s="P[2;2]", a="P[2;3]", k="P[2;4]")},
    ),
    S(
        "rotation transposed in A3",
        "rows_for_columns",
        {},
        transposed("A3"),
    ),
    S(
        "sign of the sine of alpha in the third row",
        "term_sign opposite_sign",
        pairs(form("[0; sin({k})", "[0; -sin({k})"), (1,)),
    ),
    S(
        "sign of sin theta sin alpha",
        "term_sign opposite_sign",
        pairs(form("; sin({t})*sin({k});", "; -sin({t})*sin({k});"), (1,)),
    ),
    S(
        "sign of cos theta sin alpha",
        "term_sign opposite_sign",
        pairs(form("; -cos({t})*sin({k});", "; cos({t})*sin({k});"), (1,)),
    ),
    S(
        "sign of sin theta cos alpha in A2",
        "term_sign opposite_sign",
        pairs(form("; -sin({t})*cos({k});", "; sin({t})*cos({k});"), (2,)),
    ),
    S(
        "sign of sin theta cos alpha in A3",
        "term_sign opposite_sign",
        pairs(form("; -sin({t})*cos({k});", "; sin({t})*cos({k});"), (3,)),
    ),
    S(
        "sines and cosines exchanged in A2",
        "sine_cosine",
        pairs(STANDARD.replace("sin", "zzz").replace("cos", "sin").replace("zzz", "cos"), (2,)),
    ),
    S(
        "sines and cosines exchanged in A3",
        "sine_cosine",
        pairs(STANDARD.replace("sin", "zzz").replace("cos", "sin").replace("zzz", "cos"), (3,)),
    ),
    S("a and s exchanged in A2", "exchanged", {"A2": STANDARD.format(t="P[2;1]", s="P[2;3]", a="P[2;2]", k="P[2;4]")}),
    S("a and s exchanged in A1", "exchanged", {"A1": STANDARD.format(t="P[1;1]", s="P[1;3]", a="P[1;2]", k="P[1;4]")}),
    S(
        "sine for cosine in the fourth column of A2",
        "sine_cosine",
        pairs(form("; {a}*cos({t})]", "; {a}*sin({t})]"), (2,)),
    ),
    S(
        "cosine for sine in the fourth column of A2",
        "sine_cosine",
        pairs(form("; {a}*sin({t})]", "; {a}*cos({t})]"), (2,)),
    ),
    S("length left out in the fourth column of A2", "factor_lost", pairs(form("; {a}*sin({t})]", "; sin({t})]"), (2,))),
    S(
        "A1 in millimetres",
        "kilo_prefix",
        {},
        entries("A1", "*1000", (3,)),
    ),
    S(
        "A2 in millimetres",
        "kilo_prefix",
        {},
        entries("A2", "*1000", (1, 2)),
    ),
    S(
        "sign of one sine in A3",
        "opposite_sign",
        {},
        entries("A3", "*(-1)", (1,), (2,)),
    ),
    S(
        "both sines of A3 with the opposite sign",
        "opposite_sign rows_for_columns",
        {},
        BOTH_SINES,
    ),
    S("A1 and A2 exchanged", "fields_exchanged", {}, {"A1": "A2", "A2": "A1"}),
    # the product
    S("product in the reverse order", "product_reversed", {"T": "A3*A2*A1"}),
    S("product of two in the reverse order", "exchanged", {"T": "A2*A1*A3"}),
    S("last two in the reverse order", "exchanged", {"T": "A1*A3*A2"}),
    S("A3 left out", "factor_lost", {"T": "A1*A2"}),
    S("A1 left out", "factor_lost", {"T": "A2*A3"}),
    S("A2 twice", "exchanged", {"T": "A1*A2*A2"}),
    S(
        "T transposed",
        "rows_for_columns",
        {},
        {"T": TURNED},
    ),
    S(
        "T in millimetres",
        "kilo_prefix",
        {},
        entries("T", "*1000", (1, 2, 3)),
    ),
    # the point
    S("the point forgotten in the numbers", "point_forgotten term_lost", point("T[{row};4]")),
    S("the point along y", "exchanged point_along_y", point("L3*T[{row};2] + T[{row};4]")),
    S("the point behind the elbow", "term_sign", point("T[{row};4] - L3*T[{row};1]")),
    S("origin forgotten", "term_lost", point("L3*T[{row};1]")),
    S("L2 for L3", "exchanged", point("L2*T[{row};1] + T[{row};4]")),
    S("length left out", "factor_lost", point("T[{row};1] + T[{row};4]")),
    S("x and y exchanged", "fields_exchanged", {}, {"x_M": "y_M", "y_M": "x_M"}),
    S("sign of x", "opposite_sign", {}, {"x_M": "-x_M"}),
    S("z in millimetres", "kilo_prefix factor_of_ten", {}, {"z_M": "z_M*1000"}),
    S(
        "all coordinates in millimetres",
        "kilo_prefix factor_of_ten",
        {},
        {"x_M": "x_M*1000", "y_M": "y_M*1000", "z_M": "z_M*1000"},
    ),
    S("y off by ten", "power_of_ten factor_of_ten", {}, {"y_M": "y_M/10"}),
    S("height L1 forgotten in z", "term_lost", {}, {"z_M": "z_M - L1"}),
    # the formula
    S("formula of x: sum of the angles", "term_sign", for_x("cos(q1)*(L2*cos(q2) + L3*cos(q2 + q3))")),
    S("formula of z: sum of the angles", "term_sign", for_z("L1 + L2*sin(q2) + L3*sin(q2 + q3)")),
    S("formula of z: height forgotten", "term_lost", for_z("L2*sin(q2) + L3*sin(q2 - q3)")),
    S("formula of z: cosines", "sine_cosine", for_z("L1 + L2*cos(q2) + L3*cos(q2 - q3)")),
    S("formula of y: cosine of q1", "sine_cosine", for_y("cos(q1)*(L2*cos(q2) + L3*cos(q2 - q3))")),
    S("formula of x: sine of q1", "sine_cosine", for_x("sin(q1)*(L2*cos(q2) + L3*cos(q2 - q3))")),
    S("formula of x: link 3 from the level", "term_lost", for_x("cos(q1)*(L2*cos(q2) + L3*cos(q3))")),
    S("formula of x: the point forgotten", "term_lost", for_x("cos(q1)*L2*cos(q2)")),
    S("formula of y: turn forgotten", "factor_lost", for_y("L2*cos(q2) + L3*cos(q2 - q3)")),
    S("formula of z: sign of link 3", "term_sign", for_z("L1 + L2*sin(q2) - L3*sin(q2 - q3)")),
    S("matrices of Craig, z in millimetres", "factors_of_craig", pairs(CRAIG), {"z_M": "z_M*1000"}),
)
