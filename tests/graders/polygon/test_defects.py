"""Polygons with a defect: each is named with its vector and its projection."""

from __future__ import annotations

import pytest

from graders import Code, Outcome
from graders.polygon.mechanism import Mechanism
from graders.verdict import Flaws
from tests.graders.polygon.judging import judged
from tests.graders.polygon.mechanisms import FOUR_BAR, ROCKING, SLIDER, TWO_LOOPS


def flaws(text: str, mechanism: Mechanism = SLIDER) -> list[tuple[str, str, str]]:
    verdict = judged(text, mechanism)
    assert verdict.score < 1, "it is right"
    assert isinstance(verdict.details, Flaws)
    assert verdict.outcome is (Outcome.PARTLY if verdict.score else Outcome.WRONG)
    return [(flaw.code.value, flaw.subject, flaw.place) for flaw in verdict.details.found]


BASE = SLIDER.polygon


def changed(*pairs: tuple[str, str], base: str = BASE) -> str:
    for old, new in pairs:
        assert old in base, old
        base = base.replace(old, new, 1)
    return base


DEFECTS = {
    "sign of the rod in the closure": (
        changed(("l1 + l2 - l3 = 0", "l1 - l2 - l3 = 0")),
        [("closure_sign", "l2", "")],
    ),
    "sign of the slider in the closure": (
        changed(("l1 + l2 - l3 = 0", "l1 + l2 + l3 = 0")),
        [("closure_sign", "l3", "")],
    ),
    "a wrong sign carried through": (
        changed(("closure: l1 + l2", "closure: l1 - l2"), (" + l2*cos", " - l2*cos"), (" + l2*sin", " - l2*sin")),
        [("closure_sign", "l2", "")],
    ),
    "open polygon": (changed(("l1 + l2 - l3 = 0", "l1 - l3 = 0")), [("open_polygon", "B, C", "")]),
    "no closure": (changed(("closure: l1 + l2 - l3 = 0\n", "")), [("no_closure", "", "")]),
    "sine for cosine in x": (
        changed(("l2*cos(alpha2)", "l2*sin(alpha2)")),
        [("sine_cosine", "l2", "x")],
    ),
    "cosine for sine in y": (changed(("l1*sin(alpha1)", "l1*cos(alpha1)")), [("sine_cosine", "l1", "y")]),
    "sine for cosine in two terms": (
        changed(("l1*cos(alpha1) + l2*cos(alpha2)", "l1*sin(alpha1) + l2*sin(alpha2)")),
        [("sine_cosine", "l1, l2", "x")],
    ),
    "cosine of zero written in y": (changed(("sin(alpha2) = 0", "sin(alpha2) - l3 = 0")), [("sine_cosine", "l3", "y")]),
    "term lost in x": (changed((" - l3 = 0\ny", " = 0\ny")), [("term_missing", "l3", "x")]),
    "term lost in y": (changed((" + l2*sin(alpha2)", "")), [("term_missing", "l2", "y")]),
    "sign in x": (changed((" - l3 = 0\ny", " + l3 = 0\ny")), [("projection_sign", "l3", "x")]),
    "sign in y": (changed((" + l2*sin(alpha2)", " - l2*sin(alpha2)")), [("projection_sign", "l2", "y")]),
    "sign in x and sine in y": (
        changed((" - l3 = 0\ny", " + l3 = 0\ny"), ("l2*sin(alpha2)", "l2*cos(alpha2)")),
        [("projection_sign", "l3", "x"), ("sine_cosine", "l2", "y")],
    ),
    "projections exchanged": (
        changed(("x: l1", "q: l1"), ("y: l1", "x: l1"), ("q: l1", "y: l1")),
        [("swapped_projections", "", "y"), ("swapped_projections", "", "x")],
    ),
    "x twice": (
        changed(("y: l1*sin(alpha1) + l2*sin(alpha2) = 0", "y: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0")),
        [("swapped_projections", "", "y")],
    ),
    "an identity for y": (
        changed(("l1*sin(alpha1) + l2*sin(alpha2) = 0", "l1 = l1")),
        [("not_determined", "alpha2, l3", "")],
    ),
    "no projection on y": (changed(("y: l1*sin(alpha1) + l2*sin(alpha2) = 0\n", "")), [("no_projection", "", "y")]),
    "an equation about something else": (
        changed(("l1*sin(alpha1) + l2*sin(alpha2) = 0", "l1*tan(alpha1) = l3^2")),
        [("wrong_projection", "", "y")],
    ),
    "the interior angle at C": (
        changed(("angle alpha2", "angle beta"), ("cos(alpha2)", "cos(beta)"), ("+ l2*sin(alpha2)", "- l2*sin(beta)"),
                ("alpha2; l3", "beta; l3")),
        [("interior_angle", "l2", "")],
    ),
    "the angle between crank and rod": (
        changed(("angle alpha2", "angle psi"), ("cos(alpha2)", "cos(alpha1 - psi)"),
                ("sin(alpha2)", "sin(alpha1 - psi)"), ("alpha2; l3", "psi; l3")),
        [("interior_angle", "l2", "")],
    ),
    "the angle of the opposite sense": (
        changed((" + l2*cos", " - l2*cos"), (" + l2*sin", " - l2*sin")),
        [("reversed_angle", "l2", "")],
    ),
    "the driver's angle at the other end": (
        changed(("l1: A > B", "l1: B > A"), ("closure: l1", "closure: -l1")),
        [("reversed_angle", "l1", "")],
    ),
    "the slider's vector against its angle": (
        changed(("l3: A > C", "l3: C > A"), ("l2 - l3", "l2 + l3")),
        [("reversed_angle", "l3", "")],
    ),
    "the rod's angle taken for the driver's": (
        changed(("l2, angle alpha2", "l2, angle alpha1 + 0.3"), ("cos(alpha2)", "cos(alpha1 + 0.3)"),
                ("sin(alpha2)", "sin(alpha1 + 0.3)"), ("alpha2; ", "")),
        [("wrong_angle", "l2", "")],
    ),
    "a fixed angle for the rod": (
        changed(("angle alpha2", "angle 20°"), ("cos(alpha2)", "cos(20°)"), ("sin(alpha2)", "sin(20°)"),
                ("alpha2; ", "")),
        [("angle_varies", "l2", "")],
    ),
    "the slider's length called constant": (
        changed(("length l3,", "length l3 constant,")),
        [("length_varies", "l3", "")],
    ),
    "a given length for the slider": (
        changed(("length l3", "length l2"), ("- l3 = 0\ny", "- l2 = 0\ny"), ("; l3", "")),
        [("length_varies", "l3", "")],
    ),
    "the crank's length for the rod": (
        changed(("l2, angle", "l1, angle"), ("l2*cos", "l1*cos"), ("l2*sin", "l1*sin")),
        [("wrong_length", "l2", "")],
    ),
    "an unknown forgotten": (changed(("alpha2; l3", "alpha2")), [("unknown_missing", "l3", "")]),
    "a given among the unknowns": (changed(("alpha2; l3", "alpha2; l3; alpha1")), [("unknown_extra", "alpha1", "")]),
    "the rod's length for the slider's": (
        changed(("alpha2; l3", "alpha2; l2")),
        [("unknown_missing", "l3", ""), ("unknown_extra", "l2", "")],
    ),
    "no unknowns": (changed(("\nunknowns: alpha2; l3", "")), [("no_unknowns", "", "")]),
}  # fmt: skip


@pytest.mark.parametrize("name", DEFECTS)
def test_a_defect_is_named_with_its_vector_and_projection(name: str) -> None:
    text, expected = DEFECTS[name]
    assert flaws(text) == expected


FOUR = FOUR_BAR.polygon
TWO = TWO_LOOPS.polygon
MORE = {
    "a diagonal that is no link": (
        FOUR_BAR,
        """l1: A > B, length l1, angle alpha1
        d: B > D, length d, angle delta
        l4: A > D, length l4, angle 0
        closure: l1 + d - l4 = 0
        x: l1*cos(alpha1) + d*cos(delta) - l4 = 0
        y: l1*sin(alpha1) + d*sin(delta) = 0
        unknowns: d; delta""",
        [("no_link", "d", "")],
    ),
    "rocker from the wrong end": (
        FOUR_BAR,
        changed(("l3: D > C", "l3: C > D"), base=FOUR),
        [("closure_sign", "l3", "")],
    ),
    "two signs": (
        FOUR_BAR,
        changed(("closure: l1 + l2 - l3 - l4", "closure: l1 - l2 + l3 - l4"), base=FOUR),
        [("closure_sign", "l2", ""), ("closure_sign", "l3", "")],
    ),
    "the outer loop as a sum of the others": (
        TWO_LOOPS,
        TWO + "\nclosure 3: l1 + l2 + l5 - s6 - h6 = 0",
        [("dependent_loop", "3", "")],
    ),
    "the same loop twice": (
        TWO_LOOPS,
        changed(("closure 2: l4 + l3 + l5 - s6 - h6 = 0", "closure 2: l4 + l3 - l2 - l1 = 0"), base=TWO),
        [("dependent_loop", "2", "")],
    ),
    "one loop of two": (
        TWO_LOOPS,
        "\n".join(line for line in TWO.splitlines() if "2:" not in line or line.startswith("l2")),
        [("missing_loop", "2", ""), ("no_projection", "", "x"), ("no_projection", "", "y")],
    ),
    "rocker reversed in the second loop": (
        TWO_LOOPS,
        changed(("closure 2: l4 + l3", "closure 2: l4 - l3"), base=TWO),
        [("closure_sign", "l3", "2")],
    ),
    "the height's sign in the second loop": (
        TWO_LOOPS,
        changed(("sin(alpha5) - h6", "sin(alpha5) + h6"), base=TWO),
        [("projection_sign", "h6", "y2")],
    ),
    "sine for cosine in the second loop": (
        TWO_LOOPS,
        changed(("l4 + l3*cos(alpha3)", "l4 + l3*sin(alpha3)"), base=TWO),
        [("sine_cosine", "l3", "x2")],
    ),
    "guide measured from y": (
        ROCKING,
        changed(("angle alpha2", "angle psi"), ("l2*cos(alpha2)", "l2*sin(psi)"), ("l2*sin(alpha2)", "l2*cos(psi)"),
                ("l2; alpha2", "l2; psi"), base=ROCKING.polygon),
        [("interior_angle", "l2", "")],
    ),
    "length of the guide taken as constant": (
        ROCKING,
        changed(("length l2,", "length l2 const,"), ("l2; alpha2", "alpha2"), base=ROCKING.polygon),
        [("length_varies", "l2", ""), ("unknown_missing", "l2", "")],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MORE)
def test_defects_of_other_mechanisms_are_named(name: str) -> None:
    mechanism, text, expected = MORE[name]
    assert flaws(text, mechanism) == expected


@pytest.mark.parametrize(
    ("name", "score"),
    [("sign in x", 0.8), ("no unknowns", 0.8), ("an unknown forgotten", 0.9), ("open polygon", 0.8),
     ("a wrong sign carried through", 0.8), ("projections exchanged", 0.6), ("the interior angle at C", 14 / 15)],
)  # fmt: skip
def test_each_part_has_its_fifth_of_the_score(name: str, score: float) -> None:
    assert judged(DEFECTS[name][0]).score == pytest.approx(score, abs=1e-6)


def test_names_that_are_no_unknowns_take_no_more_than_the_share_of_the_list() -> None:
    verdict = judged(changed(("unknowns: alpha2; l3", "unknowns: alpha2; l3; l1; l2; alpha1")))
    assert verdict.score == 0.8


def test_an_angle_that_mends_one_projection_alone_is_not_taken_for_measured_otherwise() -> None:
    text = changed(("+ l2*sin(alpha2) = 0", "- l2*sin(alpha2) = 0"), ("+ l2*cos(alpha2) - l3 = 0", "- l3 = 0"))
    assert flaws(text) == [("term_missing", "l2", "x"), ("projection_sign", "l2", "y")]
    assert judged(text).score == 0.6


def test_nothing_right_has_no_credit() -> None:
    text = "l1: B > A, length l2, angle alpha1\ny: l1 = l2\nx: l1 = 2*l2"
    verdict = judged(text)
    assert (verdict.score, verdict.code, verdict.outcome) == (0, Code.WRONG, Outcome.WRONG)


def test_a_number_for_pi_with_eight_figures_is_left_to_the_lecturer() -> None:
    text = changed(("l1*sin(alpha1) + l2*sin(alpha2)", "l1*sin(alpha1) + l2*sin(alpha2) + l1*sin(3.1415926)"))
    assert judged(text).code is Code.UNDECIDED


@pytest.mark.parametrize("factor", [1 + 1e-5, 1 - 1e-4])
def test_a_length_that_is_off_by_little_is_wrong(factor: float) -> None:
    text = changed(("length l2", f"length {factor}*l2"))
    assert ("wrong_length", "l2", "") in flaws(text)


def test_a_formula_without_a_value_is_no_length() -> None:
    assert ("wrong_length", "l2", "") in flaws(changed(("length l2", "length l2/(l1 - l1)")))
    assert ("wrong_length", "l3", "") in flaws(changed(("length l3", "length l3 + z*0")))


def test_two_new_names_in_one_length_are_not_settled() -> None:
    assert ("wrong_length", "l3", "") in flaws(changed(("length l3", "length l3 + q3")))
