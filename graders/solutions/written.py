"""Sides as they were written: what went from them, or stands beside a factor, may be zero or without a value."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from graders.language.tree import Tree
from graders.solutions.beside import Beside, beside
from graders.solutions.scene import Effort, Residuals, Scene, Side
from graders.solutions.zeros import Zero


class Written:
    """Left minus right of the reference and the answer as they were written, ready to run once they are asked for.

    Args:
        scene: Where they run.
        trees: They, equation by equation.
        left: What is left of them.
        effort: What is spent.
    """

    def __init__(
        self, scene: Scene, trees: Sequence[Sequence[Tree]], left: Sequence[Sequence[Tree]], effort: Effort
    ) -> None:
        self.scene, self.trees, self.left, self.effort = scene, trees, left, effort

    @cached_property
    def _sides(self) -> list[Side]:
        both = Residuals(self.scene, self.trees, self.effort)
        return [Side(both, which) for which in (0, 1)]

    def vanishes(self, which: int, zero: Zero) -> bool:
        """Tell whether what went from a side may be zero where what is left of it is not."""
        return self.shorter(which) and self._touches(which, zero)

    def shorter(self, which: int) -> bool:
        """Tell whether anything went from a side."""
        return any(left is not tree for left, tree in zip(self.left[which], self.trees[which], strict=True))

    def _touches(self, which: int, zero: Zero) -> bool:
        values = self._sides[which].balls(zero.point)
        return values is not None and all(value.contains(0) for value in values)

    def holds(self, which: int, zero: Zero) -> bool:
        """Tell whether a zero of a part of a side is one of the whole: it may be a pole, or where there is no value."""
        return self._touches(which, zero) or beside(self._sides[which], zero) is Beside.ZERO
