"""Every kind of field and every outcome on one page, from the templates that students are shown."""

from __future__ import annotations

import re
from functools import partial

from exercises.presenting import Field
from graders import Code, Verdict
from graders.verdict import FAULT, RIGHT, UNDECIDED, Entries, wrong
from server.answering.submissions import judged
from server.answering.workspace import _line
from server.web import language as languages
from server.web.templating import _templates

OPTIONS = (("one", "one <math><mi>a</mi></math>"), ("two", "two"), ("three", "three"))
SHAPES: dict[str, dict[str, object]] = {
    "choice": {"options": OPTIONS}, "choices": {"options": OPTIONS}, "ordering": {"options": OPTIONS},
    "symbolic_matrix": {"rows": 2, "columns": 2, "symbols": ("a", "b")},
    "polygon": {"shape": {"nodes": ["A", "B", "C"]}, "symbols": ("l1", "alpha1")},
    "diagram": {"shape": {"quantity": "V", "x_unit": "m"}}, "expression": {"symbols": ("l1", "omega1")},
    "equation": {"symbols": ("x",)}, "function": {"symbols": ("F1", "a1")}, "rates": {"symbols": ("l1",)},
}  # fmt: skip
KINDS = (*SHAPES, "integer", "rational", "set", "samples", "text", "quantity")
OUTCOMES = (
    RIGHT, Verdict(1.0, Code.FOLLOWED), Verdict(0.5, Code.WRONG_UNIT), wrong(Code.OPPOSITE_SIGN), wrong(), UNDECIDED,
    FAULT, Verdict(0.5, Code.SOME_ENTRIES, Entries(((1, 2),), 4)),
)  # fmt: skip


def field(kind: str, **more: object) -> Field:
    """Make a field of a kind."""
    parts: dict[str, object] = {
        "name": kind, "kind": kind, "prompt_html": f"The {kind}", "prompt_text": f"The {kind}", "symbol_mathml": "",
        "unit": "mm", "unit_text": "mm", "symbols": (), "tolerance_text": "±1 %", "rtol": 0.01, "atol": None, "rows": 0,
        "columns": 0, "column_units": (), "options": (), "weight": 1.0,
    }  # fmt: skip
    return Field(**(parts | more))  # type: ignore[arg-type]


def answers(language: str = "en") -> str:
    """Give the list of all kinds, and of a number with each outcome."""
    plain = [_line(at, field(kind, **SHAPES.get(kind, {})), "", None, None, 5.0) for at, kind in enumerate(KINDS, 1)]
    judged_ = [
        _line(at, field("quantity", name=f"q{at}"), "1 mm", None, judged(verdict, language), None)
        for at, verdict in enumerate(OUTCOMES, len(KINDS) + 1)
    ]
    template = _templates().get_template("answer.html")
    words = partial(languages.say, language)
    return "".join(template.render(line=line, t=words) for line in [*plain, *judged_])


def page(workspace: str) -> str:
    """Put the list into the page of a workspace."""
    return put(workspace, answers())


def put(workspace: str, lines: str) -> str:
    """Put answers into the page of a workspace, in place of its own."""
    return re.sub(
        r'(?s)(<ol class="answers">).*?(</ol>\n<div class="row between submit)',
        lambda m: m[1] + lines + m[2],
        workspace,
    )
