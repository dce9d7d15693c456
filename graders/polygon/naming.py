"""What every name of a polygon truly is: names of the task keep their meaning, others get it from their vector."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import cos, pi, remainder, sin

from graders.language.doubles import UndefinedError
from graders.language.tree import Name, Tree, names
from graders.polygon.drawn import Drawn, Vector
from graders.polygon.jets import Trio, direction, distance, jet
from graders.polygon.mechanism import State
from graders.verdict import Code, Flaw

CLOSE = 1e-9  # relative; true states carry about 1e-12
STILL = 1e-9  # a rate below this part of the speeds around it is rounding
Trios = tuple[Trio, ...]


@dataclass(slots=True)
class Named:
    """The values and rates of all names at all true states, and what is wrong with the vectors."""

    states: tuple[State, ...]
    rows: list[dict[str, Trio]]
    owners: dict[str, tuple[str, str]] = field(default_factory=dict)  # free name: its vector, "length" or "angle"
    flaws: list[Flaw] = field(default_factory=list)

    def of(self, name: str) -> Trios:
        """Give a name at all states."""
        return tuple(row[name] for row in self.rows)

    def define(self, name: str, trios: Sequence[Trio]) -> None:
        """Give a name its value at all states."""
        for row, trio in zip(self.rows, trios, strict=True):
            row[name] = trio

    def place(self, places: Sequence[tuple[str, str, int]]) -> None:
        """Give coordinates that the task names their meaning, where the polygon has not given it."""
        for name, node, axis in places:
            if name not in self.rows[0]:
                self.define(name, [state.nodes[node][axis] for state in self.states])

    def value(self, tree: Tree) -> Trios | None:
        """Compute a formula at all states; None where a name has no meaning or the formula no value."""
        try:
            return tuple(jet(tree, row) for row in self.rows)
        except (KeyError, UndefinedError):
            return None

    def varies(self, name: str) -> bool:
        """Tell whether a name changes while the mechanism moves."""
        return moving(self.of(name), self.states)

    def given(self, name: str) -> bool:
        """Tell whether a name is one of the task's, or another name of one of them."""
        if name not in self.owners:
            return True
        own = self.of(name)
        return any(_same(own, self.of(other)) for other in self.states[0].names)

    def unknowns(self, drawn: Drawn) -> tuple[str, ...]:
        """Give the names that change and are not given, in the order of the vectors."""
        found = dict.fromkeys(n for v in drawn.vectors for tree in (v.length, v.angle) for n in sorted(names(tree)))
        return tuple(n for n in found if n in self.owners and self.varies(n) and not self.given(n))


def moving(trios: Trios, states: Sequence[State]) -> bool:
    """Tell whether a length or an angle has a rate in some state that is more than rounding."""
    return any(abs(trio[1]) > STILL * _pace(state, trio[0]) for trio, state in zip(trios, states, strict=True))


def _pace(state: State, value: float) -> float:
    rates = [abs(trio[1]) for trio in state.names.values()]
    return max(1e-12, max(rates, default=0.0) * max(abs(value), 1e-3))


def _same(one: Trios, other: Trios) -> bool:
    return _agree_turned(one, other) and all(
        abs(a[1] - b[1]) <= CLOSE * (abs(a[1]) + abs(b[1])) for a, b in zip(one, other, strict=True)
    )


@dataclass(frozen=True, slots=True)
class Shape:
    """A vector as it truly lies at all states."""

    xs: Trios
    ys: Trios

    @classmethod
    def of(cls, vector: Vector, states: Sequence[State]) -> Shape:
        """Take the vector from its start to its end."""
        ends = [(state.nodes[vector.start], state.nodes[vector.end]) for state in states]
        xs, ys = (tuple(_between(start[k], end[k]) for start, end in ends) for k in (0, 1))
        return cls(xs, ys)

    @property
    def lengths(self) -> Trios:
        """Give its length."""
        return tuple(distance(x, y) for x, y in zip(self.xs, self.ys, strict=True))

    @property
    def angles(self) -> Trios:
        """Give its angle from +X."""
        return tuple(direction(y, x) for x, y in zip(self.xs, self.ys, strict=True))

    def along(self, angle: float) -> Trios | None:
        """Give its coordinate along a fixed direction, None where it does not lie on it."""
        c, s = cos(angle), sin(angle)
        for x, y, size in zip(self.xs, self.ys, self.lengths, strict=True):
            if abs(y[0] * c - x[0] * s) > CLOSE * size[0]:
                return None
        return tuple((x[0] * c + y[0] * s, x[1] * c + y[1] * s, x[2] * c + y[2] * s)
                     for x, y in zip(self.xs, self.ys, strict=True))  # fmt: skip


def _between(start: Trio, end: Trio) -> Trio:
    return end[0] - start[0], end[1] - start[1], end[2] - start[2]


def name(drawn: Drawn, states: tuple[State, ...]) -> Named:
    """Find what every name is, and every length and angle that is not the vector's own.

    Names are settled one by one: first angles, then lengths; a formula with one new name defines it.
    """
    named = Named(states, [dict(state.names) for state in states])
    shapes = {v.label: Shape.of(v, states) for v in drawn.vectors}
    pending = [(v, what) for what in ("angle", "length") for v in drawn.vectors]
    pending.sort(key=lambda item: not isinstance(item[0].of(item[1]), Name))
    while pending:
        item = next((i for i in pending if len(_new(i[0].of(i[1]), named)) <= 1), None)
        if item is None:
            named.flaws += [Flaw(_wrong(what), v.label) for v, what in pending]
            break
        pending.remove(item)
        _settle(named, *item, shapes)
    _marks(named, drawn, shapes)
    return named


def _wrong(what: str) -> Code:
    return Code.WRONG_LENGTH if what == "length" else Code.WRONG_ANGLE


def _new(tree: Tree, named: Named) -> list[str]:
    return sorted(names(tree) - named.rows[0].keys())


def _settle(named: Named, vector: Vector, what: str, shapes: dict[str, Shape]) -> None:
    """Check a length or an angle, or define its one new name."""
    tree, shape = vector.of(what), shapes[vector.label]
    new = _new(tree, named)
    true = shape.angles if what == "angle" else _lengths(named, vector, shape)
    if new:
        _define(named, vector, what, new[0], true)
        return
    found = named.value(tree)
    if found is None:
        named.flaws.append(Flaw(_wrong(what), vector.label))
    elif what == "angle" and not _agree_turned(found, true):
        code = _angle_flaw(named, vector, found, shapes)
        named.flaws += [Flaw(code, vector.label)] if code else []
    elif what == "length" and not _agree(found, true):
        varies = moving(true, named.states) and not moving(found, named.states)
        named.flaws.append(Flaw(Code.LENGTH_VARIES if varies else Code.WRONG_LENGTH, vector.label))


def _lengths(named: Named, vector: Vector, shape: Shape) -> Trios:
    """Give the length, signed where the vector's angle is fixed and the end passes through the start."""
    if names(vector.angle) - named.rows[0].keys():
        return shape.lengths
    angles = named.value(vector.angle)
    if angles is None or moving(angles, named.states):
        return shape.lengths
    signed = shape.along(angles[0][0])
    return signed if signed and any(trio[0] > 0 for trio in signed) else shape.lengths


def _define(named: Named, vector: Vector, what: str, new: str, true: Trios) -> None:
    """Solve a formula that is affine in its one new name for it."""
    tree, trios = vector.of(what), []
    named.owners[new] = (vector.label, what)
    for row, wanted in zip(named.rows, true, strict=True):
        rest, step = (_at(tree, row | {new: (value, 0.0, 0.0)}) for value in (0.0, 1.0))
        if rest is None or step is None or abs(step[0] - rest[0]) < CLOSE:
            named.define(new, true)
            named.flaws.append(Flaw(_wrong(what), vector.label))
            return
        factor = step[0] - rest[0]
        trios.append(tuple((wanted[k] - rest[k]) / factor for k in range(3)))
    named.define(new, [(a, b, c) for a, b, c in trios])


def _at(tree: Tree, row: dict[str, Trio]) -> Trio | None:
    try:
        return jet(tree, row)
    except UndefinedError:
        return None


def _agree(one: Trios, other: Trios) -> bool:
    return all(abs(a[0] - b[0]) <= CLOSE * abs(b[0]) + 1e-15 for a, b in zip(one, other, strict=True))


def _agree_turned(one: Trios, other: Trios, turn: float = 0.0) -> bool:
    return all(
        abs(remainder(a[0] - b[0] - turn, 2 * pi)) <= CLOSE * (1 + abs(a[0])) for a, b in zip(one, other, strict=True)
    )


def _angle_flaw(named: Named, vector: Vector, found: Trios, shapes: dict[str, Shape]) -> Code | None:
    """Say what else than the vector's angle was given; a fixed direction may be passed in both senses."""
    shape = shapes[vector.label]
    if not moving(found, named.states):
        signed = shape.along(found[0][0])
        free = names(vector.length) - named.states[0].names.keys()
        if free and signed and any(trio[0] > 0 for trio in signed):
            return None
        if not signed and moving(shape.angles, named.states):
            return Code.ANGLE_VARIES
    if _agree_turned(found, shape.angles, pi):
        return Code.REVERSED_ANGLE
    others = [other.angles for label, other in shapes.items() if label != vector.label]
    if any(_agree_turned(found, trios) for trios in other_angles(shape.angles, others)):
        return Code.INTERIOR_ANGLE
    return Code.WRONG_ANGLE


def other_angles(own: Trios, others: Sequence[Trios]) -> list[Trios]:
    """Give what is taken for an angle from +X: measured clockwise, its supplement, angles between two vectors."""
    found = [mixed(own, -1.0, 0.0), mixed(own, -1.0, pi)]
    for other in others:
        between = tuple(_between(b, a) for a, b in zip(own, other, strict=True))
        found += [mixed(between, sign, turn) for sign in (1.0, -1.0) for turn in (0.0, pi)]
    return found


def mixed(own: Trios, sign: float, turn: float) -> Trios:
    """Give the angle with a sign and a constant turn."""
    return tuple((sign * a[0] + turn, sign * a[1], sign * a[2]) for a in own)


def _marks(named: Named, drawn: Drawn, shapes: dict[str, Shape]) -> None:
    """Hold what was called constant against the motion."""
    for v in drawn.vectors:
        shape = shapes[v.label]
        for what, true, code in (
            ("length", shape.lengths, Code.LENGTH_VARIES),
            ("angle", shape.angles, Code.ANGLE_VARIES),
        ):
            flaw = Flaw(code, v.label)
            if what in v.constant and moving(true, named.states) and flaw not in named.flaws:
                named.flaws.append(flaw)
