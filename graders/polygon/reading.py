"""Text to polygon: order-free lines, any of three languages, many spellings of an arrow."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.parser import parse
from graders.language.piece import Piece
from graders.language.symbols import Symbols, key, latin
from graders.language.tree import Binary, Grid, Index, Name, Number, Relation, Tree, Unary, mapped, names, walk
from graders.polygon import keywords
from graders.polygon.drawn import Axis, Closure, Drawn, Equation, Vector
from graders.polygon.lines import Line, fields_of, folded, label_of, lines_of, new_names, words_of

MAX_VECTORS = 12
MAX_EQUATIONS = 8
MAX_SPELLING = 40  # characters of a node or of two run together
TURN_IN_RADIANS = 6.3  # a bare number beyond it is an angle in degrees


@dataclass(slots=True)
class _Sorted:
    """The lines by what they say."""

    vectors: list[Line] = field(default_factory=list)
    closures: list[Line] = field(default_factory=list)
    equations: list[tuple[Axis, Line]] = field(default_factory=list)
    unknowns: list[Line] = field(default_factory=list)


def read_polygon(text: str, symbols: Symbols, nodes: tuple[str, ...]) -> Drawn:
    """Read a polygon.

    Args:
        text: Its lines, in any order.
        symbols: The names of the task; every other name in a length or an angle is declared by being used there.
        nodes: The letters of the nodes.

    Raises:
        AnswerSyntaxError: A line that cannot be read, a node or a name that does not exist.
    """
    said = _sorted(lines_of(text), nodes)
    if not said.vectors:
        raise AnswerSyntaxError(Reason.EMPTY if not text.strip() else Reason.NEEDS_VECTORS, 0, text.strip()[:20])
    if len(said.vectors) > MAX_VECTORS:
        raise said.vectors[MAX_VECTORS].body.error(Reason.TOO_LONG)
    if len(said.equations) > MAX_EQUATIONS:
        raise said.equations[MAX_EQUATIONS][1].body.error(Reason.TOO_LONG)
    drafts = [_Draft(line, nodes) for line in said.vectors]
    declared = declare([f for draft in drafts for f in draft.formulas], symbols)
    vectors = tuple(draft.vector(declared) for draft in drafts)
    _refuse_twins(said.vectors)
    return Drawn(
        vectors,
        tuple(_closure(line.body, vectors) for line in said.closures),
        numbered([(axis, loop_of(line.label), equation_of(line.body, declared)) for axis, line in said.equations]),
        _unknowns(said.unknowns, vectors, declared),
    )


def declare(formulas: Iterable[Piece], symbols: Symbols, rates: bool = False) -> Symbols:
    """Give the names of the task with those that the formulas bring along."""
    every: dict[str, str] = {key(name): name for name in symbols.known}
    for formula in formulas:
        every |= new_names(formula, Symbols(every.values()), rates)
    return Symbols(every.values())


def _sorted(lines: Iterable[Line], nodes: tuple[str, ...]) -> _Sorted:
    said = _Sorted()
    for line in lines:
        words = {folded(word) for word in line.label.text.split()}
        axis = axis_of(line.label.text)
        if words & keywords.UNKNOWNS:
            said.unknowns.append(line)
        elif axis and ("=" in line.body.text or not _names_nodes(line.body, nodes)):
            said.equations.append((axis, line))
        elif {word.rstrip("0123456789") for word in words} & keywords.CLOSURE or (
            "=" in line.body.text and not _names_nodes(line.body, nodes)
        ):
            said.closures.append(line)
        elif line.label.text:
            said.vectors.append(line)
        else:
            raise line.body.error(Reason.NOT_A_LINE)
    return said


def axis_of(label: str) -> Axis:
    """Tell of which axis a label speaks: `x`, `Ox`, `x_d`, `rzut na oś x`, `x2`."""
    words = [folded(word.translate(keywords.CYRILLIC_AXES)) for word in label.split()]
    words = [word for word in words if word not in keywords.AXIS_FILLERS and not word.isdigit()]
    if len(words) != 1:
        return ""
    name = key(words[0]).rstrip("0123456789")
    return "x" if name in keywords.X else "y" if name in keywords.Y else ""


def loop_of(label: Piece) -> int:
    """Read the number of a polygon behind its label; 0 where there is none."""
    digits = label.text[len(label.text.rstrip("0123456789")) :]
    return int(digits) if 0 < len(digits) < 3 else 0


def numbered(found: list[tuple[Axis, int, Relation]]) -> tuple[Equation, ...]:
    """Number the equations of an axis as they come, where they carry no number."""
    count: dict[Axis, int] = {}
    equations = []
    for axis, loop, tree in found:
        count[axis] = count.get(axis, 0) + 1
        equations.append(Equation(axis, loop or count[axis], tree))
    return tuple(equations)


def equation_of(body: Piece, symbols: Symbols) -> Relation:
    """Read one equation with its place; raises AnswerSyntaxError."""
    return body.read(lambda text: equation(text, symbols))


def equation(text: str, symbols: Symbols) -> Relation:
    """Read one equation; raises AnswerSyntaxError."""
    tree = parse(text, symbols)
    if not isinstance(tree, Relation) or tree.operators != ("=",):
        raise AnswerSyntaxError(Reason.NOT_AN_EQUATION, 0, text.strip()[:20])
    if any(isinstance(node, Grid | Index) for node in walk(tree)):
        raise AnswerSyntaxError(Reason.NOT_AN_EQUATION, 0, text.strip()[:20])
    return tree


class _Draft:
    """A vector's line, cut into what it says."""

    def __init__(self, line: Line, nodes: tuple[str, ...]) -> None:
        self.line, self.label = line, label_of(line.label)
        self.ends: tuple[str, str] | None = None
        self.said: dict[str, Piece] = {}
        self.marks: dict[str, set[str]] = {"constant": set(), "sought": set()}
        for piece in fields_of(line.body):
            self._field(piece, nodes)
        ends = self.ends or _two_nodes([line.label], nodes)
        if ends is None:
            raise line.body.error(Reason.NEEDS_NODES)
        if set(self.said) != {"length", "angle"}:
            raise line.body.error(Reason.NEEDS_LENGTH_AND_ANGLE)
        self.start, self.end = ends

    @property
    def formulas(self) -> list[Piece]:
        return list(self.said.values())

    def _field(self, piece: Piece, nodes: tuple[str, ...]) -> None:
        words, what, marks = _without_keywords(words_of(piece))
        if not what and self.ends is None and (ends := _ends(words, nodes)):
            self.ends = ends
            return
        what = what or ("angle" if "length" in self.said else "length")
        if not words or what in self.said:
            raise piece.error(Reason.NEEDS_LENGTH_AND_ANGLE)
        last = words[-1]
        end = last.place - piece.place + len(last.text)
        self.said[what] = _without_equals(piece.part(words[0].place - piece.place, end).bare)
        for mark in marks & {"constant", "sought"}:
            self.marks[mark].add(what)

    def vector(self, symbols: Symbols) -> Vector:
        length, angle = (self.said[what].read(lambda t: _formula(t, symbols)) for what in ("length", "angle"))
        if isinstance(angle, Number) and float(angle.exact) > TURN_IN_RADIANS:
            angle = Unary("°", angle)
        return Vector(
            self.label, self.start, self.end, length, angle,
            frozenset(self.marks["constant"]), frozenset(self.marks["sought"]),
        )  # fmt: skip


def _without_keywords(words: list[Piece]) -> tuple[list[Piece], str, set[str]]:
    """Take the keywords off both ends: what is left, "length" or "angle" if said, and what was said of it."""
    said = set()
    while words and (kind := _kind(words[0].text, words[1:])):
        said.add(kind)
        words = words[1:]
    while words and (kind := _kind(words[-1].text)) not in ("", "filler"):
        said.add(kind)
        words = words[:-1]
    return words, next((what for what in ("length", "angle") if what in said), ""), said


def _without_equals(piece: Piece) -> Piece:
    return piece.part(len(piece.text) - len(piece.text.lstrip("=: "))).bare


def _kind(word: str, behind: Sequence[Piece] = ()) -> str:
    """Tell what a word of a field says, nothing where it belongs to a formula; `o` is said before `długości` only."""
    said = folded(word)
    for kind, listed in (
        ("length", keywords.LENGTH), ("angle", keywords.ANGLE), ("constant", keywords.CONSTANT),
        ("sought", keywords.SOUGHT), ("known", keywords.KNOWN),
    ):  # fmt: skip
        if said in listed:
            return kind
    alone = len(said) == 1 and not (behind and _kind(behind[0].text) in ("length", "angle"))
    return "filler" if said in keywords.FILLERS and not alone else ""


def _formula(text: str, symbols: Symbols) -> Tree:
    tree = parse(text, symbols)
    if any(isinstance(node, Relation | Grid | Index) for node in walk(tree)):
        raise AnswerSyntaxError(Reason.NOT_AN_EXPRESSION, 0, text.strip()[:20])
    return tree


def _ends(words: list[Piece], nodes: tuple[str, ...]) -> tuple[str, str] | None:
    """Read the two nodes of a field; a field with an arrow must name them.

    Raises:
        AnswerSyntaxError: Beside an arrow stands what is no node, or one node twice.
    """
    found = _two_nodes(words, nodes)
    if found or not any(mark in word.text for word in words for mark in (">", "→", "⟶")):
        return found
    for word in words:
        for name in word.text.translate(keywords.ARROWS).split():
            if _node(name, nodes) is None and folded(name) not in keywords.FILLERS:
                place = word.place + word.text.index(name)
                raise AnswerSyntaxError(Reason.UNKNOWN_NODE, place, name, ", ".join(nodes))
    raise words[0].error(Reason.NEEDS_NODES)


def _two_nodes(words: list[Piece], nodes: tuple[str, ...]) -> tuple[str, str] | None:
    plain = " ".join(word.text for word in words).translate(keywords.ARROWS).split()
    plain = [word for word in plain if _node(word, nodes) or folded(word) not in keywords.FILLERS]
    if len(plain) == 1:
        whole = latin(plain[0])
        pairs = [(whole[:cut], whole[cut:]) for cut in range(1, len(whole))] if len(whole) <= MAX_SPELLING else []
    else:
        pairs = [(plain[0], plain[1])] if len(plain) == 2 else []
    for one, other in pairs:
        start, end = _node(one, nodes), _node(other, nodes)
        if start and end and start != end:
            return start, end
    return None


def _node(spelling: str, nodes: tuple[str, ...]) -> str | None:
    wanted = key(latin(spelling.strip(".,;()[]"))) if len(spelling) <= MAX_SPELLING else ""
    return next((node for node in nodes if key(node) == wanted), None)


def _names_nodes(body: Piece, nodes: tuple[str, ...]) -> bool:
    """Tell a vector's line that says `length = l1` from a closure."""
    return any(_two_nodes(words_of(piece), nodes) for piece in fields_of(body)[:1]) or len(fields_of(body)) > 1


def _refuse_twins(lines: list[Line]) -> None:
    seen = set()
    for line in lines:
        label = label_of(line.label)
        if label in seen:
            raise line.label.error(Reason.REPEATED_ITEM)
        seen.add(label)


def _closure(body: Piece, vectors: tuple[Vector, ...]) -> Closure:
    """Read a sum of vectors; a pair of nodes stands for the vector between them."""
    alias: dict[str, tuple[str, float]] = {}
    for v in vectors:
        alias[v.start + v.end], alias[v.end + v.start] = (v.label, 1.0), (v.label, -1.0)
    alias = {key(name): one for name, one in alias.items()} | {key(v.label): (v.label, 1.0) for v in vectors}
    tree = body.read(lambda text: equation(text, Symbols(alias)))
    walked: dict[str, float] = {}
    for side, sign in zip(tree.sides, (1.0, -1.0), strict=True):
        for name, factor in _linear(side, body).items():
            if name not in alias:  # pi
                raise body.error(Reason.NOT_A_CLOSURE)
            label, sense = alias[name]
            walked[label] = walked.get(label, 0.0) + sign * sense * factor
    return Closure(_spelled(tree, vectors), tuple((label, factor) for label, factor in walked.items() if factor))


def _linear(tree: Tree, body: Piece) -> Mapping[str, float]:
    """Read a linear sum; raises AnswerSyntaxError where it is none."""
    match tree:
        case Name(name=name):
            return {name: 1.0}
        case Number() if not float(tree.exact):
            return {}
        case Unary(operator="+" | "-" as sign, operand=inner):
            return {name: factor * (-1 if sign == "-" else 1) for name, factor in _linear(inner, body).items()}
        case Binary(operator="+" | "-" as sign, left=left, right=right):
            total = dict(_linear(left, body))
            for name, factor in _linear(right, body).items():
                total[name] = total.get(name, 0.0) + factor * (-1 if sign == "-" else 1)
            return total
        case Binary(operator="*", left=Number() as number, right=inner):
            return {name: factor * float(number.exact) for name, factor in _linear(inner, body).items()}
        case _:
            raise body.error(Reason.NOT_A_CLOSURE)


def _unknowns(lines: list[Line], vectors: tuple[Vector, ...], symbols: Symbols) -> tuple[str, ...] | None:
    """Read the list of unknowns; what is marked as unknown in its vector's line belongs to it."""
    found: dict[str, None] = {}
    for line in lines:
        for piece in fields_of(line.body):
            for name in _listed(piece, symbols):
                found[name] = None
    for vector in vectors:
        for what in sorted(vector.sought):
            found |= dict.fromkeys(sorted(names(vector.of(what))))
    return tuple(found) if found or lines else None


def _listed(piece: Piece, symbols: Symbols) -> list[str]:
    """Read one field of the list; the words between names are left out."""
    found = []
    for word in words_of(piece):
        if symbols.find(word.text) is None and (_kind(word.text) or folded(word.text) in keywords.FILLERS):
            continue
        tree = _parsed(word, declare([word], symbols))
        if not isinstance(tree, Name):
            raise word.error(Reason.NOT_A_LINE)
        found.append(tree.name)
    return found


def _parsed(piece: Piece, symbols: Symbols) -> Tree:
    return piece.read(lambda text: parse(text, symbols))


def _spelled(tree: Relation, vectors: tuple[Vector, ...]) -> Relation:
    """Write the vectors of a closure as their lines do: `r_x`, which is read as `rx`."""
    spelt = {key(vector.label): vector.label for vector in vectors}

    def named(node: Tree) -> Tree:
        return Name(spelt.get(node.name, node.name)) if isinstance(node, Name) else node

    return Relation(tree.operators, tuple(mapped(side, named) for side in tree.sides))
