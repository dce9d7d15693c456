"""Formulas as hands write them: SymPy trees to text, with names, products, powers and marks of many hands."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import sympy
from sympy.parsing.sympy_parser import parse_expr, rationalize, standard_transformations

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eta": "η", "theta": "θ", "lambda": "λ",
    "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω",
}  # fmt: skip
LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
NAME = re.compile(r"[A-Za-z_]\w*")
FUNCTIONS = ("sin", "cos", "tan", "cot", "asin", "acos", "atan", "sqrt", "exp", "atan2", "sign", "cosine", "sine")
HERE = {name: getattr(sympy, name) for name in FUNCTIONS if hasattr(sympy, name)} | {
    "pi": sympy.pi, "ln": sympy.log, "abs": sympy.Abs, "min": sympy.Min, "max": sympy.Max,
    "macaulay": sympy.Function("macaulay"), "Integer": sympy.Integer, "Float": sympy.Float,
    "Rational": sympy.Rational, "Symbol": sympy.Symbol, "Function": sympy.Function,
}  # fmt: skip
POLISH = {"tan": "tg", "cot": "ctg", "asin": "arcsin", "acos": "arccos", "atan": "arctg"}
LONG = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def symbol(name: str) -> sympy.Symbol:
    """Give the symbol of a name; all are real, which is what a hand takes for granted."""
    return sympy.Symbol(name, real=True)


@lru_cache(maxsize=4096)
def formula(line: str) -> sympy.Expr:
    """Read a line of an exercise into SymPy; only names, figures and the functions above occur in it."""
    names = {name for name in NAME.findall(line) if name not in HERE}
    safe = NAME.sub(lambda found: f"v_{found[0]}" if found[0] in names else found[0], line)
    known = {f"v_{name}": symbol(name) for name in names}
    python = safe.replace("^", "**").replace(";", ",")
    return parse_expr(python, known, (*standard_transformations, rationalize), HERE)


@dataclass(frozen=True, slots=True)
class Hand:
    """How one hand writes: signs, powers, names and function names."""

    times: str = "*"
    minus: str = "-"
    power: str = "^"
    raised: bool = False
    greek: bool = False
    lowered: bool = False
    underscore: bool = False
    squares: bool = False
    bare: bool = False
    comma: bool = False
    root: str = "sqrt"
    bracket: str = "macaulay"
    functions: tuple[tuple[str, str], ...] = ()

    def name(self, name: str) -> str:
        """Write a symbol: Greek or spelled out, its index plain, lowered or behind an underscore."""
        found = re.fullmatch(r"([A-Za-z]+?)_?(\d+)", name)
        stem, index = (found[1], found[2]) if found else (name, "")
        head, _, tail = stem.partition("_")
        stem = GREEK.get(head, head) + (f"_{tail}" if tail else "") if self.greek else stem
        if index and self.lowered:
            return stem + index.translate(LOWERED)
        return f"{stem}_{index}" if index and self.underscore else stem + index

    def write(self, tree: Any) -> str:
        """Write a formula."""
        if tree.is_Add:
            return self._sum(tree)
        if tree.is_Mul or tree.is_Rational:
            return self._product(tree)
        if tree.is_Pow:
            return self._power(tree)
        if tree.is_Symbol:
            return self.name(tree.name)
        if tree is sympy.pi:
            return "π" if self.greek else "pi"
        return self._call(tree)

    def _sum(self, tree: Any) -> str:
        pieces: list[str] = []
        for term in tree.as_ordered_terms():
            negative = term.could_extract_minus_sign()
            text = self.write(-term if negative else term)
            text = f"({text})" if (-term if negative else term).is_Add else text
            pieces.append(f" {self.minus} {text}" if negative else f" + {text}" if pieces else text)
        return "".join(pieces).strip()

    def _product(self, tree: Any) -> str:
        if tree.could_extract_minus_sign() and tree != 0:
            inner = self.write(-tree)
            return f"{self.minus}({inner})" if (-tree).is_Add else f"{self.minus}{inner}"
        top, bottom = sympy.fraction(tree, exact=True)
        upper, lower = self._factors(top), self._factors(bottom)
        over = self.times.join(upper) or "1"
        if not lower:
            return over
        return f"{over}/{lower[0]}" if len(lower) == 1 and bottom.is_Atom else f"{over}/({self.times.join(lower)})"

    def _factors(self, tree: Any) -> list[str]:
        parts = [part for part in sympy.Mul.make_args(tree) if part != 1]
        ordered = sorted(parts, key=lambda part: (not part.is_number, bool(part.has(sympy.Function)), part.sort_key()))
        return [f"({self.write(part)})" if part.is_Add else self._number(part) for part in ordered]

    def _number(self, part: Any) -> str:
        if not part.is_Integer:
            return self.write(part)
        return f"{part},0" if self.comma else str(part)

    def _power(self, tree: Any) -> str:
        base, exponent = tree.as_base_exp()
        if exponent == sympy.Rational(1, 2):
            return f"{self.root}({self.write(base)})"
        if exponent.could_extract_minus_sign():
            return self._product(tree)
        if self.squares and base.is_Function and exponent.is_Integer and base.func.__name__ in ("sin", "cos", "tan"):
            return self._call(base, str(exponent).translate(RAISED) if self.raised else f"^{exponent}")
        inside = self.write(base) if base.is_Symbol or (base.is_Function and not self.bare) else f"({self.write(base)})"
        if self.raised and exponent.is_Integer:
            return inside + str(exponent).translate(RAISED)
        return f"{inside}{self.power}{exponent if exponent.is_Integer else f'({self.write(exponent)})'}"

    def _call(self, tree: Any, power: str = "") -> str:
        name, arguments = tree.func.__name__, [self.write(argument) for argument in tree.args]
        if name == "macaulay":
            return self._macaulay(*tree.args)
        if name == "sine":
            return f"sin({arguments[0]})"
        if name == "cosine":
            return f"cos({arguments[0]})"
        plain = {"Abs": "abs", "Min": "min", "Max": "max", "log": "ln"}.get(name, name)
        plain = dict(self.functions).get(plain, plain) + power
        if self.bare and len(arguments) == 1 and tree.args[0].is_Symbol:
            return f"{plain} {arguments[0]}"
        return f"{plain}({'; '.join(arguments)})"

    def _macaulay(self, inside: Any, power: Any) -> str:
        text = self.write(inside)
        written = {
            "macaulay": f"macaulay({text}; {power})",
            "<>": f"<{text}>^{power}" if power != 1 else f"<{text}>",
            "⟨⟩": f"⟨{text}⟩{str(power).translate(RAISED)}",
            "abs": f"(({text} + |{text}|)/2)^{power}" if power != 0 else f"((1 + sign({text}))/2)",
            "max": f"max({text}; 0)^{power}" if power != 0 else f"<{text}>^0",
        }[self.bracket]
        return f"({written})" if self.bracket in ("<>", "⟨⟩") else written


PLAIN = Hand()
HANDS = {
    "stars": PLAIN,
    "Greek letters": replace(PLAIN, greek=True),
    "lowered indices": replace(PLAIN, greek=True, lowered=True, times="·", minus="−"),
    "underscores": replace(PLAIN, underscore=True, power="**"),
    "raised powers": replace(PLAIN, raised=True, times="⋅", greek=True, functions=tuple(LONG.items())),
    "implicit products": replace(PLAIN, times=" ", squares=True, functions=tuple(POLISH.items())),
    "bare functions": replace(PLAIN, times=" ", bare=True, greek=True, squares=True, raised=True),
    "crosses and commas": replace(PLAIN, times="×", comma=True, root="√", minus="–"),
    "angle brackets": replace(PLAIN, bracket="<>", times="·"),
    "mathematical brackets": replace(PLAIN, bracket="⟨⟩", greek=True),
    "absolute values": replace(PLAIN, bracket="abs", functions=tuple(POLISH.items())),
    "greatest of two": replace(PLAIN, bracket="max", power="**"),
}
