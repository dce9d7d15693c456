"""Slips at the polygon of a slider-crank and its derivatives (VP-1, VP-2): senses, signs, projections, lost terms."""

from __future__ import annotations

from tests.slips.slip import S

L1, L2, L3 = "l1: A > B, length l1, angle alpha1", "l2: B > C, length l2, angle alpha2", "l3: A > C, length l3, angle 0"
CLOSURE, X, Y, UNKNOWN = (
    "closure: l1 + l2 - l3 = 0",
    "x: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0",
    "y: l1*sin(alpha1) + l2*sin(alpha2) = 0",
    "unknowns: alpha2; l3",
)
VX = "x: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) - v3 = 0"
VY = "y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0"
AX = (
    "x: -l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1) - l2*epsilon2*sin(alpha2) - l2*omega2^2*cos(alpha2) - a3 = 0"
)
AY = "y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1) + l2*epsilon2*cos(alpha2) - l2*omega2^2*sin(alpha2) = 0"
OMEGA2 = "-l1*omega1*cos(alpha1)/(l2*cos(alpha2))"
EPSILON2 = "(l1*(omega1^2*sin(alpha1) - epsilon1*cos(alpha1)) + l2*omega2^2*sin(alpha2))/(l2*cos(alpha2))"
A3 = "-l1*(omega1^2*cos(alpha1) + epsilon1*sin(alpha1)) - l2*(omega2^2*cos(alpha2) + epsilon2*sin(alpha2))"


def polygon(
    l1: str = L1, l2: str = L2, l3: str = L3, closure: str = CLOSURE, x: str = X, y: str = Y, unknown: str = UNKNOWN
) -> dict[str, str]:
    return {"polygon": "=" + "\n".join(line for line in (l1, l2, l3, closure, x, y, unknown) if line)}


def speeds(x: str = VX, y: str = VY) -> dict[str, str]:
    return {"velocities": f"={x}\n{y}"}


def accelerations(x: str = AX, y: str = AY) -> dict[str, str]:
    return {"accelerations": f"={x}\n{y}"}


def lost(line: str, term: str) -> str:
    assert term in line, term
    return line.replace(term, "")


def put(line: str, old: str, new: str) -> str:
    assert old in line, old
    return line.replace(old, new, 1)


SLIPS = (
    # the polygon
    S(
        "a vector between nodes that no link joins",
        "no_link open_polygon",
        {},
        polygon(l2="l2: B > A, length l2, angle alpha2"),
    ),
    S(
        "rod drawn from C to B",
        "closure_sign reversed_angle open_polygon wrong_angle",
        {},
        polygon(l2="l2: C > B, length l2, angle alpha2"),
    ),
    S("sign of the rod in the closure", "closure_sign open_polygon", {}, polygon(closure="closure: l1 - l2 - l3 = 0")),
    S(
        "sign of the slider's vector in the closure",
        "closure_sign open_polygon",
        {},
        polygon(closure="closure: l1 + l2 + l3 = 0"),
    ),
    S("closure forgotten", "no_closure", {}, polygon(closure="")),
    S("projection on y forgotten", "no_projection", {}, polygon(y="")),
    S("sign in the projection on x", "projection_sign", {}, polygon(x=put(X, "+ l2", "- l2"))),
    S("sign in the projection on y", "projection_sign", {}, polygon(y=put(Y, "+ l2", "- l2"))),
    S("sine for cosine in the projection on x", "sine_cosine", {}, polygon(x=put(X, "cos(alpha1)", "sin(alpha1)"))),
    S("cosine for sine in the projection on y", "sine_cosine", {}, polygon(y=put(Y, "sin(alpha2)", "cos(alpha2)"))),
    S("slider forgotten in the projection on x", "term_missing", {}, polygon(x=lost(X, " - l3"))),
    S("crank forgotten in the projection on y", "term_missing", {}, polygon(y=lost(Y, "l1*sin(alpha1) + "))),
    S("projections exchanged", "swapped_projections", {}, polygon(x="x" + Y[1:], y="y" + X[1:])),
    S("slider along y", "wrong_angle", {}, polygon(l3="l3: A > C, length l3, angle 90°")),
    S(
        "angle of the rod measured clockwise",
        "interior_angle projection_sign wrong_angle",
        {},
        polygon(y="y: l1*sin(alpha1) - l2*sin(alpha2) = 0"),
    ),
    S("angle of the rod as constant", "angle_varies", {}, polygon(l2="l2: B > C, length l2, angle 30°")),
    S(
        "length of the slider's vector as constant",
        "length_varies wrong_length",
        {},
        polygon(l3="l3: A > C, length 0.3, angle 0"),
    ),
    S("length of the crank for the rod", "wrong_length", {}, polygon(l2="l2: B > C, length l1, angle alpha2")),
    S("unknown forgotten", "unknown_missing", {}, polygon(unknown="unknowns: alpha2")),
    S("the crank's angle as an unknown", "unknown_extra", {}, polygon(unknown="unknowns: alpha1; alpha2; l3")),
    S("unknowns not listed", "no_unknowns", {}, polygon(unknown="")),
    # the numbers of the position
    S("minus lost in alpha2", "lost_minus opposite_sign", {"alpha2": "asin(l1*sin(alpha1)/l2)"}),
    S("cosine in alpha2", "sine_cosine", {"alpha2": "-asin(l1*cos(alpha1)/l2)"}),
    S("alpha2 in radians", "degrees_radians", {}, {"alpha2": "alpha2*pi/180"}),
    S("radians mode throughout", "degrees_as_radians", {"alpha1": "alpha1*180/pi"}),
    S("slider in metres", "kilo_prefix factor_of_ten", {}, {"l3": "l3/1000"}),
    S("rod subtracted in l3", "term_sign", {"l3": "l1*cos(alpha1) - l2*cos(alpha2)"}),
    S("crank forgotten in l3", "term_lost", {"l3": "l2*cos(alpha2)"}),
    S("sine of the crank in l3", "sine_cosine", {"l3": "l1*sin(alpha1) + l2*cos(alpha2)"}),
    # velocities
    S("sign of the rod's term in x", "rate_sign", {}, speeds(x=put(VX, "- l2", "+ l2"))),
    S("sign of the crank's term in y", "rate_sign", {}, speeds(y=put(VY, "y: l1", "y: -l1"))),
    S("rate of the rod forgotten", "chain_rule", {}, speeds(y=put(VY, "l2*omega2*", "l2*"))),
    S(
        "rod's term forgotten in x",
        "term_missing tangential_missing",
        {},
        speeds(x=lost(VX, " - l2*omega2*sin(alpha2)")),
    ),
    S("speed of the slider forgotten", "term_missing", {}, speeds(x=lost(VX, " - v3"))),
    S("sine not differentiated in y", "sine_cosine", {}, speeds(y=put(VY, "cos(alpha1)", "sin(alpha1)"))),
    S("minus lost in the number omega2", "speed_lost_minus opposite_sign", {"omega2": OMEGA2[1:]}),
    S(
        "sine for cosine in omega2",
        "sine_for_cosine sine_cosine",
        {"omega2": put(OMEGA2, "cos(alpha1)", "sin(alpha1)")},
    ),
    S("rod's cosine forgotten in omega2", "factor_lost", {"omega2": "-l1*omega1*cos(alpha1)/l2"}),
    S("omega2 in turns a minute", "turns_radians", {}, {"omega2": "omega2*30/pi"}),
    S("rod's term forgotten in v3", "rod_term_lost term_lost", {"v3": "-l1*omega1*sin(alpha1)"}),
    S("sign of the rod's term in v3", "term_sign", {"v3": "-l1*omega1*sin(alpha1) + l2*omega2*sin(alpha2)"}),
    S("v3 in mm/s", "kilo_prefix factor_of_ten", {}, {"v3": "v3*1000"}),
    S("sign of v3", "opposite_sign", {}, {"v3": "-v3"}),
    # accelerations
    S(
        "centripetal term of the crank forgotten in x",
        "centripetal_missing",
        {},
        accelerations(x=lost(AX, " - l1*omega1^2*cos(alpha1)")),
    ),
    S(
        "centripetal term of the rod forgotten in y",
        "centripetal_missing",
        {},
        accelerations(y=lost(AY, " - l2*omega2^2*sin(alpha2)")),
    ),
    S(
        "tangential term of the rod forgotten in x",
        "tangential_missing",
        {},
        accelerations(x=lost(AX, " - l2*epsilon2*sin(alpha2)")),
    ),
    S(
        "tangential term of the crank forgotten in y",
        "tangential_missing",
        {},
        accelerations(y=put(AY, "y: l1*epsilon1*cos(alpha1) - l1", "y: -l1")),
    ),
    S("square forgotten at the crank", "square_missing", {}, accelerations(x=put(AX, "l1*omega1^2", "l1*omega1"))),
    S("square forgotten at the rod", "square_missing", {}, accelerations(y=put(AY, "l2*omega2^2", "l2*omega2"))),
    S(
        "sign of the centripetal term of the rod",
        "rate_sign",
        {},
        accelerations(x=put(AX, "- l2*omega2^2", "+ l2*omega2^2")),
    ),
    S("sign of the tangential term of the crank", "rate_sign", {}, accelerations(y=put(AY, "y: l1", "y: -l1"))),
    S(
        "sine for cosine at the centripetal term",
        "sine_cosine",
        {},
        accelerations(x=put(AX, "omega1^2*cos", "omega1^2*sin")),
    ),
    S("acceleration of the slider forgotten", "term_missing", {}, accelerations(x=lost(AX, " - a3"))),
    S(
        "centripetal terms forgotten in epsilon2",
        "centripetal_lost term_lost",
        {"epsilon2": "-l1*epsilon1*cos(alpha1)/(l2*cos(alpha2))"},
    ),
    S(
        "centripetal term of the rod forgotten in epsilon2",
        "term_lost",
        {"epsilon2": lost(EPSILON2, " + l2*omega2^2*sin(alpha2)")},
    ),
    S(
        "the crank taken as steady",
        "crank_taken_as_steady",
        {"epsilon2": put(EPSILON2, " - epsilon1*cos(alpha1)", ""), "a3": put(A3, " + epsilon1*sin(alpha1)", "")},
    ),
    S(
        "the crank taken as steady in epsilon2 alone",
        "term_lost",
        {"epsilon2": put(EPSILON2, " - epsilon1*cos(alpha1)", "")},
    ),
    S("square forgotten in epsilon2", "power", {"epsilon2": put(EPSILON2, "omega1^2", "omega1")}),
    S("sign in epsilon2", "term_sign", {"epsilon2": put(EPSILON2, " + l2*omega2^2", " - l2*omega2^2")}),
    S("sign of epsilon2", "opposite_sign", {}, {"epsilon2": "-epsilon2"}),
    S("the rod taken as steady in a3", "rod_taken_as_steady term_lost", {"a3": put(A3, " + epsilon2*sin(alpha2)", "")}),
    S("centripetal term of the rod forgotten in a3", "term_lost", {"a3": put(A3, "omega2^2*cos(alpha2) + ", "")}),
    S("sine for cosine in a3", "sine_cosine", {"a3": put(A3, "omega1^2*cos", "omega1^2*sin")}),
    S("square forgotten in a3", "power", {"a3": put(A3, "omega2^2", "omega2")}),
    S("a3 in mm/s^2", "kilo_prefix factor_of_ten", {}, {"a3": "a3*1000"}),
    S("sign of a3", "opposite_sign", {}, {"a3": "-a3"}),
    S("minus lost and the slider in metres", "lost_minus", {"alpha2": "asin(l1*sin(alpha1)/l2)"}, {"l3": "l3/1000"}),
)
