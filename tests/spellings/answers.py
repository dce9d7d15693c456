"""The rewritings and mutants of one answer of a solved variant, whatever its kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exercises.givens import numbers
from exercises.solving import Solved
from graders import Choice, Choices, Expression, Integer, Matrix, Ordering, Quantity, Rational
from tests.spellings import amounts, formulas, grids
from tests.spellings.hand import formula

RICHER = {
    "dh_table",
    "diagram",
    "equation",
    "function",
    "inequality",
    "polygon",
    "rates",
    "samples",
    "set",
    "symbolic_matrix",
    "text",
}  # rewritten in tests/graders
Spelled = list[tuple[str, str]]
Kind = Callable[[Solved, str], Spelled]


def covered(solved: Solved) -> list[str]:
    """Give the answers that are written here in other ways; the richer kinds have tests of their own."""
    unknown = {grader.kind for grader in solved.answers.values() if type(grader) not in RIGHT} - RICHER
    assert not unknown, f"no rewritings for {unknown}"
    return [name for name, grader in solved.answers.items() if type(grader) in RIGHT]


def right(solved: Solved, name: str) -> Spelled:
    """Give texts that must be judged right, each with its kind."""
    return RIGHT[type(solved.answers[name])](solved, name)


def wrong(solved: Solved, name: str) -> Spelled:
    """Give texts that must not be judged right, each with its kind."""
    return WRONG[type(solved.answers[name])](solved, name)


def _line(solved: Solved, name: str) -> tuple[str, formulas.Lines]:
    step = solved.step_of(name)
    lines = {key: line for key, line in solved.steps.items() if isinstance(line, str)}
    usable = (
        solved.symbols(name).names - solved.exercise.counts_of(solved.variant.givens).keys()
    )  # counts stand as such
    return lines[step], tuple((key, line) for key, line in lines.items() if key in usable)


def _formulas(solved: Solved, name: str) -> Spelled:
    line, earlier = _line(solved, name)
    return list(formulas.rewritten(solved.step_of(name), line, earlier))


def _wrong_formulas(solved: Solved, name: str) -> Spelled:
    """The mutants that differ at the variant's own numbers."""
    line, _ = _line(solved, name)
    at = {
        key: v for key, v in {**solved.values, **numbers(solved.variant.givens)}.items() if isinstance(v, float | int)
    }
    exact = formulas.value(formula(line), at)
    far = [(kind, text) for kind, text, tree in formulas.mutated(line) if _differs(formulas.value(tree, at), exact)]
    return [("only the name", solved.step_of(name)), ("zero", "0"), *far]


def _differs(one: float, other: float) -> bool:
    return not abs(one - other) <= 1e-11 * abs(other)


RIGHT: dict[type, Kind] = {
    Quantity: lambda solved, name: amounts.quantity(solved.step_of(name), _float(solved, name), _unit(solved, name)),
    Integer: lambda solved, name: amounts.integer(solved.step_of(name), _float(solved, name)),
    Choice: lambda solved, name: amounts.choice(name, _any(solved, name), _grader(solved, name).options),
    Rational: lambda solved, name: amounts.ratio(solved.step_of(name), _float(solved, name)),
    Choices: lambda solved, name: amounts.several(_any(solved, name), _grader(solved, name).options),
    Ordering: lambda solved, name: amounts.several(_any(solved, name), _grader(solved, name).options),
    Matrix: lambda solved, name: grids.matrix(solved.step_of(name), _any(solved, name), _grader(solved, name).units),
    Expression: _formulas,
}
WRONG: dict[type, Kind] = {
    Quantity: lambda solved, name: amounts.wrong_quantity(
        _float(solved, name), _unit(solved, name), _grader(solved, name).rtol, _grader(solved, name).atol
    ),
    Integer: lambda solved, name: amounts.wrong_integer(_float(solved, name)),
    Choice: lambda solved, name: amounts.wrong_choice(_any(solved, name), _grader(solved, name).options),
    Rational: lambda solved, name: amounts.wrong_ratio(_float(solved, name), _grader(solved, name).rtol),
    Choices: lambda solved, name: amounts.wrong_several(_any(solved, name), _grader(solved, name).options, False),
    Ordering: lambda solved, name: amounts.wrong_several(_any(solved, name), _grader(solved, name).options, True),
    Matrix: lambda solved, name: grids.wrong_matrix(
        _any(solved, name), _grader(solved, name).units, _grader(solved, name).rtol
    ),
    Expression: _wrong_formulas,
}


def _grader(solved: Solved, name: str) -> Any:
    return solved.answers[name]


def _any(solved: Solved, name: str) -> Any:
    return solved.reference(name)


def _float(solved: Solved, name: str) -> float:
    return float(_any(solved, name))


def _unit(solved: Solved, name: str) -> str:
    unit: str = _grader(solved, name).unit
    return unit
