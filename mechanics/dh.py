"""Denavit-Hartenberg tables as they are given (domain DH-2).

They hold no formula: both ways of solving a chain read these.

standard (distal): A_i = Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha); joint i turns or slides along z of frame
i - 1. modified (proximal, Craig): A_i = Rot(x, alpha) Trans(x, a) Rot(z, theta) Trans(z, d); along z of frame i.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from mechanics.checks import finite

Convention = Literal["standard", "modified"]
JointType = Literal["R", "P"]


@dataclass(frozen=True, slots=True)
class Row:
    """One joint and the link behind it; the joint variable is added to theta (R) or to d (P)."""

    type: JointType
    theta: float = 0.0  # turn about z, rad
    d: float = 0.0  # shift along z, m
    a: float = 0.0  # shift along x, m
    alpha: float = 0.0  # turn about x, rad
    sign: float = 1.0  # -1 where the table holds the negative variable

    def __post_init__(self) -> None:
        if self.type not in get_args(JointType):
            raise ValueError(f"joint type {self.type!r} must be R or P")
        for name, unit in (("theta", "rad"), ("d", "m"), ("a", "m"), ("alpha", "rad")):
            finite(name, getattr(self, name), unit)
        if self.sign not in (1, -1):
            raise ValueError(f"sign {self.sign} must be 1 or -1")

    def moved(self, variable: float) -> tuple[float, float]:
        """theta (rad) and d (m) at a value of the joint variable."""
        added = self.sign * variable
        return (self.theta + added, self.d) if self.type == "R" else (self.theta, self.d + added)


def check_variables(rows: Sequence[Row], convention: str, **variables: Sequence[float]) -> None:
    """Refuse a convention that is unknown, an empty table, or joint variables that do not fit it.

    Raises:
        ValueError: Names what is wrong.
    """
    if convention not in get_args(Convention):
        raise ValueError(f"convention {convention!r} must be standard or modified")
    if not rows:
        raise ValueError("a chain needs at least one row")
    for name, values in variables.items():
        if len(values) != len(rows):
            raise ValueError(f"{name} has {len(values)} values for {len(rows)} joints")
        for i, value in enumerate(values):
            finite(f"{name}[{i}]", value, "(rad or m and per s)")
