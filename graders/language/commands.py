"""The LaTeX commands that formula editors write and the answer language reads."""

from __future__ import annotations

from graders.language.symbols import ALIASES, FUNCTIONS, GREEK

_NAMES = {name: letter for letter, name in reversed(GREEK.items())}
LETTERS = _NAMES | {
    "varepsilon": "ε", "vartheta": "θ", "varphi": "φ", "varrho": "ρ", "varpi": "π", "varsigma": "σ", "varkappa": "κ",
    "exponentialE": "e", "ell": "l",
}  # fmt: skip
WORDS = {name: name for name in (*FUNCTIONS, *ALIASES) if name.isascii() and name.isalpha() and name != "sqrt"}
SIGNS = {
    "cdot": "*", "times": "*", "ast": "*", "bullet": "*", "div": "/", "colon": ":", "lt": "<", "gt": ">",
    "le": "<=", "leq": "<=", "leqslant": "<=", "ge": ">=", "geq": ">=", "geqslant": ">=", "degree": "°", "circ": "°",
    "prime": "'", "doubleprime": "''", "lbrack": "[", "rbrack": "]", "lparen": "(", "rparen": ")", "langle": "<",
    "rangle": ">", "vert": "|", "lvert": "|", "rvert": "|", "mid": "|", "%": "%", "approx": "=", "sim": "=",
    "simeq": "=", "cong": "=",
}  # fmt: skip
SPACES = frozenset((",", ";", ":", "!", " ", ">", "quad", "qquad", "thinspace", "enspace", "enskip", "displaystyle"))
ACCENTS = {"dot": "_d", "ddot": "_dd"}
UPRIGHT = frozenset(
    ("mathrm", "mathit", "mathbf", "mathsf", "mathnormal", "text", "textrm", "textit", "operatorname", "operatorname*")
)
FENCES = frozenset(("left", "mleft", "bigl", "Bigl"))
ENVIRONMENTS = frozenset(("array", "bmatrix", "pmatrix", "matrix", "smallmatrix"))
