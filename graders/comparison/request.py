"""Requests to compare two answers: one table of fields for each kind, every refusal by name."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from graders.language import AnswerSyntaxError, Symbols, parse
from graders.language.doubles import UndefinedError, line_runner, run
from graders.language.tokens import tokenize
from graders.language.tree import Number, Tree, Unary

COMMON = ("kind", "a", "b", "vars")
NEEDED = ("kind", "a", "b")
KINDS: dict[str, tuple[str, ...]] = {  # the fields of each kind beside the common ones
    "expression": (),
    "equation": ("solve_for",),
    "system": ("solve_for",),
    "matrix": (),
    "quantity": ("rtol",),
    "inequality": (),
    "unordered_list": (),
}
LISTS = ("system", "unordered_list")
MOST_VARS = 60
MOST_ITEMS = 20
LONGEST_NAME = 40
LONGEST_TEXT = 10_000  # characters; the answer language reads fewer and says so with the place
SHOWN = 60
NUMBERS = (int, float)
NOTHING = Symbols(())


class BadRequest(ValueError):
    """A request that is not compared: a code for programs, a sentence, the field.

    Args:
        code: Such as ``unknown_kind``.
        message: The sentence.
        field: Where it is wrong, such as ``vars.x``; empty where no field is.
    """

    def __init__(self, code: str, message: str, field: str = "") -> None:
        super().__init__(message)
        self.code, self.message, self.field = code, message, field


@dataclass(frozen=True, slots=True)
class Request:
    """What is asked.

    Attributes:
        kind: One of `KINDS`.
        a: The texts of the reference: one, or the items of a list.
        b: The texts that are compared with it.
        box: Least and greatest value of each symbol that has a range.
        fixed: Symbols whose range is one value, with its formula.
        symbols: The declared symbols, ready to read with.
        solve_for: The unknowns.
        rtol: The tolerance of a quantity over the size of `a`.
    """

    kind: str
    a: tuple[str, ...]
    b: tuple[str, ...]
    box: Mapping[str, tuple[float, float]]
    fixed: Mapping[str, Tree]
    symbols: Symbols
    solve_for: tuple[str, ...] = ()
    rtol: float = 0.0


def read(request: Mapping[str, Any]) -> Request:
    """Read a request, its `id` apart.

    Raises:
        BadRequest: With the field that is wrong.
    """
    kind = _kind(request)
    for name in request:
        if name not in COMMON + KINDS[kind]:
            raise BadRequest("unknown_field", f"there is no field {shown(name)} in a request of kind {kind}", name)
    for name in (*NEEDED, *(field for field in KINDS[kind] if field == "solve_for")):
        if name not in request:
            raise BadRequest("missing_field", f"{name} is missing", name)
    box, fixed, symbols = _vars(request.get("vars", {}))
    return Request(
        kind,
        _texts(request["a"], "a", kind),
        _texts(request["b"], "b", kind),
        box,
        fixed,
        symbols,
        _solve_for(request.get("solve_for"), kind, box),
        _rtol(request.get("rtol", 0)),
    )


def _kind(request: Mapping[str, Any]) -> str:
    if "kind" not in request:
        raise BadRequest("missing_field", "kind is missing", "kind")
    kind = request["kind"]
    if not isinstance(kind, str):
        raise _wrong_type("kind", kind, "a text")
    if kind not in KINDS:
        raise BadRequest("unknown_kind", f"there is no kind {shown(kind)}; there are {', '.join(KINDS)}", "kind")
    return kind


def _texts(value: Any, field: str, kind: str) -> tuple[str, ...]:
    if kind not in LISTS:
        return (_text(value, field),)
    if not isinstance(value, list):
        raise _wrong_type(field, value, "a list of texts")
    if len(value) > MOST_ITEMS:
        raise BadRequest("out_of_range", f"{field} has at most {MOST_ITEMS} items, not {len(value)}", field)
    return tuple(_text(one, f"{field}[{at}]") for at, one in enumerate(value))


def _text(value: Any, field: str) -> str:
    if not isinstance(value, str):
        raise _wrong_type(field, value, "a text")
    if len(value) > LONGEST_TEXT:
        raise BadRequest("out_of_range", f"{field} has at most {LONGEST_TEXT} characters, not {len(value)}", field)
    return value


def _solve_for(value: Any, kind: str, box: Mapping[str, Any]) -> tuple[str, ...]:
    if "solve_for" not in KINDS[kind]:
        return ()
    if kind == "equation":
        found: Sequence[str] = [_text(value, "solve_for")]
    elif not isinstance(value, list) or not value:
        raise _wrong_type("solve_for", value, "a list of names")
    else:
        found = [_text(one, f"solve_for[{at}]") for at, one in enumerate(value)]
    for name in found:
        if name not in box:
            raise BadRequest(
                "unknown_symbol", f"solve_for names {shown(name)}, which has no range in vars", "solve_for"
            )
        if found.count(name) > 1:
            raise BadRequest("contradictory", f"solve_for names {shown(name)} twice", "solve_for")
    return tuple(found)


def _rtol(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, NUMBERS):
        raise _wrong_type("rtol", value, "a number")
    if not (math.isfinite(value) and 0 <= value < 1):
        raise BadRequest("out_of_range", f"rtol = {shown(value)} must be from 0 to below 1", "rtol")
    return float(value)


def _vars(value: Any) -> tuple[dict[str, tuple[float, float]], dict[str, Tree], Symbols]:
    if not isinstance(value, dict):
        raise _wrong_type("vars", value, "an object of names and ranges")
    if len(value) > MOST_VARS:
        raise BadRequest("out_of_range", f"vars has at most {MOST_VARS} names, not {len(value)}", "vars")
    box, fixed = dict[str, tuple[float, float]](), dict[str, Tree]()
    for name, bounds in value.items():
        if len(name) > LONGEST_NAME or not _is_name(name):
            raise BadRequest("unknown_symbol", f"{_below(name)}: this is no name of a symbol", _below(name))
        if not isinstance(bounds, list) or len(bounds) != 2:
            raise _wrong_type(_below(name), bounds, "a list of its least and its greatest value")
        low, high = _bound(bounds[0], name), _bound(bounds[1], name)
        if low > high:
            said = f"{_below(name)}: the least value {low!r} is above the greatest {high!r}"
            raise BadRequest("out_of_range", said, _below(name))
        if low == high:
            fixed[name] = _exactly(bounds[0])
        else:
            box[name] = low, high
    return box, fixed, _symbols(value)


def _below(name: str) -> str:
    return f"vars.{shown(name)[1:-1]}"


@lru_cache(maxsize=2048)
def _is_name(name: str) -> bool:
    try:
        tokens = tokenize(name)
    except AnswerSyntaxError:
        return False
    return [token.kind for token in tokens] == ["name", "end"] and tokens[0].text == name


def _symbols(found: Mapping[str, Any]) -> Symbols:
    try:
        return Symbols(found)
    except ValueError as error:
        raise BadRequest("contradictory", f"vars: {error}", "vars") from None


def _bound(value: Any, name: str) -> float:
    """Read a bound: a number, or a text with a constant expression."""
    if isinstance(value, str):
        found = _constant(value)
        if isinstance(found, str):
            code, _, said = found.partition(" ")
            raise BadRequest(code, f"{_below(name)}: the bound {shown(value)} {said}", _below(name))
        return found[0]
    if isinstance(value, bool) or not isinstance(value, NUMBERS):
        raise _wrong_type(_below(name), value, "two constant expressions")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise BadRequest("not_finite", f"{_below(name)}: the bound {shown(value)} must be finite", _below(name))
    return number


def _exactly(value: Any) -> Tree:
    """Give a bound that was read as a formula."""
    if isinstance(value, str):
        found = _constant(value)
        assert not isinstance(found, str)
        return found[1]
    number = float(value)
    digits, _, power = repr(abs(number)).partition("e")
    tree: Tree = Number(digits, int(power or "0"))
    return Unary("-", tree) if number < 0 else tree


@lru_cache(maxsize=2048)
def _constant(text: str) -> tuple[float, Tree] | str:
    """Read a constant expression; a text is a code and what is wrong."""
    try:
        tree = parse(text, NOTHING)
        (number,) = run(line_runner(tree), [])
    except AnswerSyntaxError as error:
        return f"unreadable_bound cannot be read ({error.reason.value} at {error.position})"
    except UndefinedError:
        return "not_finite must be finite"
    except ValueError:  # a relation has no value
        return "unreadable_bound is no number"
    if not isinstance(number, float | int):
        return "unreadable_bound is no number"
    return (float(number), tree) if math.isfinite(number) else "not_finite must be finite"


def _wrong_type(field: str, value: Any, wanted: str) -> BadRequest:
    return BadRequest("wrong_type", f"{field} = {shown(value)} must be {wanted}", field)


def shown(value: Any) -> str:
    """Make a foreign value safe to print on one line."""
    if isinstance(value, dict | list):
        return "an object" if isinstance(value, dict) else "a list"
    text = json.dumps(value, ensure_ascii=False) if not isinstance(value, int) or abs(value) < 10**20 else "a number"
    safe = "".join(sign if sign.isprintable() else "\ufffd" for sign in text[:SHOWN])
    return safe + "…" if len(text) > SHOWN else safe
