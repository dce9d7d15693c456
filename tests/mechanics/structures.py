"""Random beams and shafts on a grid of places, so that no element is so short that the oracle itself loses digits."""

from __future__ import annotations

from hypothesis import strategies as st

from mechanics.members import Beam, Distributed, Force, Load, Moment, Segment, Shaft, ShaftSupport, Support, Torque

CELLS = 24
numbers = st.integers(-9000, 9000).map(float)
cells = st.integers(0, CELLS)


@st.composite
def beams(draw: st.DrawFn) -> Beam:
    """Any beam, stable or not."""
    L = draw(st.sampled_from([0.6, 1.0, 4.0, 12.5]))
    places = draw(st.lists(cells, min_size=1, max_size=5, unique=True))
    supports = tuple(
        Support(x * L / CELLS, draw(st.sampled_from(["pin", "roller", "fixed"])), draw(numbers) * 1e-7 * L)
        for x in places
    )
    fixed = {support.x for support in supports if support.type == "fixed"}
    hinges = tuple(
        x * L / CELLS
        for x in draw(st.lists(st.integers(1, CELLS - 1), max_size=2, unique=True))
        if x * L / CELLS not in fixed
    )
    loads = tuple(draw(st.lists(_loads(L, hinges), max_size=5)))
    return Beam(L, 2.1e11, supports, loads, hinges, I=draw(st.sampled_from([1e-7, 8.64e-6])))


@st.composite
def _loads(draw: st.DrawFn, L: float, hinges: tuple[float, ...]) -> Load:
    x = draw(cells) * L / CELLS
    kind = draw(st.sampled_from(["force", "moment", "dist"]))
    if kind == "moment" and x not in hinges:
        return Moment(x, draw(numbers))
    if kind == "dist":
        first, last = sorted(draw(st.lists(cells, min_size=2, max_size=2, unique=True)))
        return Distributed(first * L / CELLS, last * L / CELLS, draw(numbers), draw(numbers))
    return Force(x, draw(numbers))


@st.composite
def shafts(draw: st.DrawFn, support: ShaftSupport | None = None) -> Shaft:
    """Any stepped shaft that is held by at least one end."""
    segments = tuple(draw(st.lists(_segments(), min_size=1, max_size=4)))
    length = sum(segment.L for segment in segments)
    torques = tuple(
        Torque(draw(cells) * length / CELLS, draw(numbers)) for _ in range(draw(st.integers(min_value=0, max_value=4)))
    )
    kinds: list[ShaftSupport] = [support] if support else ["fixed_free", "free_fixed", "fixed_fixed"]
    return Shaft(8e10, segments, torques, draw(st.sampled_from(kinds)), 6e7, 0.0087)


@st.composite
def _segments(draw: st.DrawFn) -> Segment:
    outer = draw(st.integers(20, 90)) / 1000
    return Segment(draw(st.integers(1, 12)) / 10, outer, outer * draw(st.sampled_from([0.0, 0.3, 0.6, 0.9])))
