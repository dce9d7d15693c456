"""From a request to its answer, kind by kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from graders.comparison.functions import compare_expressions, compare_lists, compare_matrices
from graders.comparison.outcome import Answer, Verdict
from graders.comparison.quantities import compare_quantities
from graders.comparison.relations import compare_equation, compare_inequality, compare_system
from graders.comparison.request import Request, read
from graders.comparison.texts import Unread

COMPARE: Mapping[str, Callable[[Request, bytes], Answer]] = {
    "expression": compare_expressions,
    "equation": compare_equation,
    "system": compare_system,
    "matrix": compare_matrices,
    "quantity": compare_quantities,
    "inequality": compare_inequality,
    "unordered_list": compare_lists,
}


def answer(request: Mapping[str, Any], secret: bytes = b"") -> dict[str, Any]:
    """Compare two answers.

    Args:
        request: The object as JSON holds it, its `id` apart.
        secret: From which the points are drawn.

    Returns:
        `verdict`, `code` and `position`; with `different` the `witness`, with `unreadable` which of the two it is.

    Raises:
        BadRequest: It is no request.
    """
    asked = read(request)
    try:
        return COMPARE[asked.kind](asked, secret).document()
    except Unread as unread:
        item = {} if unread.item is None else {"item": unread.item}
        found = Answer(Verdict.UNREADABLE, unread.error.reason.value, unread.error.position).document()
        return {**found, "side": unread.side, **item}
