"""What cannot be solved, by kind; each is a ValueError whose message names the value and its unit.

`code` names the kind for programs (`mechanics.wire`); a plain ValueError is a value out of range.
"""

from __future__ import annotations


class AssemblyError(ValueError):
    """The links do not reach: no position exists."""

    code = "cannot_assemble"


class UnstableError(ValueError):
    """The supports do not hold the structure."""

    code = "unstable"


class UnbalancedError(ValueError):
    """The external loads of a free body do not cancel."""

    code = "unbalanced"


class SingularError(ValueError):
    """The equations have no unique solution here (a dead position, a free choice)."""

    code = "singular"


class TrainError(ValueError):
    """The conditions of a gear train contradict one another."""

    code = "inconsistent"


class UndeterminedError(TrainError):
    """The conditions of a gear train are too few to determine its motion."""

    code = "under_determined"
