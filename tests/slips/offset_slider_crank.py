"""Slips at the offset slider-crank (VP-3): the offset, its sign, dead positions, the two assemblies, units."""

from __future__ import annotations

from tests.slips.slip import S

ROOT = "sqrt(l2^2 - (h - l1*sin(alpha1))^2)"
SPEED = "-l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)"
CLOSURE = "=(l3 - l1*cos(alpha1))^2 + (h - l1*sin(alpha1))^2 = l2^2"

SLIPS = (
    # the condition of a full turn
    S("border left out", "border", {}, {"turning": "=l2 > l1 + h"}),
    S("border left out, the other way round", "border", {}, {"turning": "=l1 + h < l2"}),
    S("sense of the inequality turned", "sense_turned", {}, {"turning": "=l2 <= l1 + h"}),
    S("sense turned while moving terms", "sense_turned", {}, {"turning": "=l1 + h >= l2"}),
    # the equation of the position
    S("the other square root", "not_satisfied", {}, {"position": f"=l3 = l1*cos(alpha1) - {ROOT}"}),
    S(
        "multiplied by the coordinate",
        "surplus_solution",
        {},
        {"position": CLOSURE.replace("=(", "=l3*(", 1)[:-7] + "*l3 = l2^2*l3"},
    ),
    S("sign of h in the equation", "not_satisfied", {}, {"position": CLOSURE.replace("(h - ", "(h + ")}),
    S("h left out of the equation", "not_satisfied", {}, {"position": CLOSURE.replace("h - ", "0 - ")}),
    S(
        "sine and cosine exchanged in the equation",
        "not_satisfied",
        {},
        {"position": "=(l3 - l1*sin(alpha1))^2 + (h - l1*cos(alpha1))^2 = l2^2"},
    ),
    S(
        "squares forgotten in the equation",
        "not_satisfied",
        {},
        {"position": "=(l3 - l1*cos(alpha1)) + (h - l1*sin(alpha1)) = l2"},
    ),
    S("rod not squared", "not_satisfied", {}, {"position": CLOSURE.replace("l2^2", "l2")}),
    S("mixed term forgotten", "not_satisfied", {}, {"position": "=l3^2 + l1^2 + h^2 = l2^2"}),
    S(
        "sign of the mixed term",
        "not_satisfied",
        {},
        {"position": "=l3^2 + l1^2 + h^2 + 2*l1*l3*cos(alpha1) + 2*l1*h*sin(alpha1) = l2^2"},
    ),
    S("an identity for an equation", "undetermined", {}, {"position": "=0*l3 = 0"}),
    # the coordinate of the slider
    S("guide below A", "guide_below", {"h": "-h"}),
    S("offset forgotten everywhere", "offset_forgotten", {"h": "0*h"}),
    S(
        "offset forgotten in l3 alone",
        "offset_forgotten term_lost",
        {},
        {"l3": "l1*cos(alpha1) + sqrt(l2^2 - (l1*sin(alpha1))^2)"},
    ),
    S("the other assembly", "other_assembly term_sign", {"l3": f"l1*cos(alpha1) - {ROOT}"}),
    S("sine for cosine in l3", "sine_cosine", {"l3": f"l1*sin(alpha1) + {ROOT}"}, {"position": CLOSURE}),
    S("crank forgotten in l3", "term_lost", {"l3": ROOT}, {"position": CLOSURE}),
    S("crank subtracted in l3", "term_sign", {"l3": f"-l1*cos(alpha1) + {ROOT}"}, {"position": CLOSURE}),
    S(
        "cosine under the root",
        "sine_cosine",
        {"l3": "l1*cos(alpha1) + sqrt(l2^2 - (h - l1*cos(alpha1))^2)"},
        {"position": CLOSURE},
    ),
    S(
        "plus under the root",
        "term_sign",
        {"l3": "l1*cos(alpha1) + sqrt(l2^2 + (h - l1*sin(alpha1))^2)"},
        {"position": CLOSURE},
    ),
    S(
        "sign of h under the root",
        "term_sign guide_below",
        {"l3": "l1*cos(alpha1) + sqrt(l2^2 - (h + l1*sin(alpha1))^2)"},
        {"position": CLOSURE},
    ),
    S("l3 in metres", "kilo_prefix factor_of_ten", {}, {"l3": "l3/1000"}),
    S("l3 off by ten", "power_of_ten factor_of_ten", {}, {"l3": "l3*10"}),
    S("l3 negative", "opposite_sign", {}, {"l3": "-l3"}),
    # the angle of the rod
    S(
        "angle of the vector from C to B",
        "rod_reversed opposite_sign term_sign",
        {"alpha2": "asin((l1*sin(alpha1) - h)/l2)"},
    ),
    S("sign of the angle", "opposite_sign rod_reversed", {}, {"alpha2": "-alpha2"}),
    S("arc cosine for arc sine", "other_function", {"alpha2": "acos((h - l1*sin(alpha1))/l2)"}),
    S("arc tangent over l2", "other_function", {"alpha2": "atan((h - l1*sin(alpha1))/l2)"}),
    S("cosine of the crank in the angle", "sine_cosine", {"alpha2": "asin((h - l1*cos(alpha1))/l2)"}),
    S("h forgotten in the angle", "term_lost offset_forgotten", {"alpha2": "asin(-l1*sin(alpha1)/l2)"}),
    S("sign of h in the angle", "term_sign guide_below", {"alpha2": "asin((-h - l1*sin(alpha1))/l2)"}),
    S("radians typed as degrees", "degrees_radians", {}, {"alpha2": "alpha2*pi/180"}),
    S("calculator in radians from the start", "degrees_as_radians", {"alpha1": "alpha1*180/pi"}),
    S("rod's length forgotten in the angle", "factor_lost", {"alpha2": "asin(h - l1*sin(alpha1))"}),
    # the velocity of the slider
    S("term of the rod lost", "rod_term_lost term_lost", {"v3": "-l1*omega1*sin(alpha1)"}),
    S("term of the crank lost", "term_lost", {"v3": "-l2*omega2*sin(alpha2)"}),
    S(
        "minus lost in omega2",
        "rod_speed_lost_minus opposite_sign term_sign",
        {"omega2": "l1*omega1*cos(alpha1)/(l2*cos(alpha2))"},
    ),
    S("sine for cosine in omega2", "sine_cosine", {"omega2": "-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"}),
    S("cosine of the rod forgotten", "factor_lost", {"omega2": "-l1*omega1*cos(alpha1)/l2"}),
    S("sign of v3", "opposite_sign", {}, {"v3": "-v3"}),
    S("sign of the crank's term", "term_sign", {"v3": "l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)"}),
    S("cosines in the derivative", "sine_cosine", {"v3": "-l1*omega1*cos(alpha1) - l2*omega2*cos(alpha2)"}),
    S("omega1 forgotten", "factor_lost", {"v3": "-l1*sin(alpha1) - l2*omega2*sin(alpha2)"}),
    S("v3 in millimetres a second", "kilo_prefix factor_of_ten", {}, {"v3": "v3*1000"}),
    # the stroke
    S("stroke of the centric mechanism", "stroke_of_the_centric", {"H": "2*l1"}),
    S(
        "legs taken for the hypotenuse",
        "legs_for_hypotenuse term_sign",
        {"H": "sqrt((l2 + l1)^2 + h^2) - sqrt((l2 - l1)^2 + h^2)"},
    ),
    S("one crank for the stroke", "factor_two stroke_of_the_centric", {}, {"H": "H/2"}),
    S("dead positions added", "term_sign", {"H": "sqrt((l2 + l1)^2 - h^2) + sqrt((l2 - l1)^2 - h^2)"}),
    S("stroke in metres", "kilo_prefix factor_of_ten", {}, {"H": "H/1000"}),
    S("only the far dead position", "term_lost", {"H": "sqrt((l2 + l1)^2 - h^2)"}),
    S("only the near dead position", "term_lost", {"H": "sqrt((l2 - l1)^2 - h^2)"}),
)
