"""Correct rewritings and wrong mutants of a formula, by SymPy and by hand."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Any

import sympy

from tests.spellings.hand import HANDS, PLAIN, formula, symbol

SINE, COSINE = sympy.Function("sine"), sympy.Function("cosine")
LARGE = 60  # operations above which a formula is not expanded or factored
NUMERIC: dict[str, Callable[..., float]] = {
    "Abs": abs, "Min": min, "Max": max, "log": math.log, "sign": lambda x: float((x > 0) - (x < 0)),
    "macaulay": lambda inside, power: inside**power if inside >= 0 else 0.0,
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp")},
}  # fmt: skip
Spelled = tuple[tuple[str, str], ...]
Lines = tuple[tuple[str, str], ...]


@lru_cache(maxsize=512)
def rewritten(name: str, line: str, earlier: Lines) -> Spelled:
    """Give texts that mean the same as a line: by other hands, in other forms, with earlier steps put in."""
    tree = formula(line)
    found = [(kind, hand.write(tree)) for kind, hand in HANDS.items()]
    found += [(kind, PLAIN.write(form)) for kind, form in _forms(tree, dict(earlier))]
    plain = PLAIN.write(tree)
    some = min((s.name for s in tree.free_symbols), default="pi")
    found += [
        ("as the exercise writes it", line),
        ("name in front", f"{name} = {plain}"),
        ("double and half", f"2*({plain})/2"),
        ("decimal halves", f"0,5*({plain}) + 0.5*({plain})"),
        ("a power of ten", f"1e3*({plain})*10^-3"),
        ("one by Pythagoras", f"({plain})*(sin({some})^2 + cos({some})^2)"),
        ("plus and minus", f"({plain}) + {some} - {some}"),
        ("two signs", f"-(-({plain}))"),
        ("no spaces", plain.replace(" ", "")),
        ("many spaces", " " + plain.replace(" ", "  ").replace("*", " *\u00a0") + " "),
    ]
    return tuple(dict((text, (kind, text)) for kind, text in found).values())


def _forms(tree: Any, earlier: Mapping[str, str]) -> Iterator[tuple[str, Any]]:
    arguments = sorted({f.args[0] for f in tree.atoms(sympy.sin, sympy.cos)}, key=str)
    yield "sines of complements", _functions(tree, lambda x: COSINE(sympy.pi / 2 - x), lambda x: SINE(sympy.pi / 2 - x))
    yield "shifted by a turn", _functions(tree, lambda x: SINE(x + 2 * sympy.pi), lambda x: COSINE(x - 2 * sympy.pi))
    if arguments:
        half = [x / 2 for x in arguments]
        doubled = {sympy.sin(2 * h): 2 * sympy.sin(h) * sympy.cos(h) for h in half}
        yield "half angles", tree.xreplace(doubled | {sympy.cos(2 * h): 1 - 2 * sympy.sin(h) ** 2 for h in half})
        yield "sine by tangent", _functions(tree, lambda x: sympy.tan(x) * sympy.cos(x), sympy.cos)
    put = {symbol(step): formula(text) for step, text in earlier.items() if symbol(step) in tree.free_symbols}
    if put:
        yield "earlier step put in", tree.xreplace(put)
    if sympy.count_ops(tree) <= LARGE:
        yield "expanded", sympy.expand(tree)
        yield "expanded angles", sympy.expand_trig(tree)
        yield "factored", sympy.factor(tree)
        yield "one fraction", sympy.together(tree)


def _functions(tree: Any, sine: Callable[[Any], Any], cosine: Callable[[Any], Any]) -> Any:
    return tree.replace(sympy.sin, sine).replace(sympy.cos, cosine)


@lru_cache(maxsize=512)
def mutated(line: str) -> tuple[tuple[str, str, Any], ...]:
    """Give texts near a line that do not mean the same, each with its tree."""
    tree = formula(line)
    found: dict[str, Any] = {
        "opposite sign": -tree,
        "twice": 2 * tree,
        "ten times": 10 * tree,
        "kilo": 1000 * tree,
        "near miss": tree * (1 + sympy.Rational(1, 10**9)),
        "a little more": tree + sympy.Rational(1, 10**9),
        "reciprocal": 1 / tree,
        "square": tree**2,
        "a figure lost": sympy.Rational(99999, 100000) * tree,
        "one added": tree + 1,
        **dict(_term_lost(tree)),
        **dict(_symbol_slips(tree)),
        **dict(_swapped(tree)),
    }
    return tuple((kind, PLAIN.write(other), other) for kind, other in found.items() if other != tree)


def _term_lost(tree: Any) -> Iterator[tuple[str, Any]]:
    sums = [node for node in sympy.preorder_traversal(tree) if node.is_Add][:3]
    for number, node in enumerate(sums):
        for term in node.args[:4]:
            yield f"term {term} of sum {number} lost", tree.xreplace({node: node - term})
            yield f"sign of {term} in sum {number}", tree.xreplace({node: node - 2 * term})


def _symbol_slips(tree: Any) -> Iterator[tuple[str, Any]]:
    for name in sorted(tree.free_symbols, key=str):
        yield f"{name} in degrees", tree.xreplace({name: name * 180 / sympy.pi})
        yield f"{name} doubled", tree.xreplace({name: 2 * name})


def _swapped(tree: Any) -> Iterator[tuple[str, Any]]:
    for node in sorted(tree.atoms(sympy.sin, sympy.cos), key=str):
        other = sympy.cos if node.func is sympy.sin else sympy.sin
        yield f"{node} swapped", tree.xreplace({node: other(*node.args)})


def value(tree: Any, at: Mapping[str, float]) -> float:
    """Compute a formula at a point in doubles; NaN where it has no value."""
    try:
        return _value(tree, at)
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan


def _value(tree: Any, at: Mapping[str, float]) -> float:
    if tree.is_Symbol:
        return at[tree.name]
    if tree.is_number:
        return float(tree)
    values = [_value(argument, at) for argument in tree.args]
    if tree.is_Add:
        return math.fsum(values)
    if tree.is_Mul:
        return math.prod(values)
    if tree.is_Pow:
        return math.pow(*values)
    return NUMERIC[tree.func.__name__](*values)
