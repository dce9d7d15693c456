"""Denavit-Hartenberg tables written as a student could type them: their numbers, pair matrices and true motion.

The underscore keeps the folder off the shelf.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import accumulate

from exercises.exercise import Steps
from graders import States
from graders.chain.frames import Frame, Vector, axis_z, carried, frame_of, origin
from graders.chain.motion import Axis, Motion
from graders.language import parse_line
from graders.language.doubles import line_runner, run
from mechanics import chain, transform

Numbers = tuple[tuple[float, ...], ...]
PAIR = """[[cos({t}); -sin({t})*cos({k}); sin({t})*sin({k}); {a}*cos({t})],
    [sin({t}); cos({t})*cos({k}); -cos({t})*sin({k}); {a}*sin({t})],
    [0; sin({k}); cos({k}); {s}], [0; 0; 0; 1]]"""  # Rot(z, theta) Trans(z, s) Trans(x, a) Rot(x, alpha) (DH-2)
MODIFIED = """[[cos({t}); -sin({t}); 0; {a}],
    [sin({t})*cos({k}); cos({t})*cos({k}); -sin({k}); -{s}*sin({k})],
    [sin({t})*sin({k}); cos({t})*sin({k}); cos({k}); {s}*cos({k})], [0; 0; 0; 1]]"""  # Craig


def pairs(form: str, count: int, table: str = "P") -> Steps:
    """Write the pair matrices A1, A2, … from the rows of a table."""
    columns = {"t": 1, "s": 2, "a": 3, "k": 4}
    rows = range(1, count + 1)
    return {f"A{i}": form.format(**{key: f"{table}[{i};{at}]" for key, at in columns.items()}) for i in rows}


def numbers(table: str, values: Mapping[str, float]) -> Numbers:
    """Evaluate a table that is written in symbols.

    Raises:
        UndefinedError: An entry has no value.
    """
    runner = line_runner(parse_line(table))
    (found,) = run(runner, [values[name] for name in runner.inputs])
    return tuple(tuple(float(entry) for entry in row) for row in found.rows)


def motion(table: str, joints: str, tool: Vector, givens: Mapping[str, float], states: States) -> Motion:
    """Find the motion of the chain that a standard table describes, at drawn values of its joint variables.

    Args:
        table: The table in symbols, rows theta, d, a, alpha.
        joints: The joints as a word over R and P.
        tool: The tool point in the last frame, m.
        givens: Values of all symbols; the lengths keep them.
        states: Points from which the joint variables q1 … qn are taken.
    """
    variables = [f"q{i}" for i in range(1, len(joints) + 1)]
    points = []
    for point in states.points:
        drawn = dict(zip(states.names, point, strict=True))
        points.append(tuple(drawn[name] if name in variables else value for name, value in givens.items()))
    return _moved(table, tool, tuple(givens), tuple(points))


@lru_cache(maxsize=64)
def _moved(table: str, tool: Vector, names: tuple[str, ...], points: tuple[tuple[float, ...], ...]) -> Motion:
    poses = [_poses(numbers(table, dict(zip(names, point, strict=True)))) for point in points]
    return Motion(
        names=names,
        points=points,
        links=tuple(tuple(frames[1:]) for frames in poses),
        axes=tuple(tuple(Axis(origin(frame), axis_z(frame)) for frame in frames[:-1]) for frames in poses),
        tool=tool,
        targets=tuple(carried(frames[-1], tool) for frames in poses),
        table=table,
    )


def _poses(rows: Sequence[Sequence[float]]) -> list[Frame]:
    """The frames 0 to n by the closed form of the pair matrices."""
    matrices = [chain.pair_matrix(theta, d, a, alpha) for theta, d, a, alpha in rows]
    return [frame_of(pose) for pose in accumulate(matrices, transform.product, initial=transform.IDENTITY)]
