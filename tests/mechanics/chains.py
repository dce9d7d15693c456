"""Random serial chains, their motions and masses, for the tests that compare ways of solving them."""

from __future__ import annotations

from dataclasses import dataclass

from hypothesis import strategies as st

from mechanics.dh import Convention, Row
from mechanics.links import LinkMass
from mechanics.vectors import Matrix, Vector

numbers = st.floats(-4, 4)
lengths = st.floats(-1, 1)
rows = st.builds(Row, st.sampled_from(["R", "P"]), numbers, lengths, lengths, numbers, st.sampled_from([1, -1]))
conventions: st.SearchStrategy[Convention] = st.sampled_from(["standard", "modified"])
vectors: st.SearchStrategy[Vector] = st.tuples(lengths, lengths, lengths)


@dataclass(frozen=True)
class Moving:
    """A chain that moves: its table, masses, and the three lists of joint variables and rates."""

    rows: tuple[Row, ...]
    masses: tuple[LinkMass, ...]
    q: tuple[float, ...]
    qd: tuple[float, ...]
    qdd: tuple[float, ...]

    def after(self, time: float) -> Moving:
        """The same chain a little later, the accelerations kept."""
        state = list(zip(self.q, self.qd, self.qdd, strict=True))
        q = tuple(x + w * time + e * time**2 / 2 for x, w, e in state)
        return Moving(self.rows, self.masses, q, tuple(w + e * time for _, w, e in state), self.qdd)


def diagonal(*moments: float) -> Matrix:
    """A tensor in principal axes."""
    return tuple(tuple(moments[i] if i == j else 0.0 for j in range(3)) for i in range(3))


@st.composite
def links(draw: st.DrawFn) -> LinkMass:
    """A body of four heavy points: any centre, any tensor a body can have."""
    points = [(draw(st.floats(0.1, 2)), draw(vectors)) for _ in range(4)]
    tensor = [[0.0] * 3 for _ in range(3)]
    for m, r in points:
        for i in range(3):
            for j in range(3):
                tensor[i][j] += m * ((i == j) * sum(x * x for x in r) - r[i] * r[j])
    return LinkMass(draw(st.floats(0.1, 4)), draw(vectors), tuple(tuple(row) for row in tensor))


@st.composite
def moving(draw: st.DrawFn, most: int = 4) -> Moving:
    """A chain of up to so many joints."""
    table = tuple(draw(st.lists(rows, min_size=1, max_size=most)))
    variables = st.tuples(*[numbers] * len(table))
    return Moving(table, tuple(draw(links()) for _ in table), draw(variables), draw(variables), draw(variables))
