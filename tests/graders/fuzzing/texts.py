"""Makes texts: by the grammar of the answer language, by mutating real answers, and from any characters."""

from __future__ import annotations

import random
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

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

    def text(self) -> str:
        """Give one text; one in a hundred is longer than any field takes."""
        if self.rng.random() < OVERLONG:
            return self.overlong()
        if self.rng.random() < self.share:
            return self.mutated()
        kind = self.rng.random()
        if kind < 0.64:
            return self.by_grammar()
        return self.latex() if kind < 0.86 else self.any_characters()

    def pick(self, items: Sequence[str]) -> str:
        """Give one of some texts."""
        return items[int(self.rng.random() * len(items))]

    def mutated(self) -> str:
        """Change a real answer at up to three places."""
        text = self.pick(self.corpus)
        changes = (self._cut, self._put, self._put, self._exchanged, self._doubled, self._joined)
        for _ in range(self.rng.randrange(4)):
            text = changes[self.rng.randrange(len(changes))](text)
        return text[:2500]

    def overlong(self) -> str:
        """Repeat a text until it is longer than any field takes."""
        text = self.pick((self.mutated(), self.by_grammar(), self.latex())) or "1"
        return (text + self.pick(["", "+", ";", "\n", " "])) * (1 + self.rng.randrange(LONGER, 7 * LONGER) // len(text))

    def _spot(self, text: str) -> int:
        return self.rng.randrange(len(text) + 1)

    def _cut(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at + self.rng.randrange(1, 4) :]

    def _put(self, text: str) -> str:
        at = self._spot(text)
        return (
            text[:at]
            + self.pick((MARKS, COMMANDS, self.names, NAMES, UNITS, ["9", "0", "1e3"])[self.rng.randrange(6)])
            + text[at:]
        )

    def _exchanged(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at + 1 : at + 2] + text[at : at + 1] + text[at + 2 :]

    def _doubled(self, text: str) -> str:
        at = self._spot(text)
        return text[:at] + text[at : at + 20] * self.rng.choice((2, 2, 3, 40)) + text[at + 20 :]

    def _joined(self, text: str) -> str:
        other = self.pick(self.corpus)
        return text[: self._spot(text)] + other[self._spot(other) :]

    def by_grammar(self) -> str:
        """Write a text of the grammar, now and then with a unit, a name in front or as a relation."""
        kind = self.rng.random()
        body = self._sum(DEEPEST)
        if kind < 0.15:
            return f"{body} {self.pick(UNITS)}{self.pick(['', '^2', '/s', '·m'])}"
        if kind < 0.3:
            return f"{self.pick(self.names)}{self.pick([' = ', ' < ', '<=', '='])}{body}"
        if kind < 0.4:
            return self._matrix()
        return body

    def _matrix(self) -> str:
        rows = [[self._sum(1) for _ in range(self.rng.choice((1, 2, 4)))] for _ in range(self.rng.choice((1, 2, 4)))]
        return "[" + self.pick([", ", "; "]).join("[" + "; ".join(row) + "]" for row in rows) + "]"

    def _sum(self, depth: int) -> str:
        terms = [self._product(depth) for _ in range(self.rng.choice((1, 1, 1, 2)))]
        return self.pick(["", "", "", "-", "+"]) + self.pick([" + ", "-", " − ", "+"]).join(terms)

    def _product(self, depth: int) -> str:
        factors = [self._power(depth) for _ in range(self.rng.choice((1, 1, 1, 2, 2)))]
        return self.pick(["*", "·", " ", "/", "×", "*-"]).join(factors)

    def _power(self, depth: int) -> str:
        base = self._atom(depth)
        kind = self.rng.random()
        if kind > 0.15:
            return base
        return base + self.pick(["^2", "²", "^-1", "⁻¹", "^0.5", f"^({self._sum(0)})", "°", "^(1/3)", "^99", "**2"])

    def _atom(self, depth: int) -> str:
        kind = self.rng.random()
        if depth <= 0 or kind < 0.35:
            return self.pick(self.names) if self.rng.random() < 0.6 else self._number()
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
        return f"{self.pick([*FUNCTIONS, *ALIASES])}{power}({inner})"

    def _number(self) -> str:
        rng = self.rng
        kinds: tuple[Callable[[], str], ...] = (
            lambda: str(rng.randrange(10)), lambda: str(rng.randrange(1000)), lambda: f"{rng.random():.3f}",
            lambda: f"{rng.uniform(0, 100):.2f}".replace(".", ","), lambda: f"{rng.random():.2e}", lambda: "0",
            lambda: f"{rng.randrange(90)}°{rng.randrange(60)}'", lambda: f"1e{rng.randrange(-300, 300)}", lambda: "pi",
        )  # fmt: skip
        return kinds[rng.randrange(len(kinds))]()

    def latex(self) -> str:
        """Write what a formula editor could write, not always well formed."""
        pieces = []
        for _ in range(self.rng.randrange(1, 6)):
            kind = self.rng.random()
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
        rng = self.rng
        ranges = ((32, 127), (32, 127), (0, 0x250), (0x370, 0x530), (0x2000, 0x2300), (0, 0x110000))
        low, high = ranges[rng.randrange(len(ranges))]
        return "".join(chr(rng.randrange(low, high)) for _ in range(rng.choice((1, 2, 5, 12, 40))))
