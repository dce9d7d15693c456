"""K u = f with some displacements given: what every frame of elements comes down to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from mechanics.errors import UnstableError

# Beyond this condition number (of the matrix scaled to a unit diagonal) the structure moves freely.
_FREE = 1e14


def settle(
    count: int,
    elements: Iterable[tuple[Sequence[int], Sequence[Sequence[float]]]],
    loads: Sequence[float],
    given: Mapping[int, float],
) -> tuple[list[float], list[float]]:
    """Assemble the elements and find the displacements.

    Args:
        count: Number of displacements n.
        elements: For each element the numbers of its displacements, and its stiffness matrix.
        loads: The force at each displacement, (n,).
        given: The displacements held, by number.

    Returns:
        All displacements, and the force K u - f missing at each of them, which is the reaction where one is given;
        both (n,), in units consistent with the matrices.

    Raises:
        UnstableError: The displacements left free are not determined.

    Source:
        Residuals are taken in extended precision and the solution is corrected with them (iterative refinement:
        Golub, Van Loan, Matrix Computations, 4th ed., section 3.5.3).
    """
    import numpy as np

    K = np.zeros((count, count), dtype=np.longdouble)
    for code, matrix in elements:
        K[np.ix_(code, code)] += np.array(matrix, dtype=np.longdouble)
    u = np.zeros(count, dtype=np.longdouble)
    for number, displacement in given.items():
        u[number] = displacement
    f = np.array(loads, dtype=np.longdouble)
    free = [number for number in range(count) if number not in given]
    if free:
        scale = 1 / np.sqrt(np.diag(K)[free])
        inner = (K[np.ix_(free, free)] * np.outer(scale, scale)).astype(np.float64)
        if not np.linalg.cond(inner) < _FREE:
            raise UnstableError("unstable structure: its stiffness matrix is singular, the supports do not hold it")
        for _ in range(4):
            missing = ((f - K @ u)[free] * scale).astype(np.float64)
            u[free] += np.linalg.solve(inner, missing) * scale
    return [float(value) for value in u], [float(value) for value in K @ u - f]
