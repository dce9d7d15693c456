"""Slips at a four-bar linkage (VP-4): the diagonal, assemblies, senses of angles, differences of angles, lost terms."""

from __future__ import annotations

from exercises.linkages.four_bar import ROCKER, SIDES
from tests.slips.slip import S


def without(name: str, *terms: str) -> dict[str, str]:
    line = SIDES[name]
    for term in terms:
        line = line.replace(term, term + "*0")
    return {name: line}


def changed(name: str, old: str, new: str) -> dict[str, str]:
    assert old in SIDES[name]
    return {name: SIDES[name].replace(old, new)}


OMEGA2 = "-l1*omega1*sin(alpha3 - alpha1)/(l2*sin(alpha3 - alpha2))"
FIRST = "[[alpha21, alpha31]]"
TWICE = "[[alpha21, alpha31], [alpha21, alpha31]]"
MIXED = "[[alpha21, alpha31], [alpha22, alpha31]]"
RADIANS = "[[alpha21*pi/180, alpha31*pi/180], [alpha22*pi/180, alpha32*pi/180]]"
OPPOSITE = "[[-alpha21, -alpha31], [-alpha22, -alpha32]]"
REVERSED = "[[alpha21, alpha31 + pi], [alpha22, alpha32 + pi]]"

SLIPS = (
    # the assemblies
    S("the angle of the diagonal forgotten", "diagonal_forgotten", {"gamma": "0"}),
    S(
        "the diagonal measured the other way",
        "term_sign opposite_sign diagonal_forgotten",
        {"gamma": "atan2(l1*sin(alpha1); l4 - l1*cos(alpha1))"},
    ),
    S(
        "rockers reversed",
        "rocker_reversed",
        {"alpha31": ROCKER.format("alpha21") + " + pi", "alpha32": ROCKER.format("alpha22") + " + pi"},
    ),
    S("degrees for radians at the crank", "degrees_as_radians", {"alpha1": "alpha1*180/pi"}),
    S("the crank measured clockwise", "opposite_sign term_sign", {"alpha1": "-alpha1"}),
    S("law of cosines with plus", "term_sign opposite_sign", {"delta": "acos(-(l2^2 + f^2 - l3^2)/(2*l2*f))"}),
    S(
        "rocker and coupler exchanged in the law of cosines",
        "exchanged",
        {"delta": "acos((l3^2 + f^2 - l2^2)/(2*l3*f))"},
    ),
    S(
        "the factor 2 lost in the law of cosines",
        "factor_two factor_lost",
        {"delta": "acos((l2^2 + f^2 - l3^2)/(4*l2*f))"},
    ),
    S("sine for cosine in the law of cosines", "other_function", {"delta": "asin((l2^2 + f^2 - l3^2)/(2*l2*f))"}),
    S("squares lost in the diagonal", "power term_sign", {"f": "sqrt((l4 - l1*cos(alpha1))^2 + abs(l1*sin(alpha1)))"}),
    S(
        "the crank added to the frame in the diagonal",
        "term_sign",
        {"f": "sqrt((l4 + l1*cos(alpha1))^2 + (l1*sin(alpha1))^2)"},
    ),
    S(
        "the crank added in the diagonal and its angle",
        "crank_side",
        {
            "f": "sqrt((l4 + l1*cos(alpha1))^2 + (l1*sin(alpha1))^2)",
            "gamma": "atan2(-l1*sin(alpha1); l4 + l1*cos(alpha1))",
        },
    ),
    S(
        "sine and cosine exchanged in the diagonal's angle",
        "sine_cosine exchanged",
        {"gamma": "atan2(-l1*cos(alpha1); l4 - l1*sin(alpha1))"},
    ),
    S("arc tangent upside down", "exchanged", {"gamma": "atan2(l4 - l1*cos(alpha1); -l1*sin(alpha1))"}),
    S(
        "frame forgotten for the rocker",
        "term_lost",
        {
            "alpha31": ROCKER.format("alpha21").replace(" - l4", ""),
            "alpha32": ROCKER.format("alpha22").replace(" - l4", ""),
        },
    ),
    S(
        "crank forgotten for the rocker",
        "term_lost crank_forgotten",
        {
            "alpha31": "atan2(l2*sin(alpha21); l2*cos(alpha21) - l4)",
            "alpha32": "atan2(l2*sin(alpha22); l2*cos(alpha22) - l4)",
        },
    ),
    S("one assembly only", "lost_branch", {}, {"assemblies": FIRST}),
    S("the first assembly twice", "doubled_branch term_sign", {}, {"assemblies": TWICE}),
    S("one assembly wrong", "some_branches exchanged", {}, {"assemblies": MIXED}),
    S("angles in radians", "degrees_radians", {}, {"assemblies": RADIANS}),
    S("angles with the opposite sign", "opposite_sign", {}, {"assemblies": OPPOSITE}),
    S("angle of the rocker from C to D", "rocker_reversed", {}, {"assemblies": REVERSED}),
    # the angular velocities
    S(
        "the other assembly in the speeds",
        "other_assembly",
        {"alpha2": lambda assemblies: assemblies[1][0], "alpha3": lambda assemblies: assemblies[1][1]},
    ),
    S("sign of omega2", "opposite_sign", {}, {"omega2": "-omega2"}),
    S("minus lost in omega2", "opposite_sign", {"omega2": OMEGA2[1:]}),
    S(
        "minus too many in omega3",
        "rocker_sign",
        {"omega3": "-l1*omega1*sin(alpha1 - alpha2)/(l3*sin(alpha3 - alpha2))"},
    ),
    S(
        "the wrong difference in omega3",
        "wrong_difference",
        {"omega3": "l1*omega1*sin(alpha1 - alpha3)/(l3*sin(alpha3 - alpha2))"},
    ),
    S(
        "the wrong difference in omega2",
        "exchanged wrong_difference",
        {"omega2": OMEGA2.replace("sin(alpha3 - alpha1)", "sin(alpha2 - alpha1)")},
    ),
    S(
        "cosine for sine above in omega2",
        "sine_cosine",
        {"omega2": OMEGA2.replace("*sin(alpha3 - alpha1)", "*cos(alpha3 - alpha1)")},
    ),
    S("cosine for sine below in omega2", "sine_cosine", {"omega2": OMEGA2.replace("l2*sin", "l2*cos")}),
    S("cosines for sines in omega2", "sine_cosine", {"omega2": OMEGA2.replace("sin", "cos")}),
    S("the coupler's length left out", "factor_lost", {"omega2": OMEGA2.replace("l2*", "1*")}),
    S("the crank's length left out", "factor_lost", {"omega2": OMEGA2.replace("l1*", "1*")}),
    S(
        "lengths upside down in omega2",
        "upside_down exchanged",
        {"omega2": "-l2*omega1*sin(alpha3 - alpha1)/(l1*sin(alpha3 - alpha2))"},
    ),
    S(
        "sum for difference of the angles",
        "term_sign",
        {"omega2": OMEGA2.replace("alpha3 - alpha2", "alpha3 + alpha2")},
    ),
    S("sine below left out", "factor_lost", {"omega2": "-l1*omega1*sin(alpha3 - alpha1)/l2"}),
    S("sine above left out", "factor_lost", {"omega3": "l1*omega1/(l3*sin(alpha3 - alpha2))"}),
    S(
        "radians mode in omega3",
        "degrees_radians",
        {},
        {"omega3": "l1*omega1*sin((alpha1 - alpha2)*180/pi)/(l3*sin((alpha3 - alpha2)*180/pi))"},
    ),
    S("omega2 in turns a minute", "turns_radians", {}, {"omega2": "omega2*30/pi"}),
    S("omega3 in degrees a second", "degrees_radians", {}, {"omega3": "omega3*180/pi"}),
    S("omega3 off by ten", "power_of_ten factor_of_ten", {}, {"omega3": "omega3/10"}),
    S("omega2 and omega3 exchanged", "fields_exchanged", {}, {"omega2": "omega3", "omega3": "omega2"}),
    S("both speeds with the opposite sign", "opposite_sign", {}, {"omega2": "-omega2", "omega3": "-omega3"}),
    # the angular accelerations
    S(
        "centripetal terms lost",
        "centripetal_lost",
        {
            **without("epsilon2", "omega1^2", "omega2^2", "omega3^2"),
            **without("epsilon3", "omega1^2", "omega2^2", "omega3^2"),
        },
    ),
    S(
        "the crank taken as steady",
        "crank_taken_as_steady",
        {**without("epsilon2", "epsilon1"), **without("epsilon3", "epsilon1")},
    ),
    S("centripetal term of the crank lost", "term_lost", without("epsilon2", "l1*omega1^2")),
    S("centripetal term of the coupler lost", "term_lost", without("epsilon2", "l2*omega2^2")),
    S("centripetal term of the rocker lost", "term_lost", without("epsilon2", "l3*omega3^2")),
    S("tangential term of the crank lost", "term_lost crank_taken_as_steady", without("epsilon3", "l1*epsilon1")),
    S("centripetal term of the coupler lost in epsilon3", "term_lost", without("epsilon3", "l2*omega2^2")),
    S("sign of the crank's centripetal term", "term_sign", changed("epsilon2", "- l1*omega1^2", "+ l1*omega1^2")),
    S("sign of the coupler's centripetal term", "term_sign", changed("epsilon2", "- l2*omega2^2", "+ l2*omega2^2")),
    S("sign of the rocker's centripetal term", "term_sign", changed("epsilon3", "+ l3*omega3^2", "- l3*omega3^2")),
    S("square lost at the crank", "power", changed("epsilon2", "omega1^2", "omega1")),
    S("square lost at the rocker", "power", changed("epsilon3", "omega3^2", "omega3")),
    S("square lost at the coupler", "power", changed("epsilon2", "omega2^2", "omega2")),
    S(
        "sine for cosine at the crank's centripetal term",
        "sine_cosine",
        changed("epsilon2", "omega1^2*cos", "omega1^2*sin"),
    ),
    S(
        "cosine for sine at the crank's tangential term",
        "sine_cosine",
        changed("epsilon3", "epsilon1*sin", "epsilon1*cos"),
    ),
    S("omega3 for omega2 in epsilon2", "exchanged", changed("epsilon2", "l2*omega2^2", "l2*omega3^2")),
    S("sign of epsilon2", "opposite_sign", {}, {"epsilon2": "-epsilon2"}),
    S("sign of epsilon3", "opposite_sign", {}, {"epsilon3": "-epsilon3"}),
    S("epsilon2 off by a thousand", "kilo_prefix factor_of_ten", {}, {"epsilon2": "epsilon2/1000"}),
    S("epsilon2 and epsilon3 exchanged", "fields_exchanged", {}, {"epsilon2": "epsilon3", "epsilon3": "epsilon2"}),
    S(
        "centripetal terms lost and omega3 in turns a minute",
        "centripetal_lost",
        {
            **without("epsilon2", "omega1^2", "omega2^2", "omega3^2"),
            **without("epsilon3", "omega1^2", "omega2^2", "omega3^2"),
        },
        {"omega3": "omega3*30/pi"},
    ),
)
