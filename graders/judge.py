"""What every judge of one answer offers, and the registry of answer kinds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol, TypeAlias, runtime_checkable

from graders.language.notes import Note
from graders.language.symbols import Symbols
from graders.language.tree import Tree
from graders.verdict import Verdict

Matrix: TypeAlias = tuple[tuple[float, ...], ...]
Value: TypeAlias = float | Matrix | str


class Domain(NamedTuple):
    """The values a symbol can have: an interval, of whole numbers or of doubles."""

    low: float
    high: float
    integer: bool = False


@dataclass(frozen=True, slots=True)
class States:
    """True states of a system on which a symbolic answer is tested.

    Attributes:
        names: The givens, in the order of the numbers of a point.
        points: Points of the givens' domain at which the system can be assembled.
        lines: Formulas of the earlier steps in the order of solving; their values follow from the givens.
        box: The domains of the givens, in the same order; empty where only the points count.
    """

    names: tuple[str, ...]
    points: tuple[tuple[float, ...], ...]
    lines: tuple[tuple[str, Tree], ...] = ()
    box: tuple[Domain, ...] = ()


@dataclass(frozen=True, slots=True)
class Formula:
    """A symbolic reference: a tree over the givens and the earlier steps, with the states it holds in."""

    tree: Tree
    states: States


Reference: TypeAlias = Value | Formula


@dataclass(frozen=True, slots=True)
class Echo:
    """What was understood: MathML, the same as text, the unit of the answer, and what was read otherwise than typed;
    a formula also as LaTeX, for a visual editor."""

    mathml: str
    text: str
    unit: str | None = None
    notes: tuple[Note, ...] = ()
    latex: str = ""


@dataclass(frozen=True, slots=True)
class Samples:
    """Texts by which a judge tests itself against one reference."""

    right: tuple[str, ...]
    wrong: tuple[str, ...]
    unreadable: tuple[str, ...]


@runtime_checkable
class Grader(Protocol):
    """A judge of one answer. `step` names the step it asks for (empty: the step named like the answer)."""

    @property
    def kind(self) -> str: ...
    @property
    def step(self) -> str: ...
    @property
    def weight(self) -> float: ...
    @property
    def symbolic(self) -> bool:
        """Tell whether the answer is written in the symbols of the task."""
        ...

    def parse(self, text: str, symbols: Symbols) -> Any:
        """Read a text; raises AnswerSyntaxError."""
        ...

    def check(self, answer: Any, reference: Any) -> Verdict:
        """Judge a parsed answer."""
        ...

    def show(self, reference: Any) -> str:
        """Write a reference as a student could type it."""
        ...

    def samples(self, reference: Any) -> Samples:
        """Give right, wrong and unreadable texts."""
        ...

    def echo(self, answer: Any, comma: bool = False) -> Echo:
        """Say what was understood, decimals with a comma if asked."""
        ...

    def carried(self, answer: Any) -> Value | Tree | None:
        """Give what later answers are solved from when this one is wrong, or None."""
        ...

    def apart(self, one: Any, other: Any) -> float:
        """Give the distance of two references in tolerances (infinite where the kind has no tolerance)."""
        ...

    def describe(self) -> Mapping[str, Any]:
        """Give the unit, the tolerance and the shape that the field shows (JSON values)."""
        ...
