"""Reads a finished figure back from its SVG: texts with their room, and the lines that could cross them."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from cmath import phase, rect
from dataclasses import dataclass
from itertools import combinations, pairwise
from math import pi
from typing import Literal, cast

from figures.label import Label
from figures.plane import Box, Segment

SVG = "{http://www.w3.org/2000/svg}"
ALLOWED = {"class", "d", "x", "y", "cx", "cy", "r", "id", "viewBox", "role", "aria-labelledby", "text-anchor", "dy"}
CLASSES = re.compile(r"fig|[fht]-[a-z]+|[nrs]|up")


@dataclass(frozen=True, slots=True)
class Written:
    """A text of the figure and the room it takes on a narrow screen."""

    text: str
    box: Box


def texts(svg: str) -> list[Written]:
    found = []
    for element in ET.fromstring(svg).iter("text"):
        at = complex(float(element.get("x", "")), -float(element.get("y", "")))
        index = "".join(span.text or "" for span in element)
        label = Label(element.text or "", index, element.get("class", ""))
        anchor = cast(Literal["start", "middle", "end"], element.get("text-anchor", "start"))
        found.append(Written((element.text or "") + index, label.box(at, anchor)))
    return found


def segments(svg: str) -> list[Segment]:
    """The straight lines of the figure, and its arcs in short straight stretches."""
    found: list[Segment] = []
    for path in ET.fromstring(svg).iter("path"):
        for part in path.get("d", "").split("M")[1:]:
            points: list[complex] = []
            for step in re.findall(r"(?:^|[LA])[^LAZ]+", part):
                numbers = [float(number) for number in step.lstrip("LA").split()]
                end = complex(numbers[-2], -numbers[-1])
                points += [end] if step[0] != "A" else curve(points[-1], end, numbers)
            found += pairwise([*points, points[0]] if part.endswith("Z") else points)
    return found


def curve(start: complex, end: complex, numbers: list[float]) -> list[complex]:
    """Points of an SVG arc (SVG 1.1, F.6.5), on the circle into which its ellipse is stretched."""
    across, up, _, large, clockwise, *_ = numbers
    one, other = (complex(at.real, at.imag * across / up) for at in (start, end))
    chord = other - one
    away = max(across**2 - abs(chord) ** 2 / 4, 0) ** 0.5 * (-1 if large == clockwise else 1)
    centre = (one + other) / 2 - away * 1j * chord / abs(chord)
    sweep = phase((other - centre) / (one - centre)) % (2 * pi) - (2 * pi if clockwise else 0)
    points = [centre + (one - centre) * rect(1, sweep * i / 16) for i in range(1, 17)]
    return [complex(at.real, at.imag * up / across) for at in points]


def view(svg: str) -> Box:
    left, top, width, height = map(float, ET.fromstring(svg).get("viewBox", "").split())
    return Box(left, -top - height, left + width, -top)


def heads(svg: str, style: str) -> list[complex]:
    """The tips of the heads of a style."""
    found = [path.get("d", "") for path in ET.fromstring(svg).iter("path") if path.get("class") == f"h-{style}"]
    tips = [path[1:].split("L")[0].split() for path in found]
    return [complex(float(x), -float(y)) for x, y in tips]


def classes(svg: str) -> list[str]:
    return [element.get("class", "") for element in ET.fromstring(svg).iter()]


def assert_sound(svg: str) -> None:
    """What every figure keeps: strict markup, contents in view, texts apart from texts and from lines."""
    for element in ET.fromstring(svg).iter():
        assert set(element.attrib) <= ALLOWED
        assert all(CLASSES.fullmatch(name) for name in element.get("class", "").split())
    frame = view(svg)
    ends = [end for segment in segments(svg) for end in segment]
    drawn = Box.around([*ends, *(corner for one in texts(svg) for corner in one.box.corners)])
    assert frame.left <= drawn.left and drawn.right <= frame.right
    assert frame.bottom <= drawn.bottom and drawn.top <= frame.top
    for one, other in combinations(texts(svg), 2):
        assert not one.box.grown(0.5).overlaps(other.box), f"{one.text} over {other.text}"
    for one in texts(svg):
        for segment in segments(svg):
            assert not one.box.grown(-0.4).crossed_by(segment), f"{one.text} crossed"
