"""Differentiated equations: any true form is right, lost terms are named, the student's own polygon is followed."""

from __future__ import annotations

import pytest

from graders import AnswerSyntaxError, Code, Outcome, Symbols
from graders.kinds.polygon import Polygon
from graders.kinds.rates import Rates
from graders.polygon.mechanism import Mechanism
from graders.verdict import Flaws, Verdict
from tests.graders.polygon.mechanisms import FOUR_BAR, ROCKING, SLIDER, TWO_LOOPS


def judged(text: str, order: int, mechanism: Mechanism = SLIDER, polygon: str | None = None) -> Verdict:
    given = list(mechanism.states()[0].names)
    symbols = Symbols(given, [*given, "alpha2", "l3", "omega2", "v3", "epsilon2", "a3"])
    if polygon is not None:
        mechanism = mechanism.beside(Polygon(mechanism.nodes, "alpha2").parse(polygon, symbols))
    grader = Rates("polygon", order, "omega2")
    return grader.check(grader.parse(text, symbols), mechanism)


def flaws(
    text: str, order: int, mechanism: Mechanism = SLIDER, polygon: str | None = None
) -> list[tuple[str, str, str]]:
    verdict = judged(text, order, mechanism, polygon)
    assert isinstance(verdict.details, Flaws), verdict
    assert verdict.outcome is (Outcome.PARTLY if verdict.score else Outcome.WRONG)
    return [(flaw.code.value, flaw.subject, flaw.place) for flaw in verdict.details.found]


REVERSED = """a: A > B, l1, alpha1
b: C > B, l2, phi
c: A > C, x_C, 0
closure: a = b + c
x: l1*cos(alpha1) = l2*cos(phi) + x_C
y: l1*sin(alpha1) = l2*sin(phi)
unknowns: phi; x_C"""
FORMS = {
    "rates by _d": (1, None, "x: -l1*alpha1_d*sin(alpha1) - l2*alpha2_d*sin(alpha2) = l3_d\n"
                    "y: l1*alpha1_d*cos(alpha1) + l2*alpha2_d*cos(alpha2) = 0"),
    "dots": (1, None, "x: -l1*α̇1*sin(α1) - l2*α̇₂*sin(α₂) = l̇3\ny: l1*ω₁*cos(α1) + l2*α̇₂*cos(α₂) = 0"),
    "primes": (1, None, "x: -l1 alpha1' sin(alpha1) - l2 alpha2' sin(alpha2) = l3'\n"
               "y: l1 alpha1' cos(alpha1) + l2 alpha2' cos(alpha2) = 0"),
    "LaTeX": (1, None, r"x: -l_1\omega_1\sin\alpha_1 - l_2\omega_2\sin\alpha_2 - v_3 = 0" "\n"
              r"y: l_1\omega_1\cos\alpha_1 + l_2\omega_2\cos\alpha_2 = 0"),
    "solved for the unknowns, without labels": (1, None, "omega2 = -l1*omega1*cos(alpha1)/(l2*cos(alpha2))\n"
                                                "v3 = -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2)"),
    "own names, said": (1, None, "rates: W = alpha2_d; u = l3_d\nx: -l1*omega1*sin(alpha1) - l2*W*sin(alpha2) = u\n"
                        "y: l1*omega1*cos(alpha1) + l2*W*cos(alpha2) = 0"),
    "said the other way round": (1, None, "alpha2_d = W\nx: -l1*omega1*sin(alpha1) - l2*W*sin(alpha2) = v3\n"
                                 "y: l1*omega1*cos(alpha1) + l2*W*cos(alpha2) = 0"),
    "another name of a usual letter": (1, None, "W = omega2\nx: -l1*omega1*sin(alpha1) - l2*W*sin(alpha2) = v3\n"
                                       "y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0"),
    "a name that says nothing of a usual letter": (1, None, "W_d = omega2\nx: -l1*omega1*sin(alpha1)"
                                                   " - l2*omega2*sin(alpha2) = v3\n"
                                                   "y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0"),
    "the polygon's own names": (1, REVERSED, "x: -l1*omega1*sin(alpha1) = -l2*phi_d*sin(phi) + x_C_d\n"
                                "y: l1*omega1*cos(alpha1) = l2*phi_d*cos(phi)"),
    "the only angle and the only length": (1, REVERSED, "x: -l1*omega1*sin(alpha1) = -l2*omega2*sin(phi) + v\n"
                                           "y: l1*omega1*cos(alpha1) = l2*omega2*cos(phi)"),
    "a rate named like its length": (1, REVERSED, "x: -l1*omega1*sin(alpha1) = -l2*w*sin(phi) + v_C\n"
                                     "y: l1*omega1*cos(alpha1) = l2*w*cos(phi)"),
    "a capital letter for a velocity": (1, None, "x: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) = V3\n"
                                        "y: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) = 0"),
    "a velocity named like its node": (1, REVERSED, "x: -l1*omega1*sin(alpha1) = -l2*w*sin(phi) + VC\n"
                                       "y: l1*omega1*cos(alpha1) = l2*w*cos(phi)"),
    "accelerations by _dd": (2, None, "x: -l1*alpha1_dd*sin(alpha1) - l1*alpha1_d^2*cos(alpha1)"
                             " - l2*alpha2_dd*sin(alpha2) - l2*alpha2_d^2*cos(alpha2) - l3_dd = 0\n"
                             "y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1)"
                             " + l2*alpha2_dd*cos(alpha2) - l2*alpha2_d^2*sin(alpha2) = 0"),
    "rates of rates": (2, None, "x: -l1*omega1_d*sin(alpha1) - l1*omega1^2*cos(alpha1) - l2*omega2_d*sin(alpha2)"
                       " - l2*omega2^2*cos(alpha2) - v3_d = 0\ny: l1*omega1_d*cos(alpha1)"
                       " - l1*omega1^2*sin(alpha1) + l2*omega2_d*cos(alpha2) - l2*omega2^2*sin(alpha2) = 0"),
    "usual letters": (2, None, "y: l1*epsilon1*cos(alpha1) - l1*omega1^2*sin(alpha1) + l2*eps2*cos(alpha2)"
                      " - l2*omega2^2*sin(alpha2) = 0\nx: -l1*epsilon1*sin(alpha1) - l1*omega1^2*cos(alpha1)"
                      " - l2*eps2*sin(alpha2) - l2*omega2^2*cos(alpha2) = p3"),
}  # fmt: skip


@pytest.mark.parametrize("name", FORMS)
def test_any_true_form_is_right(name: str) -> None:
    order, polygon, text = FORMS[name]
    verdict = judged(text, order, polygon=polygon)
    assert verdict.code is Code.RIGHT, verdict.details


@pytest.mark.parametrize("mechanism", [SLIDER, ROCKING])
@pytest.mark.parametrize("order", [1, 2])
def test_a_judge_passes_its_own_samples(mechanism: Mechanism, order: int) -> None:
    grader = Rates("polygon", order, "omega2")
    samples = grader.samples(mechanism)
    assert {judged(text, order, mechanism).code for text in samples.right} == {Code.RIGHT}
    assert all(judged(text, order, mechanism).code is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            grader.parse(text, Symbols(mechanism.states()[0].names))


def test_two_loops_need_four_equations() -> None:
    text = """x1: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) + l3*omega3*sin(alpha3) = 0
y1: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) - l3*omega3*cos(alpha3) = 0
x2: -l3*omega3*sin(alpha3) - l5*omega5*sin(alpha5) - v6 = 0
y2: l3*omega3*cos(alpha3) + l5*omega5*cos(alpha5) = 0"""
    assert judged(text, 1, TWO_LOOPS).code is Code.RIGHT
    assert flaws("\n".join(text.splitlines()[:3]), 1, TWO_LOOPS) == [("no_projection", "", "y")]
    turned = text.replace("- l5*omega5*sin", "+ l5*omega5*sin")
    assert flaws(turned, 1, TWO_LOOPS) == [("rate_sign", "l5", "x2")]


V, A = ROCKING.velocity, ROCKING.acceleration
SV, SA = SLIDER.velocity, SLIDER.acceleration
DEFECTS = {
    "Coriolis term lost": (2, ROCKING, A, " + 2*v2*omega2*sin(alpha2)", "", ("coriolis_missing", "l2", "x")),
    "Coriolis term lost in y": (2, ROCKING, A, " - 2*v2*omega2*cos(alpha2)", "", ("coriolis_missing", "l2", "y")),
    "factor two lost": (2, ROCKING, A, "2*v2*omega2*sin", "v2*omega2*sin", ("coriolis_factor", "l2", "x")),
    "Coriolis sign": (2, ROCKING, A, "+ 2*v2*omega2*sin", "- 2*v2*omega2*sin", ("rate_sign", "l2", "x")),
    "Coriolis with cosine": (2, ROCKING, A, "2*v2*omega2*sin", "2*v2*omega2*cos", ("sine_cosine", "l2", "x")),
    "centripetal of the guide": (2, ROCKING, A, " + l2*omega2^2*cos(alpha2)", "", ("centripetal_missing", "l2", "x")),
    "centripetal of the crank": (2, SLIDER, SA, " - l1*omega1^2*cos(alpha1)", "", ("centripetal_missing", "l1", "x")),
    "centripetal sign": (2, SLIDER, SA, "- l2*omega2^2*cos", "+ l2*omega2^2*cos", ("rate_sign", "l2", "x")),
    "square forgotten": (2, SLIDER, SA, "l2*omega2^2*cos", "l2*omega2*cos", ("square_missing", "l2", "x")),
    "steady crank": (2, SLIDER, SA, "x: -l1*epsilon1*sin(alpha1)", "x: 0", ("tangential_missing", "l1", "x")),
    "steady rod": (2, SLIDER, SA, " + l2*epsilon2*cos(alpha2)", "", ("tangential_missing", "l2", "y")),
    "slider's acceleration lost": (2, SLIDER, SA, " - a3", "", ("term_missing", "l3", "x")),
    "slide lost": (1, ROCKING, V, " - v2*cos(alpha2)", "", ("term_missing", "l2", "x")),
    "guide held at its length": (1, ROCKING, V, " - v2*sin(alpha2)", "", ("term_missing", "l2", "y")),
    "chain rule": (1, SLIDER, SV, "l2*omega2*cos", "l2*cos", ("chain_rule", "l2", "y")),
    "sign of the derived cosine": (1, SLIDER, SV, "- l2*omega2*sin", "+ l2*omega2*sin", ("rate_sign", "l2", "x")),
    "sine not derived": (1, SLIDER, SV, "l2*omega2*cos(alpha2)", "l2*omega2*sin(alpha2)", ("sine_cosine", "l2", "y")),
    "slider's velocity lost": (1, SLIDER, SV, " - v3", "", ("term_missing", "l3", "x")),
    "rod lost": (1, SLIDER, SV, " - l2*omega2*sin(alpha2)", "", ("term_missing", "l2", "x")),
    "no name of a rate": (1, SLIDER, SV, "v3", "q7", ("unknown_rate", "q7", "")),
    "a velocity of nothing": (1, SLIDER, SV, "v3", "vq", ("unknown_rate", "vq", "")),
    "something else": (1, SLIDER, SV, "v3", "v3*l3/l2", ("wrong_rates", "", "x")),
}  # fmt: skip


@pytest.mark.parametrize("name", DEFECTS)
def test_a_lost_term_is_named_with_its_vector_and_equation(name: str) -> None:
    order, mechanism, text, old, new, expected = DEFECTS[name]
    assert old in text
    typed = text.replace(old, new, 1)
    assert flaws(typed, order, mechanism) == [expected]
    assert judged(typed, order, mechanism).score == 0.5


def test_the_same_slip_in_every_vector_is_one_flaw() -> None:
    """Three turning vectors, all without their centripetal terms."""
    text = """x: -l1*epsilon1*sin(alpha1) - l2*epsilon2*sin(alpha2) + l3*epsilon3*sin(alpha3) = 0
y: l1*epsilon1*cos(alpha1) + l2*epsilon2*cos(alpha2) - l3*epsilon3*cos(alpha3) = 0"""
    assert flaws(text, 2, FOUR_BAR) == [
        ("centripetal_missing", "l1, l2, l3", "x"),
        ("centripetal_missing", "l1, l2, l3", "y"),
    ]


def test_two_slips_in_one_equation_are_both_named() -> None:
    text = SA.replace("- l1*omega1^2*cos", "+ l1*omega1^2*cos").replace(" - a3", "")
    assert flaws(text, 2) == [("rate_sign", "l1", "x"), ("term_missing", "l3", "x")]


def test_an_equation_without_a_label_is_diagnosed_too() -> None:
    text = "\n".join(line[3:] for line in SA.replace(" - l1*omega1^2*sin(alpha1)", "").splitlines())
    assert flaws(text, 2) == [("centripetal_missing", "l1", "2")]


WRONG_SIGN = SLIDER.polygon.replace("l1 + l2 - l3", "l1 - l2 - l3").replace("+ l2*", "- l2*")


def test_derivatives_of_an_own_wrong_polygon_are_followed() -> None:
    text = SV.replace("- l2*omega2*sin", "+ l2*omega2*sin").replace("+ l2*omega2*cos", "- l2*omega2*cos")
    assert judged(text, 1, polygon=WRONG_SIGN).code is Code.FOLLOWED
    assert flaws(text, 1) == [("rate_sign", "l2", "x"), ("rate_sign", "l2", "y")]


def test_the_derivative_of_one_own_wrong_projection_counts_once() -> None:
    x, _ = SV.replace("- l2*omega2*sin", "+ l2*omega2*sin").splitlines()
    twice = f"{x}\n{x.replace('x:', 'y:', 1)}"
    assert flaws(twice, 1, polygon=WRONG_SIGN) == [("not_determined", "alpha2, l3", "")]
    assert judged(twice, 1, polygon=WRONG_SIGN).score == 0.5


def test_a_slip_in_the_derivative_of_a_wrong_polygon_is_named() -> None:
    text = SV.replace("- l2*omega2*sin", "+ l2*sin").replace("+ l2*omega2*cos", "- l2*omega2*cos")
    assert [code for code, *_ in flaws(text, 1, polygon=WRONG_SIGN)] == [
        "chain_rule",
    ]


def test_true_derivatives_beside_a_wrong_polygon_are_right() -> None:
    broken = SLIDER.polygon.replace("closure: l1 + l2 - l3", "closure: l1 + l2")
    assert judged(SV, 1, polygon=broken).code is Code.RIGHT


def test_the_sign_of_one_projection_is_followed() -> None:
    slip = SLIDER.polygon.replace("+ l2*sin(alpha2)", "- l2*sin(alpha2)")
    text = SV.replace("+ l2*omega2*cos", "- l2*omega2*cos")
    assert judged(text, 1, polygon=slip).code is Code.FOLLOWED


@pytest.mark.parametrize(("order", "own"), [(1, "v3*omega1 + l3*epsilon1"), (2, "a3*omega1 + 2*v3*epsilon1")])
def test_an_own_projection_that_holds_a_rate_of_the_task_is_followed(order: int, own: str) -> None:
    slip = SLIDER.polygon.replace("cos(alpha2) - l3 = 0", "cos(alpha2) = l3*omega1")
    text = SV.replace("- v3 = 0", f"= {own}") if order == 1 else SA.replace("- a3 = 0", f"= {own}")
    assert judged(text, order, polygon=slip).code is Code.FOLLOWED


def test_equations_of_another_order_are_not_enough() -> None:
    lines = SLIDER.polygon.splitlines()
    positions = "\n".join(line for line in lines if line.startswith(("x:", "y:")))
    assert flaws(positions, 1) == [("not_determined", "alpha2, l3", "")]
    assert flaws(SV, 2) == [("not_determined", "alpha2, l3", "")]
    assert {code for code, *_ in flaws(SA, 1)} == {"wrong_rates"}


def test_the_same_equation_twice_determines_nothing_more() -> None:
    first = SV.splitlines()[1]
    assert flaws(f"{first}\n{first.replace('y: ', 'x: 2*0 + ')}", 1) == [("not_determined", "alpha2, l3", "")]


def test_one_equation_of_two_has_half_the_credit() -> None:
    assert judged(SV.splitlines()[0], 1).score == 0.5
    assert flaws(SV.splitlines()[0], 1) == [("no_projection", "", "y")]


def test_the_score_is_the_share_of_equations_that_are_true() -> None:
    two = """x1: -l1*omega1*sin(alpha1) - l2*omega2*sin(alpha2) + l3*omega3*sin(alpha3) = 0
y1: l1*omega1*cos(alpha1) + l2*omega2*cos(alpha2) - l3*omega3*cos(alpha3) = 0
x2: -l3*omega3*sin(alpha3) - l5*omega5*sin(alpha5) - v6 = 0
y2: l3*omega3*cos(alpha3) + l5*omega5*cos(alpha5) = 0"""
    assert judged(two.replace("- v6", "+ v6"), 1, TWO_LOOPS).score == 0.75
    assert judged("\n".join(two.splitlines()[:3]), 1, TWO_LOOPS).score == 0.75
    assert judged("\n".join(two.splitlines()[:2]), 1, TWO_LOOPS).score == 0.5
    assert judged(f"{SV}\ny: omega2 = v3", 1).score == 0.666667
    assert judged(SV, 2).score == 0.5


def test_a_constant_with_eight_figures_is_left_to_the_lecturer() -> None:
    assert judged(SV.replace("- v3 = 0", "- v3 = l1*omega1*sin(3.1415926)"), 1).code is Code.UNDECIDED


@pytest.mark.parametrize(
    "text", ["", "l1 + 1", "3 mm", "x: l1", "rates: W = alpha2_d", "unknowns: l3", "x: 1 = [1; 2]"]
)
def test_what_is_no_equation_of_rates_is_unreadable(text: str) -> None:
    with pytest.raises(AnswerSyntaxError):
        Rates("polygon", 1, "omega2").parse(text, Symbols(["l1"]))


def test_names_that_explain_one_another_in_a_circle_are_unclear() -> None:
    assert ("unknown_rate", "W", "") in flaws(f"W_d = U\nU_d = W\nx: W = 0\n{SV}", 1)


def test_the_echo_tells_how_rates_were_read() -> None:
    grader = Rates("polygon", 1, "omega2")
    answer = grader.parse("x: l̇3 = 0,5\nv = l3_d", Symbols(["l3"]))
    echo = grader.echo(answer, comma=True)
    assert echo.text == "x: l3_d = 0.5\nv = l3_d"
    assert "<mn>0,5</mn>" in echo.mathml and "<mn>0.5</mn>" in grader.echo(answer).mathml
    assert echo.mathml.endswith("<mtr><mtd><mtext>v = l3_d</mtext></mtd></mtr></mtable></math>")
    assert grader.describe() == {"order": 1}
    assert grader.apart(SLIDER, SLIDER) == 0 and grader.apart(SLIDER, ROCKING) == float("inf")
