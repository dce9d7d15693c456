"""Polygons without a key: every valid choice is right."""

from __future__ import annotations

from itertools import product
from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graders import Code
from graders.kinds.polygon import Polygon
from graders.polygon.mechanism import Mechanism
from tests.depth import amount
from tests.graders.polygon.judging import STANDARD, judged
from tests.graders.polygon.mechanisms import FOUR_BAR, OFFSET, SLIDER, TWO_LOOPS, four_bar_states, slider_states

quick = settings(max_examples=amount(13, 40), deadline=None)


@pytest.mark.parametrize("name", STANDARD)
def test_the_polygon_that_a_judge_shows_is_right(name: str) -> None:
    assert judged(STANDARD[name].polygon, STANDARD[name]).code is Code.RIGHT


@pytest.mark.parametrize("name", STANDARD)
def test_a_judge_passes_its_own_samples(name: str) -> None:
    mechanism = STANDARD[name]
    samples = Polygon(mechanism.nodes, "alpha2").samples(mechanism)
    assert {judged(text, mechanism).code for text in samples.right} == {Code.RIGHT}
    assert all(judged(text, mechanism).code is not Code.RIGHT for text in samples.wrong)


RIGHT = {
    "other letters, other order": """unknowns: phi, s
        y: a*sin(alpha1)*0 + l1*sin(alpha1) + l2*sin(phi) = 0
        x: l1*cos(alpha1) + l2*cos(phi) = s
        closure: a + b = c
        c: A > C, angle 0, length s
        b: B > C, length l2, angle phi
        a: A > B, length l1, angle alpha1""".replace("a*sin(alpha1)*0 + ", ""),
    "the rod from C to B": """l1: A > B, length l1, angle alpha1
        l2: C > B, length l2, angle gamma
        l3: A > C, length l3, angle 0
        closure: l1 - l2 - l3 = 0
        x: l1*cos(alpha1) - l2*cos(gamma) - l3 = 0
        y: l1*sin(alpha1) - l2*sin(gamma) = 0
        unknowns: gamma; l3""",
    "the rod from C to B, named alpha2": """l1: A > B, length l1, angle alpha1
        l2: C > B, length l2, angle alpha2
        l3: A > C, length l3, angle 0
        closure: l3 + l2 - l1 = 0
        x: l3 + l2*cos(alpha2) = l1*cos(alpha1)
        y: l2*sin(alpha2) = l1*sin(alpha1)
        unknowns: l3; alpha2""",
    "the slider's vector from C to A, its angle pi": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle alpha2
        l3: C > A, length l3, angle pi
        closure: l1 + l2 + l3 = 0
        x: l1*cos(alpha1) + l2*cos(alpha2) + l3*cos(pi) = 0
        y: l1*sin(alpha1) + l2*sin(alpha2) + l3*sin(pi) = 0
        unknowns: alpha2; l3""",
    "the crank from B to A": """r: B > A, length l1, angle alpha1 + 180°
        l2: B > C, length l2, angle alpha2
        l3: A > C, length l3, angle 0
        closure: -r + l2 - l3 = 0
        x: -l1*cos(alpha1 + pi) + l2*cos(alpha2) - l3 = 0
        y: l1*sin(alpha1) + l2*sin(alpha2) = 0
        unknowns: alpha2; l3""",
    "the interior angle at C, declared as what it is": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle -beta
        l3: A > C, length l3, angle 0
        closure: l1 + l2 - l3 = 0
        x: l1*cos(alpha1) + l2*cos(beta) - l3 = 0
        y: l1*sin(alpha1) - l2*sin(beta) = 0
        unknowns: beta; l3""",
    "the angle between crank and rod, declared as what it is": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle alpha1 - psi
        l3: A > C, length l3, angle 0
        closure: l1 + l2 - l3 = 0
        x: l1*cos(alpha1) + l2*cos(alpha1 - psi) - l3 = 0
        y: l1*sin(alpha1) + l2*sin(alpha1 - psi) = 0
        unknowns: psi; l3""",
    "a constant angle with a name": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle alpha2
        l3: A > C, length l3, angle alpha3 (const)
        closure: l1 + l2 - l3 = 0
        x: l1*cos(alpha1) + l2*cos(alpha2) - l3*cos(alpha3) = 0
        y: l1*sin(alpha1) + l2*sin(alpha2) - l3*sin(alpha3) = 0
        unknowns: alpha2; l3""",
    "a rod with an own letter for its length": """l1: A > B, length l1, angle alpha1
        l2: B > C, length b, angle alpha2
        l3: A > C, length l3, angle 0
        closure: l1 + l2 - l3 = 0
        x: l1*cos(alpha1) + b*cos(alpha2) - l3 = 0
        y: l1*sin(alpha1) + b*sin(alpha2) = 0
        unknowns: alpha2; l3""",
    "equations multiplied and moved": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle alpha2
        l3: A > C, length l3, angle 0
        closure: 2*l3 = 2*l1 + 2*l2
        x: 3*(l3 - l1*cos(alpha1))/l2 = 3*cos(alpha2)
        y: sin(alpha2) = -l1*sin(alpha1)/l2
        unknowns: alpha2; l3""",
    "another true equation for a projection": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2, angle alpha2
        l3: A > C, length l3, angle 0
        closure: l1 + l2 - l3 = 0
        x: l2^2 = l1^2 + l3^2 - 2*l1*l3*cos(alpha1)
        y: l1*sin(alpha1) + l2*sin(alpha2) = 0
        unknowns: alpha2; l3""",
    "unknowns said in the vectors' lines": """l1: A > B, length l1, angle alpha1
        l2: B > C, length l2 known, angle alpha2 unknown
        l3: A > C, length l3 (unknown), angle 0 constant
        closure: l1 + l2 - l3 = 0
        x: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0
        y: l1*sin(alpha1) + l2*sin(alpha2) = 0""",
    "Polish": """niewiadome: φ i x_C
        wektor a: z A do B, długość l₁ (dana), kąt α₁
        wektor b: BC, długość l2, kąt φ
        wektor c: A → C, kąt 0°, długość x_C
        zamknięcie: a + b = c
        rzut na oś x: l1·cos α1 + l2·cos φ = x_C
        rzut na oś y: l1·sin α1 + l2·sin φ = 0""",
    "Russian with letters that only look Latin": """вектор l1: из А в В, длина l1, угол альфа1
        l2: В → С, длина l2 постоянная, угол alpha2 неизвестный
        l3: A → C, длина l3 неизвестная, угол 0
        замыкание: l1 + l2 - l3 = 0
        х: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0
        у: l1*sin(alpha1) + l2*sin(alpha2) = 0""",
    "in one line": "AB: l1, alpha1; BC: l2, alpha2; AC: l3, 0; polygon: AB + BC + CA = 0; "
    "Ox: l1 cos(alpha1) + l2 cos(alpha2) = l3; Oy: l1 sin(alpha1) = -l2 sin(alpha2); unknowns: alpha2; l3",
    "LaTeX": r"""l1: A > B, length l_1, angle \alpha_1
        l2: B > C, length l_{2}, angle \alpha_{2}
        l3: A > C, length l_3, angle 0
        closure: l_1 + l_2 - l_3 = 0
        x: l_1\cos\alpha_1 + l_2\cos\left(\alpha_2\right) - l_3 = 0
        y: l_1\cdot\sin\alpha_1 + l_2\cdot\sin\alpha_2 = 0
        unknowns: \alpha_2; l_3""",
    "a second name of the driver": """l1: A > B, length l1, angle phi1
        l2: B > C, length l2, angle alpha2
        l3: A > C, length l3, angle 0
        closure: l1 + l2 - l3 = 0
        x: l1*cos(phi1) + l2*cos(alpha2) - l3 = 0
        y: l1*sin(phi1) + l2*sin(alpha2) = 0
        unknowns: alpha2; l3""",
}


@pytest.mark.parametrize("name", RIGHT)
def test_any_valid_choice_is_right(name: str) -> None:
    verdict = judged(RIGHT[name])
    assert verdict.code is Code.RIGHT, verdict.details


def four_bar(senses: tuple[bool, ...], shift: int) -> str:
    """Write the four-bar's polygon with every vector in either sense and the lines in another order."""
    bars = [("A", "B", "l1", 1), ("B", "C", "l2", 1), ("C", "D", "l3", 1), ("D", "A", "l4", 1)]
    angles = ["alpha1", "a2", "a3", "pi"]
    lines, walk, xs, ys = [], [], [], []
    for (start, end, length, _), angle, turned in zip(bars, angles, senses, strict=True):
        if turned:
            start, end = end, start
            angle = {"alpha1": "alpha1 + pi", "pi": "0"}.get(angle, angle)
        sign = "-" if turned else "+"
        lines.append(f"{length}: {start} > {end}, length {length}, angle {angle}")
        walk.append(f"{sign} {length}")
        xs.append(f"{sign} {length}*cos({angle})")
        ys.append(f"{sign} {length}*sin({angle})")
    lines += [f"closure: {' '.join(walk)} = 0", f"x: {' '.join(xs)} = 0", f"y: 0 = {' '.join(ys)}", "unknowns: a3; a2"]
    return "\n".join(lines[shift:] + lines[:shift])


@pytest.mark.parametrize("senses", list(product((False, True), repeat=4)))
def test_every_sense_of_every_vector_is_right(senses: tuple[bool, ...]) -> None:
    verdict = judged(four_bar(senses, sum(senses)), FOUR_BAR)
    assert verdict.code is Code.RIGHT, verdict.details


@quick
@given(order=st.permutations(TWO_LOOPS.polygon.splitlines()))
def test_lines_may_stand_in_any_order(order: list[str]) -> None:
    assert judged("\n".join(order), TWO_LOOPS).code is Code.RIGHT


def test_the_outer_loop_may_take_the_place_of_an_inner_one() -> None:
    outer = TWO_LOOPS.polygon.replace("closure 2: l4 + l3 + l5 - s6 - h6 = 0", "closure 2: l1 + l2 + l5 - s6 - h6 = 0")
    outer = outer.replace(
        "x2: l4 + l3*cos(alpha3) + l5*cos(alpha5) - s6 = 0",
        "x2: l1*cos(alpha1) + l2*cos(alpha2) + l5*cos(alpha5) - s6 = 0",
    )
    assert judged(outer, TWO_LOOPS).code is Code.RIGHT


def test_a_slider_that_passes_its_origin_has_a_coordinate_with_a_sign() -> None:
    """The rod is shorter than the throw of the crank minus the offset allows: E > C changes its sense."""
    states = tuple(state for state in slider_states(0.03))
    moved = []
    for k, state in enumerate(states):
        shift = 0.2 + 0.01 * (k % 9)
        nodes = dict(state.nodes)
        nodes["E"] = ((shift, 0.0, 0.0), nodes["E"][1])
        names = dict(state.names) | {"e": (shift, 0.0, 0.0)}
        moved.append(type(state)(names, nodes))
    assert {state.nodes["C"][0][0] > state.nodes["E"][0][0] for state in moved} == {False, True}
    mechanism = Mechanism(
        edges=(*OFFSET.edges, ("A", "F"), ("F", "E")),
        polygon="",
        states=lambda: tuple(
            type(s)(s.names, dict(s.nodes) | {"F": (s.nodes["E"][0], (0.0, 0.0, 0.0))}) for s in moved
        ),
    )
    text = """a: A > B, l1, alpha1
        b: B > C, l2, alpha2
        s: E > C, s, 0
        e: A > F, e, 0
        h: F > E, h, 90°
        closure: a + b = e + h + s
        x: l1*cos(alpha1) + l2*cos(alpha2) = e + s
        y: l1*sin(alpha1) + l2*sin(alpha2) = h
        unknowns: s; alpha2"""
    assert judged(text, mechanism).code is Code.RIGHT


def test_true_states_that_are_too_few_are_the_author_s_fault() -> None:
    mechanism = Mechanism(SLIDER.edges, SLIDER.polygon, lambda: slider_states()[:3])
    with pytest.raises(ValueError, match="too few"):
        judged(SLIDER.polygon, mechanism)


def test_states_are_true() -> None:
    for state in four_bar_states():
        (bx, by), (cx, cy) = state.nodes["B"], state.nodes["C"]
        assert (cx[0] - bx[0]) ** 2 + (cy[0] - by[0]) ** 2 == pytest.approx(state.names["l2"][0] ** 2)
        assert abs(state.names["alpha1"][0]) < 5 * pi
