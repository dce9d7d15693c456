"""Judge of a formula: equality as functions, never equality of shape."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import isclose, nan
from typing import Any, ClassVar

from graders.asides import without_derivatives, without_label
from graders.common_slips import CommonSlip, Slips
from graders.formulas import Form, checked, has_form
from graders.judge import Echo, Formula, Samples, States
from graders.language.doubles import UndefinedError, line_runner, run
from graders.language.latex import latex_of
from graders.language.mathml import mathml_of
from graders.language.parser import parse
from graders.language.symbols import Symbols
from graders.language.text import text_of
from graders.language.tree import Binary, Name, Number, Relation, Tree, Unary, names
from graders.line_slips import slips_in
from graders.verdict import RIGHT, UNDECIDED, Code, Named, Verdict, Witness, wrong

FEWEST = 2  # figures of a decimal that may stand for a fraction, a root or pi
LIKELY = 1e-6  # relative, between doubles at one state
WRONG_FORM = {Form.PRODUCT: Code.NOT_A_PRODUCT, Form.NO_INVERSE: Code.HOLDS_INVERSE}


@dataclass(frozen=True, slots=True)
class Expression:
    r"""A formula in the givens and the earlier steps.

    Args:
        step: The step whose formula is asked for.
        weight: Share in the score.
        figures: The significant figures to which its decimals may be rounded, at least; 0 where they are exact.
        without: Earlier names that it has to do without: it is to be solved for the step.
        forms: Forms asked for besides the value.
        form_credit: Credit for the right value in another form.
        called: Another name that the unknown may have in front, `z_M = …` where the step is z.
        rates: Names of rates that it is and that may stand in front, `\dot{\alpha}_2 = …` where the step is omega2.
    """

    step: str
    weight: float = 1.0
    figures: int = 0
    without: tuple[str, ...] = ()
    forms: tuple[Form, ...] = ()
    form_credit: float = 0.5
    called: str = ""
    rates: tuple[str, ...] = ()
    kind: ClassVar[str] = "expression"
    symbolic: ClassVar[bool] = True

    def parse(self, text: str, symbols: Symbols) -> Tree:
        """Read a formula; `omega2 = …` or an unknown name in front is allowed, the unknown itself inside is not."""
        tree = self._read(text, symbols)
        front = {Name(name) for name in (self.step, self.called, *self.rates)}
        if isinstance(tree, Relation) and {*tree.operators} == {"="} and front.issuperset(tree.sides[:-1]):
            tree = tree.sides[-1]
        return checked(tree, text, symbols)

    def _read(self, text: str, symbols: Symbols) -> Tree:
        if self.rates and "=" in text:
            symbols = Symbols(symbols.names, (*symbols.known, *self.rates))
            text = without_derivatives(text, self.rates)
        return parse(without_label(text, symbols), symbols)

    def check(self, answer: Tree, reference: Formula) -> Verdict:
        """Judge by ball arithmetic on true states; what cannot be decided is kept for the lecturer."""
        if answer == reference.tree:  # the reference has a value at all of its points, and the form asked for
            return RIGHT
        from graders.equality import Finding, compare, rounds

        found = compare(answer, reference, self.figures)
        if found.finding is Finding.EQUAL:
            return self._formed(answer)
        if found.finding is Finding.DIFFERENT and names(reference.tree) and not names(answer):
            return wrong(Code.NO_SYMBOLS)
        if found.finding is Finding.DIFFERENT and not self.figures and rounds(answer, reference, FEWEST):
            return wrong(Code.ROUNDED_NUMBER, Witness(found.witness))
        if found.finding in (Finding.DIFFERENT, Finding.UNDEFINED):
            return wrong(Code.UNDEFINED if found.finding is Finding.UNDEFINED else Code.WRONG, Witness(found.witness))
        return UNDECIDED

    def _formed(self, answer: Tree) -> Verdict:
        """Judge the form of a formula whose value is right."""
        for name in sorted(names(answer).intersection(self.without)):
            return Verdict(self.form_credit, Code.NOT_SOLVED, Named(name))
        for form in self.forms:
            if not has_form(answer, form):
                return Verdict(self.form_credit, WRONG_FORM[form])
        return RIGHT

    def slips(self, answer: Tree, reference: Formula) -> Slips:
        """Tell the opposite sign, a factor of two, the reciprocal, and slips in one place of the reference."""
        values = _first(reference.states)
        typed, true = _value(answer, values), _value(reference.tree, values)
        for slip, mended in _mended(answer):
            if isclose(_value(mended, values), true, rel_tol=LIKELY) and self.check(mended, reference) is RIGHT:
                return frozenset((slip,))
        likely = [
            (slip, tree)
            for slip, tree in slips_in(reference.tree)
            if isclose(_value(tree, values), typed, rel_tol=LIKELY)
        ]
        return frozenset(slip for slip, tree in likely if self.check(answer, Formula(tree, reference.states)) is RIGHT)

    def show(self, reference: Formula) -> str:
        """Write the formula as a student could type it."""
        return text_of(reference.tree)

    def samples(self, reference: Formula) -> Samples:
        """Give texts that must be judged right, wrong and unreadable."""
        text = text_of(reference.tree)
        right = (text, f"({text})*2/2", f"{self.step} = {text}", f"({text}) + 1 - 1")
        return Samples(
            right[: 3 if self.forms else 4],
            (f"-({text})", f"2*({text})", f"({text}) + 1e-9*({text})"),
            ("", f"({text}", "1 +", self.step),
        )

    def echo(self, answer: Tree, comma: bool = False) -> Echo:
        """Show the formula as it was read."""
        return Echo(mathml_of(answer, comma), text_of(answer), latex=latex_of(answer, comma))

    def carried(self, answer: Tree) -> Tree:
        """Give the student's formula, from which later answers are solved."""
        return answer

    def apart(self, one: Formula, other: Formula) -> float:
        """Two formulas are equal or far apart."""
        return 0.0 if self.check(one.tree, other).code is Code.RIGHT else float("inf")

    def describe(self) -> Mapping[str, Any]:
        """Give how it may be rounded and the forms asked for, where the task declares any."""
        figures = {"figures": self.figures} if self.figures else {}
        asked = {"forms": [form.value for form in self.forms], "without": list(self.without)}
        return {**figures, **(asked if self.forms or self.without else {})}


def _first(states: States) -> dict[str, float]:
    """Give the values of all symbols in doubles at one state; what agrees there may be equal."""
    values = dict(zip(states.names, states.points[0], strict=True))
    for name, line in states.lines:
        values[name] = _value(line, values)
    return values


def _value(tree: Tree, values: Mapping[str, float]) -> float:
    """Give a value in doubles; none is no number, which agrees with nothing."""
    runner = line_runner(tree)
    try:
        (found,) = run(runner, [values[name] for name in runner.inputs])
    except UndefinedError:
        return nan
    return float(found)


def _mended(answer: Tree) -> Iterator[tuple[CommonSlip, Tree]]:
    yield CommonSlip.OPPOSITE_SIGN, Unary("-", answer)
    yield CommonSlip.INVERTED_RATIO, Binary("/", Number("1"), answer)
    yield CommonSlip.FACTOR_TWO, Binary("*", Number("2"), answer)
    yield CommonSlip.FACTOR_TWO, Binary("/", answer, Number("2"))
