"""The kinematic scheme of a train of gears on fixed parallel axes, from the side.

Every mesh stands to the right of the one before, an idler's two meshes in one plane; the first shaft is the input.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from figures import gears
from figures.canvas import Drawing, Piece
from figures.label import number, symbol
from figures.loads import turn_mark
from figures.picture import Picture, Words
from figures.placing import Spot, place
from figures.plane import Point

WIDTH = 572.0
_WIDEST, _BREADTH = 150.0, 336.0  # between two planes of meshes, between the first and the last
_OVERHANG = 96.0  # of the input and the output beyond their planes
_STUB = 36.0  # of other shafts beyond a wheel
_LARGEST, _SMALLEST = 76.0, 20.0
_HEIGHT = 300.0
_PLAY = 2.0  # half of the gap drawn between two faces in mesh


@dataclass(frozen=True, slots=True)
class Wheel:
    """A wheel with its name and size (in any unit: numbers of teeth, when these may be seen)."""

    name: str
    size: float


@dataclass(frozen=True, slots=True)
class Mesh:
    """Two wheels in mesh; of an internal pair the larger one is the ring."""

    driver: Wheel
    driven: Wheel
    kind: Literal["external", "internal"] = "external"


@dataclass(frozen=True, slots=True)
class _Stage:
    mesh: Mesh
    plane: float
    driver: float  # ordinates of the axes
    driven: float
    radii: tuple[float, float]
    idle: bool  # its driver is the driven wheel of the stage before

    @property
    def ends(self) -> tuple[float, ...]:
        """The ordinates of the ends of both diameters."""
        axes = ((self.driver, self.radii[0]), (self.driven, self.radii[1]))
        return tuple(axis + way * radius for axis, radius in axes for way in (1, -1))


@dataclass(frozen=True, slots=True)
class _Shaft:
    start: Point
    end: Point
    bearings: tuple[float, ...]

    @property
    def middle(self) -> Point:
        return (self.start + self.end) / 2


def draw(
    prefix: str,
    words: Words,
    meshes: Sequence[Mesh],
    shafts: Sequence[str] = (),
    speeds: tuple[str, str] = ("", ""),
    sense: Literal["", "+", "-"] = "",
) -> Picture:
    """Draw a gear train.

    Args:
        prefix: The id of the figure on its page.
        words: Title, description and table.
        meshes: In the order of the flow of power; a driver equal to the driven wheel before it is an idler.
        shafts: Names of the shafts, input first, at most one more than there are meshes.
        speeds: Names of the input and the output speed; an empty one is left out.
        sense: The sense of the input about the axis that runs to the right; no arc when empty.

    Raises:
        ValueError: There is no mesh, a size is not positive, an idler is a ring, or a ring is not the larger wheel.
    """
    _check(meshes)
    stages = _fitted(meshes)
    shapes = [_shaft(number, stages) for number in range(len(stages) + 1)]
    pieces: list[Piece] = [mark for shape in shapes for mark in _shaft_marks(shape)]
    for stage in stages:
        pieces += _wheels(stage)
    _speeds(pieces, shapes, speeds, sense)
    for stage in stages:
        _name_wheels(pieces, stage)
    for name, shape in zip(shafts, shapes, strict=False):
        pieces += place(number(name), _shaft_spots(shape), pieces, shape.middle) if name else ()
    svg = Drawing(tuple(pieces)).to_svg(prefix, words.title, words.description, WIDTH)
    return Picture(svg, words.table)


def _ring(mesh: Mesh) -> Wheel | None:
    if mesh.kind == "external":
        return None
    return mesh.driver if mesh.driver.size > mesh.driven.size else mesh.driven


def _check(meshes: Sequence[Mesh]) -> None:
    if not meshes:
        raise ValueError("a gear train has at least one mesh")
    for mesh in meshes:
        first, second = mesh.driver, mesh.driven
        if not min(first.size, second.size) > 0:
            raise ValueError(f"{first.name} of size {first.size} and {second.name} of {second.size} cannot be drawn")
        if mesh.kind == "internal" and first.size == second.size:
            raise ValueError(f"of {first.name} and {second.name} neither can be the ring")
    for before, mesh in pairwise(meshes):
        if mesh.driver == before.driven and mesh.driver in (_ring(before), _ring(mesh)):
            raise ValueError(f"the idler {mesh.driver.name} is a ring")


def _fitted(meshes: Sequence[Mesh]) -> list[_Stage]:
    """The stages in a scale that keeps the largest wheel and the whole within bounds."""
    scale = _LARGEST / max(wheel.size for mesh in meshes for wheel in (mesh.driver, mesh.driven))
    ends = [end for stage in _stages(meshes, scale) for end in stage.ends]
    height = max(ends) - min(ends)
    return _stages(meshes, scale * min(1.0, _HEIGHT / height))


def _stages(meshes: Sequence[Mesh], scale: float) -> list[_Stage]:
    """Axes go down and up in turn, so that the train keeps low; an idler is met on its two opposite sides."""
    stages: list[_Stage] = []
    turns = sum(mesh.driver != before.driven for before, mesh in pairwise(meshes))
    pitch = min(_WIDEST, _BREADTH / max(turns, 1))
    plane, axis, way = 0.0, 0.0, -1.0
    for at, mesh in enumerate(meshes):
        idle = at > 0 and mesh.driver == meshes[at - 1].driven
        if idle:
            met = way if _ring(meshes[at - 1]) else -way  # the side of the idler that is taken
            way = met if _ring(mesh) else -met
        elif at:
            plane, way = plane + pitch, -way
        radii = _radii(mesh, scale)
        next_axis = axis + way * (abs(radii[1] - radii[0]) if _ring(mesh) else sum(radii))
        stages.append(_Stage(mesh, plane, axis, next_axis, radii, idle))
        axis = next_axis
    return stages


def _radii(mesh: Mesh, scale: float) -> tuple[float, float]:
    """Pitch radii on the sheet; a ring keeps its axis apart from its pinion's."""
    first, second = (max(_SMALLEST, wheel.size * scale) for wheel in (mesh.driver, mesh.driven))
    if _ring(mesh) is mesh.driver:
        return (max(first, second + 26), second)
    if _ring(mesh) is mesh.driven:
        return (first, max(second, first + 26))
    return (first, second)


def _wheels(stage: _Stage) -> tuple[Piece, ...]:
    first, second = complex(stage.plane, stage.driver), complex(stage.plane, stage.driven)
    one, other = stage.radii
    ring = _ring(stage.mesh)
    if ring is stage.mesh.driver:
        return (*gears.ring(first, one + _PLAY, -1), *gears.wheel(second, other - _PLAY))
    driver = () if stage.idle else gears.wheel(first, one - _PLAY)
    driven = gears.ring(second, other + _PLAY, 1) if ring else gears.wheel(second, other - _PLAY)
    return (*driver, *driven)


def _shaft(number: int, stages: Sequence[_Stage]) -> _Shaft:
    before = stages[number - 1] if number else None
    after = stages[number] if number < len(stages) else None
    axis = before.driven if before else stages[0].driver
    start, left = _left_end(before, stages) if before else (stages[0].plane - _OVERHANG, False)
    end, right = _right_end(after, stages) if after else (stages[-1].plane + _OVERHANG, False)
    return _Shaft(complex(start, axis), complex(end, axis), tuple(_bearings(start, end, left, right, before, after)))


def _left_end(before: _Stage, stages: Sequence[_Stage]) -> tuple[float, bool]:
    """Where the shaft of a driven wheel begins, and whether a ring keeps it from a bearing there."""
    if _ring(before.mesh) is before.mesh.driven:
        return (before.plane + gears.WEB - 5, True)
    walled = any(_ring(s.mesh) is s.mesh.driver and s.plane == before.plane for s in stages)
    return (before.plane - 6, True) if walled else (before.plane - _STUB, False)


def _right_end(after: _Stage, stages: Sequence[_Stage]) -> tuple[float, bool]:
    """Where the shaft of a driving wheel ends, and whether a ring keeps it from a bearing there."""
    if _ring(after.mesh) is after.mesh.driver:
        return (after.plane - gears.WEB + 5, True)
    walled = any(_ring(s.mesh) is s.mesh.driven and s.plane == after.plane for s in stages)
    return (after.plane + 6, True) if walled else (after.plane + _STUB, False)


def _bearings(
    start: float, end: float, left: bool, right: bool, before: _Stage | None, after: _Stage | None
) -> Iterator[float]:
    """On free stubs, else on the inner side of an overhung wheel; at the input and output beside the wheel."""
    if before is None:
        yield end - 66 if right else start + _OVERHANG - 34
    elif not left:
        yield start + 10
    elif after is None or after.plane > before.plane:
        yield before.plane + 38
    if after is None:
        yield start + 66 if left else end - _OVERHANG + 34
    elif not right:
        yield end - 10
    elif before is None or after.plane > before.plane:
        yield after.plane - 38


def _shaft_marks(shape: _Shaft) -> tuple[Piece, ...]:
    marks = tuple(gears.bearing(complex(x, shape.start.imag)) for x in shape.bearings)
    return (gears.shaft(shape.start, shape.end), *marks)


def _speeds(
    pieces: list[Piece], shapes: Sequence[_Shaft], names: tuple[str, str], sense: Literal["", "+", "-"]
) -> None:
    start, end = shapes[0].start, shapes[-1].end
    if sense:
        pieces += turn_mark(start + 12, sense == "+", 22)
    if names[0]:
        spots: tuple[Spot, ...] = ((start + 12 + 34j, "middle"),) if sense else ((start - 8 - 6j, "end"),)
        pieces += place(symbol(names[0], "vel"), spots, pieces, start)
    if names[1]:
        pieces += place(symbol(names[1], "vel"), ((end + 8 - 6j, "start"),), pieces, end)


def _name_wheels(pieces: list[Piece], stage: _Stage) -> None:
    """Every wheel at the end of its diameter that is away from the mesh, an idler once."""
    way = 1.0 if stage.driven > stage.driver else -1.0
    outer = _ring(stage.mesh)
    sides = (way if outer is stage.mesh.driven else -way, way if outer is not stage.mesh.driver else -way)
    wheels = ((stage.mesh.driver, stage.driver), (stage.mesh.driven, stage.driven))
    for at, ((wheel, axis), radius, side) in enumerate(zip(wheels, stage.radii, sides, strict=True)):
        if not (at == 0 and stage.idle):
            centre = complex(stage.plane, axis)
            target = centre + side * (radius - 6) * 1j
            pieces += place(symbol(wheel.name), _wheel_spots(centre, radius, side), pieces, target)


def _wheel_spots(centre: Point, radius: float, side: float) -> tuple[Spot, ...]:
    ends = [centre + 1j * (way * (radius + 20) - 8) for way in (side, -side)]
    rims = [centre + 1j * (way * (radius - 14) - 8) for way in (side, -side)]
    aside: list[Spot] = [(rim + 24, "start") for rim in rims] + [(rim - 24, "end") for rim in rims]
    return ((ends[0], "middle"), *aside, (ends[1], "middle"))


def _shaft_spots(shape: _Shaft) -> tuple[Spot, ...]:
    span = shape.end - shape.start
    shares = [shape.start + share * span for share in (0.5, 0.3, 0.7, 0.15, 0.85)]
    return tuple((at + rise, "middle") for rise in (12j, -26j) for at in shares)
