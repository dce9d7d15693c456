"""What cannot be solved, by kind; each is a ValueError whose message names the value and its unit."""

from __future__ import annotations


class AssemblyError(ValueError):
    """The links do not reach: no position exists."""


class UnstableError(ValueError):
    """The supports do not hold the structure."""


class UnbalancedError(ValueError):
    """The external loads of a free body do not cancel."""


class SingularError(ValueError):
    """The equations have no unique solution here (a dead position, a free choice)."""


class TrainError(ValueError):
    """The conditions of a gear train contradict one another or do not determine its motion."""
