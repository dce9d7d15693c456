"""A polygon as it was read: vectors between nodes, closures, projections, unknowns."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from graders.language.mathml import mathml_of, symbol_mathml
from graders.language.text import text_of
from graders.language.tree import Binary, Relation, Tree, names

Axis = Literal["x", "y", ""]


@dataclass(frozen=True, slots=True)
class Vector:
    """A vector from a node to a node; `constant` and `sought` hold what was said of "length" and "angle"."""

    label: str
    start: str
    end: str
    length: Tree
    angle: Tree
    constant: frozenset[str] = frozenset()
    sought: frozenset[str] = frozenset()

    def of(self, what: str) -> Tree:
        """Give the formula of "length" or "angle"."""
        return self.length if what == "length" else self.angle


@dataclass(frozen=True, slots=True)
class Closure:
    """A sum of vectors that is zero: how often each is walked, with its sign."""

    tree: Relation
    walked: tuple[tuple[str, float], ...]


@dataclass(frozen=True, slots=True)
class Equation:
    """An equation on an axis (none: not said) of the polygon with a number from 1."""

    axis: Axis
    loop: int
    tree: Relation

    @property
    def difference(self) -> Tree:
        """Give left minus right."""
        left, right = self.tree.sides
        return Binary("-", left, right)


@dataclass(frozen=True, slots=True)
class Drawn:
    """A whole polygon; `unknowns` is None where nothing was said of them."""

    vectors: tuple[Vector, ...]
    closures: tuple[Closure, ...] = ()
    equations: tuple[Equation, ...] = ()
    unknowns: tuple[str, ...] | None = None

    @property
    def names(self) -> frozenset[str]:
        """Give the names in lengths and angles."""
        return frozenset().union(*(names(v.length) | names(v.angle) for v in self.vectors))

    def vector(self, label: str) -> Vector:
        """Give a vector by its label."""
        return next(vector for vector in self.vectors if vector.label == label)

    def lines(self, comma: bool = False) -> Iterator[tuple[str, str]]:
        """Give every line as text and as the inside of MathML."""
        for v in self.vectors:
            text = f"{v.label}: {v.start} > {v.end}, length {text_of(v.length)}, angle {text_of(v.angle)}"
            inner = [_symbol(v.label), "<mo>:</mo>", _word(v.start), "<mo>→</mo>", _word(v.end), "<mo>,</mo>"]
            inner += [_inner(v.length, comma), "<mo>∠</mo>", _inner(v.angle, comma)]
            yield text, "".join(inner)
        for closure in self.closures:
            yield f"closure: {text_of(closure.tree)}", _inner(closure.tree, comma)
        yield from equation_lines(self.equations, comma)
        if self.unknowns is not None:
            listed = "; ".join(self.unknowns)
            yield f"unknowns: {listed}", "<mo>;</mo>".join(map(_symbol, self.unknowns))


def equation_lines(equations: tuple[Equation, ...], comma: bool) -> Iterator[tuple[str, str]]:
    """Give equations as text and as the inside of MathML."""
    for e in equations:
        head = f"{e.axis}: " if e.axis else ""
        yield head + text_of(e.tree), (_word(e.axis) + "<mo>:</mo>" if e.axis else "") + _inner(e.tree, comma)


def sheet(lines: Iterator[tuple[str, str]]) -> tuple[str, str]:
    """Join lines to one MathML table and one text."""
    both = list(lines)
    rows = "".join(f"<mtr><mtd>{inner}</mtd></mtr>" for _, inner in both)
    return f'<math><mtable columnalign="left">{rows}</mtable></math>', "\n".join(text for text, _ in both)


def _symbol(name: str) -> str:
    return _bare(symbol_mathml(name))


def _word(text: str) -> str:
    return f"<mi>{text}</mi>"


def _inner(tree: Tree, comma: bool) -> str:
    return _bare(mathml_of(tree, comma))


def _bare(mathml: str) -> str:
    return mathml.removeprefix("<math>").removesuffix("</math>")
