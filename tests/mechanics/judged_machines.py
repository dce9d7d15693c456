"""A random machine is drawn, solved and checked by what it was made of; shared by a test and a benchmark."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import TypeAlias

import numpy as np

from mechanics import gear_train, mobility
from mechanics.errors import TrainError, UndeterminedError
from tests.mechanics import machines

Judge: TypeAlias = Callable[[Random], str]


def train(chance: Random) -> str:
    """Solve a random train: every equation holds exactly, or the rank of all of them says why there is no answer."""
    drawn = machines.train(chance)
    equations, right = _written_out(drawn)
    rank = np.linalg.matrix_rank(equations)
    whole = np.linalg.matrix_rank(np.column_stack([equations, right]))
    try:
        found = gear_train.solve(drawn)
    except UndeterminedError as refusal:
        assert rank == whole < len(drawn.members) and "is not determined" in str(refusal)
        return "under-determined"
    except TrainError as refusal:
        assert rank < whole and "contradicts" in str(refusal)
        return "contradictory"
    assert rank == whole == len(drawn.members)
    speeds = [found.omega[member] for member in drawn.members]
    assert np.allclose(equations @ speeds, right, atol=1e-9 * max(1.0, *map(abs, speeds)))
    return "solved"


def _written_out(drawn: gear_train.Train) -> tuple[np.ndarray, np.ndarray]:
    """Write relative pitch-point speeds, differentials, fixed members and inputs as rows of floats."""
    at = {member: np.eye(len(drawn.members))[i] for i, member in enumerate(drawn.members)}
    rows, right = [], []
    for mesh in drawn.meshes:
        carrier = at[mesh.carrier] if mesh.carrier else 0 * at[mesh.a]
        sense = -1 if mesh.type == "external" else 1
        rows.append((at[mesh.a] - carrier) - sense * mesh.zb / mesh.za * (at[mesh.b] - carrier))
        right.append(0.0)
    for joint in drawn.differentials:
        rows.append((at[joint.left] + at[joint.right]) / 2 - at[joint.carrier])
        right.append(0.0)
    for member, speed in [*((member, 0.0) for member in drawn.fixed), *drawn.input_omega.items()]:
        rows.append(at[member])
        right.append(float(speed))
    return np.array(rows), np.array(right)


def structure(chance: Random) -> str:
    """Count and move a random structure: no more moves than is free in the drawing, all of it where no bar is too many.

    A drawing at the end of its reach is an isolated position: less may move there than the formula counts.
    """
    links, joints = machines.structure(chance)
    found = mobility.plane(links, joints)
    assert found.instantaneous is not None and found.true is not None and found.rank is not None
    assert found.instantaneous == 3 * found.moving - found.rank
    assert 0 <= found.true <= found.instantaneous and found.formula <= found.instantaneous
    assert found.true == found.formula or found.instantaneous > found.formula
    assert found.formula == sum({"R": 1, "P": 1, "H": 2}[joint.kind] for joint in joints) - 3 * found.loops
    if found.true == found.formula:
        return "solved"
    return "passive constraints" if found.true > found.formula else "end of reach"
