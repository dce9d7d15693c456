"""Slips at the inverse task of the RRR arm (DH-25): lost branches, quadrants, the cosine, the correction, units."""

from __future__ import annotations

from tests.slips.slip import S

FULL = (
    "[[phi, epsilon + beta, theta3], [phi, epsilon - beta, -theta3],"
    " [phi + pi, pi - epsilon + beta, theta3], [phi + pi, pi - epsilon - beta, -theta3]]"
)


def q(text: str) -> dict[str, str]:
    return {"q": text}


ROWS = FULL[2:-2].split("], [")


def rows(*numbers: int) -> dict[str, str]:
    return q("[[" + "], [".join(ROWS[at] for at in numbers) + "]]")


def changed(old: str, new: str) -> dict[str, str]:
    assert old in FULL
    return q(FULL.replace(old, new))


TURNED_BACK = FULL.replace("phi", "-phi").replace("-phi + pi", "-phi - pi")
LIFTED_DOWN = (
    "[[phi, -epsilon - beta, theta3], [phi, -epsilon + beta, -theta3],"
    " [phi + pi, epsilon - pi - beta, theta3], [phi + pi, epsilon - pi + beta, -theta3]]"
)

SLIPS = (
    # branches
    S("bend down only", "bend_down_only lost_branch", {}, {**rows(0, 2), "n": "2"}),
    S("bend down only, number not minded", "bend_down_only lost_branch", {}, rows(0, 2)),
    S("bend up only", "lost_branch", {}, rows(1, 3)),
    S("facing only", "facing_only lost_branch", {}, {**rows(0, 1), "n": "2"}),
    S("facing only, number not minded", "facing_only lost_branch", {}, rows(0, 1)),
    S("turned away only", "lost_branch", {}, rows(2, 3)),
    S("one solution only", "lost_branch", {}, {**rows(0), "n": "1"}),
    S("one solution only, bent up", "lost_branch", {}, rows(1)),
    S("three solutions", "lost_branch", {}, rows(0, 1, 2)),
    S("the first one twice", "doubled_branch", {}, rows(0, 0, 1, 2)),
    S("all twice", "doubled_branch surplus_branch", {}, rows(0, 1, 2, 3, 0, 1)),
    S("a fifth one", "surplus_branch", {}, q(FULL[:-1] + ", [phi, epsilon, theta3]]")),
    S("turned away without turning the lift", "some_branches", {}, changed("pi - epsilon", "epsilon")),
    S("turned away with the lift of the facing one negative", "some_branches", {}, changed("pi - epsilon", "-epsilon")),
    S("bend with the same sign in all", "some_branches doubled_branch", {}, changed("-theta3", "theta3")),
    S("turn with a minus", "some_branches", {}, changed("phi + pi", "-phi")),
    # quadrants and signs
    S(
        "the turn without its quadrant",
        "lost_quadrant other_function",
        lambda g: {"phi": "atan(y/x)"} if g.x < 0 else None,
    ),
    S("x and y exchanged in the turn", "exchanged", {"phi": "atan2(x; y)"}),
    S("arc tangent upside down", "upside_down exchanged", {"phi": "atan(x/y)"}),
    S("sign of the turn", "term_sign opposite_sign", {"phi": "-atan2(y; x)"}),
    S("sign of y in the turn", "term_sign opposite_sign", {"phi": "atan2(-y; x)"}),
    S("sign of the correction", "correction_sign", {"beta": "atan2(-L3*sin(theta3); L2 + L3*c3)"}),
    S("correction forgotten", "correction_forgotten", {}, q(FULL.replace(" + beta", "").replace(" - beta", ""))),
    S(
        "sine and cosine exchanged in the correction",
        "exchanged sine_cosine",
        {"beta": "atan2(L3*c3; L2 + L3*sin(theta3))"},
    ),
    S("minus in the correction's denominator", "term_sign", {"beta": "atan2(L3*sin(theta3); L2 - L3*c3)"}),
    S("lengths exchanged in the correction", "exchanged", {"beta": "atan2(L2*sin(theta3); L3 + L2*c3)"}),
    S("L2 forgotten in the correction", "term_lost", {"beta": "atan2(L3*sin(theta3); L3*c3)"}),
    S("L3 forgotten in the correction", "factor_lost", {"beta": "atan2(sin(theta3); L2 + L3*c3)"}),
    S("cosine for sine in the correction", "sine_cosine", {"beta": "atan2(L3*cos(theta3); L2 + L3*c3)"}),
    S("lift upside down", "exchanged", {"epsilon": "atan2(rho; h)"}),
    S("sign of the lift", "term_sign opposite_sign", {"epsilon": "atan2(-h; rho)"}),
    S("height of the base forgotten", "base_forgotten term_lost", {"h": "z"}),
    S("height of the base added", "term_sign", {"h": "z + L1"}),
    S("height counted down", "opposite_sign term_sign", {"h": "L1 - z"}),
    S("square root of the reach forgotten", "power", {"rho": "x^2 + y^2"}),
    S("y forgotten in the reach", "term_lost", {"rho": "sqrt(x^2)"}),
    S("minus in the reach", "term_sign", lambda g: {"rho": "sqrt(x^2 - y^2)"} if abs(g.x) > abs(g.y) else None),
    # the cosine
    S("inner angle", "inner_angle", {"c3": "(L2^2 + L3^2 - rho^2 - h^2)/(2*L2*L3)"}),
    S("sign of the cosine typed alone", "opposite_sign", {}, {"c3": "-c3"}),
    S("the 2 forgotten below", "factor_two factor_lost", {"c3": "(rho^2 + h^2 - L2^2 - L3^2)/(L2*L3)*1"}),
    S("a length forgotten below", "factor_lost", {"c3": "(rho^2 + h^2 - L2^2 - L3^2)/(2*L2)"}),
    S("a length forgotten below, the other one", "factor_lost", {"c3": "(rho^2 + h^2 - L2^2 - L3^2)/(2*L3)"}),
    S("plus L2^2", "term_sign", {"c3": "(rho^2 + h^2 + L2^2 - L3^2)/(2*L2*L3)"}),
    S("plus L3^2", "term_sign", {"c3": "(rho^2 + h^2 - L2^2 + L3^2)/(2*L2*L3)"}),
    S("minus h^2", "term_sign", {"c3": "(rho^2 - h^2 - L2^2 - L3^2)/(2*L2*L3)"}),
    S("h forgotten in the cosine", "term_lost", {"c3": "(rho^2 - L2^2 - L3^2)/(2*L2*L3)"}),
    S("L3 forgotten in the cosine", "term_lost", {"c3": "(rho^2 + h^2 - L2^2)/(2*L2*L3)"}),
    S("L2 forgotten in the cosine", "term_lost", {"c3": "(rho^2 + h^2 - L3^2)/(2*L2*L3)"}),
    S("lengths not squared", "power", {"c3": "(rho^2 + h^2 - L2 - L3^2)/(2*L2*L3)"}),
    S("cosine off by ten", "power_of_ten factor_of_ten", {}, {"c3": "c3*10"}),
    S("angle for the cosine", "degrees_radians angle_for_cosine", {}, {"c3": "theta3"}),
    S("cosine halved", "factor_two", {}, {"c3": "c3/2"}),
    # units
    S(
        "angles in radians",
        "degrees_radians",
        {},
        q("[[" + "], [".join("; ".join(f"({e})*pi/180" for e in row.split(", ")) for row in ROWS) + "]]"),
    ),
    S(
        "sign of all q3",
        "opposite_sign",
        {},
        {"q": FULL.replace("-theta3", "zz").replace(", theta3", ", -theta3").replace("zz", "theta3")},
    ),
    S(
        "sign of all q1",
        "opposite_sign",
        {},
        q(TURNED_BACK),
    ),
    S(
        "sign of all q2",
        "opposite_sign",
        {},
        q(LIFTED_DOWN),
    ),
    S("sines of degrees in the correction", "degrees_radians", {"beta": "atan2(L3*sin(theta3*180/pi); L2 + L3*c3)"}),
    S(
        "inner angle, number of solutions left empty",
        "inner_angle",
        {"c3": "(L2^2 + L3^2 - rho^2 - h^2)/(2*L2*L3)"},
        {},
        "n",
    ),
    S("base forgotten, number of solutions left empty", "base_forgotten", {"h": "z"}, {}, "n"),
    S(
        "sign of the correction, number left empty",
        "correction_sign",
        {"beta": "atan2(-L3*sin(theta3); L2 + L3*c3)"},
        {},
        "n",
    ),
)
