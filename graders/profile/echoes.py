"""How pieces with their ranges are echoed."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from graders.judge import Echo
from graders.language.mathml import mathml_of
from graders.language.text import text_of
from graders.language.tree import Tree


def echoed(heads: Sequence[str], trees: Sequence[Tree], comma: bool, unit: str | None = None) -> Echo:
    """Echo formulas, each behind its range; an empty range is left out."""
    texts = [f"{head}: {text_of(tree)}".removeprefix(": ") for head, tree in zip(heads, trees, strict=True)]
    if len(trees) == 1 and not heads[0]:
        return Echo(mathml_of(trees[0], comma), texts[0], unit)
    rows = [
        f"<mtr><mtd><mtext>{_range(head, comma)}</mtext></mtd><mtd>{_inner(tree, comma)}</mtd></mtr>"
        for head, tree in zip(heads, trees, strict=True)
    ]
    return Echo(f"<math><mtable>{''.join(rows)}</mtable></math>", "; ".join(texts), unit)


def _range(head: str, comma: bool) -> str:
    start, _, end = head.partition(" .. ")
    return escape(f"{start} … {end}".replace(".", "," if comma else "."))


def _inner(tree: Tree, comma: bool) -> str:
    return mathml_of(tree, comma).removeprefix("<math>").removesuffix("</math>")
