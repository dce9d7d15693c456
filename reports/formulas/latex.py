"""Formulas in LaTeX, for Markdown."""

from __future__ import annotations

from collections.abc import Callable

from reports.formulas import FUNCTIONS, Node, read

OPERATORS = {
    "−": "-", "·": r"\cdot", "⋅": r"\cdot", "×": r"\times", "≤": r"\le", "≥": r"\ge", "≈": r"\approx", "±": r"\pm",
    "→": r"\to", "′": "'", "°": r"^\circ", "…": r"\ldots", "⟨": r"\langle", "⟩": r"\rangle", "{": r"\{", "}": r"\}",
    "%": r"\%", "#": r"\#", "&": r"\&", "_": r"\_", "$": r"\$", "\\": r"\backslash", "^": r"\hat{}", "~": r"\sim",
}  # fmt: skip
GREEK = dict(
    zip(
        "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ",
        [
            "alpha", "beta", "gamma", "delta", "varepsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
            "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "varphi", "chi", "psi", "omega", "Gamma", "Delta",
            "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega",
        ],
        strict=True,
    )
)  # fmt: skip
ACCENTS = {"˙": "dot", "¨": "ddot", "→": "vec", "¯": "bar"}
KNOWN = frozenset(("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "exp", "ln", "log", "min", "max"))


def formula(mathml: str) -> str:
    """Write a formula as the inside of `$…$`."""
    return _written(read(mathml)).strip()


def _written(node: Node) -> str:
    return WRITERS[node.kind](node)


def _text(text: str) -> str:
    return r"\mathrm{" + "".join(OPERATORS.get(c, c) for c in text) + "}"


def _identifier(node: Node) -> str:
    if node.text in GREEK:
        return f"\\{GREEK[node.text]} "
    if node.text in KNOWN:
        return f"\\{node.text} "
    if node.text in FUNCTIONS:
        return rf"\operatorname{{{node.text}}} "
    return node.text if len(node.text) == 1 and node.text.isalpha() else _text(node.text)


def _operator(node: Node) -> str:
    return f" {OPERATORS.get(node.text, node.text)} "


def _group(node: Node) -> str:
    opening, closing = (OPERATORS.get(mark, mark) for mark in node.text)
    return rf"\left{opening} {_row(node)} \right{closing}"


def _row(node: Node) -> str:
    return "".join(map(_written, node.parts))


def _marked(*marks: str) -> Callable[[Node], str]:
    def write(node: Node) -> str:
        base, *others = (_written(part).strip() for part in node.parts)
        return f"{{{base}}}" + "".join(f"{mark}{{{other}}}" for mark, other in zip(marks, others, strict=True))

    return write


def _over(node: Node) -> str:
    base, mark = node.parts
    inner = _written(base).strip()
    return rf"\{ACCENTS[mark.text]}{{{inner}}}" if mark.text in ACCENTS else rf"\overset{{{_written(mark)}}}{{{inner}}}"


def _root(node: Node) -> str:
    inside, *degree = (_written(part).strip() for part in node.parts)
    return rf"\sqrt[{degree[0]}]{{{inside}}}" if degree else rf"\sqrt{{{inside}}}"


def _table(node: Node) -> str:
    rows = r" \\ ".join(" & ".join(_written(cell).strip() for cell in row.parts) for row in node.parts)
    return rf"\begin{{matrix}}{rows}\end{{matrix}}"


WRITERS: dict[str, Callable[[Node], str]] = {
    "identifier": _identifier, "operator": _operator, "row": _row, "group": _group, "root": _root, "table": _table,
    "over": _over, "sub": _marked("_"), "sup": _marked("^"), "subsup": _marked("_", "^"), "under": _marked("_"),
    "fraction": lambda node: rf"\frac{{{_written(node.parts[0])}}}{{{_written(node.parts[1])}}}",
    "number": lambda node: node.text.replace(",", "{,}"), "text": lambda node: _text(node.text),
    "space": lambda node: r"\,",
}  # fmt: skip
