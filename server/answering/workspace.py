"""What the workspace page shows of each answer: the field, what was typed, how it was read, the verdict."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from exercises import presenting
from exercises.exercise import Variant
from exercises.presenting import Field
from graders.language.mathml import symbol_mathml
from server.answering import forms
from server.answering.previews import Understood, as_typed, understood
from server.answering.receipts import whole
from server.answering.submissions import ByHand, Graded, Judged
from server.web.errors import Refused
from server.workbench import Bench

SHORT = ("quantity", "integer", "rational")
LONG = {
    "polygon": 8,
    "samples": 8,
    "text": 6,
    "rates": 3,
    "function": 3,
    "system": 3,
    "equation": 2,
    "inequality": 2,
}  # lines
HELPED = (
    "choices", "dh_table", "diagram", "equation", "function", "inequality", "ordering", "polygon", "rates", "samples",
    "set", "system",
)  # fmt: skip
KEYED = (
    "dh_table", "equation", "expression", "function", "inequality", "polygon", "rates", "symbolic_matrix", "system",
)  # fmt: skip
LOOKS = {  # the template of a kind's field
    "choice": "choice", "choices": "choices", "ordering": "ordering", "diagram": "diagram", "expression": "formula",
    **dict.fromkeys(forms.GRIDS, "grid"), **dict.fromkeys(LONG, "lines"),
}  # fmt: skip
SENTENCE_END = re.compile(r"(?<=[^\d]\.) (?=[^\W\d_])|(?<=\d\.) (?=[A-ZĄĆĘŁŃÓŚŹŻА-ЯЁ])")  # not after "od 8. znaku"


@dataclass(frozen=True, slots=True)
class Key:
    """A key of the symbol row: what it types, how far it steps back, what stands on it."""

    insert: str
    label: str
    back: int = 0
    name: str = ""  # key of its spoken name in the words of the page


SIGNS = (
    Key("sin()", "sin", 1), Key("cos()", "cos", 1), Key("*", "·", name="times"), Key("/", "/", name="divided"),
    Key("^", "<i>x</i><sup><i>n</i></sup>", name="power"), Key("sqrt()", "√", 1, "root"), Key("(", "(", name="open"),
    Key(")", ")", name="close"),
)  # fmt: skip


MORE_SIGNS = {"function": (Key("<>^1", "⟨ ⟩", 3, "macaulay"),), "rates": (Key("_d", "ẋ", name="rate"),)}


@dataclass(frozen=True, slots=True)
class Cell:
    """One entry of a matrix grid."""

    name: str
    value: str
    wrong: bool
    row: int
    column: int


@dataclass(frozen=True, slots=True)
class Line:
    """One line of the solution as the page shows it.

    `sold` is the step of its ladder that can be opened at a price, `selling` what that tells.
    """

    number: int
    field: Field
    typed: str
    twin: str
    cells: tuple[tuple[Cell, ...], ...]
    keys: tuple[Key, ...]
    span: float | None
    echo: Understood | None
    verdict: Judged | None
    rungs: tuple[presenting.Rung, ...] = ()
    sold: int | None = None
    selling: str = ""
    marks: tuple[ByHand, ...] = ()

    @property
    def id(self) -> str:
        """The id from which the ids of the field and its messages are made."""
        return f"a{self.number}"

    @property
    def look(self) -> str:
        """The name of the template of the field."""
        return LOOKS.get(self.field.kind, "line")

    @property
    def ticked(self) -> list[str]:
        """The options that are ticked."""
        return [item.strip() for item in self.typed.split(";")]

    @property
    def short(self) -> bool:
        """Whether the field is short."""
        return self.field.kind in SHORT

    @property
    def long(self) -> int:
        """How many lines the field has; 0 for a field of one line."""
        return LONG.get(self.field.kind, 0)

    @property
    def helped(self) -> bool:
        """Whether a sentence says how the answer is typed."""
        return self.field.kind in HELPED

    @property
    def described_by(self) -> str:
        """The ids of what describes the field."""
        parts = ["h"] if self.field.tolerance_text or self.field.unit_text else []
        parts += ["k"] if self.helped else []
        parts += ["v"] if self.verdict else []
        parts += ["m"] if self.marks else []
        return " ".join(f"{self.id}-{part}" for part in [*parts, "r"])

    @property
    def unreadable(self) -> bool:
        """Whether what was typed could not be read (an empty field is not an error)."""
        judged = self.verdict is not None and self.verdict.code == "unreadable"
        return judged or (self.echo is not None and not self.echo.ok and self.echo.code != "empty")

    @property
    def headline(self) -> tuple[str, str]:
        """The first sentence of the verdict, and the rest."""
        assert self.verdict is not None
        first, *rest = SENTENCE_END.split(self.verdict.message, maxsplit=1)
        return first, "".join(rest)


async def lines(
    bench: Bench,
    variant: Variant,
    fields: Mapping[str, Field],
    typed: Mapping[str, str],
    graded: Graded | None,
    lang: str,
) -> list[Line]:
    """Lay out the answers of a variant.

    Args:
        bench: The server's tools.
        variant: The variant answered.
        fields: The answers asked for, in order.
        typed: What was typed so far.
        graded: The submission shown, if one is.
        lang: The reader's language.
    """
    laid, judged = [], _still(graded, typed) if graded else {}
    for number, (name, field) in enumerate(fields.items(), 1):
        text = typed.get(name, "")
        echo = await _understood(bench, variant, name, text, lang) if text.strip() else None
        laid.append(_line(number, field, text, echo, judged.get(name), getattr(variant.givens, "L", None)))
    return laid


async def _understood(bench: Bench, variant: Variant, name: str, text: str, lang: str) -> Understood:
    """Say what is understood of an answer that is asked for, also where only the card still asks for it."""
    try:
        return await understood(bench, variant, name, text, lang)
    except Refused:
        return as_typed(text)


def laddered(variant: Variant, laid: Sequence[Line], lang: str, opened: Mapping[str, int] | None = None) -> list[Line]:
    """Put the ladder of hints under what is wrong or partly right; of one at a price, the steps `opened` so far."""
    return [_laddered(variant, line, lang, opened) for line in laid]


def _laddered(variant: Variant, line: Line, lang: str, opened: Mapping[str, int] | None) -> Line:
    astray = line.verdict is not None and line.verdict.outcome in ("wrong", "partly")
    bought = opened.get(line.field.name, 0) if opened is not None else 0
    if not astray and not bought:
        return line
    rungs = presenting.ladder(variant, line.field.name, lang)
    if opened is None:
        return replace(line, rungs=rungs)
    left = rungs[bought:] if astray else ()
    return replace(line, rungs=rungs[:bought], sold=bought + 1 if left else None, selling=left[0].kind if left else "")


def marked(laid: Sequence[Line], result: Graded) -> list[Line]:
    """Put what the lecturer says of an answer under its verdict."""
    return [
        replace(line, marks=tuple(one for one in result.by_hand if one.answer == line.field.name))
        if line.verdict
        else line
        for line in laid
    ]


def _still(graded: Graded, typed: Mapping[str, str]) -> dict[str, Judged]:
    """Give the verdicts whose answers still stand as they were judged."""
    answers = whole(graded.answers)
    return {name: one for name, one in graded.verdicts.items() if _text(typed, name) == _text(answers, name)}


def _text(answers: Mapping[str, str], name: str) -> str:
    """Give an answer with plain line ends: a form sends other ones than a draft."""
    return answers.get(name, "").replace("\r\n", "\n")


def _line(
    number: int, field: Field, text: str, echo: Understood | None, verdict: Judged | None, span: float | None
) -> Line:
    grid = field.kind in forms.BY_CELLS
    apart = forms.apart(field, text) if grid and text else None
    return Line(
        number=number,
        field=field,
        typed="" if grid else text,
        twin=text if grid and apart is None else "",
        cells=_cells(field, apart, verdict) if grid else (),
        keys=_keys(field) if field.kind in KEYED else (),
        span=span,
        echo=echo,
        verdict=verdict,
    )


def _cells(field: Field, values: list[list[str]] | None, verdict: Judged | None) -> tuple[tuple[Cell, ...], ...]:
    wrong = set(verdict.entries) if verdict else set()
    return tuple(
        tuple(
            Cell(name, values[row - 1][column - 1] if values else "", (row, column) in wrong, row, column)
            for column, name in enumerate(names, 1)
        )
        for row, names in enumerate(forms.cell_names(field), 1)
    )


def _keys(field: Field) -> tuple[Key, ...]:
    names = (Key(name, symbol_mathml(name)) for name in field.symbols)
    return (*names, *SIGNS, *MORE_SIGNS.get(field.kind, ()))
