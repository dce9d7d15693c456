"""Decimals that a student may round: a literal with enough figures stands for all numbers that round to it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from flint import arb, fmpq

from graders.equality.deciding import SETTLING, Finding, exactly
from graders.judge import Formula
from graders.language.balls import BALLS, precision
from graders.language.doubles import UndefinedError
from graders.language.program import Builder, Program, Runner
from graders.language.tree import Binary, Call, Name, Number, Tree, Unary
from graders.states import Point

GUARD = 1.5  # how much wider than one rounded literal a ball may be, for each literal


@dataclass(frozen=True, slots=True)
class Rounded:
    """An answer beside its reference, the rounded literals of the answer being inputs of their own."""

    program: Program
    literals: tuple[Number, ...]
    figures: int

    def at(self, point: Point) -> Finding:
        """Decide at a point: undecided where the literals cancel, so that their ball would accept too much."""
        with precision(SETTLING):
            try:
                right, typed = Runner(self.program, BALLS).run([*exactly(point), *map(_ball, self.literals)])
            except UndefinedError:
                return Finding.NOWHERE
            if not (right - typed).contains(0):
                return Finding.DIFFERENT
            bound = GUARD * 10.0 ** (1 - self.figures) * len(self.literals)
            return Finding.EQUAL if typed.rad() <= bound * right.abs_upper() else Finding.UNDECIDED


def rounded(answer: Tree, reference: Formula, figures: int) -> Rounded | None:
    """Make the comparison of an answer whose decimals are rounded; None where it holds none."""
    literals: dict[Number, Name] = {}
    renamed = _renamed(answer, literals, figures)
    if not literals:
        return None
    states = reference.states
    builder = Builder((*states.names, *(name.name for name in literals.values())))
    for name, line in states.lines:
        builder.define(name, line)
    return Rounded(builder.program(builder.add(reference.tree), builder.add(renamed)), tuple(literals), figures)


def _renamed(tree: Tree, literals: dict[Number, Name], figures: int) -> Tree:
    """Put a name of its own in the place of every decimal that has enough figures."""
    match tree:
        case Number(digits=digits) if "." in digits and len(digits.replace(".", "").lstrip("0")) >= figures:
            return literals.setdefault(tree, Name(f"≈{digits}e{tree.exponent}"))
        case Unary(operand=operand):
            return replace(tree, operand=_renamed(operand, literals, figures))
        case Binary(left=left, right=right):
            return replace(tree, left=_renamed(left, literals, figures), right=_renamed(right, literals, figures))
        case Call(arguments=arguments):
            return replace(tree, arguments=tuple([_renamed(one, literals, figures) for one in arguments]))
    return tree


def _ball(number: Number) -> Any:
    """Give all numbers that round to a decimal: half of its last digit to both sides."""
    half = arb(fmpq(1, 2 * 10 ** len(number.digits.partition(".")[2]))) * arb(10) ** number.exponent
    return arb(BALLS.literal(number)) + arb(0, 1) * half
