"""Symbolic pose of a serial chain, for authors of exercises (domain DH-11..16). SymPy is imported on the first call.

Turns about parallel axes are added before a sine or cosine is written, so that cos(th2 - th3) stands as in the tables
and nothing has to be simplified afterwards.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, TypeAlias

from mechanics import rod_groups
from mechanics.dh import JointType

Expr: TypeAlias = Any  # a SymPy expression or matrix


@dataclass(frozen=True, slots=True)
class SymbolicRow:
    """One row of a standard table with the joint variable already in theta or d."""

    theta: Expr  # turn about z
    d: Expr  # shift along z
    a: Expr  # shift along x
    alpha: Expr  # turn about x


@dataclass(frozen=True, slots=True)
class SymbolicGroup:
    """A rod functional group in letters: q1, q2, q3 and its lengths."""

    T: Expr  # (4, 4)
    M: Expr  # point M in base axes, (3, 1)
    q: tuple[Expr, Expr, Expr]


def pose(rows: Sequence[SymbolicRow]) -> Expr:
    """Multiply the pair matrices of a standard table, ``(4, 4)``, parallel turns added."""
    import sympy as sp

    axes, place, turn = sp.eye(3), sp.zeros(3, 1), sp.Integer(0)
    for row in rows:
        turn += row.theta
        place += axes * sp.Matrix([row.a * sp.cos(turn), row.a * sp.sin(turn), row.d])
        if row.alpha != 0:
            axes, turn = axes * _about_z(turn) * _about_x(row.alpha), sp.Integer(0)
    upper = (axes * _about_z(turn)).row_join(place)
    return upper.col_join(sp.Matrix([[0, 0, 0, 1]]))


def _about_z(angle: Expr) -> Expr:
    import sympy as sp

    return sp.Matrix([[sp.cos(angle), -sp.sin(angle), 0], [sp.sin(angle), sp.cos(angle), 0], [0, 0, 1]])


def _about_x(angle: Expr) -> Expr:
    import sympy as sp

    return sp.Matrix([[1, 0, 0], [0, sp.cos(angle), -sp.sin(angle)], [0, sp.sin(angle), sp.cos(angle)]])


def rod_group(group: str) -> SymbolicGroup:
    """Write T and M of a rod functional group in letters.

    Args:
        group: Word over R and P, as for `rod_groups.table`.

    Raises:
        ValueError: Unknown group.
    """
    import sympy as sp

    if group not in rod_groups.GROUPS:
        raise ValueError(f"group {group!r} must be one of {', '.join(rod_groups.GROUPS)}")
    names = rod_groups.GROUPS[group].lengths
    stand_ins = {name: float(i) for i, name in enumerate(names, start=2)}  # numbers that no angle of a table equals
    rows, point = rod_groups.table(group, stand_ins)
    letters = {value: sp.Symbol(name, real=True) for name, value in stand_ins.items()}
    angles = {k * pi / 2: k * sp.pi / 2 for k in range(-2, 3)}
    q = sp.symbols("q1 q2 q3", real=True)
    symbolic = []
    for row, variable in zip(rows, q, strict=True):
        theta, d = angles[row.theta], letters.get(row.d, sp.Integer(0))
        theta, d = _moved(row.type, theta, d, int(row.sign) * variable)
        symbolic.append(SymbolicRow(theta, d, letters.get(row.a, sp.Integer(0)), angles[row.alpha]))
    T = pose(symbolic)
    place = sp.Matrix([sp.sign(x) * letters[abs(x)] if x else 0 for x in point])
    return SymbolicGroup(T, T[:3, :3] * place + T[:3, 3], (q[0], q[1], q[2]))


def _moved(joint: JointType, theta: Expr, d: Expr, variable: Expr) -> tuple[Expr, Expr]:
    return (theta + variable, d) if joint == "R" else (theta, d + variable)
