"""Names a student may type: the declared symbols, the functions, and their many spellings."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from functools import lru_cache

from graders.language.tree import Name

GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "epsilon", "ϵ": "epsilon", "ζ": "zeta", "η": "eta",
    "θ": "theta", "ϑ": "theta", "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu", "µ": "mu", "ν": "nu", "ξ": "xi",
    "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau", "υ": "upsilon", "φ": "phi", "ϕ": "phi", "χ": "chi", "ψ": "psi",
    "ω": "omega", "Γ": "Gamma", "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi", "Σ": "Sigma",
    "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega", "\u2126": "Omega", "\u2206": "Delta",
}  # fmt: skip
LETTERS = {  # the letters' names in Polish and Russian, where they differ from the English ones
    "alfa": "alpha", "teta": "theta", "ksi": "xi", "ro": "rho", "fi": "phi", "mi": "mu", "ni": "nu", "альфа": "alpha",
    "бета": "beta", "гамма": "gamma", "дельта": "delta", "эпсилон": "epsilon", "эта": "eta", "тета": "theta",
    "лямбда": "lambda", "мю": "mu", "ню": "nu", "кси": "xi", "ро": "rho", "сигма": "sigma", "тау": "tau", "фи": "phi",
    "пси": "psi", "омега": "omega",
}  # fmt: skip
BORDER = re.compile(r"(?<=[\d₀-₉])(?=[^\W\d_₀-₉])|(?<=[A-Za-z])(?=[α-ωΑ-Ω])|(?<=[α-ωΑ-Ω])(?=[A-Za-z])")
SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True))
LOOK_ALIKES = dict(zip("АВЕКМНОРСТХаеорсухіѕј", "ABEKMHOPCTXaeopcyxisj", strict=True))  # Cyrillic to Latin
DOTS = {"\u0307": "_d", "\u0308": "_dd"}  # a dot over a name is its rate
RATES = {"_dot": "_d", "_ddot": "_dd", "''": "_dd", "'": "_d"}  # other ways to write it, where the rate is declared

DEGREES = (  # words behind a number of degrees
    "deg", "degree", "degrees", "st", "stopień", "stopnia", "stopnie", "stopni",
    "град", "градус", "градуса", "градусов",
)  # fmt: skip

FUNCTIONS: dict[str, tuple[int, int]] = {  # least and greatest number of arguments
    **dict.fromkeys(("sin", "cos", "tan", "cot", "asin", "acos", "atan", "acot"), (1, 1)),
    **dict.fromkeys(("sinh", "cosh", "tanh", "exp", "ln", "sqrt", "abs", "sign"), (1, 1)),
    **dict.fromkeys(("atan2", "root", "macaulay"), (2, 2)),
    **dict.fromkeys(("min", "max"), (2, 12)),
    "log": (1, 2),
}
ALIASES = {
    "tg": "tan", "ctg": "cot", "cotg": "cot", "ctan": "cot", "sen": "sin",
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctg": "atan", "atg": "atan",
    "arcctg": "acot", "arccot": "acot", "arcctan": "acot", "actg": "acot", "arctan2": "atan2", "arctg2": "atan2",
    "sh": "sinh", "ch": "cosh", "th": "tanh", "tgh": "tanh", "lg": "log", "log10": "log", "sgn": "sign",
    "pierw": "sqrt", "pierwiastek": "sqrt", "корень": "sqrt", "znak": "sign", "знак": "sign", "modul": "abs",
    "moduł": "abs", "модуль": "abs",
    "SIN": "sin", "COS": "cos", "TAN": "tan", "ASIN": "asin", "ACOS": "acos", "ATAN": "atan", "SQRT": "sqrt",
}  # fmt: skip

LONGEST_RUN, LONGEST_NAME = 12, 16  # names of a run, and letters of one
MOST_NODES = 400  # spellings that are remembered


_named = lru_cache(maxsize=4096)(Name)


@lru_cache(maxsize=4096)
def key(spelling: str) -> str:
    """Fold the spellings of one symbol: `α₁`, `alpha_1` and `alpha1` have one key, `R_A` and `RA` too."""
    apart = unicodedata.normalize("NFD", spelling)
    dots = "".join(DOTS.get(c, "") for c in apart)  # wherever the dot stands, it is about the whole symbol
    letters = "".join(GREEK.get(c) or SUBSCRIPTS.get(c) or c for c in apart if c not in DOTS)
    stem = letters.rstrip("'′")
    folded = stem + dots + letters[len(stem) :]
    return unicodedata.normalize("NFC", folded.replace("_", "").replace("′", "'"))


def _lettered(spelling: str) -> str:
    stem = spelling.rstrip("_0123456789₀₁₂₃₄₅₆₇₈₉'")
    return key(LETTERS.get(stem, stem) + spelling[len(stem) :])


def latin(spelling: str) -> str:
    """Replace Cyrillic look-alikes by the Latin letters they look like."""
    return "".join(LOOK_ALIKES.get(c, c) for c in spelling)


def function_named(spelling: str) -> str | None:
    """Give the function of the language that a spelling means, or None."""
    folded = spelling if spelling in FUNCTIONS else ALIASES.get(spelling, "")
    return folded if folded in FUNCTIONS else None


class Symbols:
    """The symbols declared for one answer; `names` are those it may use, `known` those that mean something here."""

    __slots__ = ("_by_key", "known", "names", "nodes")

    def __init__(self, names: Iterable[str], known: Iterable[str] = ()) -> None:
        self.names = frozenset(names)
        self.known = frozenset(known) | self.names
        self._by_key: dict[str, str] = {}
        self.nodes: dict[str, Name | None] = {}
        for name in self.known:
            self.nodes[name] = _named(name)
            other = self._by_key.setdefault(key(name), name)
            if other != name:
                raise ValueError(f"symbols {other!r} and {name!r} cannot be told apart when typed")

    def find(self, spelling: str) -> str | None:
        """Give the declared symbol that a spelling means, look-alike letters mapped, or None."""
        found = self._by_key.get(key(spelling)) or self._by_key.get(key(latin(spelling)))
        return found or self._by_key.get(_lettered(spelling)) or self._rate(spelling)

    def node(self, spelling: str) -> Name | None:
        """Give the tree of the declared symbol that a spelling means, or None; both are kept in `nodes`."""
        found = self.find(spelling)
        node = Name(found) if found else None
        return self.nodes.setdefault(spelling, node) if len(self.nodes) < MOST_NODES else node

    def calls(self, spelling: str) -> bool:
        """Tell whether a spelling is the name of a function as it stands, and of no declared symbol."""
        return spelling in FUNCTIONS and spelling not in self._by_key

    def typed(self, spelling: str) -> bool:
        """Tell whether a spelling means a declared symbol without a change of alphabet."""
        return key(spelling) in self._by_key or _lettered(spelling) in self._by_key

    def _rate(self, spelling: str) -> str | None:
        """Find a declared rate typed with a prime or as `x_dot`."""
        for ending, mark in RATES.items():
            if spelling.endswith(ending):
                found = self._by_key.get(key(spelling.removesuffix(ending) + mark))
                return found if found and found.endswith(mark) else None
        return None

    def parts(self, spelling: str) -> list[str]:
        """Cut a run at its visible borders, behind a figure and between alphabets (`l1ω1`, `cosα1`).

        Empty unless every part is a declared name or a function.
        """
        for run in dict.fromkeys((spelling, latin(spelling))):
            parts = BORDER.split(run)
            if len(parts) > 1 and all(self.find(p) or function_named(p) for p in parts):
                return parts
        return []

    def run(self, spelling: str) -> list[str]:
        """Cut a run of letters into declared names, the longest first; empty if something is left over."""
        found: list[str] = []
        while spelling and len(found) < LONGEST_RUN:
            end = next((end for end in range(min(len(spelling), LONGEST_NAME), 0, -1) if self.find(spelling[:end])), 0)
            if not end:
                return []
            found.append(spelling[:end])
            spelling = spelling[end:]
        return [] if spelling else found

    def split(self, spelling: str) -> list[str]:
        """Cut a run of letters into declared names and functions, fewest pieces first; empty if it cannot be cut."""
        found = _cut(spelling, tuple(sorted(self.known)))
        return list(found) if found else []


@lru_cache(maxsize=256)
def _cut(spelling: str, known: tuple[str, ...]) -> tuple[str, ...] | None:
    symbols = Symbols(known)
    best: list[tuple[str, ...] | None] = [()] + [None] * len(spelling)
    for end in range(1, len(spelling) + 1):
        for start in range(max(0, end - 16), end):
            before, piece = best[start], spelling[start:end]
            if before is None or not (symbols.find(piece) or function_named(piece) or piece.isdigit()):
                continue
            best_here = best[end]
            if best_here is None or len(before) + 1 < len(best_here):
                best[end] = (*before, piece)
    return best[len(spelling)]
