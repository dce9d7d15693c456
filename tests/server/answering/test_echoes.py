"""Echoes of long formulas break before the signs between their terms; nothing of them is lost."""

from __future__ import annotations

import re

import pytest

from exercises.grading import preview, reference
from exercises.variants import deal
from graders import Verdict
from server.answering.echoes import NEW_LINE, breakable

ARM = deal("tmm2_oop", 7)


def read(name: str, text: str) -> str:
    echo = preview(ARM, name, text)
    assert not isinstance(echo, Verdict)
    return echo.mathml


def letters(mathml: str) -> str:
    return re.sub("<[^>]*>", "", mathml)


def test_a_long_sum_breaks_before_each_of_its_terms() -> None:
    found = breakable(read("v_x_formula", "-l_AB*Theta1_d*sin(Theta1) - l_BC*(omega3 + omega3)*sin(alpha2) + h3_d"))
    pieces = [letters(one) for one in found.split("</math>")[:-1]]
    assert [piece[0] for piece in pieces] == ["−", "−", "+"]
    assert found.count('form="infix"') == 2 and "(" in pieces[1]


@pytest.mark.parametrize("text", ["l_AB", "l_AB + h3", "-h3"])
def test_what_fits_stays_one_formula(text: str) -> None:
    assert breakable(read("v_x_formula", text)) == read("v_x_formula", text)


@pytest.mark.parametrize("name", ["polygon", "velocities", "accelerations"])
def test_each_line_of_a_column_is_a_line_of_formulas(name: str) -> None:
    whole = read(name, reference(ARM)[name])
    found = breakable(whole)
    assert found.count(NEW_LINE) == whole.count("<mtr>") - 1 and "<mtable" not in found
    assert letters(found) == letters(whole)
    heads = [letters(line)[:2] for line in found.split(NEW_LINE)]
    assert name == "polygon" or heads == ["x:", "y:"]


def test_a_matrix_stays_whole() -> None:
    matrix = "<math><mrow><mo>[</mo><mtable><mtr><mtd><mn>1</mn></mtd></mtr></mtable><mo>]</mo></mrow></math>"
    assert breakable(matrix) == matrix and breakable("") == ""
