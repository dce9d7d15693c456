"""Makes texts: by the grammar of the answer language, by mutating real answers, and from any characters."""

from __future__ import annotations

import random
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar

from graders.language.symbols import ALIASES, FUNCTIONS, GREEK, LETTERS, LOOK_ALIKES, SUBSCRIPTS, SUPERSCRIPTS
from graders.language.tokens import SAME
from graders.units import TABLE

SPELLINGS = Path(__file__).parents[2] / "spellings"
DEEPEST = 3
OVERLONG = 0.01  # of the texts
LONGER = 3000  # characters: no formula is as long
MARKS = [
    *"+-*/^()[]<>=,;:|!√°'\"%.{}_&\\ ", *SAME, *SUPERSCRIPTS, *SUBSCRIPTS, *LOOK_ALIKES, *GREEK, "\u0307", "\u0308",
    "\u00a0", "\u202f", "\u200b", "\u202e", "e", "E", "\x00", "\ud800", "٣", "１", "½", "ﬁ", "\n", "𝛼", "İ", "ß",
]  # fmt: skip
COMMANDS = [
    r"\frac{", r"\sqrt", r"\sqrt[", r"\left(", r"\right)", r"\left|", r"\right|", r"\cdot ", r"\times10^{", r"\mathrm{",
    r"\operatorname{", r"\dot{", r"\ddot", "^{", "_{", "{,}", r"\begin{bmatrix}", r"\end{bmatrix}", r"\\", "&", r"\,",
    r"\placeholder{}", r"^{\circ}", r"\alpha", r"\sin", r"\log_", r"\left\langle ", r"\right\rangle^", "}", "{",
    r"\text",
]  # fmt: skip
UNITS = list(TABLE)
NAMES = [*FUNCTIONS, *ALIASES, *LETTERS]
CALLED = [*FUNCTIONS, *ALIASES]
RANGES = ((32, 127), (32, 127), (0, 0x250), (0x370, 0x530), (0x2000, 0x2300), (0, 0x110000))  # of characters
Item = TypeVar("Item")


def hand_written() -> list[str]:
    """Give the hand-written answers of all three languages."""
    return [
        text
        for lang in ("pl", "en", "ru")
        for field in tomllib.loads((SPELLINGS / f"{lang}.toml").read_text("utf-8"))["field"]
        for text in field["texts"]
    ]


class Texts:
    """A source of texts over the names of one answer; every text follows from the generator alone."""

    def __init__(self, rng: random.Random, names: Sequence[str], corpus: Sequence[str], mutated: float = 0.45) -> None:
        self.rng, self.corpus, self.share = rng, list(corpus) or ["1"], mutated
        self.names = list(names) or ["x"]
        self.random = rng.random
        self.inserted: tuple[Sequence[str], ...] = (MARKS, COMMANDS, self.names, NAMES, UNITS, ["9", "0", "1e3"])

    def text(self) -> str:
        """Give one text; one in a hundred is longer than any field takes."""
        if self.random() < OVERLONG:
            return self.overlong()
        if self.random() < self.share:
            return self.mutated()
        kind = self.random()
        if kind < 0.64:
            return self.by_grammar()
        return self.latex() if kind < 0.86 else self.any_characters()

    def below(self, end: int) -> int:
        """Give one of the numbers 0 … end - 1, three times as fast as the generator's own way."""
        return int(self.random() * end)

    def pick(self, items: Sequence[Item]) -> Item:
        """Give one of some things."""
        return items[int(self.random() * len(items))]

    def mutated(self) -> str:
        """Change a real answer at up to three places."""
        text = self.pick(self.corpus)
        changes: tuple[Callable[[str], str], ...] = (
            self._cut,
            self._put,
            self._put,
            self._exchanged,
            self._doubled,
            self._joined,
        )
        for _ in range(self.below(4)):
            text = changes[self.below(len(changes))](text)
        return text[:2500]

    def overlong(self) -> str:
        """Repeat a text until it is longer than any field takes."""
        text = self.pick((self.mutated(), self.by_grammar(), self.latex())) or "1"
        return (text + self.pick(["", "+", ";", "\n", " "])) * (1 + self.rng.randrange(LONGER, 7 * LONGER) // len(text))

    def _spot(self, text: str) -> int:
        return self.below(len(text) + 1)

    def _cut(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at + 1 + self.below(3) :]

    def _put(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + self.pick(self.pick(self.inserted)) + text[at:]

    def _exchanged(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at + 1 : at + 2] + text[at : at + 1] + text[at + 2 :]

    def _doubled(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at : at + 20] * self.pick((2, 2, 3, 40)) + text[at + 20 :]

    def _joined(self, text: str) -> str:
        other = self.pick(self.corpus)
        return text[: self._spot(text)] + other[self._spot(other) :]

    def by_grammar(self) -> str:
        """Write a text of the grammar, now and then with a unit, a name in front or as a relation."""
        kind = self.random()
        body = self._sum(DEEPEST)
        if kind < 0.15:
            return f"{body} {self.pick(UNITS)}{self.pick(['', '^2', '/s', '·m'])}"
        if kind < 0.3:
            return f"{self.pick(self.names)}{self.pick([' = ', ' < ', '<=', '='])}{body}"
        if kind < 0.4:
            return self._matrix()
        return body

    def _matrix(self) -> str:
        rows = [[self._sum(1) for _ in range(self.pick((1, 2, 4)))] for _ in range(self.pick((1, 2, 4)))]
        return "[" + self.pick([", ", "; "]).join("[" + "; ".join(row) + "]" for row in rows) + "]"

    def _sum(self, depth: int) -> str:
        terms = [self._product(depth) for _ in range(self.pick((1, 1, 1, 2)))]
        return self.pick(["", "", "", "-", "+"]) + self.pick([" + ", "-", " − ", "+"]).join(terms)

    def _product(self, depth: int) -> str:
        factors = [self._power(depth) for _ in range(self.pick((1, 1, 1, 2, 2)))]
        return self.pick(["*", "·", " ", "/", "×", "*-"]).join(factors)

    def _power(self, depth: int) -> str:
        base = self._atom(depth)
        kind = self.random()
        if kind > 0.15:
            return base
        return base + self.pick(["^2", "²", "^-1", "⁻¹", "^0.5", f"^({self._sum(0)})", "°", "^(1/3)", "^99", "**2"])

    def _atom(self, depth: int) -> str:
        kind = self.random()
        if depth <= 0 or kind < 0.35:
            return self.pick(self.names) if self.random() < 0.6 else self._number()
        inner = self._sum(depth - 1)
        if kind < 0.55:
            return f"({inner})"
        if kind < 0.62:
            return f"<{inner}>^{self.pick(['0', '1', '2', '-1'])}"
        if kind < 0.67:
            return f"|{inner}|"
        if kind < 0.74:
            return f"{self.pick(['atan2', 'root', 'min', 'max', 'log', 'macaulay'])}({inner}; {self._sum(0)})"
        power = self.pick(["", "", "^2", "²"])
        return f"{self.pick(CALLED)}{power}({inner})"

    def _number(self) -> str:
        kind = self.below(9)
        if kind == 0:
            return str(self.below(10))
        if kind == 1:
            return str(self.below(1000))
        if kind == 2:
            return f"{self.random():.3f}"
        if kind == 3:
            return f"{100 * self.random():.2f}".replace(".", ",")
        if kind == 4:
            return f"{self.random():.2e}"
        if kind == 5:
            return f"{self.below(90)}°{self.below(60)}'"
        return f"1e{self.below(600) - 300}" if kind == 6 else self.pick(("0", "pi"))

    def latex(self) -> str:
        """Write what a formula editor could write, not always well formed."""
        pieces = []
        for _ in range(1 + self.below(5)):
            kind = self.random()
            if kind < 0.3:
                pieces.append(rf"\frac{{{self._sum(1)}}}{{{self._sum(0)}}}")
            elif kind < 0.5:
                pieces.append(rf"\{self.pick(['sin', 'cos', 'tan', 'arctan', 'ln'])}\left({self._sum(0)}\right)")
            elif kind < 0.65:
                pieces.append(rf"\sqrt{{{self._sum(1)}}}^{{{self._number()}}}")
            elif kind < 0.75:
                pieces.append(self.pick(COMMANDS))
            else:
                pieces.append(self._sum(0))
        return self.pick([r"\cdot ", "+", r"\,", "-"]).join(pieces)

    def any_characters(self) -> str:
        """Write characters from everywhere."""
        low, high = self.pick(RANGES)
        return "".join([chr(low + self.below(high - low)) for _ in range(self.pick((1, 2, 5, 12, 40)))])
